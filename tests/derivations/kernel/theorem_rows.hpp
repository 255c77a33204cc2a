// Whether a text of Coq says what a row of the paper says: both are worth the same at 50 points.
#pragma once

#include <derivations/numbers/evaluate.hpp>
#include <tests/block.hpp>
#include <tests/derivations/kernel/coq_points.hpp>
#include <tests/derivations/kernel/theorem_tables.hpp>

namespace rederive::coq {

struct Names {
  std::set<std::string> numbers{"t"}, functions;
  Names(const Theorem& theorem, const Text& statement) : functions_(theorem.functions) {
    for (const Item& item : theorem.around) {
      if (item.kind == Item::Kind::number) numbers.insert(item.name);
      if (item.kind == Item::Kind::function) functions.insert(item.name);
    }
    bind(theorem.statement), bind(statement);
  }
  void bind(const Text& text) {
    for (const std::string& name : text->binders)
      (functions_.contains(name) ? functions : numbers).insert(name);
    for (const Text& part : text->parts) bind(part);
  }
  const std::set<std::string>& functions_;
};

/// The values of the row's symbols, as the theorem has them; throws NoValue where it has none.
struct Dictionary {
  const Theorem& theorem;
  const About& about;
  const Names& names;
  World& world;
  const Symbols& symbols;
  int side;
  bool has_start;

  Ball of(const std::string& symbol) const {
    if (const auto found = about.names.find(symbol); found != about.names.end()) return asked(found->second);
    const std::string name = symbol == "R" ? "R'" : symbol;
    if (names.numbers.contains(name)) return asked(name);
    if (names.functions.contains(name)) return asked(name + " t");
    if (symbol == "thetaddot" && names.functions.contains("thetadot")) return asked("Derive thetadot t");
    if (symbol == "t_star") return asked("t");
    if (const auto cut = symbol.rfind('_'); cut != std::string::npos) {
      const std::string base = symbol.substr(0, cut), at = symbol.substr(cut + 1);
      static const std::map<std::string, std::string> moments{
          {"ex", "T_ex"}, {"to", "t_o"}, {"i", "t_i"}, {"before", "t_i"}, {"after", "t_i"}, {"star", "t"}};
      const auto moment = moments.find(at);
      if (names.functions.contains(base) && (moment != moments.end() || at == "0"))
        return asked(base + " " + (at == "0" ? (has_start ? "0" : "t") : moment->second));
      if (names.numbers.contains(base) && at == "0") return asked(base);
    }
    if (const auto found = energies.find(symbol); found != energies.end())
      return side_other_than(symbol, right_form_of(side == 1 ? found->second.first : found->second.second));
    if (const auto found = meanings().find(symbol); found != meanings().end())
      return side_other_than(symbol, found->second);
    throw NoValue(theorem.name + " has no " + symbol);
  }
  Ball value(const Tree& tree) const {
    Point point;
    for (const std::string& name : names_of(tree)) point.emplace(name, Number(cln::cl_RA(of(name).middle())));
    const Value value = value_at(tree, point, bits);
    if (value.is != Value::Is::certain) throw NoValue("the row has no value");
    return value.ball().at(bits);
  }

 private:
  Ball asked(const std::string& text) const {
    const Text term = parse(text);
    std::set<std::string> used;
    names_in(term, used);
    for (const std::string& name : used)  // what the theorem binds
      if (!world.values.contains(name) &&
          (names.numbers.contains(name) || names.functions.contains(name) || name == "t"))
        world.values[name] = world.any(name, names.functions.contains(name));
    return world.number(term);
  }
  Ball side_other_than(const std::string& symbol, const std::string& text) const {
    const Relation r = parse_relation(text, symbols);
    return value(is_symbol(r.sides[0]) && r.sides[0]->text == symbol ? r.sides[1] : r.sides[0]);
  }
};

/// How a relation of a theorem may say what a row says.
enum class Way {
  same,
  turned,
  difference,
  turned_difference,
  left_is_named,
  right_is_named,
  left_is_residual,
  right_is_residual
};

inline bool says(const Atom& atom, Way way, const std::string& op, const std::optional<Ball>& l,
                 const Ball& r, bool is_derivation) {
  const bool is_equation =
      atom.op == "=" || atom.op == "~" || atom.op == "d" || !is_derivation;  // claims say on which side
  if (way == Way::left_is_named || way == Way::right_is_named) {
    const auto& side = way == Way::left_is_named ? atom.left : atom.right;
    return !l && side && is_equation && !(atom.op == "d" && way == Way::left_is_named) && op == "=" &&
           is_close(*side, r);
  }
  if (!l || !atom.left || !atom.right) return false;
  const Ball &a = *atom.left, &b = *atom.right;
  const bool is_turned = way == Way::turned || way == Way::turned_difference;
  const auto turned = [](std::string text) {
    return (text[0] = text[0] == '<' ? '>' : text[0] == '>' ? '<' : '='), text;
  };
  if ((is_equation ? "=" : is_turned ? turned(atom.op) : atom.op) != op) return false;
  switch (way) {
    case Way::same:
      return is_close(a, *l) && is_close(b, r);
    case Way::turned:
      return is_close(a, r) && is_close(b, *l);
    case Way::difference:
      return is_close(a - b, *l - r);
    case Way::turned_difference:
      return is_close(a - b, r - *l);
    case Way::left_is_residual:
      return atom.op == "~" && is_close(a, *l - r);
    default:
      return atom.op == "~" && is_close(b, *l - r);
  }
}

/// Whether it has the value of a function at 0.
inline bool speaks_of_start(const Text& text) {
  if (text->head == "apply" && text->parts[1]->head == "0") return true;
  return std::any_of(text->parts.begin(), text->parts.end(), speaks_of_start);
}

/// Whether some relation of a theorem has the row's values at 50 points; else why not.
inline std::string compare(const Theorem& theorem, const Text& statement, const About& about,
                           const std::string& text, const std::string& domain, int side) {
  const Symbols symbols = symbols_in(domain);
  const Relation row = parse_relation(text, symbols);
  if (row.operators.size() != 1) return "a chain";
  const Names names(theorem, statement);
  const bool is_derivation = theorem.name.starts_with("derivation_") || theorem.name.starts_with("instance_");
  const bool has_start = speaks_of_start(statement);
  const auto has_sign = [&](const std::string& name) {
    const Symbol* symbol = symbols.find(name);
    return symbol != nullptr && symbol->range.starts_with("(-");
  };
  std::set<std::pair<std::size_t, Way>> left;
  int compared = 0;
  std::string why = "its relations say something else";
  for (unsigned long seed = 1; compared < 50 && seed < (compared == 0 ? 20 : 200); ++seed) {
    World world(theorem.around);
    put_anywhere(world, theorem, seed, side, has_sign);
    std::vector<Atom> atoms;
    world.atoms = &atoms, world.wants_hypotheses = !is_derivation;
    world.holds(statement);
    world.atoms = nullptr;
    const Dictionary dictionary{theorem, about, names, world, symbols, side, has_start};
    std::optional<Ball> l;
    Ball r;
    try {
      r = dictionary.value(row.sides[1]);
    } catch (const NoValue& error) {
      why = error.what();
      continue;
    }
    try {
      l = dictionary.value(row.sides[0]);
    } catch (const NoValue& error) {
      why = error.what();
      if (!is_symbol(row.sides[0])) continue;
    }
    std::set<std::pair<std::size_t, Way>> here;
    for (std::size_t k = 0; k < atoms.size(); ++k)
      for (int way = 0; way < 8; ++way)
        if (says(atoms[k], Way(way), row.operators[0], l, r, is_derivation)) here.emplace(k, Way(way));
    if (compared++ == 0) left = here;
    std::erase_if(left, [&](const auto& one) { return !here.contains(one); });
    if (left.empty()) return why;
  }
  return compared == 50 ? "" : "only " + std::to_string(compared) + " points: " + why;
}

/// On the side of the row, or on both.
inline std::string compare(const Theorem& theorem, const Text& statement, const About& about,
                           const std::string& id) {
  const std::string domain = entries().at(id).row.domain,
                    text = about.is_printed ? entries().at(id).row.printed : right_form_of(id);
  std::string why;
  for (const int side : {1, -1})
    if (why.empty() && domain.find(side == 1 ? "theta >" : "theta <") == std::string::npos)
      why = compare(theorem, statement, about, text, domain, side);
  return why.empty() ? why : why + "; " + text;
}

}  // namespace rederive::coq
