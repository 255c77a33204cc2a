#include <algorithm>
#include <derivations/algebra/factor_form.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Generator::Kind;

namespace {

bool is_circular(const std::string& name) { return name == "sin" || name == "cos"; }
bool is_real_exponential(const std::string& name) {
  return name == "sinh" || name == "cosh" || name == "exp";
}

/// log(u) for a u whose roots are generators of their own.
bool is_logarithm_of_root(const ex& e) {
  return name_of(e) == "log" && (is_a<GiNaC::symbol>(e.op(0)) || is_a<numeric>(e.op(0)));
}

bool is_fractional_power(const ex& e) {
  return is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1)) && !ex_to<numeric>(e.op(1)).is_integer();
}

}  // namespace

Phases::Phases(const std::vector<ex>& expressions, const Symbols& symbols) : symbols_(symbols) {
  for (const ex& e : expressions) collect(prepared_[e] = prepare(e, symbols_));
  make_generators();
}

/// First walk: which arguments, which roots, which functions that stay as they are.
void Phases::collect(const ex& e) {
  const std::string name = name_of(e);
  if (is_circular(name) || is_real_exponential(name)) {
    arguments_.push_back({e.op(0), is_circular(name)});
    for (auto part = e.op(0).preorder_begin(); part != e.op(0).preorder_end(); ++part)
      if (const ex under = under_the_root(*part); !under.is_zero()) {
        collect(part->op(0));
        collect(prepare(GiNaC::pow(under, numeric(1, 2)), symbols_));
      } else if (name_of(*part) == "log") {
        collect(part->op(0));
      }
    return;
  }
  if (!name.empty()) {
    opaques_.push_back(e);
    if (name == "abs") collect(e.op(0));
    return;
  }
  if (is_fractional_power(e)) {
    long& denominator = roots_.try_emplace(e.op(0), 1).first->second;
    denominator = GiNaC::lcm(numeric(denominator), ex_to<numeric>(e.op(1)).denom()).to_long();
    if (denominator > 64) throw Undecidable("roots of a degree above 64");
    if (!is_a<GiNaC::symbol>(e.op(0)) && !is_a<numeric>(e.op(0))) collect(e.op(0));
    return;
  }
  if (is_a<GiNaC::power>(e) && !is_a<numeric>(e.op(1))) throw Undecidable("a power with a symbolic exponent");
  for (const ex& part : e) collect(part);
}

void Phases::make_generators() {
  const auto add = [&](Kind kind, const std::string& name, const ex& meaning) -> Generator& {
    generators_.push_back({kind, GiNaC::symbol(name), meaning, 1, 0, 0});
    return generators_.back();
  };
  Generator& imaginary = add(Kind::imaginary, "$i", GiNaC::I);
  imaginary.degree = 2;
  imaginary.value = -1;
  generators_.push_back({Kind::pi, pi_symbol(), GiNaC::Pi, 1, 0, 0});

  find_denominator();
  find_units();
  std::map<ex, long, GiNaC::ex_is_less> divisors[2];
  std::vector<numeric> turns;
  for (const auto& [argument, circular] : arguments_) {
    const Argument taken = take_apart(argument, circular);
    for (const auto& [phase, coefficient] : taken.parts) {
      long& n = divisors[circular].try_emplace(phase, 1).first->second;
      const numeric common = GiNaC::lcm(numeric(n), coefficient.denom());
      if (common > 1000) throw Undecidable("a phase with a denominator above 1000");
      n = common.to_long();
      if (GiNaC::abs(coefficient * common) > 4000) throw Undecidable("a phase with a multiple above 4000");
    }
    if (circular && !taken.pi.is_integer()) turns.push_back(taken.pi);
  }
  make_turns(turns);
  for (const auto& [phase, n] : divisors[false])
    if (is_logarithm_of_root(phase) && n > 1) {  // e^{log(u)/n} is the n-th root of u
      long& denominator = roots_.try_emplace(phase.op(0), 1).first->second;
      denominator = GiNaC::lcm(numeric(denominator), numeric(n)).to_long();
      if (denominator > 64) throw Undecidable("roots of a degree above 64");
    }
  for (const auto& [base, degree] : roots_) {
    if (degree == 2 && !root_of_turns(base).is_zero()) continue;
    // the root of a symbol or a prime generates; that of anything else is tied to what stands under it
    const bool free = is_a<GiNaC::symbol>(base);
    Generator& generator = add(Kind::root, "$r" + std::to_string(generators_.size()), base);
    generator.divisor = generator.degree = static_cast<int>(degree);
    if (free)
      generator.degree = 0;
    else if (is_a<numeric>(base))
      generator.value = base;
  }
  for (const int circular : {1, 0})
    for (const auto& [phase, n] : divisors[circular]) {
      Generator& generator = add(circular == 1 ? Kind::circular : Kind::real,
                                 (circular == 1 ? "$z" : "$h") + std::to_string(generators_.size()), phase);
      generator.divisor = static_cast<int>(n);
    }
  for (const ex& value : opaques_)
    if (find(Kind::opaque, value) == nullptr)
      add(Kind::opaque, "$f" + std::to_string(generators_.size()), value);

  for (std::size_t k = 0; k < generators_.size(); ++k) {  // relations, now that all generators are there
    Generator& generator = generators_[k];
    const bool is_tied = !is_a<GiNaC::symbol>(generator.meaning) && !is_a<numeric>(generator.meaning);
    if (generator.kind == Kind::root && is_tied) generator.value = rewrite(generator.meaning);
    if (generator.kind == Kind::opaque && name_of(generator.meaning) == "abs") {
      generator.degree = 2;
      generator.value = GiNaC::pow(rewrite(generator.meaning.op(0)), 2);
    }
    if (generator.kind == Kind::real && name_of(generator.meaning) == "log") {
      generator.degree = generator.divisor;
      generator.value = rewrite(generator.meaning.op(0));
    }
    if (generator.kind == Kind::circular || generator.kind == Kind::real) relate_inverse(generator);
  }
  join_equal_sizes();
}

/// |u| and |v| are one where u^2 and v^2 are.
void Phases::join_equal_sizes() {
  std::vector<Generator*> sizes;
  for (Generator& generator : generators_)
    if (generator.kind == Kind::opaque && name_of(generator.meaning) == "abs") sizes.push_back(&generator);
  for (std::size_t k = 1; k < sizes.size(); ++k)
    for (std::size_t j = 0; j < k && sizes[k]->degree == 2; ++j)
      if (sizes[j]->degree == 2 && reduce((sizes[k]->value - sizes[j]->value).normal().numer()).is_zero())
        sizes[k]->degree = 1, sizes[k]->value = sizes[j]->symbol;
}

ex Phases::operator()(const ex& expression) const {
  const auto seen = prepared_.find(expression);
  return rewrite(seen != prepared_.end() ? seen->second : prepare(expression, symbols_));
}

/// Second walk: every function becomes a rational function of generators.
ex Phases::rewrite(const ex& e) const {
  if (is_a<numeric>(e)) {
    if (!ex_to<numeric>(e).is_rational()) throw Undecidable("a number that is not exact");
    return e;
  }
  if (e.is_equal(GiNaC::Pi)) return pi_symbol();
  if (is_a<GiNaC::symbol>(e)) {
    const Generator* generator = find(Kind::root, e);
    return generator != nullptr ? GiNaC::pow(generator->symbol, generator->divisor) : e;
  }
  if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) {
    ex result = is_a<GiNaC::add>(e) ? 0 : 1;
    for (const ex& part : e) is_a<GiNaC::add>(e) ? result += rewrite(part) : result *= rewrite(part);
    return result;
  }
  if (is_fractional_power(e)) return root(e.op(0), ex_to<numeric>(e.op(1)));
  if (is_a<GiNaC::power>(e)) return GiNaC::pow(rewrite(e.op(0)), e.op(1));
  const std::string name = name_of(e);
  const ex i = generators_.front().symbol;
  if (is_circular(name)) {
    const ex unit = exponential(e.op(0), true);
    return name == "sin" ? (unit - 1 / unit) / (2 * i) : (unit + 1 / unit) / 2;
  }
  if (is_real_exponential(name)) {
    const ex unit = exponential(e.op(0), false);
    return name == "exp" ? unit : name == "sinh" ? (unit - 1 / unit) / 2 : (unit + 1 / unit) / 2;
  }
  return opaque(e);
}

std::pair<std::vector<std::pair<GiNaC::symbol, numeric>>, numeric> Phases::combination(const ex& argument,
                                                                                       bool circular) const {
  const Argument taken = take_apart(argument, circular);
  std::vector<std::pair<GiNaC::symbol, numeric>> exponents;
  for (const auto& [phase, coefficient] : taken.parts) {
    const Generator* generator = find(circular ? Kind::circular : Kind::real, phase);
    if (generator == nullptr || !(coefficient * generator->divisor).is_integer())
      throw Undecidable("an argument that was not seen before");
    exponents.push_back({generator->symbol, coefficient * generator->divisor});
  }
  const Generator* turn = circular ? find(Kind::circular, GiNaC::Pi) : nullptr;
  if (turn == nullptr) {
    if (!is_tabled(taken.pi)) throw Undecidable("a multiple of pi that was not seen before");
    return {exponents, taken.pi};
  }
  if (!(taken.pi * turn->divisor).is_integer())
    throw Undecidable("a multiple of pi that was not seen before");
  const numeric turns = taken.pi * turn->divisor, rest = GiNaC::mod(turns, 2 * turn->divisor);
  if (!rest.is_zero()) exponents.push_back({turn->symbol, rest});
  return {exponents, (turns - rest) / turn->divisor};
}

ex Phases::turn(const numeric& q) const {
  if (q.is_zero()) return 1;
  return rewrite(prepare(GiNaC::cos(q * GiNaC::Pi), symbols_)) +
         generators_.front().symbol * rewrite(prepare(GiNaC::sin(q * GiNaC::Pi), symbols_));
}

ex Phases::exponential(const ex& argument, bool circular) const {
  const auto [exponents, pi] = combination(argument, circular);
  ex result = turn(pi);
  for (const auto& [symbol, exponent] : exponents) {
    const auto g = std::find_if(generators_.begin(), generators_.end(),
                                [&s = symbol](const Generator& other) { return other.symbol.is_equal(s); });
    if (!circular && is_logarithm_of_root(g->meaning))
      result *= rewrite(GiNaC::pow(g->meaning.op(0), exponent / g->divisor));
    else
      result *= GiNaC::pow(symbol, exponent);
  }
  return result;
}

ex Phases::root(const ex& base, const numeric& exponent) const {
  const Generator* generator = find(Kind::root, base);
  if (generator == nullptr) {
    const ex of_turns = root_of_turns(base);
    if (of_turns.is_zero() || !(2 * exponent).is_integer())
      throw Undecidable("a root that was not seen before");
    return GiNaC::pow(of_turns, 2 * exponent);
  }
  return GiNaC::pow(generator->symbol, exponent * generator->divisor);
}

ex Phases::opaque(const ex& value) const {
  const Generator* generator = find(Kind::opaque, value);
  if (generator == nullptr)
    throw Undecidable("the function " + name_of(value) + " in a place where it is not handled");
  return generator->symbol;
}

const Generator* Phases::find(Kind kind, const ex& meaning) const {
  for (const Generator& generator : generators_)
    if (generator.kind == kind && generator.meaning.is_equal(meaning)) return &generator;
  return nullptr;
}

}  // namespace rederive
