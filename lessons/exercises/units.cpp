#include <cln/dfloat.h>
#include <cln/real.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <derivations/decide/problem.hpp>
#include <derivations/language/print.hpp>
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
m m 1  cm m 1/100  mm m 1/1000  km m 1000  g m/s^2 981/100  Gal m/s^2 1/100
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

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// A text translated into our syntax, in which units need a sign of multiplication. It keeps, for each byte,
/// the place in the text that was typed.
class Typed {
 public:
  explicit Typed(const std::string& typed) : typed_(typed) {
    while (at_ < typed_.size()) read();
  }
  const std::string& text() const { return text_; }
  std::size_t place(std::size_t at) const { return at < places_.size() ? places_[at] : typed_.size(); }

 private:
  void add(const std::string& more) {
    text_ += more;
    places_.insert(places_.end(), more.size(), at_);
  }

  /// Returns whether an operand ends here. Then a unit that comes next is a factor.
  bool ends_operand() const {
    const std::size_t last = text_.find_last_not_of(' ');
    return last != std::string::npos &&
           std::string_view("+-*/^(,=<>_").find(text_[last]) == std::string::npos;
  }

  void read() {
    static const std::vector<std::pair<std::string, std::string>> signs{
        {"·", "*"}, {"⋅", "*"}, {"×", "*"}, {" x 10^", "*10^"}, {"÷", "/"}, {"−", "-"}};
    for (const auto& [sign, meant] : signs)
      if (typed_.compare(at_, sign.size(), sign) == 0) return take(meant, sign.size());
    if (typed_.compare(at_, 2, "°") == 0) return take_unit("deg", 2);
    if (typed_[at_] == '%') return take_unit("percent", 1);
    const char before = at_ > 0 ? typed_[at_ - 1] : ' ';
    std::size_t end = at_;
    while (end < typed_.size() && is_letter(typed_[end])) ++end;
    const std::string word = typed_.substr(at_, end - at_);
    if (before != '_' && unit_symbols().find(word) != nullptr) return take_unit(word, word.size());
    if (!word.empty()) return take(word, word.size());
    if (before == ' ' && typed_[at_] == '1' && is_reciprocal()) return take("", 1);
    if (typed_[at_] == '(' && is_unit_in_parentheses()) add("*");
    take(typed_.substr(at_, 1), 1);
  }
  void take(const std::string& meant, std::size_t size) {
    add(meant);
    at_ += size;
  }
  void take_unit(const std::string& name, std::size_t size) {
    if (ends_operand()) add("*");
    take(name, size);
    const auto digit = [this](std::size_t at) { return at < typed_.size() && std::isdigit(typed_[at]) != 0; };
    if (digit(at_) && !digit(at_ + 1) && typed_[at_] > '1') add("^");  // m/s2
  }

  /// Returns whether the 1 here begins a unit, as in 2.69 1/s.
  bool is_reciprocal() const {
    const std::size_t name = typed_.find_first_not_of(' ', at_ + 2);
    return ends_operand() && typed_.compare(at_ + 1, 1, "/") == 0 && name != std::string::npos &&
           is_letter(typed_[name]);
  }
  bool is_unit_in_parentheses() const {
    const std::size_t end = typed_.find(')', at_);
    return ends_operand() && end != std::string::npos && end - at_ < 40 &&
           is_unit(typed_.substr(at_ + 1, end - at_ - 1));
  }

  const std::string& typed_;
  std::string text_;
  std::vector<std::size_t> places_;
  std::size_t at_ = 0;
};

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

/// Refuses 0,25, and says how to write it.
void refuse_comma(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return;
  std::string meant = text;
  const bool is_plain = text.find('.') == std::string::npos && text.find(',', comma + 1) == std::string::npos;
  throw SyntaxError(
      Mistake::decimal_comma, comma,
      "write decimal fractions with a point" + (is_plain ? ": " + meant.replace(comma, 1, ".") : ""));
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
  return {.value = base_value(tree),
          .dimension = report.dimension,
          .read_as = echo(tree),
          .digits = parts ? digits_of(parts->first) : 0,
          .in_turns = names_of(tree).contains("Hz")};
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

Quantity parse_quantity(const std::string& text) {
  refuse_comma(text);
  const Typed typed(text);
  try {
    return quantity_of(parse(typed.text(), unit_symbols()));
  } catch (const SyntaxError& error) {
    if (error.mistake == Mistake::unknown_symbol) complain_of_unit(text);
    const bool is_product =
        error.mistake == Mistake::implicit_multiplication;  // what the parser would write has units
    throw SyntaxError(error.mistake, error.position == 0 ? 0 : typed.place(error.position),
                      is_product ? "a product needs its '*'" : error.what());
  }
}

}  // namespace rederive::classroom
