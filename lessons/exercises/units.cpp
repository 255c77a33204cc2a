#include <cln/dfloat.h>
#include <cln/real.h>
#include <fmt/format.h>

#include <cctype>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/exercises/units.hpp>
#include <limits>
#include <sstream>

namespace rederive::classroom {
namespace {

/// A unit, what it measures in base units, and its size in those.
struct Unit {
  std::string name, si, factor;
};
constexpr auto table = R"(
m m 1  cm m 1/100  mm m 1/1000  km m 1000  g m/s^2 981/100
s s 1  sec s 1  ms s 1/1000  min s 60  Hz 1/s 2*pi
kg kg 1  t kg 1000  N kg*m/s^2 1  kN kg*m/s^2 1000  Pa kg/m/s^2 1
J kg*m^2/s^2 1  kJ kg*m^2/s^2 1000  Nm kg*m^2/s^2 1  W kg*m^2/s^3 1
rad 1 1  deg 1 pi/180  percent 1 1/100)";

const std::vector<Unit>& units() {
  static const auto list = [] {
    std::vector<Unit> all;
    std::istringstream words(table);
    for (Unit unit; words >> unit.name >> unit.si >> unit.factor;) all.push_back(unit);
    return all;
  }();
  return list;
}

const Symbols& unit_symbols() {
  static const Symbols table = [] {
    Symbols symbols;
    for (const auto& unit : units())
      symbols.declare(unit.name, unit.name, unit.name, unit.si, "(0, inf)", "a unit", "SI");
    return symbols;
  }();
  return table;
}

const Symbols& no_symbols() {
  static const Symbols table;
  return table;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// A constant, to all the digits of a double.
double as_number(const Tree& tree) {
  const Value value = value_at(tree, {}, 256);
  if (value.is != Value::Is::certain)
    throw SyntaxError("not_real", 0, "no value of this can be found: it has none, or one that is too large");
  const auto largest = cln::rational(cln::cl_DF(std::numeric_limits<double>::max()));
  const cln::cl_RA number = value.ball().lower();
  if (cln::abs(number) > largest) throw SyntaxError("not_real", 0, "this number is too large");
  return cln::double_approx(number);
}

/// The size of a unit such as "m/s^2" and what it measures.
std::pair<double, Dimension> read_unit(const std::string& text) {
  const Tree tree = parse(text, unit_symbols());
  GiNaC::exmap sizes;
  for (const auto& unit : units())
    sizes[unit_symbols()[unit.name]] = lower(parse(unit.factor, no_symbols()), no_symbols());
  const auto report = dimension(tree, unit_symbols());
  if (names_of(tree).empty()) throw SyntaxError("unit", 0, "this is no unit: " + text);
  if (!report.consistent || !report.dimension) throw SyntaxError("unit", 0, "this is no unit: " + text);
  const GiNaC::ex size = lower(tree, unit_symbols()).subs(sizes);
  return {as_number(to_tree(size, no_symbols())), *report.dimension};
}

/// The significant digits of a plain decimal number; 0 of anything else.
int digits_of(const Tree& tree) {
  if (tree->kind == Node::Kind::negative) return digits_of(tree->children[0]);
  if (tree->kind != Node::Kind::number) return 0;
  int digits = 0;
  for (const char c : tree->text.substr(0, tree->text.find_first_of("eE")))
    if (c != '.') digits += digits > 0 || c != '0';
  return digits;
}

/// "m s⁻²" as "m*s⁻²": between the units of a product a blank is enough.
std::string with_stars(const std::string& unit) {
  std::string result;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool between = unit[i] == ' ' && i > 0 && i + 1 < unit.size() &&
                         std::isalpha(static_cast<unsigned char>(unit[i + 1])) &&
                         std::string_view("*/(").find(unit[i - 1]) == std::string_view::npos;
    result += between ? '*' : unit[i];
  }
  return result;
}

/// Where a unit may begin: at a letter, at a sign of division before one, or behind a blank.
bool may_split(const std::string& text, std::size_t at) {
  const unsigned char c = static_cast<unsigned char>(text[at]);
  return std::isalpha(c) || c == '/' || text[at - 1] == ' ';
}

std::optional<Quantity> split_at(const std::string& text, std::size_t at) {
  try {
    std::string left = text.substr(0, at);
    if (left.ends_with('*')) left.pop_back();  // "0.3*g"
    std::string right = text.substr(at);
    if (right[0] == '/') right = "1" + right;
    right = with_stars(right);
    const Tree tree = parse(left, no_symbols());
    (void)lower(tree, no_symbols());  // refuses what is undefined at once, such as 1/0
    const double number = as_number(tree);
    const auto [size, what] = read_unit(right);
    return Quantity{number * size, what, print(tree) + " " + right, digits_of(tree)};
  } catch (const std::exception&) {  // no number, no unit, or one that has no size: m/(100*cm-m)
    return {};
  }
}

/// A number with something behind it that is no unit: "5 apples".
void complain_of_unit(const std::string& text) {
  const std::size_t at = text.find_first_not_of("0123456789.+-eE ");
  if (at == std::string::npos || at == 0 || !std::isalpha(static_cast<unsigned char>(text[at]))) return;
  if (text.find_first_of("(*", at) != std::string::npos || text.compare(at, 2, "pi") == 0) return;
  throw SyntaxError("unknown_unit", at,
                    "this is no unit known here; m, cm, mm, s, ms, kg, N, J, rad, deg, g (gravity) are");
}

}  // namespace

bool is_unit(const std::string& text) {
  try {
    (void)read_unit(text);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

Quantity parse_quantity(const std::string& typed) {
  std::string text = typed;
  replace_all(text, "°", " deg");
  replace_all(text, "%", " percent");
  replace_all(text, "·", "*");
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos)
    throw SyntaxError("decimal_comma", comma, "write decimal fractions with a point: 0.25");
  constexpr std::size_t longest =
      40;  // of a unit; without a bound, a long text would be parsed at each letter
  for (std::size_t at = text.size() > longest ? text.size() - longest : 1; at < text.size(); ++at)
    if (may_split(text, at))
      if (auto quantity = split_at(text, at)) return *quantity;
  complain_of_unit(text);
  const Tree tree = parse(text, no_symbols());
  (void)lower(tree, no_symbols());
  return {as_number(tree), {}, print(tree), digits_of(tree)};
}

}  // namespace rederive::classroom
