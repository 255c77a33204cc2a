#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/rearrange.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

Tree written_residual(const Link& link) {
  return link.op[0] == '<' ? difference(link.right, link.left) : difference(link.left, link.right);
}

/// What is not 0 where a statement means anything: what it divides by, and what was declared so.
std::vector<ex> divisors_of(const Relation& relation, const Question& question) {
  std::vector<ex> result;
  for (const Tree& side : relation.sides)
    for (const ex& divisor : divisors(side, question.symbols))
      result.push_back(put_in(divisor, question.given));
  for (const ex& e : question.symbols.never_zero()) result.push_back(put_in(e, question.given));
  return result;
}

/// With trees for names.
Tree put_in(const Tree& tree, const std::map<std::string, Tree>& given) {
  if (given.empty()) return tree;
  if (const auto found = given.find(tree->text); tree->kind == Node::Kind::symbol && found != given.end())
    return found->second;
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = put_in(child, given);
  return copy;
}

std::optional<ex> squared_residual(const Sides& sides, const Symbols& symbols) {
  const auto squares = squared(sides, symbols);
  return squares ? std::optional(residual_of(*squares)) : std::nullopt;
}

/// Narrows the range of a symbol to what also holds for it, as far as a range can say that.
void narrow_to(const Interval& other, const ex& name, Symbols& symbols) {
  const Symbol* symbol = symbols.find(name);
  if (symbol == nullptr) return;
  const auto text = [&](const End& end) {
    return end.infinite != 0 ? std::string(end.infinite < 0 ? "-inf" : "inf")
                             : print(end.value, Notation::plain, symbols);
  };
  const auto narrow_by = [&](const Interval& interval) {
    const Interval both = overlap(parse_range(symbol->range), interval);
    const std::string range = (both.low.closed ? "[" : "(") + text(both.low) + ", " + text(both.high) +
                              (both.high.closed ? "]" : ")");
    const bool is_room =
        both.low.infinite != 0 || both.high.infinite != 0 || compare(both.low.value, both.high.value) < 0;
    (void)parse_range(range);
    if (is_room) symbols.narrow(symbol->name, range);
  };
  for (const Interval& half : {Interval{other.low, {0, 1}}, Interval{{0, -1}, other.high}}) try {
      narrow_by(half);
    } catch (const std::exception&) {  // too close to tell, or a number that no range has
    }
}

/// Where a symbol may be.
struct Stretch {
  std::string name;
  Interval line;
};

/// Where a residual of one symbol is positive, or not negative, or 0: one that is linear in it, or 1 - x^2.
std::optional<Stretch> stretch(const ex& residual, Claim claim, const Symbols& symbols) {
  const ex value = residual.expand();
  const auto names = names_in(value);
  const Symbol* symbol = names.size() == 1 ? symbols.find(*names.begin()) : nullptr;
  if (symbol == nullptr || !value.is_polynomial(symbol->ginac)) return std::nullopt;
  const ex &x = symbol->ginac, rest = value.coeff(x, 0);
  const bool weak = claim != Claim::positive;
  Stretch result{symbol->name, {}};
  if (value.degree(x) == 1) {
    const End end{-rest / value.coeff(x, 1), 0, weak};
    const int sign = sign_of(value.coeff(x, 1), symbols);
    if (sign > 0 || claim == Claim::zero) result.line.low = end;
    if (sign < 0 || claim == Claim::zero) result.line.high = end;
    return sign != 0 ? std::optional(result) : std::nullopt;
  }
  if (claim == Claim::zero || !(value - (1 - x * x)).expand().is_zero()) return std::nullopt;
  result.line = {{-1, 0, weak}, {1, 0, weak}};
  return result;
}

/// Where the sides have values, as far as stretches of single symbols say that.
std::vector<Stretch> stretches_with_values(const Relation& relation, const Question& question) {
  std::vector<Stretch> result;
  for (const Tree& side : relation.sides)
    for (const std::string& text : side_conditions(side, question.symbols)) {
      if (text.find("!=") != std::string::npos) continue;
      const Relation condition = parse_statement(text, question.symbols);
      const ex value = put_in(lower(condition.sides[0], question.symbols), question.given);
      if (const auto line = stretch(value, claim_of(condition.operators[0]), question.symbols))
        result.push_back(*line);
    }
  return result;
}

/// Whether all that holds in a relation, and lies on the stretches where that has values, lies on others.
bool implies(const Relation& relation, const std::vector<Stretch>& lines, const std::vector<Stretch>& others,
             const Question& question) {
  std::map<std::string, Interval> together;
  const auto add = [&](const Stretch& s) { together[s.name] = overlap(together[s.name], s.line); };
  for (const Stretch& line : lines) add(line);
  for (const Link& link : links_of(relation)) {
    const Sides s = sides_of(link, question);
    if (const auto line = stretch(residual_of(s), claim_of(s.op), question.symbols)) add(*line);
  }
  const auto lies_in = [](const End& end, const End& other, int side) {
    if (end.infinite != 0 || other.infinite != 0) return other.infinite != 0;
    const int order = side * compare(end.value, other.value);
    return order > 0 || (order == 0 && (other.closed || !end.closed));
  };
  return std::all_of(others.begin(), others.end(), [&](const Stretch& other) {
    const Interval& line = together[other.name];
    return lies_in(line.low, other.line.low, 1) && lies_in(line.high, other.line.high, -1);
  });
}

}  // namespace

Pair Question::pair(const Tree& left_side, const Tree& right_side) const {
  std::map<std::string, Tree> meanings;
  Pair pair{};
  for (const Given& g : given) {
    const Symbol* symbol = symbols.find(g.name);
    const ex value = rederive::put_in(g.value, given);
    const Tree tree = meanings[symbol->name] = to_tree(value, symbols);
    if (symbol->range != "(-inf, inf)" || !value.info(GiNaC::info_flags::polynomial))  // it may fail
      pair.bound.push_back({symbol->name, tree});
  }
  pair.left = put_in(left_side, meanings), pair.right = put_in(right_side, meanings);
  pair.left_value = rederive::put_in(lower(left_side, symbols), given);
  pair.right_value = rederive::put_in(lower(right_side, symbols), given);
  for (const auto* list : {&symbols.never_zero(), &symbols.no_witness()})
    for (const ex& e : *list) pair.never_zero.push_back(to_tree(rederive::put_in(e, given), symbols));
  return pair;
}

Symbols with_ranges_of(const std::vector<Given>& given, const Symbols& symbols) {
  Symbols result = symbols;
  for (const Given& g : given) {
    const ex value = put_in(g.value, given);
    if (symbols.find(g.name) == nullptr || symbols.find(g.name)->range == "(-inf, inf)") continue;
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part) {
      if (!GiNaC::is_a<GiNaC::symbol>(*part) || !value.is_polynomial(*part)) continue;
      const ex slope = value.diff(GiNaC::ex_to<GiNaC::symbol>(*part));
      if (!GiNaC::is_a<GiNaC::numeric>(slope) || slope.is_zero()) continue;
      const ex words = *part + ((g.name - value) / slope).expand();
      result.say_otherwise(*part, words);
      narrow_to(interval_of(words, symbols), *part, result);
    }
  }
  return result;
}

std::optional<Symbols> where_defined(const Question& question) {
  const std::vector<Stretch> left = stretches_with_values(question.left, question),
                             right = stretches_with_values(question.right, question);
  if (!implies(question.left, left, right, question) || !implies(question.right, right, left, question))
    return std::nullopt;
  Symbols result = question.symbols;
  for (const auto* lines : {&left, &right})
    for (const auto& [name, line] : *lines) narrow_to(line, question.symbols[name], result);
  const auto is_narrower = [&](const Stretch& line) {
    return result.find(line.name)->range != question.symbols.find(line.name)->range;
  };
  const bool any = std::any_of(left.begin(), left.end(), is_narrower) ||
                   std::any_of(right.begin(), right.end(), is_narrower);
  return any ? std::optional(result) : std::nullopt;
}

std::vector<Link> links_of(const Relation& relation) {
  std::vector<Link> links;
  bool explicit_form = true;
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    explicit_form = explicit_form && relation.operators[k] == "=";
    links.push_back({relation.sides[explicit_form ? 0 : k], relation.operators[k], relation.sides[k + 1]});
  }
  return links;
}

Sides sides_of(const Link& link, const Question& question) {
  const auto value = [&](const Tree& tree) { return put_in(lower(tree, question.symbols), question.given); };
  return {value(link.left), link.op, value(link.right)};
}

Claim claim_of(const std::string& op) {
  return op == "=" ? Claim::zero : op.size() == 1 ? Claim::positive : Claim::not_negative;
}

ex residual_of(const Sides& s) { return s.op[0] == '<' ? s.right - s.left : s.left - s.right; }

Residuals residuals_of(const Link& left, const Link& right, const Question& question) {
  const Symbols& symbols = question.symbols;
  const Sides inner_left = unwrapped(sides_of(left, question), symbols),
              inner_right = unwrapped(sides_of(right, question), symbols);
  return {question.pair(written_residual(left), written_residual(right)),
          claim_of(left.op),
          claim_of(right.op),
          residual_of(inner_left),
          residual_of(inner_right),
          squared_residual(inner_left, symbols),
          squared_residual(inner_right, symbols),
          divisors_of(question.left, question),
          divisors_of(question.right, question)};
}

}  // namespace rederive
