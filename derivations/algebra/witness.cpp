#include <algorithm>
#include <array>
#include <cmath>
#include <derivations/algebra/witness.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <sstream>

namespace rederive {

void collect_names(const Tree& tree, std::set<std::string>& names) {
  if (tree->kind == Node::Kind::symbol && tree->text != "pi") names.insert(tree->text);
  for (const Tree& child : tree->children) collect_names(child, names);
}

void collect_numbers(const Tree& tree, std::set<double>& numbers) {
  std::set<std::string> names;
  collect_names(tree, names);
  if (const auto value = names.empty() ? evaluate(tree, {}, 15) : std::nullopt)
    if (cln::abs(*value) < cln::expt_pos(cln::cl_I(10), 60)) numbers.insert(cln::double_approx(*value));
  for (const Tree& child : tree->children) collect_numbers(child, numbers);
}

namespace {

double to_double(const End& end) {
  if (end.infinite != 0) return end.infinite * HUGE_VAL;
  return GiNaC::ex_to<GiNaC::numeric>(end.value.evalf()).to_double();
}

/// A rational number with a small denominator near `value`.
cln::cl_RA near(double value, double denominator) {
  return cln::rational(cln::cl_DF(std::floor(value * denominator + 0.5))) /
         cln::rational(cln::cl_DF(denominator));
}

constexpr int working_digits = 70;

/// An exact constant, rounded up (+1) or down (-1) to 45 digits if it is not rational.
cln::cl_RA rounded(const GiNaC::ex& value, int direction) {
  if (GiNaC::is_a<GiNaC::numeric>(value) && GiNaC::ex_to<GiNaC::numeric>(value).is_rational())
    return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
  const auto exactly = evaluate(to_tree(value, Symbols()), {}, working_digits);
  const cln::cl_I scale = cln::expt_pos(cln::cl_I(10), 45);
  const cln::cl_R scaled = exactly.value() * scale;
  return (direction > 0 ? cln::ceiling1(scaled) : cln::floor1(scaled)) / cln::cl_RA(scale);
}

/// A repeatable mixing of two small integers into [0, 1).
double mixed(unsigned a, unsigned b) {
  unsigned long long x = (a + 1) * 0x9E3779B97F4A7C15ULL + (b + 1) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 31)) * 0x94D049BB133111EBULL;
  x ^= x >> 29;
  return static_cast<double>(x >> 11) / 9007199254740992.0;
}

Tree number(const std::string& text) {
  Node node{};
  node.kind = Node::Kind::number;
  node.text = text;
  return std::make_shared<const Node>(std::move(node));
}

constexpr std::array small_numbers{0.4, 1.25, 0.75, 2.0, 0.5, 1.5, 3.0, 0.2, 1.75, 0.6};

}  // namespace

std::optional<cln::cl_R> value_of(const Tree& tree, const Point& point) {
  // evaluate gives significant digits, of which 0 has none: an odd constant beside it gives decimal places
  static const Tree offset = number("0.618033");
  Node beside{};
  beside.kind = Node::Kind::sum;
  beside.children = {offset, tree};
  beside.inverse = {false, false};
  const auto value = evaluate(std::make_shared<const Node>(std::move(beside)), point, working_digits);
  if (!value) return std::nullopt;
  return *value - exact(offset->text);
}

Points::Points(const std::set<std::string>& names, const Symbols& symbols, const std::set<double>& numbers) {
  for (const std::string& name : names) {
    const Symbol* symbol = symbols.find(name);
    const Interval i = symbol != nullptr ? parse_range(symbol->range) : Interval{};
    Range& range = ranges_[name] = {to_double(i.low), to_double(i.high), {}, {}, {}};
    if (i.low.infinite == 0) range.above = rounded(i.low.value, +1);
    if (i.high.infinite == 0) range.below = rounded(i.high.value, -1);
    if (i.low.closed) range.closed_ends.push_back(*range.above);
    if (i.high.closed) range.closed_ends.push_back(*range.below);
  }
  for (const double n :
       numbers)  // x, x², 1/x and e^x may be compared with it; the ordinary points pass small ones
    if (n > 5 || (n > 0 && n < 0.2))
      for (const double landmark : {n, std::sqrt(n), 1 / n, std::fabs(std::log(n))})
        if (landmark < 1e40 && landmark > 1e-40) landmarks_.push_back(landmark);
}

std::vector<std::string> Points::names() const {
  std::vector<std::string> result;
  for (const auto& [name, range] : ranges_) result.push_back(name);
  return result;
}

std::vector<cln::cl_RA> Points::closed_ends(const std::string& name) const {
  return ranges_.at(name).closed_ends;
}

namespace {

/// How far a value is from an end towards the inside; nothing where there is no end.
std::optional<cln::cl_R> distance(const End& end, int side, const cln::cl_R& value) {
  if (end.infinite != 0) return std::nullopt;
  const auto at = evaluate(to_tree(end.value, Symbols()), {}, working_digits);
  return (value - at.value()) * side;
}

}  // namespace

bool is_inside(const std::string& range, const cln::cl_R& value) {
  const auto keeps = [&](const End& end, int side) {
    const auto inside = distance(end, side, value);
    const bool is_rounded = !end.value.info(GiNaC::info_flags::rational);
    const bool is_there = inside && (is_rounded ? cln::abs(*inside) * cln::expt_pos(cln::cl_I(10), 60) < 1
                                                : cln::zerop(*inside));
    return !inside || (end.closed && is_there) || cln::plusp(*inside);
  };
  const Interval i = parse_range(range);
  return keeps(i.low, 1) && keeps(i.high, -1);
}

bool is_strictly_inside(const std::string& range, const cln::cl_R& value) {
  const auto keeps = [&](const End& end, int side) {
    const auto inside = distance(end, side, value);
    return !inside || cln::plusp(*inside);
  };
  const Interval i = parse_range(range);
  return keeps(i.low, 1) && keeps(i.high, -1);
}

bool Points::is_between(const std::string& name, double value) const {
  const Range& range = ranges_.at(name);
  return value > range.low && value < range.high;
}

/// To all digits.
bool Points::is_inside(const Range& range, const cln::cl_RA& value) {
  return (!range.above || *range.above < value) && (!range.below || value < *range.below);
}

/// Where doubles are too coarse for the range: x > 10^38, or between 10^20 and 10^20 + 1.
cln::cl_RA Points::exactly_inside(const Range& range, double value, unsigned index, unsigned place) {
  const cln::cl_RA part = near(0.1 + 0.8 * mixed(index, place), 1000);
  if (range.above && range.below) return *range.above + (*range.below - *range.above) * part;
  const cln::cl_RA size = near(std::fabs(value), 1) * part + part;
  return range.above ? *range.above + size : *range.below - size;
}

double Points::ordinary(const Range& range, unsigned index, unsigned place) const {
  const double part = mixed(index, place);
  if (std::isfinite(range.low) && std::isfinite(range.high))
    return range.low + (range.high - range.low) * (0.1 + 0.8 * part);
  double size = small_numbers[(index * 3 + place * 7) % small_numbers.size()] * (1 + 0.3 * (part - 0.5));
  if (index >= count)
    size = 2 * part;
  else if (index >= 8)
    size *= std::exp((index < 24 ? 6 : 16) * (mixed(place, index + 77) - 0.5));
  if (std::isfinite(range.low)) return range.low + size;
  if (std::isfinite(range.high)) return range.high - size;
  return mixed(place + 5, index + 11) < 0.5 ? size : -size;
}

/// Near the ends of a bounded range; above and below a landmark, on both sides of 0, in an unbounded one.
double Points::special(const Range& range, unsigned index, unsigned place) const {
  constexpr std::array ends{0.0001, 0.9999, 0.02, 0.98}, times{2.0, 0.5, 1.25, 0.75};
  const unsigned turn = place == 0 ? index : static_cast<unsigned>(1000 * mixed(index, place));
  if (std::isfinite(range.low) && std::isfinite(range.high))
    return range.low + (range.high - range.low) * ends[turn % ends.size()];
  if (landmarks_.empty()) return ordinary(range, index, place);
  const double size = landmarks_[turn % landmarks_.size()] * times[turn / landmarks_.size() % times.size()];
  if (std::isfinite(range.low)) return size > range.low ? size : range.low + size;
  if (std::isfinite(range.high)) return range.high - size;
  return turn / (landmarks_.size() * times.size()) % 2 == 0 ? size : -size;
}

Point Points::at(int index) const {
  Point point;
  unsigned place = 0;
  for (const auto& [name, range] : ranges_) {
    const auto k = static_cast<unsigned>(index);
    const bool is_special = index >= first_special && index < count;
    const double value = is_special ? special(range, k - first_special, place) : ordinary(range, k, place);
    // coarse numbers are easier on the hand; finer ones where an end of the range, or 0, is near
    double room = std::min(value - range.low, range.high - value);
    if (!std::isfinite(room)) room = std::fabs(value);
    for (const double denominator : {20., 1000., 1e6, 1e15, 0x1p100, 0x1p200}) {
      point[name] = near(value, denominator);
      const double coarse = cln::double_approx(point[name]);
      if (is_between(name, coarse) && std::fabs(coarse - value) <= 0.2 * room) break;
    }
    if (!is_inside(range, point[name])) point[name] = exactly_inside(range, value, k, place);
    ++place;
  }
  return point;
}

Point Points::with_zeros(int index) const {
  Point point = at(index);
  for (auto& [name, value] : point) {
    const std::vector<cln::cl_RA> ends = closed_ends(name);
    if (is_between(name, 0) || std::find(ends.begin(), ends.end(), cln::cl_RA(0)) != ends.end()) value = 0;
  }
  return point;
}

std::string rational_text(const cln::cl_RA& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string decimal_text(const cln::cl_RA& value) {
  int places = 0;
  cln::cl_RA whole = cln::abs(value);
  for (; cln::denominator(whole) != 1 && places < 60; ++places) whole = whole * 10;
  if (places == 0 || cln::denominator(whole) != 1) return rational_text(value);
  std::string digits = rational_text(whole);
  const auto after = static_cast<std::size_t>(places);
  if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
  return (cln::minusp(value) ? "-" : "") + digits.insert(digits.size() - after, ".");
}

}  // namespace rederive
