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

/// f(a) op f(b), where f is one and the same.
std::optional<Sides> without_the_same(const Sides& s) {
  const std::string kind = kind_of(s.left);
  if (kind.empty() || kind != kind_of(s.right)) return std::nullopt;
  if (is_a<GiNaC::power>(s.left) && !s.left.op(1).is_equal(s.right.op(1))) return std::nullopt;
  const ex a = s.left.op(0), b = s.right.op(0);
  for (const char* increasing :
       {"exp", "log", "sinh", "asinh", "tanh", "atanh", "asin", "atan", "acosh", "root", "odd"})
    if (kind == increasing) return Sides{a, s.op, b};
  if (kind == "acos") return Sides{a, turned(s.op), b};
  const bool squares = kind == "even" && s.left.op(1).is_equal(2);
  if (kind == "cosh" || kind == "abs" || (kind == "even" && !squares))  // they grow with the size of a
    return Sides{GiNaC::pow(a, 2), s.op, GiNaC::pow(b, 2)};
  return std::nullopt;
}

/// f(a) op b becomes a op g(b), where b lies among the values of f and g is the inverse of f.
std::optional<Sides> without_the_left(const Sides& s, const Symbols& symbols) {
  const std::string kind = kind_of(s.left);
  const ex &b = s.right, half = GiNaC::Pi / 2;
  if (kind.empty() || !has_symbol(s.left)) return std::nullopt;
  const ex a = s.left.op(0);
  const auto between = [&](const ex& low, const ex& high) {
    return is_nonnegative(b - low, symbols) && is_nonnegative(high - b, symbols);
  };
  if (kind == "log") return Sides{a, s.op, GiNaC::exp(b)};
  if (kind == "asinh") return Sides{a, s.op, GiNaC::sinh(b)};
  if (kind == "atanh") return Sides{a, s.op, GiNaC::tanh(b)};
  if (kind == "asin" && between(-half, half)) return Sides{a, s.op, GiNaC::sin(b)};
  if (kind == "acos" && between(0, GiNaC::Pi)) return Sides{a, turned(s.op), GiNaC::cos(b)};
  if (kind == "atan" && sign_of(b + half, symbols) > 0 && sign_of(half - b, symbols) > 0)
    return Sides{a, s.op, GiNaC::sin(b) / GiNaC::cos(b)};
  if (is_nonnegative(b, symbols)) {
    if (kind == "acosh") return Sides{a, s.op, GiNaC::cosh(b)};
    if (kind == "abs") return Sides{GiNaC::pow(a, 2), s.op, GiNaC::pow(b, 2)};
    if (kind == "root" && s.left.op(1).is_equal(numeric(1, 2))) return Sides{a, s.op, GiNaC::pow(b, 2)};
  }
  if (has_symbol(b))
    return std::nullopt;  // exp(x) = y is not made x = log(y), for log(y) = x becomes the former
  if (b.is_zero() && (kind == "sinh" || kind == "tanh" || kind == "odd")) return Sides{a, s.op, 0};
  if (kind == "exp" && sign_of(b, symbols) > 0) return Sides{a, s.op, GiNaC::log(b)};
  return std::nullopt;
}

}  // namespace

Sides unwrapped(Sides sides, const Symbols& symbols) {
  for (int layer = 0; layer < 10; ++layer) {
    auto inner = without_the_same(sides);
    if (!inner) inner = without_the_left(sides, symbols);
    if (!inner) inner = without_the_left({sides.right, turned(sides.op), sides.left}, symbols);
    if (!inner) break;
    sides = *inner;
  }
  return sides;
}

}  // namespace rederive
