#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/certificate_steps.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Json = nlohmann::ordered_json;
using Kind = Generator::Kind;

namespace {

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

}  // namespace

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
    const bool is_even = tree->text == "cos" || tree->text == "cosh", circular = is_circular(tree->text);
    const Tree& of = tree->children[0];
    const ex argument = q_.value(of);
    if (is_even && of->kind == Node::Kind::call && of->text == "fabs")  // cos|u| = cos u
      unit(of->children[0], q_.value(of->children[0]), circular);
    else if (is_even && name_of(argument) == "abs")
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
/// e^{2πi n} = 1, where n is a power of 1000: a thousandth of it comes first.
void Steps::whole_turns(const numeric& n) {
  if (!done_.insert(turn_text(2 * n)).second) return;
  if (n > 1) whole_turns(n / 1000);
  const std::string from = n > 1 ? turn_text(2 * n / 1000) : "$i*pi/2";
  steps_.push_back(
      {{"function", "exp"}, {"of", turn_text(2 * n)}, {"is", "1"}, {"from", {{from, n > 1 ? 1000 : 4}}}});
}
/// e^{iqπ}, of which a power is a power of i; whole turns by their digits in thousands.
void Steps::turn(const numeric& q) {
  for (numeric unit = 1000; 2 * unit <= q; unit *= 1000)
    if (q == 2 * unit) return whole_turns(unit);
  if (q.is_zero() || !done_.insert(turn_text(q)).second) return;
  generators(phases_.turn(q));
  if (GiNaC::abs(q) > 100) {
    const numeric whole = GiNaC::iquo((q / 2).numer(), (q / 2).denom()), rest = q - 2 * whole;
    Json from = Json::object();
    if (!rest.is_zero()) turn(rest), from[turn_text(rest)] = 1;
    numeric left = whole;
    for (numeric unit = 1; !left.is_zero(); unit *= 1000, left = GiNaC::iquo(left, 1000))
      if (const numeric digit = GiNaC::irem(left, 1000); !digit.is_zero())
        whole_turns(unit), from[turn_text(2 * unit)] = digit.to_int();
    steps_.push_back(
        {{"function", "exp"}, {"of", turn_text(q)}, {"is", fraction_text(phases_.turn(q))}, {"from", from}});
    return;
  }
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
  const ex whole = out_cofactor(*c);
  generators(whole);
  std::string function = tree->text, of = q_.text(tree->children[0]);
  if (function == "fabs") of = "(" + of + ")^2";
  if (function == "fabs" || function == "sqrt") function = "^1/2";
  if (tree->kind == Node::Kind::power) {
    const numeric q = *q_.rational(tree->children[1]);
    function = "^" + std::to_string(q.numer().to_int()) + "/" + std::to_string(q.denom().to_int());
  }
  Json step{{"function", function}, {"of", of}, {"is", fraction_text(out(is))}};
  if (!whole.is_equal(1)) step["cofactor"] = polynomial_text(whole);
  steps_.push_back(step);
}

}  // namespace rederive
