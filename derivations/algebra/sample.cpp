#include <algorithm>
#include <derivations/algebra/sample.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

namespace {

constexpr int working_digits = 70, shown_digits = 30;

cln::cl_R power_of_ten(int exponent) {
  const cln::cl_I power = cln::expt_pos(cln::cl_I(10), std::abs(exponent));
  return exponent < 0 ? cln::cl_RA(1) / power : cln::cl_RA(power);
}

/// The text "0" where a value is 0 to all the places that can be had.
std::string shown(const Tree& tree, const Point& point, int digits) {
  if (const auto value = evaluate(tree, point, digits + 5)) return decimal(*value, digits);
  return value_of(tree, point) ? "0" : "undefined";
}

/// 0.4000 is 0.4.
std::string without_zeros(std::string text) {
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

bool is_well_inside(const std::string& range, const cln::cl_R& value) {
  const bool is_simple = cln:: instanceof
      (value, cln::cl_RA_ring) &&
          cln::denominator(cln::the<cln::cl_RA>(value)) < cln::expt_pos(cln::cl_I(10), 20);
  if (is_simple) return is_inside(range, value);
  const cln::cl_R margin = power_of_ten(-30) * cln::max(cln::cl_R(1), cln::abs(value));
  return cln::abs(value) < power_of_ten(30) && is_strictly_inside(range, value - margin) &&
         is_strictly_inside(range, value + margin);
}

Tree difference(const Tree& a, const Tree& b) {
  Node node{};
  node.kind = Node::Kind::sum;
  node.children = {a, b};
  node.inverse = {false, true};
  return std::make_shared<const Node>(std::move(node));
}

std::vector<Tree> trees_of(const Pair& pair) {
  std::vector<Tree> trees{pair.left, pair.right};
  for (const auto& [name, value] : pair.bound) trees.push_back(value);
  trees.insert(trees.end(), pair.never_zero.begin(), pair.never_zero.end());
  return trees;
}

namespace {

bool is_constant(const Tree& tree) {
  std::set<std::string> names;
  collect_names(tree, names);
  return names.empty();
}

/// The constant part, if any, that has no value though all of its parts do.
Tree part_without_value(const Tree& tree) {
  if (is_constant(tree) && value_of(tree, {})) return nullptr;
  for (const Tree& child : tree->children)
    if (Tree part = part_without_value(child)) return part;
  return is_constant(tree) ? tree : nullptr;
}

}  // namespace

std::string without_value(const Pair& pair) {
  constexpr std::size_t longest = 80;
  for (const Tree& tree : trees_of(pair))
    if (const Tree part = part_without_value(tree))
      if (const std::string text = print(part); text.size() <= longest) return "; none was found of " + text;
  return {};
}

Points points_for(const Pair& pair, const Symbols& symbols) { return points_for(trees_of(pair), symbols); }

Points points_for(const std::vector<Tree>& trees, const Symbols& symbols) {
  std::set<std::string> names;
  std::set<double> numbers;
  for (const Tree& tree : trees) collect_names(tree, names), collect_numbers(tree, numbers);
  return Points(names, symbols, numbers);
}

bool is_admitted(const Pair& pair, const Point& point, const Symbols& symbols) {
  for (const auto& [name, tree] : pair.bound) {
    const auto value = value_of(tree, point);
    if (!value || !is_well_inside(symbols.find(name)->range, *value)) return false;
  }
  return std::all_of(pair.never_zero.begin(), pair.never_zero.end(), [&](const Tree& tree) {
    const auto value = value_of(tree, point);
    return value && !is_nearly_zero(*value);  // a point of 40 digits may stand for one where it is 0
  });
}

bool is_claimed(const Pair& pair, const cln::cl_R& left, const cln::cl_R& right, const Symbols& symbols) {
  if (pair.name.empty()) return true;
  const std::string& range = symbols.find(pair.name)->range;
  return is_well_inside(range, left) || is_well_inside(range, right);
}

bool differ(const cln::cl_R& a, const cln::cl_R& b) {
  const cln::cl_R size = cln::max(cln::cl_R(1), cln::max(cln::abs(a), cln::abs(b)));
  return cln::abs(a - b) > size * power_of_ten(20 - working_digits);
}

bool certainly_differ(const Pair& pair, const Point& point) {
  const auto value = evaluate(difference(pair.left, pair.right), point, 3);
  return value && !cln::zerop(*value);
}

bool is_nearly_zero(const cln::cl_R& value) { return cln::abs(value) < power_of_ten(-35); }

Witness make_witness(const Pair& pair, const Point& point) {
  Witness witness;
  for (const auto& [name, value] : point) witness.at[name] = rational_text(value);
  for (int digits = shown_digits; digits <= 3 * working_digits;
       digits += 20) {  // more, where they differ further on
    witness.printed = shown(pair.left, point, digits);
    witness.derived = shown(pair.right, point, digits);
    if (without_zeros(witness.printed) != without_zeros(witness.derived)) break;
  }
  return witness;
}

Sample sample(const Pair& pair, const Points& points, const Symbols& symbols,
              const std::function<bool(const Sample&)>& enough, int most) {
  Sample seen;
  for (int k = 0; k < most && !enough(seen); ++k) {
    const Point point = points.at(k);
    const auto a = value_of(pair.left, point);
    const auto b = a ? value_of(pair.right, point) : std::nullopt;
    if (!b || !is_admitted(pair, point, symbols)) continue;
    ++seen.both;
    if (!seen.differs && differ(*a, *b) && is_claimed(pair, *a, *b, symbols)) seen.differs = point;
  }
  return seen;
}

}  // namespace rederive
