#include <algorithm>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_steps.hpp>
#include <sstream>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Json = nlohmann::ordered_json;
using Kind = Generator::Kind;

/// A polynomial as text, term by term: "3*x^2*z1 - 1/2".
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
  const ex parts = rational.normal().numer_denom();
  const std::string above = polynomial_text(parts.op(0)), below = polynomial_text(parts.op(1));
  return below == "1" ? above : "(" + above + ")/(" + below + ")";
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
bool is_circular(const std::string& name) {
  return is_one_of(name, {"sin", "cos", "tan", "cot", "sec", "csc"});
}
bool is_real(const std::string& name) {
  return is_one_of(name, {"exp", "sinh", "cosh", "tanh", "coth", "sech", "csch"});
}

/// sin x from e^{ix}, sinh x from e^x, and so on.
ex of_unit(const std::string& function, const ex& unit, const ex& i) {
  if (function == "exp") return unit;
  const ex sum = (unit + 1 / unit) / 2, difference = (unit - 1 / unit) / 2;
  if (function.ends_with('h'))
    return function == "sinh" ? difference : function == "cosh" ? sum : difference / sum;
  return function == "sin" ? difference / i : function == "cos" ? sum : difference / i / sum;
}

std::string exponent_text(const std::string& argument, bool circular) {
  return (circular ? "$i*(" : "(") + argument + ")";
}

/// The logarithm that a power with a symbolic exponent stands for.
Tree logarithm(const Tree& power) { return call("log", power->children[0]); }
ex exponent_of(const Tree& power, const CertifiedStatement& q) {
  return q.value((lower(power->children[1], q.symbols) * lower(logarithm(power), q.symbols)).expand());
}

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
    for (const ex& e : {x, (2 * x).expand()}) add(circular ? GiNaC::cos(e) : GiNaC::cosh(e));
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

void Steps::tree(const Tree& tree) {
  for (const Tree& child : tree->children) this->tree(child);
  if (tree->kind == Node::Kind::symbol) return given(tree->text);
  if (tree->kind != Node::Kind::call && !q_.is_root(tree)) return;
  if (!done_.insert(q_.text(tree)).second) return;
  if (is_circular(tree->text) || is_real(tree->text)) {
    const bool is_even = tree->text == "cos" || tree->text == "cosh", circular = is_circular(tree->text);
    const ex argument = q_.value(tree->children[0]);
    if (is_even && name_of(argument) == "abs")  // cos|u| = cos u
      unit(to_tree(argument.op(0), q_.symbols), argument.op(0), circular);
    else
      unit(tree->children[0], argument, circular);
  } else if (tree->kind == Node::Kind::call || q_.rational(tree->children[1]))
    value(tree);
  else
    this->tree(logarithm(tree)),
        unit(to_tree(exponent_of(tree, q_), q_.symbols), exponent_of(tree, q_), false);
}
void Steps::generators(const ex& rational) {
  for (const Generator& g : phases_.generators())
    if (rational.has(g.symbol)) generator(g);
}

void Steps::given(const std::string& name) {
  for (const Given& g : q_.given)
    if (ex_to<GiNaC::symbol>(g.name).get_name() == name && done_.insert("given " + name).second) {
      tree(to_tree(g.value, q_.symbols));
      steps_.push_back({{"given", name}});
    }
}
void Steps::generator(const Generator& g) {
  const std::string name = g.symbol.get_name();
  if (g.kind == Kind::imaginary || g.kind == Kind::pi || !done_.insert(name).second) return;
  const ex of = g.kind == Kind::opaque ? g.meaning.op(0) : g.meaning;
  tree(to_tree(of, q_.symbols));
  Json step{{"generator", name}, {"function", "exp"}, {"of", {text(of)}}};
  if (g.kind == Kind::root)
    step["function"] = "^", step["of"].push_back("1/" + std::to_string(g.divisor));
  else if (g.kind == Kind::opaque)
    step["function"] = name_of(g.meaning) == "abs" ? "fabs" : name_of(g.meaning);
  else
    step["of"][0] = exponent_text(text(of), g.kind == Kind::circular) + "/" + std::to_string(g.divisor);
  if (g.degree > 0 && step["function"] == "exp") return relation(g, step);
  steps_.push_back(step);
}
/// The power of e that stands in the relation comes first: with it the new name may be replaced.
void Steps::relation(const Generator& g, const Json& step) {
  const std::string name = g.symbol.get_name();
  const auto relate = [&](const std::string& to, int degree) {
    steps_.push_back({{"relation", to}, {"degree", std::to_string(degree)}});
  };
  if (g.meaning.is_equal(GiNaC::Pi)) {  // z^n = -1, and i is one of its powers
    power_of_e("$i*pi", -1, Json::object(), 1);
    steps_.push_back(step);
    relate(name, g.divisor);
    power_of_e("$i*pi/2", GiNaC::pow(g.symbol, g.divisor / 2), {{name, g.divisor / 2}}, 0);
    relate("$i", 1);
    return;
  }
  const bool is_log = name_of(g.meaning) == "log";  // e^{log(u)/n} is u^{1/n}
  const int over = is_log ? g.divisor : 1;
  const ex value = is_log ? phases_(GiNaC::pow(g.meaning.op(0), numeric(1, over))) : g.value;
  generators(value);
  const std::string exponent = exponent_text(text(g.meaning), g.kind == Kind::circular);
  steps_.push_back({{"function", "exp"},
                    {"of", {exponent + "/" + std::to_string(over)}},
                    {"is", fraction_text(value)},
                    {"inverse", name_of(g.meaning)},
                    {"at", text(g.meaning.op(0))},
                    {"over", over}});
  steps_.push_back(step);
  relate(name, g.divisor / over);
}
void Steps::power_of_e(const std::string& exponent, const ex& is, const Json& generators,
                       const numeric& turn) {
  steps_.push_back({{"function", "exp"},
                    {"of", {exponent}},
                    {"is", fraction_text(is)},
                    {"generators", generators},
                    {"turn", polynomial_text(turn)}});
}
/// e^argument, or e^{i argument}, as a product of generators and a root of unity.
void Steps::unit(const Tree& written, const ex& argument, bool circular) {
  const std::string of = exponent_text(q_.text(written), circular);
  if (!done_.insert(of).second) return;
  const auto [exponents, q] = phases_.combination(argument, circular);
  Json powers = Json::object();
  ex product = phases_.turn(q);
  for (const Generator& g : phases_.generators())
    for (const auto& [symbol, n] : exponents)
      if (g.symbol.is_equal(symbol)) powers[symbol.get_name()] = n.to_int(), product *= GiNaC::pow(symbol, n);
  generators(product);
  power_of_e(of, product, powers, q);
}
/// is^q - base^p for a root, an absolute value or another power; f(is) - u for the inverse function of f.
ex Steps::difference(const Tree& tree, const ex& value, const ex& is) {
  const ex of = phases_(q_.value(tree->children[0]));
  if (tree->text == "fabs") return is * is - of * of;
  if (tree->text == "sqrt") return is * is - of;
  if (tree->kind == Node::Kind::power) {
    const numeric q = *q_.rational(tree->children[1]);
    return GiNaC::pow(is, q.denom()) - GiNaC::pow(of, q.numer());
  }
  const std::string forward = tree->text == "log" ? "exp" : tree->text.substr(1);
  this->tree(to_tree(value, q_.symbols));
  unit(to_tree(value, q_.symbols), value, is_circular(forward));
  const ex e = phases_.exponential(value, is_circular(forward));
  return of_unit(forward, e, phases_.generators().front().symbol) - of;
}

/// A root or an inverse function in the generators.
void Steps::value(const Tree& tree) {
  const ex value = q_.value(tree), is = phases_(value).normal();
  generators(is);
  for (const Generator& g : phases_.generators())
    if (g.kind == Kind::opaque && is.is_equal(g.symbol) && name_of(g.meaning) == tree->text) return;
  ex difference = this->difference(tree, value, is);
  for (const Generator& g : phases_.generators())  // that of a logarithm was given as a root
    if (g.kind == Kind::real && name_of(g.meaning) == "log" && difference.has(g.symbol))
      difference = difference.subs(g.symbol == phases_(GiNaC::pow(g.meaning.op(0), numeric(1, g.divisor))));
  const auto c = cofactor(phases_.reduce(difference.normal().numer()), phases_, q_.symbols);
  if (!c) throw Undecidable("no polynomial identity gives the value of " + q_.text(tree));
  generators(*c);
  Json of = Json::array();
  for (const Tree& child : tree->children) of.push_back(q_.text(child));
  if (tree->text == "sqrt") of.push_back("1/2");
  steps_.push_back({{"function", of.size() > 1 ? "^" : tree->text},
                    {"of", of},
                    {"is", fraction_text(is)},
                    {"cofactor", polynomial_text(*c)}});
}

}  // namespace rederive
