#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>

namespace rederive::language {
namespace {
using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Node::Kind;

/// An expression, with bounds on the bits of its numbers and on its size that are known before it is made.
struct Lowered {
  ex value;
  double bits = 0, parts = 1;
};

constexpr double most_bits = 1 << 16, most_parts = 100'000;
constexpr int largest_root = 1000;

[[noreturn]] void refuse(const Node& node, Mistake mistake, const std::string& message) {
  throw SyntaxError(mistake, node.position, message);
}

void check_size(const Node& node, double bits, double parts) {
  if (bits > most_bits) refuse(node, Mistake::too_large, "the numbers in this would be too large");
  if (parts > most_parts) refuse(node, Mistake::too_large, "this would be too large when written out");
}

struct Lowering {
  const Symbols& symbols;
  const Limits& limits;

  Lowered lower(const Tree& tree) const {
    try {
      Lowered result = build(*tree);
      check_size(*tree, result.bits, result.parts);
      if (is_a<numeric>(result.value) && !result.value.info(GiNaC::info_flags::real))
        refuse(*tree, Mistake::undefined, "this has no real value");
      return result;
    } catch (const SyntaxError&) {
      throw;
    } catch (const std::out_of_range&) {
      refuse(*tree, Mistake::unknown_symbol, "there is no symbol '" + tree->text + "'");
    } catch (const std::exception&) {  // GiNaC's pole_error, and its relatives
      refuse(*tree, Mistake::undefined, "this has no value: it divides by zero, or is a pole of a function");
    }
  }

  Lowered build(const Node& node) const {
    if (node.kind == Kind::number) {
      const numeric value(exact(node.text));
      return {value, 1.0 * value.numer().int_length() + value.denom().int_length()};
    }
    if (node.kind == Kind::symbol) return {node.text == "pi" ? ex(GiNaC::Pi) : ex(symbols[node.text])};
    if (node.kind == Kind::power) return power(node);
    if (node.kind == Kind::call) return call(node);
    if (node.kind != Kind::negative) return combine(node);
    const Lowered operand = lower(node.children[0]);
    return {-operand.value, operand.bits, operand.parts};
  }

  Lowered combine(const Node& node) const {
    const bool is_sum = node.kind == Kind::sum;
    GiNaC::exvector values;
    Lowered all{0, 0, 1};
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const auto [value, bits, parts] = lower(node.children[i]);
      all.bits += bits, all.parts += parts;
      if (node.inverse[i] && !is_sum && value.is_zero())
        refuse(*node.children[i], Mistake::undefined, "this divisor is zero");
      values.push_back(!node.inverse[i] ? value : is_sum ? -value : pow(value, -1));
    }
    check_size(node, all.bits, all.parts);
    all.value = is_sum ? ex(GiNaC::add(values)) : ex(GiNaC::mul(values));
    return all;
  }

  Lowered power(const Node& node) const {
    const Lowered base = lower(node.children[0]), exponent = lower(node.children[1]);
    if (!is_a<numeric>(exponent.value))
      return {pow(base.value, exponent.value), base.bits + exponent.bits, base.parts + exponent.parts};
    const numeric n = GiNaC::ex_to<numeric>(exponent.value);
    const ex inner = is_a<GiNaC::power>(base.value) ? base.value.op(1) : ex(1);
    const numeric total = is_a<numeric>(inner) ? n * GiNaC::ex_to<numeric>(inner) : n;
    if (GiNaC::abs(total) > limits.exponent)
      refuse(*node.children[1], Mistake::too_large, "exponents go up to " + std::to_string(limits.exponent));
    if (n.denom() > largest_root)
      refuse(*node.children[1], Mistake::too_large,
             "as a fraction, an exponent has a denominator up to " + std::to_string(largest_root) +
                 ": write 1/3 for 0.333…");
    const double bits = (base.bits + 1) * (GiNaC::abs(n).to_double() + 1);
    check_size(node, bits, base.parts + 1);
    if (base.value.info(GiNaC::info_flags::negative) && is_a<numeric>(base.value) && !n.is_integer())
      refuse(node, Mistake::undefined, "a root of a negative number has no real value");
    if (base.value.is_zero() && !n.is_positive())
      refuse(node, Mistake::undefined, "this divides by zero, or is 0^0");
    return {pow(base.value, n), bits, base.parts + 1};
  }

  Lowered call(const Node& node) const {
    const Function* function = find_function(node.text);
    if (function == nullptr)
      refuse(node, Mistake::unknown_function, "there is no function '" + node.text + "'");
    const Lowered argument = lower(node.children[0]);
    const auto sign_beyond = [&](long end) -> std::optional<int> {
      return GiNaC::ex_to<numeric>(argument.value - end).csgn();
    };
    if (is_a<numeric>(argument.value) && function->domain.excludes(sign_beyond))
      refuse(node, Mistake::undefined, "this has no real value");
    const double copies = node.text == "cot" || node.text == "coth" ? 2 : 1;  // cos(x)/sin(x)
    const double bits = copies * argument.bits + 1, parts = copies * argument.parts + 1;
    check_size(node, bits, parts);
    return {function->of(argument.value), bits, parts};
  }
};

/// Simplifies for real values: each symbol and function is its own conjugate and its own real part.
class Real : public GiNaC::map_function {
 public:
  ex operator()(const ex& e) override {
    if (is_a<numeric>(e) && !e.info(GiNaC::info_flags::real)) throw std::domain_error("not real");
    if (!is_a<GiNaC::function>(e)) return e.map(*this);
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if (name == "imag_part" || name == "atan2") return 0;  // the angle of the positive base of a power
    return name == "conjugate" || name == "real_part" ? (*this)(e.op(0)) : e.map(*this);
  }
};

}  // namespace

ex lower(const Tree& tree, const Symbols& symbols, const Limits& limits) {
  const ex value = Lowering{symbols, limits}.lower(tree).value;
  try {
    return Real()(value);
  } catch (const std::domain_error&) {  // GiNaC's pole_error is one
    refuse(*tree, Mistake::undefined, "this has no real value");
  }
}

}  // namespace rederive::language
