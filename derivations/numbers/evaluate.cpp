#include <cln/integer.h>

#include <derivations/numbers/evaluate.hpp>
#include <regex>

namespace rederive::numbers {
using namespace language;
namespace {
using cln::cl_RA;
using Is = Value::Is;

/// Narrows the bracket by quadratic interval refinement (Abbott 2006) until `bits` bits are certain: the
/// secant guesses a cell; if signs confirm it, the next cells are smaller, else the bracket is halved.
Value zero_between(const Tree& tree, const std::string& symbol, cl_RA& low, cl_RA& high, long bits) {
  const auto at = [&](const cl_RA& x) { return value_at(tree, {{symbol, x}}, 2 * bits + 256); };
  Value at_low = at(low), at_high = at(high);
  const auto first = at_low.sign(), last = at_high.sign();
  if (first == 0 || last == 0) return known(Constant{first == 0 ? low : high}, bits);
  if (!first || !last || first == last) return {};
  long log_cells = 8;
  while ((high - low) * cln::ash(cln::cl_I(1), bits) > std::max(cln::abs(low), cln::abs(high))) {
    const Ball share = at_low.ball() / (at_low.ball() - at_high.ball());
    const cl_RA cells = cln::ash(cln::cl_I(1), log_cells), cell = (high - low) / cells,
                guess = share.is_moderate() ? low + cln::floor1(cells * cl_RA(share.middle())) * cell : low;
    Value at_guess = at(guess), beyond = at(guess + cell);
    if (at_guess.sign() == first && beyond.sign() == last) {
      low = guess, high = guess + cell, log_cells *= 2;
      at_low = std::move(at_guess), at_high = std::move(beyond);
      continue;
    }
    log_cells = std::max(1L, log_cells / 2);
    const cl_RA middle = (low + high) / 2;
    Value there = at(middle);
    const auto sign = there.sign();
    if (!sign) break;
    if (sign == 0) return known(Constant{middle}, bits);
    (sign == first ? low : high) = middle, (sign == first ? at_low : at_high) = std::move(there);
  }
  return known(Ball::between(Ball(low, 2 * bits), Ball(high, 2 * bits)).at(bits));
}

}  // namespace

const Value& Number::value(long bits) const {
  State& s = *state_;
  if (s.bits >= bits) return s.value;
  s.bits = bits;
  return s.value = !s.tree            ? known(Constant{s.low}, bits)
                   : s.symbol.empty() ? value_at(s.tree, {}, bits)
                                      : zero_between(s.tree, s.symbol, s.from, s.to, bits);
}

Value value_at(const Tree& tree, const Point& point, long bits) {
  using Kind = Node::Kind;
  const Node& node = *tree;
  const auto child = [&](std::size_t i) { return value_at(node.children[i], point, bits); };
  if (node.kind == Kind::number) return known(Constant{exact(node.text)}, bits);
  if (node.kind == Kind::symbol && node.text == "pi") return known(Constant{0, 1}, bits);
  if (node.kind == Kind::symbol) return point.at(node.text).value(bits);
  if (node.kind == Kind::negative) return known(Constant{}, bits) - child(0);
  if (node.kind == Kind::power) return pow(child(0), child(1));
  if (node.kind == Kind::call) return call(node.text, child(0));
  const bool is_sum = node.kind == Kind::sum;
  Value result = node.inverse[0] ? known(Constant{is_sum ? 0 : 1}, bits) : child(0);
  for (std::size_t i = node.inverse[0] ? 0 : 1; i < node.children.size(); ++i)
    if (node.inverse[i])
      result = is_sum ? result - child(i) : result / child(i);
    else
      result = is_sum ? result + child(i) : result * child(i);
  return result;
}

Sign sign_at(const Tree& left, const Tree& right, const Point& point, long most) {
  if (left == right) {  // the very same
    const Value value = value_at(left, point, 64);
    return value.is == Is::certain ? Sign::zero : value.is == Is::nowhere ? Sign::undefined : Sign::unknown;
  }
  for (long bits = 192; bits <= most; bits *= 3) {
    const Value rest = value_at(left, point, bits) - value_at(right, point, bits);
    if (rest.is == Is::nowhere) return Sign::undefined;
    if (const auto sign = rest.sign())
      return *sign < 0 ? Sign::negative : *sign > 0 ? Sign::positive : Sign::zero;
  }
  return Sign::unknown;
}

std::optional<std::string> digits_at(const Tree& tree, const Point& point, int digits) {
  const long least = 64 + 4L * digits;
  for (long bits = least; bits <= 9 * least; bits *= 3) {
    const Value value = value_at(tree, point, bits);
    if (value.is == Is::nowhere) return std::nullopt;
    const auto text = value.is == Is::certain ? value.ball().digits(digits) : std::nullopt;
    if (!text) continue;
    if (!value.exact) return text;
    const std::string shorter =  // "0.25" of "0.25000", if that is the whole number
        std::regex_replace(*text, std::regex("\\.?0*(e|$)"), "$1", std::regex_constants::format_first_only);
    return exact(shorter.substr(shorter[0] == '-')) == cln::abs(*value.exact) ? shorter : *text;
  }
  return std::nullopt;
}

}  // namespace rederive::numbers
