#include <algorithm>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/unwrap.hpp>
#include <optional>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

bool has_symbol(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(),
                     [](const ex& part) { return is_a<GiNaC::symbol>(part); });
}

std::string turned(const std::string& op) {
  return op[0] == '<' ? ">" + op.substr(1) : op[0] == '>' ? "<" + op.substr(1) : op;
}

/// "exp" of exp(x); "abs" of |x|; "root" of x^(1/2), "odd" of x^3, "even" of x^4.
std::string kind_of(const ex& e) {
  if (is_a<GiNaC::function>(e) && e.nops() == 1) return ex_to<GiNaC::function>(e).get_name();
  if (!is_a<GiNaC::power>(e) || !is_a<numeric>(e.op(1)) || !e.op(1).info(GiNaC::info_flags::positive))
    return "";
  const numeric n = ex_to<numeric>(e.op(1));
  return !n.is_integer() ? "root" : n.is_odd() ? "odd" : "even";
}

/// "exp"; "^3", "^1/2".
std::string layer_name(const ex& e) {
  if (!is_a<GiNaC::power>(e)) return name_of(e) == "abs" ? "fabs" : name_of(e);
  const numeric n = ex_to<numeric>(e.op(1));
  const auto text = [](const numeric& whole) { return std::to_string(whole.to_int()); };
  return "^" + text(n.numer()) + (n.is_integer() ? "" : "/" + text(n.denom()));
}

bool is_even(const std::string& kind) { return kind == "cosh" || kind == "abs" || kind == "even"; }

/// f(a) op f(b), where f is one and the same.
std::optional<Layer> the_same(const Sides& s) {
  const std::string kind = kind_of(s.left);
  if (kind.empty() || kind != kind_of(s.right)) return std::nullopt;
  const bool is_power = is_a<GiNaC::power>(s.left);
  if (is_power && !s.left.op(1).is_equal(s.right.op(1))) return std::nullopt;
  if (is_power && s.left.op(1).is_equal(2)) return std::nullopt;  // squares stay
  for (const char* known : {"exp", "log", "sinh", "asinh", "tanh", "atanh", "asin", "atan", "acosh", "acos",
                            "root", "odd", "cosh", "abs", "even"})
    if (kind == known) return Layer{layer_name(s.left), s.left.op(0), s.right.op(0)};
  return std::nullopt;
}

/// f(a) op b is f(a) op f(g(b)), where b lies among the values of f and g is the inverse of f.
std::optional<Layer> of_the_left(const Sides& s, const Symbols& symbols) {
  const std::string kind = kind_of(s.left);
  const ex &b = s.right, half = GiNaC::Pi / 2;
  if (kind.empty() || !has_symbol(s.left)) return std::nullopt;
  const auto between = [&](const ex& low, const ex& high) {
    return is_nonnegative(b - low, symbols) && is_nonnegative(high - b, symbols);
  };
  const auto with = [&](const ex& right) { return Layer{layer_name(s.left), s.left.op(0), right}; };
  if (kind == "log") return with(GiNaC::exp(b));
  if (kind == "asinh") return with(GiNaC::sinh(b));
  if (kind == "atanh") return with(GiNaC::tanh(b));
  if (kind == "asin" && between(-half, half)) return with(GiNaC::sin(b));
  if (kind == "acos" && between(0, GiNaC::Pi)) return with(GiNaC::cos(b));
  if (kind == "atan" && sign_of(b + half, symbols) > 0 && sign_of(half - b, symbols) > 0)
    return with(GiNaC::sin(b) / GiNaC::cos(b));
  if (is_nonnegative(b, symbols)) {
    if (kind == "acosh") return with(GiNaC::cosh(b));
    if (kind == "abs") return with(b);
    if (kind == "root" && s.left.op(1).is_equal(numeric(1, 2))) return with(GiNaC::pow(b, 2));
  }
  if (has_symbol(b))
    return std::nullopt;  // exp(x) = y is not made x = log(y), for log(y) = x becomes the former
  const bool higher = kind == "even" && (s.op == "=" || !s.left.op(1).is_equal(2));
  if (b.is_zero() && (kind == "sinh" || kind == "tanh" || kind == "odd" || higher)) return with(0);
  if (kind == "exp" && sign_of(b, symbols) > 0) return with(GiNaC::log(b));
  return std::nullopt;
}

/// The relation inside of a layer; x^2 = 0 is x = 0.
Sides inside(const Layer& layer, const std::string& kind, const std::string& op) {
  const bool is_zero = op == "=" && (layer.left.is_zero() || layer.right.is_zero());
  const int power = is_even(kind) && !is_zero ? 2 : 1;
  return {GiNaC::pow(layer.left, power), kind == "acos" ? turned(op) : op, GiNaC::pow(layer.right, power)};
}

}  // namespace

Sides unwrapped(Sides sides, const Symbols& symbols, std::vector<Layer>* layers) {
  for (int depth = 0; depth < 10; ++depth) {
    std::string kind = kind_of(sides.left);
    auto layer = the_same(sides);
    if (!layer) layer = of_the_left(sides, symbols);
    if (!layer && (layer = of_the_left({sides.right, turned(sides.op), sides.left}, symbols)))
      std::swap(layer->left, layer->right), kind = kind_of(sides.right);
    if (!layer) break;
    sides = inside(*layer, kind, sides.op);
    if (layers != nullptr) layers->push_back(*layer);
  }
  return sides;
}

}  // namespace rederive
