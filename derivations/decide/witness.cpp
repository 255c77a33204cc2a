// Puts a witness into words and digits.
#include <cln/rational_io.h>
#include <fmt/ostream.h>

#include <derivations/decide/points.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/numbers/interval.hpp>

namespace rederive::decide {
using namespace language;
using namespace numbers;
using cln::cl_RA;

namespace {
std::string rational_text(const cl_RA& value) { return fmt::to_string(fmt::streamed(value)); }

/// Returns digits of a value; "no value" if there certainly is none, "" if that is not known.
std::string text_at(const Tree& tree, const Point& point, int digits = 30) {
  if (const auto text = digits_at(tree, point, digits)) return *text;
  return value_at(tree, point, 200).is == Value::Is::nowhere ? "no value" : "";
}

/// Returns the first difference between the sides of a link that is not 0, or "0".
std::string residual_at(const Relation& relation, const Point& point) {
  for (const Relation& link : links_of(relation)) {
    const std::string text = text_at(difference(link.sides[0], link.sides[1]), point);
    if (!text.empty() && text != "0") return text;
  }
  return "0";
}

/// Returns both values: of expressions or right-hand sides, with as many digits as distinguish them; or of
/// residuals, one of which is 0 at a solution.
std::pair<std::string, std::string> values_at(const Problem& problem, const Point& point,
                                              std::optional<bool> of_left) {
  const auto& [left, right] = std::tie(problem.left, problem.right);
  const auto name = [&](const Relation& r) { return print(r.sides[0], Notation::plain, problem.symbols); };
  const bool is_simple = left.operators.size() == 1 && right.operators.size() == 1;
  const Tree &a = left.sides.back(), &b = right.sides.back();
  if (left.operators.empty() || (is_simple && name(left) == name(right))) {
    std::pair shown(text_at(a, point), text_at(b, point));
    for (int digits = 60; shown.first == shown.second && !is_same(a, b) && digits < 16'000; digits *= 2)
      shown = {text_at(a, point, digits), text_at(b, point, digits)};
    return shown;
  }
  return {of_left == true ? "0" : residual_at(left, point),
          of_left == false ? "0" : residual_at(right, point)};
}

/// Returns a substituted value in our syntax; nothing if a coordinate is a root between bounds.
std::optional<std::string> closed_form(const Tree& tree, const Point& point, const Symbols& symbols) try {
  const Tree value = with_coordinates(tree, point);
  return value ? std::optional(print(lower(value, symbols), Notation::plain, symbols)) : std::nullopt;
} catch (const SyntaxError&) {  // too large to be written
  return std::nullopt;
}

}  // namespace

std::optional<Witness> make_witness(const Problem& problem, const Point& point, std::optional<bool> of_left) {
  Witness witness;
  const auto text_of = [&](const auto& of) { return print(of, Notation::plain, problem.symbols); };
  const auto say = [&](const std::string& name, const Value& value) {
    if (value.constant && value.constant->is_rational()) {
      witness.at[name] = rational_text(value.constant->a);
      return;
    }
    const cl_RA power = cln::expt_pos(cln::cl_I(10), 40);  // to 40 places
    witness.at[name] = rational_text(cln::round1(cl_RA(value.ball().lower()) * power) / power);
    if (value.constant) witness.exactly[name] = text_of(tree_of(*value.constant));
  };
  for (const auto& [name, number] : point) {
    say(name, number.value(160));
    const Number::State& known = *number;
    if (!known.tree || known.value.constant) continue;
    const std::string text = text_of(lower(known.tree, problem.symbols));
    if (known.symbol.empty())
      witness.exactly[name] = text;
    else
      witness.between[name] = {rational_text(known.low), rational_text(known.high)},
      witness.solves = text + " = 0";
  }
  for (const auto& [name, tree] : problem.values) {  // what was put in
    const Value value = value_at(tree, point, 160);
    if (value.is != Value::Is::certain) continue;
    say(name, value);
    if (value.constant) continue;
    if (const auto text = closed_form(tree, point, problem.symbols))
      witness.exactly[name] = *text;
    else
      witness.at[name] = value.ball().digits(38).value_or(witness.at[name]);
  }
  std::tie(witness.printed, witness.derived) = values_at(problem, point, of_left);
  if (witness.printed.empty() && witness.derived.empty()) return std::nullopt;
  return witness;
}

}  // namespace rederive::decide
