#include <cln/integer.h>

#include <derivations/numbers/evaluate.hpp>
#include <regex>

namespace rederive {

namespace {

using cln::cl_RA;
using Is = Value::Is;

/// By quadratic interval refinement (Abbott 2006) until so many bits are certain: the secant guesses a cell
/// of the bracket, signs confirm it, and cells get smaller each time; else the bracket is halved.
Value zero_between(const Tree& tree, const std::string& symbol, cl_RA low, cl_RA high, long bits) {
  const auto at = [&](const cl_RA& x) { return value_at(tree, {{symbol, x}}, 2 * bits + 256); };
  const auto first = at(low).sign(), last = at(high).sign();
  if (first == 0 || last == 0) return known(Constant{first == 0 ? low : high}, bits);
  if (!first || !last || first == last) return {};
  long log_cells = 1;
  while ((high - low) * cln::ash(cln::cl_I(1), bits) > std::max(cln::abs(low), cln::abs(high))) {
    const Ball start = at(low).ball, share = start / (start - at(high).ball);
    const cl_RA cells = cln::ash(cln::cl_I(1), log_cells), cell = (high - low) / cells,
                guess = share.is_moderate() ? low + cln::floor1(cells * cl_RA(share.middle())) * cell : low;
    if (at(guess).sign() == first && at(guess + cell).sign() == last) {
      low = guess, high = guess + cell, log_cells *= 2;
      continue;
    }
    log_cells = std::max(1L, log_cells / 2);
    const cl_RA middle = (low + high) / 2;
    const auto there = at(middle).sign();
    if (!there) break;
    if (there == 0) return known(Constant{middle}, bits);
    (there == first ? low : high) = middle;
  }
  return known(Ball::between(Ball(low, 2 * bits), Ball(high, 2 * bits)).at(bits));
}

}  // namespace

const Value& Number::value(long bits) const {
  auto& [tree, symbol, low, high, known_bits, value] = *state_;
  if (known_bits >= bits) return value;
  known_bits = bits;
  return value = !tree            ? known(Constant{low}, bits)
                 : symbol.empty() ? value_at(tree, {}, bits)
                                  : zero_between(tree, symbol, low, high, bits);
}

Value value_at(const Tree& tree, const Point& point, long bits) {
  using Kind = Node::Kind;
  const Node& node = *tree;
  const auto child = [&](std::size_t i) { return value_at(node.children[i], point, bits); };
  if (node.kind == Kind::number) return known(Constant{exact(node.text)}, bits);
  if (node.kind == Kind::symbol && node.text == "pi") return known(Constant{0, 1}, bits);
  if (node.kind == Kind::symbol) return point.at(node.text).value(bits);
  if (node.kind == Kind::negative) return known(Constant{-1}, bits) * child(0);
  if (node.kind == Kind::power) return pow(child(0), child(1));
  if (node.kind == Kind::call) return call(node.text, child(0));
  const bool is_sum = node.kind == Kind::sum;
  Value result = known(Constant{is_sum ? 0 : 1}, bits);
  for (std::size_t i = 0; i < node.children.size(); ++i)
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
  for (long bits = 64; bits <= most; bits *= 3) {
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
    const auto text = value.is == Is::certain ? value.ball.digits(digits) : std::nullopt;
    if (!text) continue;
    if (!value.exact) return text;
    const std::string shorter =  // "0.25" of "0.25000", if that is the whole number
        std::regex_replace(*text, std::regex("\\.?0*(e|$)"), "$1", std::regex_constants::format_first_only);
    return exact(shorter.substr(shorter[0] == '-')) == cln::abs(*value.exact) ? shorter : *text;
  }
  return std::nullopt;
}

}  // namespace rederive
