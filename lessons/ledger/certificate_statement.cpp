#include <algorithm>
#include <lessons/ledger/certificate_statement.hpp>
#include <set>
#include <sstream>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Generator::Kind;

std::string polynomial_text(const ex& polynomial) {
  const auto term_text = [](const ex& term) {
    std::vector<std::string> factors;
    numeric number = 1;
    const auto one = [&](const ex& f) {
      std::ostringstream text;
      if (is_a<numeric>(f))
        number = ex_to<numeric>(f);
      else if (is_a<GiNaC::power>(f))
        text << f.op(0) << "^" << f.op(1);
      else
        text << f;
      if (!text.str().empty()) factors.push_back(text.str());
    };
    if (is_a<GiNaC::mul>(term))
      for (const ex& f : term) one(f);
    else
      one(term);
    std::sort(factors.begin(), factors.end());
    std::ostringstream text;
    text << number;
    for (const std::string& f : factors) text << "*" << f;
    return text.str();
  };
  const ex expanded = polynomial.expand();
  if (!is_a<GiNaC::add>(expanded)) return term_text(expanded);
  std::vector<std::string> terms;
  for (const ex& term : expanded) terms.push_back(term_text(term));
  std::sort(terms.begin(), terms.end());
  std::string text;
  for (const std::string& term : terms) text += (text.empty() ? "" : " + ") + term;
  return text;
}

std::string fraction_text(const ex& rational) {
  const ex parts = rational.normal().numer_denom(), product = GiNaC::factor(parts.op(1));
  std::string text = polynomial_text(parts.op(0));
  if (!parts.op(1).is_equal(1)) text = "(" + text + ")";
  const ex factors = is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product});
  std::vector<std::string> divisors;
  for (const ex& f : factors) {
    const bool is_power = is_a<GiNaC::power>(f);
    if (f.is_equal(1)) continue;
    divisors.push_back("/(" + polynomial_text(is_power ? f.op(0) : f) + ")");
    if (is_power) divisors.back() += "^" + polynomial_text(f.op(1));
  }
  std::sort(divisors.begin(), divisors.end());
  for (const std::string& divisor : divisors) text += divisor;
  return text;
}

Tree call(const std::string& name, const Tree& argument) {
  Node node{};
  node.kind = Node::Kind::call;
  node.text = name;
  node.children = {argument};
  node.inverse = {false};
  return std::make_shared<const Node>(std::move(node));
}

namespace {

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool is_circular(const std::string& name) {
  return is_one_of(name, {"sin", "cos", "tan", "cot", "sec", "csc"});
}
bool is_real(const std::string& name) {
  return is_one_of(name, {"exp", "sinh", "cosh", "tanh", "coth", "sech", "csch"});
}

Tree logarithm(const Tree& power) { return call("log", power->children[0]); }
ex exponent_of(const Tree& power, const CertifiedStatement& q) {
  return q.value((lower(power->children[1], q.symbols) * lower(logarithm(power), q.symbols)).expand());
}

namespace {

/// Everything that has to be said of these trees: Phases that know all their arguments, and all that those
/// are made of.
class Needs {
 public:
  Needs(const CertifiedStatement& question, const std::vector<Tree>& trees) : q_(question) {
    for (const Tree& tree : trees) visit(tree);
    for (std::size_t known = 0; known < expressions_.size();) {
      known = expressions_.size();
      const Phases phases(expressions_, q_.symbols);
      for (const Generator& g : phases.generators())
        if (g.kind != Kind::imaginary && seen_.insert(g.meaning).second) {
          visit(to_tree(name_of(g.meaning) == "abs" ? g.meaning.op(0) : g.meaning, q_.symbols));
          if (name_of(g.meaning) == "log") add(GiNaC::pow(g.meaning.op(0), numeric(1, g.divisor)));
        }
    }
  }
  const std::vector<ex>& expressions() const { return expressions_; }

 private:
  /// Twice the argument, too: GiNaC knows cos(asin(x)), but not cos(2*asin(x)).
  void argument(const ex& x, bool circular) {
    for (const ex& e : {x, (2 * x).expand()})
      if (circular)
        add(GiNaC::cos(e)), add(GiNaC::sin(e));
      else
        add(GiNaC::cosh(e));
  }
  void add(const ex& e) {
    if (seen_.insert(e).second) expressions_.push_back(e);
  }
  void visit(const Tree& tree) {
    for (const Tree& child : tree->children) visit(child);
    if (q_.is_root(tree) && !q_.rational(tree->children[1])) {
      visit(logarithm(tree));
      return argument(exponent_of(tree, q_), false);
    }
    if (tree->kind != Node::Kind::call && !q_.is_root(tree)) return;
    const ex value = q_.value(tree);
    add(value);
    if (is_circular(tree->text) || is_real(tree->text))
      argument(q_.value(tree->children[0]), is_circular(tree->text));
    else if (is_one_of(tree->text, {"asin", "acos", "atan", "log", "asinh", "acosh", "atanh"}))
      argument(value, is_circular(tree->text.substr(1)));
  }

  const CertifiedStatement& q_;
  std::vector<ex> expressions_;
  std::set<ex, GiNaC::ex_is_less> seen_;
};

}  // namespace

ex CertifiedStatement::value(const ex& e) const {
  struct : GiNaC::map_function {
    ex operator()(const ex& part) override {
      if (!is_a<GiNaC::power>(part) || is_a<numeric>(part.op(1))) return part.map(*this);
      return GiNaC::exp((*this)(part.op(1)) * GiNaC::log((*this)(part.op(0))));
    }
  } as_exponentials;
  return prepare(as_exponentials(put_in(e, given)), symbols).subs(equal, GiNaC::subs_options::no_pattern);
}

std::vector<ex> expressions_in(const CertifiedStatement& statement, const std::vector<Tree>& trees) {
  return Needs(statement, trees).expressions();
}

}  // namespace rederive
