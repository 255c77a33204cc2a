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

/// The exponent of a power of e that is a generator.
std::string exponent_text(const Generator& g, const Symbols& symbols) {
  const std::string whole =
      exponent_text(print(g.meaning, Notation::plain, symbols), g.kind == Kind::circular);
  return g.divisor == 1 ? whole : whole + "/" + std::to_string(g.divisor);
}

bool is_exponential(const Generator& g) { return g.kind == Kind::circular || g.kind == Kind::real; }

std::string turn_text(const numeric& q) { return "$i*pi*(" + polynomial_text(q) + ")"; }

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

Steps::Steps(const CertifiedStatement& statement, const Phases& phases) : q_(statement), phases_(phases) {
  for (const Generator& g : phases.generators())
    if (g.kind == Kind::real && name_of(g.meaning) == "log")
      logarithms_[g.symbol] = phases(GiNaC::pow(g.meaning.op(0), numeric(1, g.divisor)));
}

ex Steps::with_roots(const ex& rational) const {
  return rational.subs(logarithms_, GiNaC::subs_options::no_pattern);
}
ex Steps::out(const ex& rational) const {
  const ex parts = with_roots(rational).normal().numer_denom();
  ex above = 1, below = 1;
  const ex numerator = phases_.reduce(parts.op(0), &above), denominator = phases_.reduce(parts.op(1), &below);
  return (numerator * below / (denominator * above)).normal();
}

/// With what z^n + 1 has besides the minimal polynomial of z = e^{iπ/n}.
ex Steps::out_cofactor(const ex& cofactor) const {
  ex turns = 1;
  for (const Generator& g : phases_.generators())
    if (g.kind == Kind::circular && g.meaning.is_equal(GiNaC::Pi))
      turns =
          GiNaC::quo(GiNaC::pow(g.symbol, g.divisor) + 1, GiNaC::pow(g.symbol, g.degree) - g.value, g.symbol);
  return with_roots(cofactor) * turns;
}

void Steps::tree(const Tree& tree) {
  for (const Tree& child : tree->children) this->tree(child);
  if (tree->kind == Node::Kind::symbol) return given(tree->text);
  if (tree->kind != Node::Kind::call && !q_.is_root(tree)) return;
  if (!done_.insert(q_.text(tree)).second) return;
  if (is_circular(tree->text) || is_real(tree->text)) {
    const ex argument = q_.value(tree->children[0]);
    const bool is_even = tree->text == "cos" || tree->text == "cosh", circular = is_circular(tree->text);
    if (is_even && name_of(argument) == "abs")  // cos|u| = cos u
      unit(to_tree(argument.op(0), q_.symbols), argument.op(0), circular);
    else
      unit(tree->children[0], argument, circular);
  } else if (tree->kind == Node::Kind::call || q_.rational(tree->children[1])) {
    value(tree);
  } else {
    this->tree(logarithm(tree));
    unit(to_tree(exponent_of(tree, q_), q_.symbols), exponent_of(tree, q_), false);
  }
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
  if (is_exponential(g)) return exponential(g);
  if (g.kind == Kind::opaque && name_of(g.meaning) != "abs") return inverse_function(g);
  const ex of = g.kind == Kind::root ? g.meaning : g.meaning.op(0);
  tree(to_tree(of, q_.symbols));
  if (g.kind == Kind::root)
    steps_.push_back({{"function", "^1/" + std::to_string(g.divisor)}, {"of", text(of)}, {"name", name}});
  else  // |u| is the root of u^2
    steps_.push_back({{"function", "^1/2"}, {"of", "(" + text(of) + ")^2"}, {"name", name}});
}
void Steps::inverse_function(const Generator& g) {
  const ex of = g.meaning.op(0);
  tree(to_tree(of, q_.symbols));
  Json step{{"function", name_of(g.meaning)}, {"of", text(of)}, {"name", g.symbol.get_name()}};
  for (const Generator& power : phases_.generators())
    if (is_exponential(power) && power.degree > 0 && power.meaning.is_equal(g.meaning)) {
      const bool is_log = name_of(g.meaning) == "log";
      if (!is_log) generators(power.value);
      step["unit"] = is_log ? text(of) : fraction_text(with_roots(power.value));
    }
  steps_.push_back(step);
}
/// A free one, a root of unity, or one of an inverse function, which comes from the unit of that one.
void Steps::exponential(const Generator& g) {
  tree(to_tree(g.meaning, q_.symbols));
  Json step{{"function", "exp"}, {"of", exponent_text(g, q_.symbols)}, {"name", g.symbol.get_name()}};
  if (g.degree > 0) {
    const bool is_turn = g.meaning.is_equal(GiNaC::Pi);
    Generator whole = g;
    whole.divisor = 1;
    step["power"] = is_turn ? g.divisor / 2 : g.divisor;
    step["from"] = {{is_turn ? "$i*pi/2" : exponent_text(whole, q_.symbols), 1}};
  }
  if (const auto root = logarithms_.find(g.symbol); root != logarithms_.end()) {
    generators(root->second);
    step.erase("name"), step["is"] = fraction_text(root->second);
  }
  steps_.push_back(step);
}
/// e^{iqπ}, of which a power is a power of i.
void Steps::turn(const numeric& q) {
  if (q.is_zero() || !done_.insert(turn_text(q)).second) return;
  generators(phases_.turn(q));
  steps_.push_back({{"function", "exp"},
                    {"of", turn_text(q)},
                    {"is", fraction_text(phases_.turn(q))},
                    {"power", (2 * q).denom().to_int()},
                    {"from", {{"$i*pi/2", (2 * q).numer().to_int()}}}});
}
/// e^argument, or e^{i argument}, as a product of generators and a root of unity.
void Steps::unit(const Tree& written, const ex& argument, bool circular) {
  const std::string of = exponent_text(q_.text(written), circular);
  if (!done_.insert(of).second) return;
  const auto [exponents, q] = phases_.combination(argument, circular);
  Json from = Json::object();
  ex product = phases_.turn(q);
  turn(q);
  if (!q.is_zero()) from[turn_text(q)] = 1;
  for (const Generator& g : phases_.generators())
    for (const auto& [symbol, n] : exponents)
      if (g.symbol.is_equal(symbol)) {
        generator(g);
        from[exponent_text(g, q_.symbols)] = n.to_int(), product *= GiNaC::pow(symbol, n);
      }
  steps_.push_back(
      {{"function", "exp"}, {"of", of}, {"is", fraction_text(with_roots(product))}, {"from", from}});
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
  generators(out(is));
  for (const Generator& g : phases_.generators())
    if (g.kind == Kind::opaque && is.is_equal(g.symbol) && name_of(g.meaning) == tree->text) return;
  const ex difference = out(this->difference(tree, value, is));
  const auto c = cofactor(phases_.reduce(difference.normal().numer()), phases_, q_.symbols);
  if (!c) throw Undecidable("no polynomial identity gives the value of " + q_.text(tree));
  generators(out(*c));
  std::string function = tree->text, of = q_.text(tree->children[0]);
  if (function == "fabs") of = "(" + of + ")^2";
  if (function == "fabs" || function == "sqrt") function = "^1/2";
  if (tree->kind == Node::Kind::power) {
    const numeric q = *q_.rational(tree->children[1]);
    function = "^" + std::to_string(q.numer().to_int()) + "/" + std::to_string(q.denom().to_int());
  }
  Json step{{"function", function}, {"of", of}, {"is", fraction_text(out(is))}};
  if (const ex whole = out_cofactor(*c); !whole.is_equal(1)) step["cofactor"] = polynomial_text(whole);
  steps_.push_back(step);
}

}  // namespace rederive
