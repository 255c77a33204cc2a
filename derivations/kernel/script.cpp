#include <algorithm>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/script.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>

namespace rederive::kernel {
using namespace language;
using namespace numbers;
using namespace identity;
using namespace decide;

namespace {

/// Returns a - b for a > b and a != b, and a for a > 0.
Tree difference_of(const Relation& a) {
  const bool is_zero = a.sides[1]->kind == Node::Kind::number && a.sides[1]->text == "0";
  return is_zero ? a.sides[0] : difference(a.sides[0], a.sides[1]);
}

bool has_symbols_only(const Ring& ring, const Polynomial& p) {
  return std::ranges::all_of(p.used(),
                             [&](int k) { return GiNaC::is_a<GiNaC::symbol>(ring.generators()[k].meaning); });
}

/// Returns whether a product or a power has a factor that is a sum: 2*a*(a - b).
bool multiplies_sum(const Tree& tree) {
  if (tree->kind == Node::Kind::power) return tree->children[0]->kind == Node::Kind::sum;
  return tree->kind == Node::Kind::product && std::ranges::any_of(tree->children, [](const Tree& child) {
           return child->kind == Node::Kind::sum || multiplies_sum(child);
         });
}

/// Returns the polynomial with cos² = 1 - sin².
Polynomial in_sines(const Ring& ring, const Polynomial& p) {
  Polynomial result = p;
  for (int k = 0; k < static_cast<int>(ring.generators().size()); ++k) {
    const Generator& g = ring.generators()[k];
    if (g.function != "sin" || g.degree != 2) continue;
    const int cosine = g.value.numerator.used().at(0);
    const auto coefficients = result.coefficients(cosine);
    result = 0;
    for (int n = 0; n < static_cast<int>(coefficients.size()); ++n)
      result = result + coefficients[n] * power(Polynomial::variable(cosine), n % 2) *
                            power(Polynomial(1) - Polynomial::variable(k) * Polynomial::variable(k), n / 2);
  }
  return result;
}

bool has_root(const Tree& tree) {
  return (tree->kind == Node::Kind::call && tree->text == "sqrt") ||
         std::ranges::any_of(tree->children, has_root);
}

/// Returns the polynomial without its factors that are symbols, sines or exponentials.
Polynomial without_monomials(const Polynomial& p) {
  Polynomial result = p;
  for (const auto& [factor, exponent] : factors(p).second)
    if (factor.terms() == 1 && !factor.is_constant()) result = *quotient(result, power(factor, exponent));
  return result;
}

}  // namespace

Script::Script(const Problem& problem)
    : problem_(problem), known_(problem_.symbols), names_(problem.symbols) {
  known_.translator.with_basis([&] { translate(known_, problem_); });
  for (const Tree& tree : trees_of(problem_)) say_arguments(tree);
  for (const std::string& call : inverse_)  // a name that both have
    if (inverse_.count(call) < 2) throw Undecidable("there is no script for the inverse of a function");
  say_facts();
}

Fraction Script::value(const Tree& tree) {
  std::vector<Atom> unused;
  return known_.translator(tree, unused);
}

std::string Script::text_of(const Fraction& f) const {
  Tree tree = to_tree(Ring::meaning_of(f, meanings_), names_);
  for (const auto& [name, call] : exponentials_) tree = put_in(tree, name, call);
  return coq_text(tree);
}

const Symbol& Script::declare(const std::string& name) {
  return names_.declare({name, name, name, "1", all_numbers, "a name in a script", ""});
}

/// Returns the name of a phase; a phase that is a symbol keeps its name.
std::string Script::name_of(const Fraction& phase) {
  const GiNaC::ex meaning = known_.ring.meaning_of(phase);
  if (const Symbol* symbol = problem_.symbols.find(meaning)) return symbol->name;
  const std::string text = coq_text(to_tree(meaning, problem_.symbols));
  for (const auto& [name, known] : phases_)
    if (known == text) return name;
  phases_.emplace_back("phase" + std::to_string(phases_.size() + 1), text);
  return declare(phases_.back().first).name;
}

void Script::say_arguments(const Tree& tree) {
  for (const Tree& child : tree->children) say_arguments(child);
  if (tree->kind != Node::Kind::call) return;
  const Function& f = function_named(tree->text);
  if (f.name == "sqrt") roots_.push_back(tree);
  if (f.kind == Function::Kind::inverse && f.has_coq) inverse_.insert(coq_text(tree));
  if (f.name == "sqrt" && has_root(tree->children[0]))
    throw Undecidable("there is no script for roots of roots");
  const bool is_circular = f.kind == Function::Kind::circular;
  if (is_circular || f.kind == Function::Kind::exponential) say_argument(tree->children[0], is_circular);
}

/// Returns whether a tree has a root that the ring writes as a product of several roots: sqrt(1 - x^2).
bool Script::has_root_of_product(const Tree& tree) {
  const bool is_root = tree->kind == Node::Kind::call && tree->text == "sqrt";
  if (is_root && value(tree).numerator.used().size() > 1) return true;
  return std::ranges::any_of(tree->children, [&](const Tree& child) { return has_root_of_product(child); });
}

void Script::say_argument(const Tree& argument, bool is_circular) {
  for (const std::string& call : inverse_)
    if (coq_text(argument).find(call) != std::string::npos)
      throw Undecidable("there is no script for functions of inverse functions");
  if (has_root_of_product(argument))
    throw Undecidable("there is no script for functions of roots of products");
  has_arguments_ = true;
  std::string sum;
  const auto add = [&](const std::string& term) { sum += (sum.empty() ? "" : " + ") + term; };
  cln::cl_RA turns = 0;
  for (const auto& [number, term] : terms_of(value(argument))) {
    if (is_circular && term == known_.translator.pi()) {
      turns = number;
      continue;
    }
    const auto [phase, times] =
        known_.translator.multiple_of_phase(is_circular ? "cos" : "exp", number, term);
    const std::string name = coq_name(name_of(phase));
    for (int k = 0; k < std::abs(times); ++k) add(times > 0 ? name : "- " + name);
  }
  if (cln::denominator(2 * turns) != 1) throw Undecidable("there is no script for parts of a right angle");
  const int right_angles = cln::cl_I_to_int(cln::mod(cln::numerator(2 * turns), 4));
  for (int k = 0; k < right_angles; ++k) add("PI / 2");
  if (sum.empty()) add("0");
  const std::string text = coq_text(argument);
  const std::string line = std::string(is_circular ? "angle" : "exponent") + " (" + text + ") (" + sum + ")";
  if (text != sum && std::find(arguments_.begin(), arguments_.end(), line) == arguments_.end())
    arguments_.push_back(line);
}

/// Returns the base of a root, as the statement writes it if it occurs there.
std::string Script::base_of(const Generator& root, int index) {
  for (const Tree& tree : roots_)
    if (value(tree) == Fraction(Polynomial::variable(index))) return coq_text(tree->children[0]);
  return text_of(root.of);
}

void Script::say_facts() {
  for (const Generator& g : std::vector<Generator>(known_.ring.generators())) {
    GiNaC::ex meaning = g.meaning;
    const bool is_number = g.function == "cos" && !known_.ring.find("sin", g.of);  // cos(pi/n)
    if (!is_number && (g.function == "cos" || g.function == "sin" || g.function == "exp")) {
      const std::string name = name_of(g.of);
      const GiNaC::ex x = names_[name];
      meaning = g.function == "cos" ? cos(x) : sin(x);
      if (g.function == "exp") {  // by a name: GiNaC writes exp(x)^2 as exp(2 x)
        meaning = declare("exp_" + name);
        exponentials_["exp_" + name] =
            make_tree(Node::Kind::call, "exp", {make_tree(Node::Kind::symbol, name)});
      }
      if (g.function == "sin") say_fact("assert (# := pyth " + coq_name(name) + ")");
    } else if (g.function == "sqrt" && g.degree == 2) {
      const int index = static_cast<int>(meanings_.size());
      const std::string name = "root" + std::to_string(index);
      say_fact("square_root " + name + " # (" + base_of(g, index) + ")");
      meaning = declare(name);
    } else if (g.function == "sqrt" || g.function == "fabs" || g.function == "log") {
      throw Undecidable("there is no script for higher roots, absolute values and logarithms");
    }
    meanings_.push_back(meaning);
  }
}

/// Adds a fact, with its name in place of #.
void Script::say_fact(std::string text) {
  const std::string name = "F" + std::to_string(facts_.size() + 1);
  names_of_facts_ += (names_of_facts_.empty() ? "" : " ") + name;
  facts_.push_back(text.replace(text.find('#'), 1, name));
}

std::string Script::steps() {
  std::vector<std::string> lines;
  for (const auto& [name, phase] : phases_) lines.push_back("phase " + name + " (" + phase + ")");
  lines.insert(lines.end(), arguments_.begin(), arguments_.end());
  if (has_arguments_) lines.push_back("addition_theorems");
  lines.insert(lines.end(), facts_.begin(), facts_.end());
  for (const Tree& root : roots_) {
    lines.push_back("root (" + coq_text(root->children[0]) + ") (" + text_of(value(root)) + ") by (field [" +
                    names_of_facts_ + "]; nz)");
    if (std::find(lines.begin(), lines.end() - 1, lines.back()) != lines.end() - 1) lines.pop_back();
  }
  std::string text;
  for (const std::string& line : lines) text += "  " + line + ".\n";
  return text;
}

bool Script::grants(const Tree& need, Signs signs) { return known_.ring.signs_of(value(need)).within(signs); }

std::string Script::identity() const {
  if (names_of_facts_.empty()) return "identity ring or field";
  return "identity (ring [" + names_of_facts_ + "]) or (field [" + names_of_facts_ + "])";
}

std::string Script::meets(const Tree& need, Signs signs) {
  if (need->kind != Node::Kind::sum && !(signs == Signs::nonzero() && multiplies_sum(need))) return "defined";
  const Fraction f = value(need);
  Polynomial rest = f.numerator;  // without what is assumed not to be 0
  Fraction known = 1;
  std::string text;
  for (const Relation& a : problem_.assumptions) {
    const Tree tree = difference_of(a);
    if (is_same(tree, need)) return "defined";
    const Fraction one = value(tree), ratio = known_.ring.normal(one / f);
    if (ratio.numerator.terms() == 1 && ratio.denominator.terms() == 1) {
      if (signs == Signs::nonzero() && a.operators[0] == "!=")
        return "(multiple (" + text_of(ratio) + ") (" + identity() + "))";
      if (signs == Signs::nonzero())
        return "(apply (nonzero_by (" + text_of(ratio) + ") (" + coq_text(tree) + ")); [ nz | " + identity() +
               " ])";
      if (ratio == Fraction(1)) return "(as_known (" + identity() + "))";
    }
    if (a.operators[0] == "!=" && !one.numerator.is_constant())
      for (auto q = quotient(rest, one.numerator); q; q = quotient(rest, one.numerator))
        rest = *q, known = known * one, text += "(" + coq_text(tree) + ") * ";
  }
  if (signs != Signs::nonzero()) return "defined";
  if (text.empty() && f.denominator.is_one() && has_symbols_only(known_.ring, rest)) return "defined";
  const Fraction positive = known_.ring.normal(without_monomials(in_sines(known_.ring, rest)));
  text += text.empty() ? text_of(positive) : "(" + text_of(positive) + ")";
  return "(apply (nonzero_by (" + text_of(known_.ring.normal(known * positive / f)) + ") (" + text +
         ")); [ nz | " + identity() + " ])";
}

std::optional<std::string> Script::factor(const Tree& left, const Tree& right) {
  const Fraction a = value(left), b = value(right);
  if (a.is_zero() || b.is_zero()) return a == b ? std::optional("1") : std::nullopt;
  Fraction ratio = known_.ring.rationalized(a / b);
  ratio = Fraction(in_sines(known_.ring, ratio.numerator), in_sines(known_.ring, ratio.denominator));
  for (const auto& [factor, exponent] : factors(ratio.numerator * ratio.denominator).second)
    if (!known_.ring.signs_of(factor).is_definite())
      throw Undecidable("there is no script for relations that differ by more than a factor");
  return text_of(ratio);
}

}  // namespace rederive::kernel
