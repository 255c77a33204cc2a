#include <algorithm>
#include <derivations/decide/comparison.hpp>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/lemma.hpp>
#include <derivations/language/lower.hpp>

namespace rederive {

namespace {

using Kind = Generator::Kind;

/// The problem of a question in the ring, and its phases by name.
class Script {
 public:
  Script(const Question& question, const std::vector<Relation>& conditions)
      : problem_(put_in(question, conditions)), known_(problem_.symbols), names_(problem_.symbols) {
    translate(known_, problem_);
    for (const Tree& tree : trees_of(problem_)) say_arguments(tree);
    say_facts();
  }

  const Problem& problem() const { return problem_; }

  /// `angle u s`, `exponent u s`, `root u v`: the steps before the statement is an identity of fractions.
  std::string steps() {
    std::string text;
    for (const auto& [name, phase] : phases_) text += "  phase " + name + " (" + phase + ").\n";
    for (const std::string& line : arguments_) text += "  " + line + ".\n";
    if (has_arguments_) text += "  addition_theorems.\n";
    for (const std::string& line : facts_) text += "  " + line + ".\n";
    std::set<std::string> said;
    for (const Tree& root : roots_) {
      const std::string line = "(" + coq_text(root->children[0]) + ") (" + text_of(value(root)) + ")";
      if (said.insert(line).second) text += "  root " + line + " by (field [" + facts_names_ + "]; nz).\n";
    }
    return text;
  }

  std::string identity() const {
    return facts_names_.empty() ? "identity ring or field"
                                : "identity (ring [" + facts_names_ + "]) or (field [" + facts_names_ + "])";
  }

  Fraction value(const Tree& tree) {
    std::vector<DomainCondition> unused;
    return known_.translator(tree, unused);
  }

  /// How a need is met. A sum is a multiple of what is assumed, or of a sum of positive terms.
  std::string meets(const Tree& need, Signs signs) {
    if (need->kind != Node::Kind::sum) return "defined";
    const Fraction f = value(need);
    for (const Relation& a : problem_.assumptions) {
      const Tree known = difference_of(a);
      const Fraction ratio = known_.ring.normal(value(known) / f);
      if (is_same(known, need) || ratio.numerator.terms() != 1 || ratio.denominator.terms() != 1) continue;
      if (signs == Signs::nonzero()) return "(multiple (" + text_of(ratio) + ") (" + identity() + "))";
      if (ratio == Fraction(1)) return "(as_known (" + identity() + "))";
    }
    if (signs != Signs::nonzero() || has_symbols_only(f.numerator)) return "defined";
    const Fraction positive = without_monomials(in_sines(f.numerator));
    return by_multiple(known_.ring.normal(positive / f), text_of(known_.ring.normal(positive)));
  }

  /// left = factor * right, of residuals; nothing where one of them is 0.
  std::optional<Fraction> factor(const Tree& left, const Tree& right) {
    const Fraction a = value(left), b = value(right);
    if (a.is_zero() && b.is_zero()) return Fraction(1);
    if (a.is_zero() || b.is_zero()) return std::nullopt;
    const Fraction ratio = known_.ring.rationalized(a / b);
    return is_definite(ratio) ? std::optional(ratio) : std::nullopt;
  }

  /// In the names of the phases.
  std::string text_of(const Fraction& f) const {
    return coq_text(to_tree(Ring::meaning_of(f, meanings_), names_));
  }

 private:
  static Problem put_in(const Question& q, std::vector<Relation> conditions) {
    conditions.insert(conditions.begin(), q.assumptions.begin(), q.assumptions.end());
    return with_values({q.left, q.right, conditions, q.symbols}, q.given);
  }

  static Tree difference_of(const Relation& a) {
    const bool is_zero = a.sides[1]->kind == Node::Kind::number && a.sides[1]->text == "0";
    return is_zero ? a.sides[0] : difference(a.sides[0], a.sides[1]);
  }

  bool has_symbols_only(const Polynomial& p) const {
    const auto used = p.used();
    return std::all_of(used.begin(), used.end(),
                       [&](int k) { return known_.ring.generators()[k].kind == Kind::symbol; });
  }

  bool is_definite(const Fraction& f) const {
    const auto& [number, list] = factors(f.numerator * f.denominator);
    return std::all_of(list.begin(), list.end(),
                       [&](const auto& factor) { return known_.ring.signs_of(factor.first).is_definite(); });
  }

  std::string by_multiple(const Fraction& factor, const std::string& known) const {
    return "(apply (nonzero_by (" + text_of(factor) + ") (" + known + ")); [ nz | " + identity() + " ])";
  }

  /// With cos² = 1 - sin².
  Polynomial in_sines(const Polynomial& p) const {
    Polynomial result = p;
    for (const int k : p.used()) {
      const Generator& g = known_.ring.generators()[k];
      if (g.kind != Kind::sine || g.degree != 2) continue;
      const int cosine = g.value.numerator.used().at(0);
      const auto coefficients = result.coefficients(cosine);
      result = 0;
      for (int n = 0; n < static_cast<int>(coefficients.size()); ++n)
        result = result + coefficients[n] * power(Polynomial::variable(cosine), n % 2) *
                              power(1 - Polynomial::variable(k) * Polynomial::variable(k), n / 2);
    }
    return result;
  }

  /// Without the symbols, sines and exponentials that are its factors.
  static Polynomial without_monomials(const Polynomial& p) {
    Polynomial result = p;
    for (const auto& [factor, exponent] : factors(p).second)
      if (factor.terms() == 1) result = *quotient(result, power(factor, exponent));
    return result;
  }

  /// The name of a phase: itself, if it is a symbol.
  std::string name_of(const Fraction& phase) {
    const auto used = phase.numerator.used();
    const GiNaC::ex meaning = known_.ring.meaning_of(phase);
    if (const Symbol* symbol = problem_.symbols.find(meaning)) return coq_name(symbol->name);
    const std::string text = coq_text(to_tree(meaning, problem_.symbols));
    for (const auto& [name, known] : phases_)
      if (known == text) return name;
    const std::string name = "phase" + std::to_string(phases_.size() + 1);
    phases_.emplace_back(name, text);
    declare(name);
    return name;
  }

  void say_arguments(const Tree& tree) {
    for (const Tree& child : tree->children) say_arguments(child);
    if (tree->kind == Node::Kind::call && tree->text == "sqrt") roots_.push_back(tree);
    if (tree->kind != Node::Kind::call) return;
    static const std::set<std::string> circular{"sin", "cos", "tan", "cot", "sec", "csc"};
    static const std::set<std::string> real{"exp", "sinh", "cosh", "tanh", "coth", "sech", "csch"};
    const bool is_circular = circular.contains(tree->text);
    if (!is_circular && !real.contains(tree->text)) return;
    cln::cl_RA turns = 0;
    std::string sum;
    const auto add = [&](const std::string& term) { sum += (sum.empty() ? "" : " + ") + term; };
    const auto multiples = known_.translator.phases_of(value(tree->children[0]), is_circular ? &turns : nullptr);
    for (const Multiple& m : multiples) {
      const std::string name = name_of(m.phase);
      for (int k = 0; k < std::abs(m.times); ++k) add(m.times > 0 ? name : "- " + name);
    }
    if (cln::denominator(2 * turns) != 1) throw Undecidable("there is no script for parts of a right angle");
    const int right_angles = cln::cl_I_to_int(cln::mod(cln::numerator(2 * turns), 4));
    for (int k = 0; k < right_angles; ++k) add("PI / 2");
    if (sum.empty()) add("0");
    has_arguments_ = true;
    const std::string argument = coq_text(tree->children[0]);
    const std::string line = std::string(is_circular ? "angle" : "exponent") + " (" + argument + ") (" + sum + ")";
    if (argument != sum && std::find(arguments_.begin(), arguments_.end(), line) == arguments_.end())
      arguments_.push_back(line);
  }

  const Symbol& declare(const std::string& name) {
    return names_.declare(name, name, name, "1", all_numbers, "a name in a script", "");
  }

  void say_facts() {
    for (const Generator& g : std::vector<Generator>(known_.ring.generators())) {
      const bool is_function = g.kind == Kind::cosine || g.kind == Kind::sine || g.kind == Kind::exponential;
      GiNaC::ex meaning = g.meaning;
      if (is_function) {
        const std::string name = name_of(g.of);
        const GiNaC::ex x = names_[name];
        meaning = g.kind == Kind::cosine ? cos(x) : g.kind == Kind::sine ? sin(x) : exp(x);
        if (g.kind == Kind::sine) say_fact("assert (# := pyth " + name + ")");
      } else if (g.kind == Kind::root && g.order == 2) {
        const std::string name = "root" + std::to_string(meanings_.size());
        meaning = declare(name).ginac;
        say_fact("square_root " + name + " # (" + base_of(g, static_cast<int>(meanings_.size())) + ")");
      } else if (g.kind == Kind::root || g.kind == Kind::absolute || g.kind == Kind::logarithm) {
        throw Undecidable("there is no script for roots of higher order, bars and logarithms");
      }
      meanings_.push_back(meaning);
    }
  }

  /// The base of a root, as the statement has it if it is there.
  std::string base_of(const Generator& g, int index) {
    for (const Tree& root : roots_)
      if (value(root) == Fraction(Polynomial::variable(index))) return coq_text(root->children[0]);
    return text_of(g.of);
  }

  /// A fact gets a name in the place of #.
  void say_fact(std::string text) {
    const std::string name = "F" + std::to_string(facts_.size() + 1);
    facts_names_ += (facts_names_.empty() ? "" : " ") + name;
    facts_.push_back(text.replace(text.find('#'), 1, name));
  }

  Problem problem_;
  Comparison known_;
  Symbols names_;
  std::vector<std::pair<std::string, std::string>> phases_;  ///< name, and what it stands for
  std::vector<std::string> arguments_, facts_;
  std::vector<Tree> roots_;
  std::string facts_names_;
  std::vector<GiNaC::ex> meanings_;  ///< of the generators, in the names of the phases and roots
  bool has_arguments_ = false;
};

/// "V != 0", "1 - lambda >= 0" as relations.
std::vector<Relation> conditions_of(const Proof& proof, const Symbols& symbols) {
  std::vector<Relation> result;
  for (const std::string& text : proof.side_conditions) {
    const auto at = text.find(" != ");
    if (at == std::string::npos)
      result.push_back(parse_relation(text, symbols));
    else
      result.push_back({{parse(text.substr(0, at), symbols), parse(text.substr(at + 4), symbols)}, {"!="}});
  }
  return result;
}

/// The declared range of a symbol.
std::vector<std::string> range_of(const Symbol& symbol, const Symbols& symbols) {
  std::vector<std::string> result;
  const Range range = read_range(symbol.range);
  const auto end = [&](const std::string& text) { return coq_text(parse(text, symbols)); };
  if (range.lower != "-inf") result.push_back(end(range.lower) + (range.lower_closed ? " <= " : " < ") + coq_name(symbol.name));
  if (range.upper != "inf") result.push_back(coq_name(symbol.name) + (range.upper_closed ? " <= " : " < ") + end(range.upper));
  return result;
}

/// All trees of a question as it is asked, before anything is put in.
std::vector<Tree> sides_of(const Question& q) {
  std::vector<Tree> trees = q.left.sides;
  trees.insert(trees.end(), q.right.sides.begin(), q.right.sides.end());
  for (const Given& g : q.given) trees.push_back(to_tree(g.value, q.symbols));
  return trees;
}

std::set<std::string> names_in(const Question& q, const std::vector<Relation>& conditions) {
  std::set<std::string> names;
  for (const Tree& tree : sides_of(q)) names.merge(names_of(tree));
  for (const Given& g : q.given) names.insert(q.symbols.find(g.name)->name);
  for (const auto* list : {&q.assumptions, &conditions})
    for (const Relation& r : *list) names.merge(names_of(r));
  return names;
}

std::vector<std::string> hypotheses(const Question& q, const std::vector<Relation>& conditions,
                                    const std::set<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names)
    for (std::string& bound : range_of(*q.symbols.find(name), q.symbols)) result.push_back(std::move(bound));
  for (const Given& g : q.given)
    result.push_back(coq_name(q.symbols.find(g.name)->name) + " = " + coq_text(to_tree(g.value, q.symbols)));
  for (const auto* list : {&q.assumptions, &conditions})
    for (const Relation& r : *list) result.push_back(coq_text(r));
  return result;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += coq_name(name) + " ";
  return text;
}

bool is_reversed(const Relation& r) { return r.operators[0][0] == '>'; }

/// lower - upper, as Coq writes an inequality; left - right of an equation.
Tree residual(const Relation& r) {
  return is_reversed(r) ? difference(r.sides[1], r.sides[0]) : difference(r.sides[0], r.sides[1]);
}

/// The last step: up to a factor, or link by link.
std::string conclusion(Script& script) {
  const Relation &left = script.problem().left, &right = script.problem().right;
  if (left.operators.empty()) return script.identity();
  const auto kind = [](const Relation& r) { return r.operators[0].substr(r.operators[0][0] == '=' ? 0 : 1); };
  if (left.operators.size() != 1 || right.operators.size() != 1 || is_equation(left) != is_equation(right) ||
      kind(left) != kind(right))
    return "links";
  const auto factor = script.factor(residual(left), residual(right));
  if (!factor) return "links";
  const std::string lemma = is_equation(left) ? "eq_by" : kind(left).empty() ? "lt_by" : "le_by";
  return "apply (" + lemma + " (" + script.text_of(*factor) + ")); [ " + (is_equation(left) ? "nz" : "pos") + " | " +
         script.identity() + " ]";
}

}  // namespace

std::string lemma(const std::string& name, const Question& q, const Proof& proof) {
  const std::vector<Relation> conditions = conditions_of(proof, q.symbols);
  const std::set<std::string> names = names_in(q, conditions);
  std::string text = "Lemma " + name + " :" + (names.empty() ? "" : " forall " + joined(names) + ": real,") + "\n  ";
  for (const std::string& h : hypotheses(q, conditions, names)) text += h + " ->\n  ";
  Script script(q, conditions);
  std::string steps;
  for (const auto& [need, signs] : needs_of(sides_of(q))) {
    text += coq_text(need, signs) + " /\\\n  ";
    Tree put = need;
    for (const auto& [symbol, value] : script.problem().values) put = put_in(put, symbol, value);
    steps += "  first_of " + script.meets(put, signs) + ".\n";
  }
  text += q.left.operators.empty() ? coq_text(q.left.sides[0]) + " = " + coq_text(q.right.sides[0])
                                   : "(" + coq_text(q.left) + " <->\n   " + coq_text(q.right) + ")";
  return text + ".\nProof.\n  start.\n" + script.steps() + steps + "  " + conclusion(script) + ".\nQed.\n";
}

}  // namespace rederive
