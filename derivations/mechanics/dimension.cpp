// Finds the dimension of every node, from the leaves up, and names the terms where two disagree.
#include <algorithm>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/language/text.hpp>
#include <derivations/mechanics/dimension.hpp>
#include <sstream>

namespace rederive::mechanics {
using namespace language;

namespace {

using Kind = Node::Kind;

/// The dimension of a value; none for 0, which has any dimension.
using Maybe = std::optional<Dimension>;

const Dimension pure = {};

struct Inconsistent {
  std::string explanation;
};

std::string power_text(const char* unit, const GiNaC::numeric& power) {
  if (power == 1) return unit;
  std::ostringstream plain;
  plain << power;
  if (!power.is_integer()) return std::string(unit) + "^(" + plain.str() + ")";
  return unit + superscript(plain.str());
}

std::string named(const Dimension& dimension) {
  return dimension == pure ? "a pure number" : unit_text(dimension);
}

/// A term of a sum, and its name in messages.
struct LabelledTerm {
  std::string label;
  Maybe dimension;
};

/// Returns the dimension of all terms. If they differ, throws and names the odd ones and the dimension of
/// most terms, or the first of these: "term 3 is kg·m²/s, the others kg·m²/s²".
Maybe common(const std::vector<LabelledTerm>& terms, const std::string& where) {
  const auto count = [&](const Maybe& d) { return std::ranges::count(terms, d, &LabelledTerm::dimension); };
  Maybe usual;
  for (const LabelledTerm& term : terms)
    if (term.dimension && (!usual || count(term.dimension) > count(usual))) usual = term.dimension;
  std::string odd, last;
  for (const LabelledTerm& term : terms) {
    if (!term.dimension) continue;
    if (term.dimension == usual)
      last = term.label;
    else
      odd += (odd.empty() ? "" : " and ") + term.label + " is " + named(*term.dimension);
  }
  if (odd.empty()) return usual;
  const std::string others = count(usual) == 1 ? last + " is " : "the others ";
  throw Inconsistent{where + odd + ", " + others + named(*usual)};
}

Dimension scaled(Dimension dimension, const GiNaC::numeric& factor) {
  for (GiNaC::numeric& exponent : dimension) exponent *= factor;
  return dimension;
}

class Dimensions {
 public:
  explicit Dimensions(const Symbols& symbols) : symbols_(symbols) {}

  Maybe of(const Tree& tree) const {
    const Node& node = *tree;
    switch (node.kind) {
      case Kind::number:
        return cln::zerop(exact(node.text)) ? Maybe() : pure;
      case Kind::symbol:
        if (node.text == "pi") return pure;
        if (const Symbol* known = symbols_.find(node.text)) return parse_unit(known->unit);
        throw Inconsistent{"the unit of " + node.text + " is not known"};
      case Kind::negative:
        return of(node.children[0]);
      case Kind::sum:
        return common(terms(tree, "", ""), "in " + shown(tree) + ": ");
      case Kind::product:
        return product(node);
      case Kind::power:
        return power(node);
      case Kind::call:
        return call(node);
    }
    return std::nullopt;
  }

  /// Returns the terms of a sum, each with its label; any other tree is one term with its name.
  std::vector<LabelledTerm> terms(const Tree& tree, const std::string& name, const std::string& place) const {
    if (tree->kind != Kind::sum) return {{name, of(tree)}};
    std::vector<LabelledTerm> result;
    for (const Tree& term : tree->children)
      result.push_back({"term " + std::to_string(result.size() + 1) + place, of(term)});
    return result;
  }

 private:
  std::string shown(const Tree& tree) const { return print(tree, Notation::plain, symbols_); }

  Maybe product(const Node& node) const {
    Maybe total = pure;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Maybe factor = of(node.children[i]);
      if (!factor) total.reset();
      for (std::size_t k = 0; total && k < pure.size(); ++k)
        (*total)[k] += node.inverse[i] ? -(*factor)[k] : (*factor)[k];
    }
    return total;
  }

  Maybe power(const Node& node) const {
    const Tree &base = node.children[0], &exponent = node.children[1];
    const Maybe below = of(base);
    expect_pure(exponent, "the exponent " + shown(exponent));
    if (!below || *below == pure) return below;
    const GiNaC::ex value = lower(exponent, symbols_);
    if (!value.info(GiNaC::info_flags::rational))
      throw Inconsistent{shown(base) + " is " + named(*below) + ", and its exponent is not a number"};
    return scaled(*below, GiNaC::ex_to<GiNaC::numeric>(value));
  }

  Maybe call(const Node& node) const {
    const Tree& argument = node.children[0];
    if (node.text == "fabs") return of(argument);
    if (node.text != "sqrt") return expect_pure(argument, "the argument of " + node.text), pure;
    const Maybe radicand = of(argument);
    return radicand ? scaled(*radicand, GiNaC::numeric(1, 2)) : radicand;
  }

  void expect_pure(const Tree& tree, const std::string& what) const {
    const Maybe dimension = of(tree);
    if (dimension && *dimension != pure)
      throw Inconsistent{what + " is " + named(*dimension) + ", not " + named(pure)};
  }

  const Symbols& symbols_;
};

std::string side_name(std::size_t side, std::size_t sides) {
  if (sides == 1) return "term 1";
  if (sides == 2) return side == 0 ? "the left side" : "the right side";
  return "side " + std::to_string(side + 1);
}

}  // namespace

namespace {

/// The derived units, each in base units. A is a base unit.
constexpr std::pair<const char*, const char*> derived_units[] = {
    {"N", "kg*m/s^2"}, {"J", "kg*m^2/s^2"},     {"W", "kg*m^2/s^3"}, {"Pa", "kg/(m*s^2)"},
    {"Hz", "1/s"},     {"V", "kg*m^2/(s^3*A)"}, {"rad", "1"}};

/// Units with themselves in base units.
const Symbols& units_as_symbols() {
  static const Symbols units = [] {
    Symbols table;
    for (const char* unit : base_units) table.declare({unit, unit, unit, unit, "(0, inf)", "", ""});
    for (const auto& [name, in_base] : derived_units)
      table.declare({name, name, name, in_base, "(0, inf)", "", ""});
    return table;
  }();
  return units;
}

/// Returns the dimension of a product of powers of base units. Throws std::invalid_argument for other trees.
Dimension dimension_of_unit(const Tree& tree) {
  Dimension result = pure;
  if (tree->kind == Kind::symbol && tree->text != "pi") {
    const auto base = std::ranges::find(base_units, tree->text);
    if (base == base_units.end()) return parse_unit(units_as_symbols().find(tree->text)->unit);
    result[static_cast<std::size_t>(base - base_units.begin())] = 1;
  } else if (tree->kind == Kind::product) {
    for (std::size_t i = 0; i < tree->children.size(); ++i) {
      const Dimension factor = dimension_of_unit(tree->children[i]);
      for (std::size_t k = 0; k < result.size(); ++k) result[k] += tree->inverse[i] ? -factor[k] : factor[k];
    }
  } else if (tree->kind == Kind::power) {
    const GiNaC::ex exponent = lower(tree->children[1], units_as_symbols());
    if (!exponent.info(GiNaC::info_flags::rational)) throw std::invalid_argument("not a number");
    return scaled(dimension_of_unit(tree->children[0]), GiNaC::ex_to<GiNaC::numeric>(exponent));
  } else if (tree->text != "1") {
    throw std::invalid_argument("not a unit");
  }
  return result;
}

}  // namespace

Dimension parse_unit(std::string_view text) try {
  return dimension_of_unit(parse(text, units_as_symbols()));
} catch (const std::exception&) {  // SyntaxError among them
  throw std::invalid_argument(
      "a unit is written in kg, m, s, A, K, mol, cd, N, J, W, Pa, Hz, V and rad, such as 'kg*m^2/s^2', "
      "'s^4/(kg*m^2)' or '1', not '" +
      std::string(text) + "'");
}

std::string unit_text(const Dimension& dimension) {
  std::string above, below;
  for (std::size_t i = 0; i < dimension.size(); ++i) {
    if (dimension[i].is_zero()) continue;
    std::string& side = dimension[i].is_negative() ? below : above;
    side += (side.empty() ? "" : "·") + power_text(base_units[i], GiNaC::abs(dimension[i]));
  }
  if (above.empty()) above = "1";
  if (below.empty()) return above;
  const bool several = std::ranges::count_if(dimension, &GiNaC::numeric::is_negative) > 1;
  return above + "/" + (several ? "(" + below + ")" : below);
}

DimensionReport dimension(const Relation& relation, const Symbols& symbols) try {
  const std::vector<Tree>& sides = relation.sides;
  const bool several = std::ranges::count(sides, Kind::sum, [](const Tree& side) { return side->kind; }) > 1;
  std::vector<LabelledTerm> all;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::string name = side_name(i, sides.size());
    for (LabelledTerm& term : Dimensions(symbols).terms(sides[i], name, several ? " of " + name : ""))
      all.push_back(std::move(term));
  }
  return {true, common(all, ""), ""};
} catch (const Inconsistent& problem) {
  return {false, std::nullopt, problem.explanation};
}

DimensionReport dimension(const Tree& tree, const Symbols& symbols) {
  return dimension(Relation{{tree}, {}}, symbols);
}

}  // namespace rederive::mechanics
