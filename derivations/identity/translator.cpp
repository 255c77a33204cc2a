#include <algorithm>
#include <derivations/identity/translator.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/syntax.hpp>
#include <utility>

namespace rederive::identity {
using namespace language;
using namespace numbers;

using cln::cl_RA;

Fraction Translator::operator()(const Tree& tree, std::vector<Atom>& conditions) {
  argument_.reset(), conditions_ = &conditions;
  return translate(tree);
}

void Translator::require(const Fraction& value, Signs allowed, const Tree& tree) {
  if (value.is_constant()) {
    if (!ring_.signs_of(value).within(allowed)) throw NoValue("a part of it never has a value");
    return;
  }
  conditions_->push_back({value, allowed, tree});
}

Fraction Translator::translate(const Tree& tree) {
  const Node& node = *tree;
  if (node.kind == Node::Kind::number) return Fraction(exact(node.text));
  if (node.kind == Node::Kind::symbol)
    return argument_ && node.text == "u" ? *argument_ : node.text == "pi" ? pi() : symbol(node.text);
  if (node.kind == Node::Kind::negative) return -translate(node.children[0]);
  if (node.kind == Node::Kind::power) return power_of(tree);
  if (node.kind == Node::Kind::call) return call(node);
  const bool is_sum = node.kind == Node::Kind::sum;
  Fraction result = is_sum ? 0 : 1;
  for (std::size_t k = 0; k < node.children.size(); ++k) {
    const Fraction part = translate(node.children[k]);
    if (!is_sum && node.inverse[k]) require(part, Signs::nonzero(), node.children[k]);
    result = of_value_or_whole(part, [&](const Fraction& x) {
      if (is_sum) return node.inverse[k] ? result - x : result + x;
      return ring_.normal(node.inverse[k] ? result / x : result * x);
    });
  }
  return ring_.normal(result);
}

/// Returns the value as one unknown, of which only the range is known.
Fraction Translator::whole(const Fraction& value) {
  return ring_.generator("whole", value, [&] {
    return Generator{ring_.meaning_of(value), ring_.range_of(value), "whole", value};
  });
}

/// Returns b^e: a root if the exponent is a fraction, else e^{e log b} if the base is positive. For other
/// bases it is one unknown, because only integer exponents have values; 0 is excluded.
Fraction Translator::power_of(const Tree& tree) {
  const Node& node = *tree;
  const Fraction base = translate(node.children[0]), exponent = translate(node.children[1]);
  if (!exponent.is_constant()) {
    if (ring_.signs_of(base) == Signs::positive())
      return exponential(ring_.normal(exponent * logarithm(base)));
    if (base.is_zero()) throw Undecidable("a power of 0 has a symbolic exponent");
    const std::string name = "to the power " + std::to_string(whole(exponent).numerator.used().at(0));
    const Fraction power = ring_.generator(name, base, [&] {
      return Generator{pow(ring_.meaning_of(base), ring_.meaning_of(exponent)), {}, "power", base};
    });
    require(power, Signs::nonzero(), tree);
    return power;
  }
  const cl_RA number = exponent.constant();
  const bool is_whole = cln::denominator(number) == 1,
             needs_nonzero = !cln::plusp(number);  // 0^0 has no value
  if (!is_whole) require(base, needs_nonzero ? Signs::positive() : Signs::nonnegative(), node.children[0]);
  if (is_whole && needs_nonzero) require(base, Signs::nonzero(), node.children[0]);
  return of_value_or_whole(base, [&](const Fraction& x) {
    return is_whole ? raised(x, number) : root_of(node.children[0], x, number);
  });
}

/// Returns base^exponent; the base must not be negative if the exponent is a fraction.
Fraction Translator::raised(const Fraction& base, const cl_RA& exponent) {
  if (cln::abs(exponent) > 64 || cln::denominator(exponent) > 180) throw TooLarge("an exponent is too large");
  const int n = cln::cl_I_to_int(cln::numerator(exponent)),
            order = cln::cl_I_to_int(cln::denominator(exponent));
  const Fraction factor = order > 1 ? root(base, order) : base;
  Fraction result = 1;
  for (int k = 0; k < std::abs(n); ++k) result = ring_.normal(result * factor);
  return n < 0 ? ring_.normal(1 / result) : result;
}

Fraction Translator::call(const Node& node) {
  const std::string& name = node.text;
  const Tree& argument = node.children[0];
  const bool is_of_cosh = argument->kind == Node::Kind::call && argument->text == "cosh";
  if (name == "acosh" && is_of_cosh) return absolute(translate(argument->children[0]));
  const Fraction x = translate(argument);
  const auto known = name == "atan"                     ? known_angle(false, x)
                     : name == "asin" || name == "acos" ? known_angle(true, x)
                                                        : std::nullopt;
  if (known) return name == "acos" ? pi() / 2 - *known : *known;
  const auto of_x = [&](const Tree& tree) {  // the conditions of the parts are those of the whole
    const std::size_t before = conditions_->size();
    const auto outer = std::exchange(argument_, x);
    const Fraction result = translate(tree);
    argument_ = outer;  // if something is thrown, at the next round
    conditions_->erase(conditions_->begin() + static_cast<std::ptrdiff_t>(before), conditions_->end());
    return result;
  };
  const RewriteRule& rule = rewrite_rule(name);
  for (const auto& [value, signs] : rule.domain) require(of_x(value), signs, put_in(value, "u", argument));
  if (rule.result) return of_x(rule.result);
  return of_value_or_whole(x, [&](const Fraction& of) {
    if (name == "sin") return circular(of).second;
    if (name == "cos") return circular(of).first;
    if (name == "sqrt") return root_of(argument, of, cl_RA(1) / 2);
    if (name == "fabs") return absolute(of);
    if (name == "exp") return exponential(of);
    if (name == "log") return logarithm(of);
    if (name == "atan" || name == "asin") return angle(name == "asin", of);
    throw Undecidable("unknown function " + name);
  });
}

Fraction Translator::symbol(const std::string& name) {
  const Fraction variable = ring_.generator(name, 0, [&] {
    const Symbol* known = symbols_.find(name);
    if (known == nullptr) throw Undecidable("the symbol " + name + " is not declared");
    return Generator{*known, parse_range(known->range)};
  });
  return ring_.normal(variable);  // an equation that is assumed may say what it is
}

Fraction Translator::pi() {
  return ring_.generator("pi", 0, [] { return Generator{GiNaC::Pi, point({0, 1})}; });
}

// Circular functions and exponentials of integer multiples of independent phases, by the addition theorems

using Pair = std::pair<Fraction, Fraction>;
constexpr int most_times = 64, most_parts = 180;

/// Returns the least common multiple of this number and all earlier ones for this function and argument.
int Translator::common_multiple(const std::string& name, const Fraction& of, const cln::cl_I& number) {
  const auto [place, is_new] = denominators_.try_emplace({name, of}, 1);
  const cln::cl_I before = std::exchange(place->second, cln::lcm(place->second, number));
  if (place->second > most_parts) throw TooLarge("the order of a root is above 180");
  if (!is_new && place->second != before) throw OtherBasis();
  return cln::cl_I_to_int(place->second);
}

/// Returns the term over the common denominator, if the multiples of that are small.
cl_RA Translator::Multiples::unit() const {
  const cln::cl_I parts = cln::denominator(common);
  return largest * parts <= most_times ? 1 / cl_RA(parts) : common;
}

/// Returns the phase and multiple of an argument. Phases are linearly independent over the rationals, except
/// for multiples of one term that have little in common.
Translator::Multiple Translator::multiple_of_phase(const std::string& function, const cl_RA& number,
                                                   const Fraction& term) {
  if (function == "cos" && term == pi() &&
      cln::lcm(denominators_.at({"turn", 0}), cln::denominator(number)) <= most_parts) {
    const int parts = common_multiple("turn", 0, cln::denominator(number));
    const cl_RA times = (number - 2 * cln::round1(number / 2)) * parts;
    return {term / parts, cln::cl_I_to_int(cln::numerator(times))};
  }
  const cl_RA size = cln::abs(number);
  auto& all = multiples_[{function, term}];
  auto known = all.begin();
  Multiples with_this{size, size};
  for (; known != all.end(); ++known) {
    const cl_RA parts = cln::lcm(cln::denominator(known->common), cln::denominator(size));
    with_this = {cln::gcd(cln::numerator(known->common * parts), cln::numerator(size * parts)) / parts,
                 cln::max(known->largest, size)};
    if (with_this.largest <= most_times * with_this.common) break;
  }
  if (known == all.end()) known = all.insert(known, with_this = {size, size});
  const cl_RA unit = with_this.unit();
  if (std::exchange(*known, with_this).unit() != unit) throw OtherBasis();
  return {Fraction(unit) * term, cln::cl_I_to_int(cln::numerator(number / unit))};
}

/// Returns cos and sin of a phase of the basis, as generators with c² + s² = 1.
Pair Translator::phase(const Fraction& phase) {
  const Fraction c = ring_.function("cos", phase), s = ring_.function("sin", phase, 2, 1 - c * c);
  const auto used = phase.numerator.used();
  const Fraction x = used.size() == 1 ? Fraction(Polynomial::variable(used[0])) : Fraction(0);
  const bool is_half = phase == x / 2;
  if ((!is_half && phase != x) || !ring_.generators()[used[0]].is_angle()) return {c, s};
  // The cosine and sine of the angle of an inverse function are algebraic.
  const Generator angle = ring_.generators()[used[0]];
  const bool is_asin = angle.function == "asin";
  const Fraction u = angle.of, rest = root(is_asin ? 1 - u * u : 1 + u * u, 2),
                 cosine = is_asin ? rest : ring_.normal(1 / rest),
                 sine = is_asin ? u : ring_.normal(u / rest);
  ring_.relate(*ring_.find("cos", phase), is_half ? 2 : 1, is_half ? (1 + cosine) / 2 : cosine);
  ring_.relate(*ring_.find("sin", phase), 1, is_half ? sine / (2 * c) : sine);
  return {ring_.normal(c), ring_.normal(s)};
}

/// Returns cos and sin of times·π/n for even n, by the algebraic cos π/n; sin(k·π/n) = cos((n/2 - k)·π/n).
Pair Translator::part_of_pi(int times, int n) {
  const auto cosine = [&](int k) {
    if (n == 2) return Fraction(1 - k);  // of no, one or two right angles
    const int c = ring_.function("cos", pi() / n).numerator.used().at(0);
    const auto [degree, value] = algebraic_cosine(c, n);
    if (ring_.generators()[c].degree == 0) ring_.relate(c, degree, value);
    return ring_.normal(2 * k > n ? -chebyshev(c, n - k) : chebyshev(c, k));
  };
  const Fraction sine = cosine(std::abs(n / 2 - std::abs(times)));
  return {cosine(std::abs(times)), times < 0 ? -sine : sine};
}

Pair Translator::circular(const Fraction& argument) {
  if (const auto known = circular_.find(argument); known != circular_.end())
    return {ring_.normal(known->second.first), ring_.normal(known->second.second)};
  Pair result{1, 0};
  for (const auto& [number, term] : terms_of(argument)) {
    const auto [part, times] = multiple_of_phase("cos", number, term);
    const int n = cln::cl_I_to_int(denominators_.at({"turn", 0}));
    const bool is_turn = part == pi() / n;
    auto [c, s] = is_turn ? part_of_pi(times, n) : phase(part);
    if (times < 0 && !is_turn) s = -s;
    for (int k = 0; k < (is_turn ? 1 : std::abs(times)); ++k) {  // cos and sin of a sum
      const auto [cosine, sine] = result;
      result.first = ring_.normal(cosine * c - sine * s);
      result.second = ring_.normal(sine * c + cosine * s);
    }
  }
  if (!result.first.is_constant()) {
    const Interval range = ring_.range_of(argument);
    ring_.learn(result.first, signs_of(numbers::call("cos", range)));
    ring_.learn(result.second, signs_of(numbers::call("sin", range)));
  }
  circular_.try_emplace(argument, result);
  return result;
}

/// Returns e^argument; e^{q log u} is u^q.
Fraction Translator::exponential(const Fraction& argument) {
  Fraction result = 1;
  for (const auto& [number, term] : terms_of(argument)) {
    const auto used = term.numerator.used();
    if (used.size() == 1 && term == Fraction(Polynomial::variable(used[0])) &&
        ring_.generators()[used[0]].function == "log") {
      result = result * raised(Fraction(ring_.generators()[used[0]].of), number);
    } else {
      const auto [phase, times] = multiple_of_phase("exp", number, term);
      result = result * power(ring_.function("exp", phase), times);
    }
    result = ring_.normal(result);
  }
  ring_.learn(result - 1, ring_.signs_of(argument));  // e^x > 1 where x > 0
  return result;
}

Atom atom_of(const Fraction& a, const std::string& op, const Fraction& b) {
  const Fraction value = op[0] == '<' ? b - a : a - b;
  return {value, op == "=" ? Signs::zero() : op.size() == 2 ? Signs::nonnegative() : Signs::positive()};
}

const RewriteRule& rewrite_rule(const std::string& function) {
  static const auto rules = [] {
    Symbols symbols;
    symbols.declare({"u", "u", "u", "1", all_numbers, "", ""});
    std::vector<RewriteRule> made;
    for (const Function& f : functions()) {
      RewriteRule& rule = made.emplace_back();
      if (!f.simpler.empty()) rule.result = parse(f.simpler, symbols);
      for (const std::string_view text : f.needs) {
        if (text.empty()) continue;
        const auto [sides, operators] = parse_statement(text, symbols);
        const Signs signs = operators.empty() ? Signs::nonzero() : atom_of(0, operators[0], 0).signs;
        rule.domain.emplace_back(sides[0], signs);
      }
    }
    return made;
  }();
  return rules[static_cast<std::size_t>(&function_named(function) - functions().data())];
}

}  // namespace rederive::identity
