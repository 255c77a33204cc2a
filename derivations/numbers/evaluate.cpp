#include <derivations/numbers/evaluate.hpp>
#include <functional>

namespace rederive::inline numbers {

namespace {

using cln::cl_I;
using cln::cl_RA;
using Is = Value::Is;

struct Evaluation {
  const Point& point;
  Arithmetic arithmetic;

  Value number(const std::string& text) const {
    const bool is_short = text.size() < 18 && text.find_first_not_of("0123456789") == std::string::npos;
    return arithmetic.known(Constant{is_short ? cl_RA(std::stol(text)) : exact(text)});
  }

  Value symbol(const std::string& name) const {
    return name == "pi" ? arithmetic.known(Constant{0, 1}) : point.at(name).value(arithmetic.bits);
  }

  using Operation = Value (Arithmetic::*)(const Value&, const Value&) const;
  Value chain(const Node& node, long start, Operation join, Operation part) const {
    Value result = arithmetic.known(Constant{start});
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      result = (arithmetic.*(node.inverse[i] ? part : join))(result, of(*node.children[i]));
    }
    return result;
  }

  Value of(const Node& node) const {
    const auto child = [&](std::size_t i) { return of(*node.children[i]); };
    switch (node.kind) {
      case Node::Kind::number:
        return number(node.text);
      case Node::Kind::symbol:
        return symbol(node.text);
      case Node::Kind::negative:
        return arithmetic.minus(arithmetic.known(Constant{}), child(0));
      case Node::Kind::sum:
        return chain(node, 0, &Arithmetic::plus, &Arithmetic::minus);
      case Node::Kind::product:
        return chain(node, 1, &Arithmetic::times, &Arithmetic::over);
      case Node::Kind::power:
        return arithmetic.power(child(0), child(1));
      case Node::Kind::call:
        return arithmetic.call(node.text, child(0));
    }
    return {};
  }
};

/// The value, without its ball where it is exact.
Value evaluate(const Tree& tree, const Point& point, long bits) {
  return Evaluation{point, {bits}}.of(*tree);
}

/// The zero of a tree in one symbol between two ends, which move towards it.
struct Zero {
  Tree tree;
  std::string symbol;
  cl_RA low, high;
  long log_cells = 1;

  Value value(long bits) {
    const long most = 4 * bits + 256;
    const Sign first = sign(low, most), last = sign(high, most);
    if (first == Sign::zero) high = low;
    if (last == Sign::zero) low = high;
    const bool changes = (first == Sign::negative && last == Sign::positive) ||
                         (first == Sign::positive && last == Sign::negative);
    if (low != high && !changes) return {};
    for (int step = 0; step < 200 && !is_narrow(bits) && refine(first, most); ++step) {
    }
    return low == high ? Arithmetic{bits}.known(Constant{low})
                       : Arithmetic{bits}.known(Ball::between(low, high, bits));
  }

  Sign sign(const cl_RA& at, long most) const {
    static const Tree zero = std::make_shared<const Node>(Node{Node::Kind::number, "0", {}, {}, 0});
    return sign_at(tree, zero, {{symbol, at}}, most);
  }

  bool is_narrow(long bits) const {
    return (high - low) * cln::ash(cl_I(1), bits) <= std::max(cln::abs(low), cln::abs(high));
  }

  /// Quadratic interval refinement (Abbott 2006): of 2^n cells the one where the chord is 0. If the signs at
  /// its ends confirm it, next come 4^n cells. False where a sign is not certain.
  bool refine(Sign first, long most) {
    const cl_RA cell = (high - low) / cln::ash(cl_I(1), log_cells), left = low + guess(most) * cell;
    const bool is_certain = move_end(left, first, most) && move_end(left + cell, first, most);
    log_cells = high - low == cell ? std::min(2 * log_cells, most) : std::max(1L, log_cells / 2);
    return is_certain;
  }

  bool move_end(const cl_RA& at, Sign first, long most) {
    if (at <= low || at >= high) return true;
    const Sign sign = this->sign(at, most);
    if (sign == Sign::undefined || sign == Sign::unknown) return false;
    if (sign == first || sign == Sign::zero) low = at;
    if (sign != first) high = at;
    return true;
  }

  /// The number of the cell where the chord from end to end is 0; a middle one where that is not certain.
  cl_I guess(long most) const {
    const cl_I cells = cln::ash(cl_I(1), log_cells), last = cells - 1;
    const auto at = [&](const cl_RA& x) { return value_at(tree, {{symbol, x}}, most).ball; };
    const Ball first = at(low), share = first / (first - at(high));
    if (!share.is_moderate()) return cln::floor1(cells, 2);
    return std::clamp(cln::floor1(share.lower() * cells), cl_I(0), last);
  }
};

}  // namespace

struct Number::State {
  std::function<Value(long bits)> find;
  long bits = 0;  // of the value
  Value value = {};
};

Number::Number(const cl_RA& q)
    : state_(new State{[q](long bits) { return Arithmetic{bits}.known(Constant{q}); }}) {}

Number::Number(const Tree& constant)
    : state_(new State{[constant](long bits) { return evaluate(constant, {}, bits); }}) {}

Number::Number(const Tree& tree, const std::string& symbol, const cl_RA& low, const cl_RA& high)
    : state_(
          new State{[zero = Zero{tree, symbol, low, high}](long bits) mutable { return zero.value(bits); }}) {
}

const Value& Number::value(long bits) const {
  if (state_->bits != bits) state_->value = state_->find(bits);
  state_->bits = bits;
  return state_->value;
}

Value value_at(const Tree& tree, const Point& point, long bits) {
  return Arithmetic{bits}.complete(evaluate(tree, point, bits));
}

Sign sign_at(const Tree& left, const Tree& right, const Point& point, long most) {
  for (long bits = 64; bits <= most; bits *= 3) {
    const Value rest = Arithmetic{bits}.minus(evaluate(left, point, bits), evaluate(right, point, bits));
    if (rest.is == Is::nowhere) return Sign::undefined;
    if (const auto sign = rest.sign()) {
      return *sign < 0 ? Sign::negative : *sign > 0 ? Sign::positive : Sign::zero;
    }
  }
  return Sign::unknown;
}

std::optional<std::string> digits_at(const Tree& tree, const Point& point, int digits) {
  const long least = 64 + 4L * digits;
  for (long bits = least; bits <= 9 * least; bits *= 3) {
    const Value value = value_at(tree, point, bits);
    if (value.is == Is::nowhere) return std::nullopt;
    if (value.exact) return decimal(*value.exact, digits);
    if (value.is != Is::certain) continue;
    if (const auto text = value.ball.digits(digits)) return text;
  }
  return std::nullopt;
}

}  // namespace rederive::inline numbers
