#include <cln/dfloat.h>
#include <cln/real.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/decide/problem.hpp>
#include <derivations/language/print.hpp>
#include <derivations/reader/generous.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/exercises/units.hpp>
#include <limits>
#include <sstream>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace paper;
namespace {

/// A unit: its name, its dimension in base units, and its size in those.
struct Unit {
  std::string name, si, factor;
};
constexpr auto table = R"(
m m 1  g m/s^2 981/100  Gal m/s^2 1/100
s s 1  sec s 1  min s 60  Hz 1/s 2*pi
kg kg 1  t kg 1000  N kg*m/s^2 1  Pa kg/m/s^2 1  bar kg/m/s^2 100000
J kg*m^2/s^2 1  Nm kg*m^2/s^2 1  kNm kg*m^2/s^2 1000  W kg*m^2/s^3 1
A A 1  V kg*m^2/s^3/A 1  C A*s 1  K K 1  mol mol 1
rad 1 1  deg 1 pi/180  percent 1 1/100)";

/// Returns the units of the table, and those with prefixes: cm, ms, kN.
const std::vector<Unit>& units() {
  static const auto list = [] {
    constexpr std::pair<const char*, const char*> prefixes[] = {
        {"n", "1/1000000000"}, {"u", "1/1000000"}, {"m", "1/1000"},  {"c", "1/100"},
        {"d", "1/10"},         {"k", "1000"},      {"M", "1000000"}, {"G", "1000000000"}};
    std::vector<Unit> all;
    std::istringstream words(table);
    for (Unit unit; words >> unit.name >> unit.si >> unit.factor;) all.push_back(unit);
    for (const char* base : {"m", "s", "Hz", "N", "Pa", "J", "W", "A", "V", "rad"})
      for (const auto& [prefix, size] : prefixes) {
        const Unit unit = *std::ranges::find(all, base, &Unit::name);
        const std::string name = prefix + unit.name;
        if (std::ranges::count(all, name, &Unit::name) == 0)
          all.push_back({name, unit.si, std::string(size) + "*" + unit.factor});
      }
    return all;
  }();
  return list;
}

const Symbols& unit_symbols() {
  static const Symbols table = [] {
    Symbols symbols;
    for (const auto& unit : units())
      symbols.declare({unit.name, unit.name, unit.name, unit.si, "(0, inf)", "a unit", "SI"});
    return symbols;
  }();
  return table;
}

const Symbols& no_symbols() {
  static const Symbols table;
  return table;
}

/// Returns a constant to all the digits of a double. Throws SyntaxError if it has no value.
double as_number(const Tree& tree) {
  const Value value = value_at(tree, {}, 256);
  if (value.is != Value::Is::certain)
    throw SyntaxError(Mistake::not_real, 0, "this has no value, or its value is too large");
  const auto largest = cln::rational(cln::cl_DF(std::numeric_limits<double>::max()));
  const cln::cl_RA number = value.ball().lower();
  if (cln::abs(number) > largest) throw SyntaxError(Mistake::not_real, 0, "this number is too large");
  return cln::double_approx(number);
}

/// Returns the value of a tree of numbers and units, in base units.
double base_value(const Tree& tree) {
  Tree sizes = tree;
  for (const auto& unit : units())
    sizes = language::put_in(sizes, unit.name, parse(unit.factor, no_symbols()));
  (void)lower(sizes, no_symbols());  // refuses what is undefined at once, such as 1/0
  return as_number(sizes);
}

bool has_unit(const Tree& tree) { return !names_of(tree).empty(); }

/// Returns whether a tree consists of units and their powers: m, s^2, (kg*m).
bool is_of_units(const Tree& tree) {
  if (tree->kind == Node::Kind::power) return is_of_units(tree->children[0]) && !has_unit(tree->children[1]);
  if (tree->kind != Node::Kind::product) return tree->kind == Node::Kind::symbol && has_unit(tree);
  const bool starts_with_one = tree->children[0]->text == "1" && tree->inverse[1];
  return std::all_of(tree->children.begin() + (starts_with_one ? 1 : 0), tree->children.end(), is_of_units);
}

/// Returns the number of significant digits of a decimal number; 0 for anything else.
int digits_of(const Tree& tree) {
  if (tree->kind == Node::Kind::negative) return digits_of(tree->children[0]);
  if (tree->kind != Node::Kind::number) return 0;
  int digits = 0;
  for (const char c : tree->text.substr(0, tree->text.find_first_of("eE")))
    if (c != '.') digits += digits > 0 || c != '0';
  return digits;
}

/// Returns the factors from `from` up to, but not including, `to` of a product.
Tree factors(const Tree& whole, std::size_t from, std::size_t to) {
  Node node{Node::Kind::product, "", {}, {}, whole->children[from]->position};
  if (whole->inverse[from]) node.children.push_back(number("1")), node.inverse.push_back(false);
  for (std::size_t k = from; k < to; ++k) {
    node.children.push_back(whole->children[k]);
    node.inverse.push_back(whole->inverse[k]);
  }
  return node.children.size() == 1 ? node.children[0] : std::make_shared<const Node>(std::move(node));
}

/// Returns the factors of a product without units and those with units, which must follow; nothing if they
/// are mixed.
std::optional<std::pair<Tree, Tree>> number_and_unit(const Tree& tree) {
  if (tree->kind != Node::Kind::product) return {};
  const auto first = std::ranges::find_if(tree->children, has_unit), end = tree->children.end();
  if (first == tree->children.begin() || first == end || !std::all_of(first, end, is_of_units)) return {};
  const auto at = static_cast<std::size_t>(first - tree->children.begin());
  return std::pair(factors(tree, 0, at), factors(tree, at, tree->children.size()));
}

/// Returns (a - b)*m for a - b*m: the only unit, at the end of a sum, belongs to the whole sum.
Tree with_unit_of_whole(const Tree& tree) {
  if (tree->kind != Node::Kind::sum) return tree;
  const auto& terms = tree->children;
  const auto last = number_and_unit(terms.back());
  if (!last || std::any_of(terms.begin(), terms.end() - 1, has_unit)) return tree;
  if (names_of(last->second) == std::set<std::string>{"percent"}) return tree;
  const auto measured = dimension(last->second, unit_symbols()).dimension;
  if (measured && *measured == Dimension{})  // a pure number
    throw SyntaxError(
        Mistake::ambiguous_unit, last->second->position,
        "is this the unit of the whole, as in (90 - 30) deg, or of the last term, as in 2 rad - 30 deg?");
  return product(with_child(tree, terms.size() - 1, last->first), last->second);
}

/// Returns the tree as text, with units after blanks: "(1.5 - 1.47) m", "2.69 1/s".
std::string echo(const Tree& tree, bool is_first = true) {
  const std::string text = as_typed(print(tree, Notation::plain, unit_symbols()));
  const bool is_sum = tree->kind == Node::Kind::sum || tree->kind == Node::Kind::negative;
  if (tree->kind == Node::Kind::sum && is_first) {
    std::string terms = echo(tree->children[0]);
    for (std::size_t k = 1; k < tree->children.size(); ++k)
      terms += (tree->inverse[k] ? " - " : " + ") + echo(tree->children[k], false);
    return terms;
  }
  if (tree->kind == Node::Kind::negative && is_first) return "-" + echo(tree->children[0], false);
  if (is_sum) return "(" + text + ")";
  const auto parts = number_and_unit(tree);
  return parts ? echo(parts->first, false) + " " + print(parts->second, Notation::plain, unit_symbols())
               : text;
}

/// Refuses a number that is followed by something other than a unit: "5 apples".
void complain_of_unit(const std::string& text) {
  const std::size_t at = text.find_first_not_of("0123456789.+-eE ");
  if (at == std::string::npos || at == 0 || !std::isalpha(static_cast<unsigned char>(text[at]))) return;
  if (text.find_first_of("(*", at) != std::string::npos || text.compare(at, 2, "pi") == 0) return;
  throw SyntaxError(
      Mistake::unknown_unit, at,
      "this is not a known unit; the units are m, cm, mm, s, ms, kg, N, J, rad, deg, g (gravity)");
}

bool has_number(const Tree& tree) {
  return tree->kind == Node::Kind::number || (tree->kind == Node::Kind::symbol && tree->text == "pi") ||
         std::ranges::any_of(tree->children, has_number);
}

Quantity quantity_of(const Tree& typed) {
  const Tree tree = with_unit_of_whole(typed);
  if (!has_unit(tree))
    return {.value = base_value(tree), .dimension = {}, .read_as = echo(tree), .digits = digits_of(tree)};
  if (!has_number(tree)) throw SyntaxError(Mistake::number_wanted, 0, "a number is expected before the unit");
  const DimensionReport report = dimension(tree, unit_symbols());
  if (!report.consistent)
    throw SyntaxError(Mistake::unit, 0, "the units do not fit together: " + report.explanation);
  const auto parts = number_and_unit(tree);
  return {
      .value = base_value(tree),
      .dimension = report.dimension,
      .read_as = echo(tree),
      .digits = parts ? digits_of(parts->first) : 0,
      .in_turns = std::ranges::any_of(names_of(tree), [](const auto& name) { return name.ends_with("Hz"); })};
}

}  // namespace

bool is_unit(const std::string& text) {
  try {
    const Tree tree = parse(text, unit_symbols());
    const DimensionReport report = dimension(tree, unit_symbols());
    return is_of_units(tree) && report.consistent && report.dimension;
  } catch (const std::exception&) {
    return false;
  }
}

std::pair<std::vector<Quantity>, std::string> quantities_in(const std::string& text) {
  try {
    const reader::Readings readings =
        reader::generous_readings(text, {.symbols = unit_symbols(), .units = true});
    std::vector<Quantity> all;
    for (const Relation& read : readings.all) {
      if (!read.operators.empty())
        throw SyntaxError(Mistake::relation, 0, "a number is expected here, without a relation sign");
      const Quantity quantity = quantity_of(read.sides[0]);
      const bool is_known = std::ranges::any_of(all, [&](const Quantity& other) {
        return other.value == quantity.value && other.dimension == quantity.dimension;
      });
      if (!is_known) all.push_back(quantity);
    }
    return {all, readings.reason};
  } catch (const SyntaxError& error) {
    if (error.mistake == Mistake::unknown_symbol) complain_of_unit(text);
    throw;
  }
}

Quantity parse_quantity(const std::string& text) {
  const auto [all, reason] = quantities_in(text);
  if (all.size() == 1) return all[0];
  throw SyntaxError(Mistake::ambiguous_unit, 0,
                    "it is not clear " + reason + ": " + all[0].read_as + " or " + all[1].read_as);
}

}  // namespace rederive::classroom
