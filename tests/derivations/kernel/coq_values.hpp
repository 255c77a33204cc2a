// What Coq's text is worth at a point: numbers as balls of 480 bits, functions, and whether a proposition
// holds. Derivatives are difference quotients with a step of 2^-100, integrals those of polynomials, limits
// values at a late time, and what is said of all numbers is tried with five.
#pragma once

#include <cln/integer.h>

#include <cmath>
#include <derivations/numbers/value.hpp>
#include <optional>
#include <tests/derivations/kernel/coq_files.hpp>

namespace rederive::coq {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;

constexpr long bits = 480;
inline Ball number(const cln::cl_RA& q) { return {q, bits}; }

/// A number, a function, or the truth of a proposition: nothing where it cannot be told.
struct Meaning {
  std::optional<Ball> number = {};
  std::function<Meaning(const Meaning&)> apply = {};
  std::optional<bool> truth = {};
  Meaning() = default;
  Meaning(Ball x) : number(std::move(x)) {}
  Meaning(std::function<Meaning(const Meaning&)> f) : apply(std::move(f)) {}
  static Meaning of(std::optional<bool> holds) {
    Meaning result;
    return result.truth = holds, result;
  }
};

/// The text has no value there: a division by 0, a root of a negative number, or what the reader cannot tell.
struct NoValue : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline const Ball& number_in(const Meaning& m) {
  if (!m.number || !m.number->is_finite()) throw NoValue("no number");
  return *m.number;
}
inline Meaning at(const Meaning& f, const Meaning& x) {
  return f.apply ? f.apply(x) : throw NoValue("no function");
}
inline bool is_close(const Ball& x, const Ball& y, double tolerance = 1e-40) {
  const double size = 1 + std::abs(x.to_double()) + std::abs(y.to_double());
  return std::abs((x - y).to_double()) <= tolerance * size;
}

using LocalPtr = std::shared_ptr<const struct Local>;
struct Local {
  std::string name;
  Meaning meaning;
  LocalPtr next;
};

/// Names and what they are worth. Definitions are unfolded when they are asked for.
class World {
 public:
  explicit World(const std::vector<Item>& items);
  std::map<std::string, Meaning> values;
  std::map<std::string, Text> definitions;

  Meaning value(const Text& text, const LocalPtr& scope = nullptr);
  Ball number(const Text& text, const LocalPtr& scope = nullptr) { return number_in(value(text, scope)); }
  std::optional<bool> holds(const Text& text, const LocalPtr& scope = nullptr) {
    try {
      return value(text, scope).truth;
    } catch (const NoValue&) {
      return std::nullopt;
    }
  }

 private:
  Meaning named(const std::string& name, const LocalPtr& scope);
  Meaning function(const Text& text, const LocalPtr& scope, std::size_t k);
  Meaning relation(const std::string& op, const std::function<Ball()>& left,
                   const std::function<Ball()>& right);
  Meaning quantified(const Text& text, const LocalPtr& scope, std::size_t k);
  LocalPtr inner_function(const Text& text, const std::string& name, const LocalPtr& scope);
  Meaning call(const Text& text, const LocalPtr& scope);

  bool is_inside_equivalence_ = false;  ///< where five numbers that agree are not enough
};

inline Ball derivative(const Meaning& f, const Ball& x) {
  const cln::cl_I size = cln::ash(cln::cl_I(1), 100);
  const Ball h = number(cln::cl_RA(1) / size), two_h = number(cln::cl_RA(2) / size);
  return (number_in(at(f, x + h)) - number_in(at(f, x - h))) / two_h;
}
/// By Gauss with three points: exact of polynomials up to the fifth degree.
inline Ball integral(const Meaning& f, const Ball& a, const Ball& b) {
  const Ball half = (b - a) / number(2), middle = (a + b) / number(2);
  const Ball node = half * number(cln::cl_RA(3) / 5).image(arb_sqrt);
  return half *
         (number(5) * number_in(at(f, middle - node)) + number(8) * number_in(at(f, middle)) +
          number(5) * number_in(at(f, middle + node))) /
         number(9);
}

inline World::World(const std::vector<Item>& items) {
  const auto give = [&](const char* name, Ball::ArbFunction f) {
    values[name] = Meaning([f](const Meaning& x) -> Meaning { return number_in(x).image(f); });
  };
  give("sin", arb_sin), give("cos", arb_cos), give("tan", arb_tan), give("cot", arb_cot),
      give("asin", arb_asin);
  give("acos", arb_acos), give("atan", arb_atan), give("exp", arb_exp), give("ln", arb_log),
      give("sqrt", arb_sqrt);
  give("sinh", arb_sinh), give("cosh", arb_cosh);
  values["Rabs"] = Meaning(
      [](const Meaning& x) -> Meaning { return number_in(x).is_negative() ? -*x.number : *x.number; });
  values["PI"] = Ball::pi(bits);
  for (const Item& item : items)
    if (item.kind == Item::Kind::definition) definitions[item.name] = item.text, values.erase(item.name);
}

inline Meaning World::named(const std::string& name, const LocalPtr& scope) {
  for (const Local* local = scope.get(); local != nullptr; local = local->next.get())
    if (local->name == name) return local->meaning;
  if (const auto found = values.find(name); found != values.end()) return found->second;
  if (const auto found = definitions.find(name); found != definitions.end()) return value(found->second);
  if (name.find_first_not_of("0123456789") == std::string::npos) return coq::number(cln::cl_I(name.c_str()));
  throw NoValue("nothing is known of " + name);
}

inline Meaning World::function(const Text& text, const LocalPtr& scope, std::size_t k) {
  if (k == text->binders.size()) return value(text->parts[0], scope);
  return Meaning([this, text, scope, k](const Meaning& x) {
    return function(text, std::make_shared<const Local>(Local{text->binders[k], x, scope}), k + 1);
  });
}

inline Meaning World::relation(const std::string& op, const std::function<Ball()>& left,
                               const std::function<Ball()>& right) {
  const auto side = [](const std::function<Ball()>& f) -> std::optional<Ball> {
    try {
      return f();
    } catch (const NoValue&) {
      return std::nullopt;
    }
  };
  const auto l = side(left), r = side(right);
  if (!l || !r) return Meaning::of(std::nullopt);
  const bool is_same = is_close(*l, *r);
  if (!is_same && is_close(*l, *r, 1e-15)) return Meaning::of(std::nullopt);  // a residual, or a difference?
  if (op == "=") return Meaning::of(is_same);
  if (op == "<>") return Meaning::of(!is_same);
  return Meaning::of(is_same ? op.size() == 2 : (op[0] == '<') == (*l < *r));
}

/// `forall x, is_RInt f a b (name x)`, `forall x, is_derive f x (name x)` in a text: then it says what the
/// function is.
inline LocalPtr World::inner_function(const Text& text, const std::string& name, const LocalPtr& scope) {
  if (text->head == "/\\")
    for (const Text& part : text->parts)
      if (const LocalPtr found = inner_function(part, name, scope)) return found;
  if (text->head != "forall" || text->parts[0]->head != "apply") return nullptr;
  const auto& parts = text->parts[0]->parts;
  const Text& last = parts.back();
  const bool is_integral = parts[0]->head == "is_RInt";
  if ((!is_integral && parts[0]->head != "is_derive") || last->head != "apply" ||
      last->parts[0]->head != name)
    return nullptr;
  const std::string x = text->binders[0];
  const Meaning f([this, parts, scope, x, is_integral](const Meaning& at) -> Meaning {
    const LocalPtr inside = std::make_shared<const Local>(Local{x, at, scope});
    if (!is_integral) return derivative(value(parts[1], inside), number_in(at));
    return integral(value(parts[1], inside), number(parts[2], inside), number(parts[3], inside));
  });
  return std::make_shared<const Local>(Local{name, f, scope});
}

inline Meaning World::quantified(const Text& text, const LocalPtr& scope, std::size_t k) {
  if (k == text->binders.size()) return value(text->parts[0], scope);
  const std::string& name = text->binders[k];
  if (text->head == "exists")
    if (const LocalPtr inside = inner_function(text->parts[0], name, scope))
      return quantified(text, inside, k + 1);
  const bool is_function = text->functions.contains(name);
  const auto with = [&](const Meaning& x) {
    return quantified(text, std::make_shared<const Local>(Local{name, x, scope}), k + 1);
  };
  const Text& body = text->parts[0];  // forall x, x = E -> …
  if (text->head == "forall" && body->head == "->" && body->parts[0]->head == "=" &&
      body->parts[0]->parts[0]->head == name)
    return with(value(body->parts[0]->parts[1], scope));
  if (text->head == "exists" || is_function) return Meaning::of(std::nullopt);
  std::optional<bool> all = true;
  for (const int twelfths : {-31, 0, 5, 13, 29}) {
    const auto one = with(coq::number(cln::cl_RA(twelfths) / 12)).truth;
    if (one == false) return Meaning::of(false);
    if (!one) all = std::nullopt;
  }
  const bool is_identity =
      body->head == "=" || (body->head == "apply" && body->parts[0]->head == "is_derive");
  return Meaning::of(all == true && is_inside_equivalence_ && !is_identity ? std::nullopt : all);
}

inline Meaning World::call(const Text& text, const LocalPtr& scope) {
  const auto& parts = text->parts;
  const std::string& name = parts[0]->head;
  if (name == "Derive") return derivative(value(parts[1], scope), number(parts[2], scope));
  if (name == "continuous") return Meaning::of(true);  // all functions here are smooth
  const auto as = [&](std::size_t k) {
    return [this, part = parts[k], scope] { return number(part, scope); };
  };
  if (name == "is_derive")
    return relation(
        "=", [&] { return derivative(value(parts[1], scope), number(parts[2], scope)); }, as(3));
  if (name == "is_RInt")
    return relation(
        "=",
        [&] { return integral(value(parts[1], scope), number(parts[2], scope), number(parts[3], scope)); },
        as(4));
  if (name == "tends_to") {
    const auto at_time = [&](const Meaning& t) {
      return [&, t] { return number_in(at(value(parts[1], scope), t)); };
    };
    const auto p = values.find("p");
    const Ball time = coq::number(40) / (p == values.end() ? coq::number(1) : number_in(p->second));
    const Ball late = at_time(time)() - number(parts[2], scope);
    return Meaning::of(std::abs(late.to_double()) < 1e-9);
  }
  Meaning result = value(parts[0], scope);
  for (std::size_t k = 1; k < parts.size(); ++k) result = at(result, value(parts[k], scope));
  return result;
}

inline Meaning World::value(const Text& text, const LocalPtr& scope) {
  const std::string& head = text->head;
  const auto& parts = text->parts;
  const auto side = [&](std::size_t k) { return number(parts[k], scope); };
  if (head == "apply") return call(text, scope);
  if (head == "fun") return function(text, scope, 0);
  if (head == "forall" || head == "exists") return quantified(text, scope, 0);
  if (head == "let")
    return value(parts[1],
                 std::make_shared<const Local>(Local{text->binders[0], value(parts[0], scope), scope}));
  if (parts.empty()) return named(head, scope);
  if (head == "+") return side(0) + side(1);
  if (head == "-") return side(0) - side(1);
  if (head == "*") return side(0) * side(1);
  if (head == "/") return side(0) / side(1);
  if (head == "neg") return -side(0);
  if (head == "inv") return coq::number(1) / side(0);
  if (head == "^") {
    Ball power = coq::number(1);
    for (long n = std::stol(parts[1]->head); n > 0; --n) power = power * side(0);
    return power;
  }
  const auto truth = [&](std::size_t k) { return holds(parts[k], scope); };
  if (head == "->") {
    auto first = truth(0), second = truth(1);
    if (first == false) second = true;
    return Meaning::of(second == true ? second : first ? second : std::nullopt);
  }
  if (head == "<->" || head == "/\\" || head == "\\/") {
    const bool was_inside = is_inside_equivalence_;
    is_inside_equivalence_ = was_inside || head == "<->";
    const auto first = truth(0), second = truth(1);
    is_inside_equivalence_ = was_inside;
    if (head == "<->") return Meaning::of(first && second ? std::optional(first == second) : std::nullopt);
    const bool stops = head == "\\/";
    if (first == stops || second == stops) return Meaning::of(stops);
    return Meaning::of(first && second ? std::optional(!stops) : std::nullopt);
  }
  return relation(
      head, [&] { return side(0); }, [&] { return side(1); });
}

}  // namespace rederive::coq
