// Each row of the table of functions says the truth: it is checked against GiNaC, and field against field.
#include <doctest/doctest.h>

#include <derivations/decide/decide.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/interval.hpp>
#include <set>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;

namespace {

/// The symbol u in the open domain of a function, and at a distance from its poles.
Symbols argument_of(const Function& f) {
  Symbols symbols;
  const bool is_bounded = f.domain.most == 1, is_positive = f.domain.least >= 0 || f.half_turn != 0;
  const char* range = f.domain.least == 1 ? "(1, inf)"
                      : is_bounded        ? "(-1, 1)"
                      : is_positive       ? "(0, 1)"
                                          : "(0, inf)";
  symbols.declare({"u", "u", "u", "1", range, "", ""});
  return symbols;
}

bool are_same(const Tree& a, const Tree& b, const Symbols& symbols) {
  return decide({{a}, {}}, {{b}, {}}, symbols).verdict == Verdict::proved;
}

Tree call_of(std::string_view name, const Tree& argument) {
  return make_tree(Node::Kind::call, std::string(name), {argument});
}

}  // namespace

TEST_CASE("derivatives, simpler forms, reciprocals, inverses and parities are true") {
  for (const Function& f : functions()) {
    CAPTURE(f.name);
    const Symbols symbols = argument_of(f);
    const Tree u = parse("u", symbols), value = call_of(f.name, u);
    const GiNaC::ex derivative = f.of(symbols["u"]).diff(GiNaC::ex_to<GiNaC::symbol>(symbols["u"]));
    if (f.name != "fabs")  // whose derivative in GiNaC has parts of complex numbers
      CHECK(are_same(to_tree(derivative, symbols), parse(f.derivative, symbols), symbols));
    if (!f.simpler.empty()) CHECK(are_same(value, parse(f.simpler, symbols), symbols));
    if (!f.reciprocal.empty())
      CHECK(are_same(value, parse("1/" + std::string(f.reciprocal) + "(u)", symbols), symbols));
    if (!f.inverse.empty() && f.half_turn == 0) CHECK(are_same(call_of(f.inverse, value), u, symbols));
    const Tree mirrored = call_of(f.name, parse("-u", symbols));
    if (f.parity == Function::Parity::even) CHECK(are_same(mirrored, value, symbols));
    if (f.parity == Function::Parity::odd)
      CHECK(are_same(mirrored, make_tree(Node::Kind::negative, "", {value}), symbols));
  }
}

TEST_CASE("a function has values at the ends of its monotone piece, and no others outside its domain") {
  for (const Function& f : functions()) {
    CAPTURE(f.name);
    const auto is_outside = [&](long at) {
      return f.domain.excludes([&](long end) { return std::optional(at < end ? -1 : at > end ? 1 : 0); });
    };
    for (const long at : {-2, -1, 0, 1, 2}) {
      const Value value = call(std::string(f.name), known(Constant{at}, 200));
      const bool is_pole = at == 0 && !f.needs[0].empty() && f.needs[0].find('=') == f.needs[0].npos &&
                           (f.name == "cot" || f.name == "csc" || f.name == "coth" || f.name == "csch");
      CHECK((value.is == Value::Is::nowhere) == (is_outside(at) || is_pole));
    }
    if (f.values.empty()) continue;
    const auto& [domain, values, inverse, half_turn, range] = monotone_piece(std::string(f.name));
    CHECK(is_within(call(std::string(f.name), domain), range));
    CHECK(is_within(range, call(std::string(f.name), domain)));
  }
}

TEST_CASE("no two functions have a name, an alias or a command in common") {
  std::set<std::string_view> names, commands;
  for (const Function& f : functions()) {
    CHECK(names.insert(f.name).second);
    if (!f.latex.empty()) CHECK(commands.insert(f.latex).second);
    CHECK(f.latex.empty() != f.latex_frame.empty());
    if (!f.inverse.empty()) CHECK(find_function(f.inverse) != nullptr);
  }
}
