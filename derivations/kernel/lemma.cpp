#include <algorithm>
#include <derivations/decide/points.hpp>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/kernel/script.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/paper/prove.hpp>

namespace rederive::kernel {
using namespace language;
using namespace numbers;
using namespace identity;
using namespace decide;
using namespace paper;

namespace {

/// A question with its side conditions among the assumptions, and its parts in Coq.
struct Statement {
  Statement(const Question& question, const Proof& proof) : q(question) {
    q.assumptions.insert(q.assumptions.end(), proof.side_conditions.begin(), proof.side_conditions.end());
    trees = trees_of({q.left, q.right, {}, q.symbols});
    for (const Given& g : q.given) {
      trees.push_back(to_tree(g.value, q.symbols));
      names.insert(q.symbols.find(g.name)->name);
    }
    needs = needs_of(trees);
    for (const Tree& tree : trees) names.merge(names_of(tree));
    for (const Relation& r : q.assumptions) names.merge(names_of(r));
  }

  std::string variables() const {
    std::string text;
    for (const std::string& name : names) text += coq_name(name) + " ";
    return text + ": real,";
  }

  /// Returns the hypotheses: ranges, given values, assumptions.
  std::vector<std::string> hypotheses() const {
    std::vector<std::string> result;
    const auto end = [&](const std::string& text) { return coq_text(parse(text, q.symbols)); };
    for (const std::string& name : names) {
      const Range range = read_range(q.symbols.find(name)->range);
      if (range.lower != "-inf")
        result.push_back(end(range.lower) + (range.lower_closed ? " <= " : " < ") + coq_name(name));
      if (range.upper != "inf")
        result.push_back(coq_name(name) + (range.upper_closed ? " <= " : " < ") + end(range.upper));
    }
    for (const Given& g : q.given)
      result.push_back(coq_name(q.symbols.find(g.name)->name) + " = " +
                       coq_text(to_tree(g.value, q.symbols)));
    for (const Relation& r : q.assumptions) result.push_back(coq_text(r));
    return result;
  }

  Question q;
  std::vector<Tree> trees;  ///< whatever must have a value
  std::vector<std::pair<Tree, Signs>> needs;
  std::set<std::string> names;
};

/// Returns lower - upper for an inequality, as Coq writes it, and left - right for an equation.
Tree residual(const Relation& r) {
  return r.operators[0][0] == '>' ? difference(r.sides[1], r.sides[0]) : difference(r.sides[0], r.sides[1]);
}

/// Returns the last step of a script that goes by a factor; nothing if it has to go link by link.
std::optional<std::string> conclusion(const Problem& problem, Script& script) {
  const Relation &left = problem.left, &right = problem.right;
  if (left.operators.empty()) return script.identity();
  const auto kind = [](const Relation& r) { return r.operators[0].substr(is_equation(r) ? 0 : 1); };
  if (left.operators.size() != 1 || right.operators.size() != 1 || kind(left) != kind(right))
    return std::nullopt;
  const auto factor = script.factor(residual(left), residual(right));
  if (!factor) return std::nullopt;
  const std::string by = is_equation(left) ? "eq_by" : kind(left).empty() ? "lt_by" : "le_by";
  return "apply (" + by + " (" + *factor + ")); [ " + (is_equation(left) ? "nz" : "pos") + " | " +
         script.identity() + " ]";
}

/// Returns the values of the symbols at a witness: numbers, given values, and the symbol itself for a root
/// between bounds.
std::map<std::string, Tree> values_at(const Witness& witness, const Statement& s) {
  std::map<std::string, Tree> at;
  for (const std::string& symbol : s.names) {
    const auto names_it = [&](const Given& g) { return s.q.symbols.find(g.name)->name == symbol; };
    if (std::any_of(s.q.given.begin(), s.q.given.end(), names_it)) continue;
    const auto exact = witness.exactly.find(symbol);
    const std::string& text = witness.between.contains(symbol) ? symbol
                              : exact != witness.exactly.end() ? exact->second
                                                               : witness.at.at(symbol);
    at[symbol] = parse(text, s.q.symbols);
  }
  for (const Given& g : s.q.given) {
    Tree value = to_tree(g.value, s.q.symbols);
    for (const auto& [symbol, other] : at) value = put_in(value, symbol, other);
    at[s.q.symbols.find(g.name)->name] = value;
  }
  return at;
}

/// Returns whether a statement holds at a witness; `residual` is its value there, if a root is only enclosed.
/// Throws Undecidable if the statement has no value.
bool holds_at(const Relation& statement, const Witness& witness, const std::map<std::string, Tree>& at,
              const std::string& residual) {
  if (!witness.between.empty()) return residual == "0";
  Point point;
  for (const auto& [symbol, value] : at) point.emplace(symbol, Number(value));
  const Truth truth = truth_at(statement, point);
  if (truth == Truth::undefined) throw Undecidable("there is no script for a side that has no value");
  return truth == Truth::holds;
}

/// Returns the tree with inverse functions as the tactic `inverses` writes them: Coq's interval arithmetic
/// and derivatives know atan and ln, but not asin, acos and asinh.
Tree with_inverses(const Tree& tree) {
  static const std::map<std::string, Tree> rules = [] {
    Symbols symbols;
    symbols.declare({"u", "u", "u", "1", all_numbers, "an argument", ""});
    return std::map<std::string, Tree>{{"asin", parse("atan(u/sqrt(1 - u^2))", symbols)},
                                       {"acos", parse("pi/2 - atan(u/sqrt(1 - u^2))", symbols)},
                                       {"asinh", parse("log(u + sqrt(u^2 + 1))", symbols)}};
  }();
  if (tree->children.empty()) return tree;
  std::vector<Tree> children;
  for (const Tree& child : tree->children) children.push_back(with_inverses(child));
  const auto rule = tree->kind == Node::Kind::call ? rules.find(tree->text) : rules.end();
  return rule != rules.end() ? put_in(rule->second, "u", children[0])
                             : make_tree(tree->kind, tree->text, std::move(children), tree->inverse);
}

/// Returns the root of a rational number as a number times the root of an integer, which has no square of a
/// number up to 100 as a factor.
Tree root_of(const cln::cl_RA& number) {
  cln::cl_I under = cln::numerator(number) * cln::denominator(number), outside = 1;
  for (int k = 2; k <= 100; ++k)
    while (cln::zerop(cln::mod(under, k * k))) under = cln::exquo(under, k * k), outside = outside * k;
  const GiNaC::numeric factor(cln::cl_RA(outside) / cln::denominator(number));
  const Tree root = make_tree(Node::Kind::call, "sqrt", {tree_of({under})}),
             times = to_tree(factor, Symbols());
  if (under == 1) return times;
  return factor == 1 ? root : make_tree(Node::Kind::product, "", {times, root}, {false, false});
}

/// Writes arguments of functions as their values at a point, and roots of numbers in one form.
void say_arguments(const Tree& tree, const std::map<std::string, Tree>& at, std::string& steps) {
  for (const Tree& child : tree->children) say_arguments(child, at, steps);
  if (tree->kind != Node::Kind::call) return;
  Tree argument = tree->children[0];
  for (const auto& [symbol, value] : at) argument = put_in(argument, symbol, value);
  const auto number = names_of(argument).empty() ? value_at(argument, {}, 64).exact : std::nullopt;
  if (!number) return;
  const auto say = [&](const std::string& kind, const std::string& from, const std::string& to,
                       const std::string& by) {
    const std::string line = "  " + kind + " (" + from + ") (" + to + ")" + by + ".\n";
    if (steps.find(line) == std::string::npos) steps += line;
  };
  const std::string text = coq_text(argument), size = coq_text(tree_of({cln::abs(*number)}));
  if (tree->text == "sqrt") {
    const Tree root = root_of(*number);
    if (coq_text(root) != "sqrt(" + text + ")") say("root", text, coq_text(root), " by square_of_numbers");
    return;
  }
  const std::string value = cln::minusp(*number) ? "- (" + size + ")" : size;
  const bool is_circular = function_named(tree->text).kind == Function::Kind::circular;
  if (value != text) say(is_circular ? "angle" : "exponent", text, value, "");
}

}  // namespace

std::string lemma(const std::string& name, const Question& question, const Proof& proof) {
  const Statement s(question, proof);
  const Question& q = s.q;
  const Problem problem = with_values({q.left, q.right, q.assumptions, q.symbols}, q.given);
  std::string text = "Lemma " + name + " :" + (s.names.empty() ? "" : " forall " + s.variables()) + "\n  ",
              steps;
  for (const std::string& h : s.hypotheses()) text += h + " ->\n  ";
  Script script(problem);
  for (const auto& [need, signs] : s.needs) {
    text += coq_text(need, signs) + " /\\\n  ";
    Tree put = need;
    for (const auto& [symbol, value] : problem.values) put = put_in(put, symbol, value);
    steps += "  first_of " + script.meets(put, signs) + ".\n";
  }
  text += q.left.operators.empty() ? coq_text(q.left.sides[0]) + " = " + coq_text(q.right.sides[0])
                                   : "(" + coq_text(q.left) + " <->\n   " + coq_text(q.right) + ")";
  return text + ".\nProof.\n  start.\n" + script.steps() + steps + "  " +
         conclusion(problem, script).value_or("links") + ".\nQed.\n";
}

bool has_script(const Question& q) try {
  const Problem problem = with_values({q.left, q.right, q.assumptions, q.symbols}, q.given);
  Script script(problem);
  if (q.left.operators.empty())
    return script.factor(difference(problem.left.sides[0], problem.right.sides[0]), zero()) == "1";
  return conclusion(problem, script).has_value();
} catch (const Undecidable&) {
  return false;
}

std::string refutation(const std::string& name, const Question& question, const Proof& proof) {
  if (proof.by == By::sign) throw Undecidable("there is no script for a side that has no value");
  const Statement s(question, proof);
  const Question& q = s.q;
  const std::map<std::string, Tree> at = values_at(*proof.witness, s);
  const auto put = [&](Tree tree) {
    for (const auto& [symbol, value] : at) tree = put_in(tree, symbol, value);
    return coq_text(with_inverses(tree));
  };
  const bool holds_left = holds_at(q.left, *proof.witness, at, proof.witness->printed);
  (void)holds_at(q.right, *proof.witness, at, proof.witness->derived);
  std::string text = "Lemma " + name + " : exists " + s.variables() + "\n  ", values, steps;
  for (const std::string& h : s.hypotheses()) text += h + " /\\\n  ";
  for (const auto& [need, signs] : s.needs) text += coq_text(need, signs) + " /\\\n  ";
  text += (holds_left ? "(" : "~ (") + coq_text(q.left) + ") /\\\n  " + (holds_left ? "~ (" : "(") +
          coq_text(q.right) + ")";
  for (const auto& [symbol, value] : at)
    values += (values.empty() ? "" : ", ") + ("(" + coq_text(with_inverses(value)) + ")");
  for (const Tree& tree : s.trees) say_arguments(tree, at, steps);
  for (const auto& [symbol, value] : at) say_arguments(value, {}, steps);
  text += ".\nProof.\n";
  for (const auto& [symbol, ends] : proof.witness->between)
    text += "  zero_between " + coq_name(symbol) + " (" + ends.first + ") (" + ends.second + ") (fun " +
            coq_name(symbol) + " => " + put(residual(holds_left ? q.left : q.right)) + ").\n";
  const auto has_inverse = [](const Tree& tree) { return !is_same(with_inverses(tree), tree); };
  const auto speaks_of_inverse = [&](const Relation& r) { return std::ranges::any_of(r.sides, has_inverse); };
  const bool needs_inverses =
      std::ranges::any_of(s.trees, has_inverse) || std::ranges::any_of(q.assumptions, speaks_of_inverse);
  return text + "  exists " + values + ".\n  start.\n" + (needs_inverses ? "  inverses.\n" : "") + steps +
         "  addition_theorems.\n  at_the_point.\nQed.\n";
}

}  // namespace rederive::kernel
