#include <cln/integer.h>

#include <derivations/numbers/evaluate.hpp>
#include <regex>

namespace rederive {

namespace {

using cln::cl_I;
using cln::cl_RA;
using Is = Value::Is;

/// "0.25" of "0.25000", if that is the whole number.
std::string without_zeros(const std::string& text, const cl_RA& whole) {
  const std::string shorter =
      std::regex_replace(text, std::regex("\\.?0*(e|$)"), "$1", std::regex_constants::format_first_only);
  return exact(shorter.substr(shorter[0] == '-')) == cln::abs(whole) ? shorter : text;
}

}  // namespace

/// A rational number, where both ends are the same and there is no tree; or what a tree is worth; or its zero
/// between the ends, which move towards it by quadratic interval refinement
/// (Abbott 2006): the secant guesses a cell, signs confirm it, and cells get smaller each time; else by
/// bisection.
struct Number::State {
  cl_RA low, high;
  Tree tree = {};
  std::string symbol = {};
  long bits = 0;  // of the value
  Value value = {};

  void find(long precision) {
    value = !tree            ? known(Constant{low}, precision)
            : symbol.empty() ? value_at(tree, {}, precision)
                             : zero(precision);
    bits = precision;
  }

  Value zero(long precision) {
    const Tree nought = make_tree(Node::Kind::number, "0");
    const auto sign = [&](const cl_RA& x) {
      return sign_at(tree, nought, {{symbol, x}}, 4 * precision + 256);
    };
    const Sign first = sign(low), last = sign(high);
    if (first == Sign::zero) high = low;
    if (last == Sign::zero) low = high;
    if (low != high && std::minmax({first, last}) != std::pair(Sign::negative, Sign::positive)) return {};
    long log_cells = 1;
    while ((high - low) * cln::ash(cl_I(1), precision) > std::max(cln::abs(low), cln::abs(high))) {
      const cl_RA cell = (high - low) / cln::ash(cl_I(1), log_cells),
                  guess = low + cells_before(log_cells, precision) * cell;
      if (sign(guess) == first && sign(guess + cell) == last) {
        low = guess, high = guess + cell, log_cells *= 2;
        continue;
      }
      log_cells = std::max(1L, log_cells / 2);
      const cl_RA middle = (low + high) / 2;
      const Sign there = sign(middle);
      if (there == Sign::undefined || there == Sign::unknown) break;
      if (there != first) high = middle;
      if (there == first || there == Sign::zero) low = middle;
    }
    return known(Ball::between(Ball(low, 2 * precision), Ball(high, 2 * precision)).at(precision));
  }

  /// In which of 2^log_cells cells the secant between the ends is 0.
  cl_I cells_before(long log_cells, long precision) const {
    const auto at = [&](const cl_RA& x) {
      const Value v = value_at(tree, {{symbol, x}}, 2 * precision);
      return v.is == Is::certain ? cl_RA(v.ball.lower()) : cl_RA(0);
    };
    const cl_RA first = at(low), change = first - at(high);
    if (cln::zerop(change)) return 0;
    const cl_I cells = cln::ash(cl_I(1), log_cells), before = cln::floor1(first * cells / change);
    return std::max(cl_I(0), std::min(cl_I(cells - 1), before));
  }
};

Number::Number(const cl_RA& q) : state_(new State{q, q}) {}
Number::Number(const Tree& constant) : state_(new State{0, 0, constant}) {}
Number::Number(const Tree& tree, const std::string& symbol, const cl_RA& low, const cl_RA& high)
    : state_(new State{low, high, tree, symbol}) {}

const Value& Number::value(long bits) const {
  if (state_->bits < bits) state_->find(bits);
  return state_->value;
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
    if (text) return value.exact ? without_zeros(*text, *value.exact) : *text;
  }
  return std::nullopt;
}

}  // namespace rederive
