// Points: what the names of a theorem are worth there.
#pragma once

#include <sstream>
#include <tests/block.hpp>
#include <tests/derivations/kernel/coq_values.hpp>

namespace rederive::coq {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;

/// The same for the same name and point everywhere.
inline unsigned long mixed(const std::string& name, unsigned long seed) {
  unsigned long h = 1469598103934665603UL + seed * 7919;
  for (const char c : name + "#") h = (h ^ static_cast<unsigned char>(c)) * 1099511628211UL;
  return h >> 20;
}
/// Between 1/10 and 6/5, of either sign where that is allowed.
inline cln::cl_RA fraction_of(const std::string& name, unsigned long seed, bool has_sign = false) {
  const unsigned long h = mixed(name, seed);
  const cln::cl_RA size = cln::cl_RA(static_cast<long>(h % 97 + 9)) / 88;
  return has_sign && h / 97 % 2 == 1 ? -size : size;
}

/// "u_gddot" is the second derivative of "u_g".
struct Derived {
  explicit Derived(std::string name) : of(std::move(name)) {
    const auto dot = of.find("dot");
    if (dot == std::string::npos) return;
    const bool is_second = dot > 0 && of[dot - 1] == 'd';
    order = is_second ? 2 : 1, of = of.substr(0, dot - (is_second ? 1 : 0));
    if (of.ends_with('_')) of.pop_back();
  }
  std::string of;
  int order = 0;
};
/// "theta#2": what the second derivative is at t.
inline std::string coefficient(const std::string& name, int k) { return name + "#" + std::to_string(k); }
/// A polynomial of the fifth degree by the name of the function, or its derivative.
inline Meaning polynomial(World& world, const std::string& name, unsigned long seed) {
  const Derived which(name);
  for (int k = 0; k <= 5; ++k) {
    const std::string c = coefficient(which.of, k);
    if (!world.values.contains(c)) world.values[c] = coq::number(fraction_of(c, seed, true));
  }
  return Meaning([which, &world](const Meaning& x) -> Meaning {
    const Ball t = number_in(x) - number_in(world.values.at("t"));
    Ball result = coq::number(0), power = coq::number(1);
    for (int k = which.order, factorial = 1; k <= 5; ++k, factorial *= k - which.order) {
      result = result + number_in(world.values.at(coefficient(which.of, k))) * power / coq::number(factorial);
      power = power * t;
    }
    return result;
  });
}

/// Some point, by a seed; side is 1 where theta < 0, -1 where theta > 0. `has_sign` are names of what may be
/// negative.
inline void put_anywhere(World& world, const Theorem& theorem, unsigned long seed, int side,
                         const std::function<bool(const std::string&)>& has_sign) {
  world.values["t"] = coq::number(fraction_of("t", seed, has_sign("t")));
  for (const Item& item : theorem.around) {
    if (item.kind == Item::Kind::function) world.values[item.name] = polynomial(world, item.name, seed);
    if (item.kind == Item::Kind::number)
      world.values[item.name] = coq::number(fraction_of(item.name, seed, has_sign(item.name)));
    if (item.name == "side") world.values["side"] = coq::number(side);
  }
}

/// A theorem as hypotheses and conclusion; what it binds has moved into `around`.
struct Parts {
  std::vector<Item> around;
  std::vector<Text> hypotheses;
  Text conclusion;
};
inline void split(const Text& text, std::vector<Text>& links) {
  if (text->head == "/\\") {
    for (const Text& part : text->parts) split(part, links);
  } else if (text->head == "forall" && text->binders.size() == 1 && text->parts[0]->head == "/\\") {
    for (const Text& part : text->parts[0]->parts)
      split(term("forall", {part}, text->binders, text->functions), links);
  } else if (text->head == "forall" && text->binders.size() == 1 && text->parts[0]->head == "->" &&
             text->parts[0]->parts[0]->head == "=" &&
             text->parts[0]->parts[0]->parts[0]->head == text->binders[0] &&
             text->parts[0]->parts[1]->head == "=") {  // forall x, x = E -> a = b
    const auto with = [&](const Text& side) {
      return term("let", {text->parts[0]->parts[0]->parts[1], side}, text->binders);
    };
    links.push_back(
        term("=", {with(text->parts[0]->parts[1]->parts[0]), with(text->parts[0]->parts[1]->parts[1])}));
  } else if (text->head == "apply" && text->parts[0]->head == "is_derive") {
    links.push_back(
        term("=", {term("apply", {term("Derive"), text->parts[1], text->parts[2]}), text->parts[3]}));
  } else {
    links.push_back(text);
  }
}
/// `lagrange t`, where that is an equation.
inline Text unfolded(const Text& text, const std::vector<Item>& items) {
  if (text->head != "apply" || text->parts.size() != 2) return text;
  for (const Item& item : items)
    if (item.kind == Item::Kind::definition && item.name == text->parts[0]->head &&
        item.text->head == "fun" && item.text->parts[0]->head == "=") {
      const auto with = [&](const Text& side) {
        return term("let", {text->parts[1], side}, item.text->binders);
      };
      return term("=", {with(item.text->parts[0]->parts[0]), with(item.text->parts[0]->parts[1])});
    }
  return text;
}
inline Parts parts_of(const Theorem& theorem) {
  Parts result{theorem.around, {}, theorem.statement};
  for (const Item& item : theorem.around)
    if (item.kind == Item::Kind::hypothesis) split(item.text, result.hypotheses);
  for (Text& rest = result.conclusion;;) {
    if (rest->head == "forall")
      for (const std::string& name : rest->binders)
        result.around.push_back(
            {theorem.functions.contains(name) ? Item::Kind::function : Item::Kind::number, name, nullptr});
    else if (rest->head == "let")
      result.around.push_back({Item::Kind::definition, rest->binders[0], rest->parts[0]});
    else if (rest->head == "->")
      split(unfolded(rest->parts[0], theorem.around), result.hypotheses);
    else
      return result;
    rest = rest->parts.back();
  }
}

/// A point at which equations and inequalities hold: they say what a symbol or a function is, or are solved
/// for one.
class Solver {
 public:
  /// `known` are motions and numbers that equations of motion ask for.
  Solver(const Theorem& theorem, const Parts& parts, unsigned long seed,
         const std::map<std::string, std::string>& known = {})
      : world(parts.around), hypotheses_(parts.hypotheses), seed_(seed) {
    Theorem all = theorem;
    all.around = parts.around;
    put_anywhere(world, all, seed, seed % 2 == 0 ? 1 : -1,
                 [seed](const std::string& name) { return mixed(name, seed) % 5 == 0; });
    for (const Item& item : parts.around) {
      if (item.kind == Item::Kind::number && item.name != "side") free_.push_back(item.name);
      if (item.kind == Item::Kind::function) functions_.insert(item.name);
    }
    for (const auto& [name, meaning] : world.values)
      if (name.find('#') != std::string::npos) free_.push_back(name);
    for (const auto& [name, text] : known) {
      if (functions_.contains(name))
        formulas_[name] = parse(text), world.values[name] = world.value(term("fun", {parse(text)}, {"t"}));
      else
        world.values.erase(name), world.definitions[name] = parse(text), std::erase(free_, name);
    }
    make_positive();
    for (int pass = 0; pass < 2; ++pass)
      for (const Text& h : hypotheses_) define_function(h);
    for (const Text& h : hypotheses_) define(h);
    for (const Text& h : hypotheses_) satisfy(h);
    settle();
  }
  World world;

  bool meets(const Text& text) { return world.holds(text) == true; }
  bool meets_all() {
    return std::all_of(hypotheses_.begin(), hypotheses_.end(), [&](const Text& h) { return meets(h); });
  }
  /// Makes an equation hold, where it can.
  void satisfy(const Text& equation) {
    if (equation->head != "=" || meets(equation)) return;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const std::string name = free_[(k + seed_) % free_.size()];
      if (!uses(equation, name) || !solve(equation, name)) continue;
      std::erase(free_, name), solved_.emplace_back(equation, name);
      return;
    }
  }
  /// Each equation once more, as the others have moved it.
  void settle() {
    for (int sweep = 0; sweep < 4; ++sweep)
      for (const auto& [equation, name] : solved_)
        if (!meets(equation)) solve(equation, name);
  }
  /// "alpha = 1/2, p = 3"
  std::string point() {
    std::string text;
    for (const auto& [name, meaning] : world.values)
      if (meaning.number && name != "PI") {
        std::ostringstream value;
        value << meaning.number->to_double();
        text += " " + name + " = " + value.str();
      }
    return text;
  }

 private:
  bool is_free(const std::string& name) const { return std::count(free_.begin(), free_.end(), name) > 0; }
  bool uses(const Text& text, const std::string& name) {
    std::set<std::string> names, seen;
    names_in(text, names);
    while (!names.empty()) {
      const std::string next = *names.begin();
      names.erase(names.begin());
      if (next == name) return true;
      if (!seen.insert(next).second) continue;
      if (const auto found = world.definitions.find(next); found != world.definitions.end())
        names_in(found->second, names);
      if (const auto found = formulas_.find(next); found != formulas_.end())
        names_in(found->second, names);
      else if (functions_.contains(next))
        for (int k = 0; k <= 5; ++k) names.insert(coefficient(Derived(next).of, k));
    }
    return false;
  }
  /// Of hypotheses "0 < x".
  void make_positive() {
    for (const Text& h : hypotheses_)
      if (h->head == "<" && h->parts[0]->head == "0" && is_free(h->parts[1]->head))
        world.values[h->parts[1]->head] = coq::number(fraction_of(h->parts[1]->head, seed_));
  }
  /// forall t, f t = E; forall t, f t / p = E; forall t, is_derive f t (g t)
  void define_function(const Text& h) {
    if (h->head != "forall") return;
    const Text& body = h->parts[0];
    const auto put = [&](const Text& applied, const Text& value) {
      const std::string& name = applied->parts[0]->head;
      if (applied->head != "apply" || !functions_.contains(name) || formulas_.contains(name)) return;
      formulas_[name] = value;
      world.values[name] = world.value(term("fun", {value}, h->binders));
    };
    if (body->head == "=") {
      const Text& left = body->parts[0];
      if (left->head == "/")
        put(left->parts[0], term("*", {left->parts[1], body->parts[1]}));
      else
        put(left, body->parts[1]);
    } else if (body->head == "apply" && body->parts[0]->head == "is_derive" &&
               formulas_.contains(body->parts[1]->head)) {
      put(body->parts[3], term("apply", {term("Derive"), body->parts[1], body->parts[2]}));
    }
  }
  /// x = E
  void define(const Text& equation) {
    if (equation->head != "=" || meets(equation)) return;
    for (const std::size_t k : {0, 1}) {
      const Text &name = equation->parts[k], &other = equation->parts[1 - k];
      if (!is_free(name->head) || uses(other, name->head)) continue;
      world.values.erase(name->head), world.definitions[name->head] = other, std::erase(free_, name->head);
      return;
    }
  }
  /// By secants.
  bool solve(const Text& equation, const std::string& name) {
    const Meaning before = world.values.at(name);
    const auto residual = [&](const Ball& x) {
      world.values[name] = x.middle().at(bits);
      return world.number(equation->parts[0]) - world.number(equation->parts[1]);
    };
    try {
      Ball x = *before.number, y = x + coq::number(cln::cl_RA(1) / 97), f = residual(x);
      for (int step = 0; step < 30; ++step) {
        const Ball g = residual(y);
        if (std::abs(g.to_double()) < 1e-50 && std::abs(y.to_double()) < 20) return true;
        const Ball next = (y - g * (y - x) / (g - f)).middle();
        x = y, f = g, y = next;
        if (!y.is_finite()) break;
      }
    } catch (const NoValue&) {
    }
    world.values[name] = before;
    return false;
  }

  std::vector<Text> hypotheses_;
  std::vector<std::string> free_;
  std::vector<std::pair<Text, std::string>> solved_;
  std::set<std::string> functions_;
  std::map<std::string, Text> formulas_;
  unsigned long seed_;
};

}  // namespace rederive::coq
