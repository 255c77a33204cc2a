#include <algorithm>
#include <derivations/identity/translator.hpp>
#include <derivations/language/syntax.hpp>
#include <map>
#include <utility>

namespace rederive {

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
  if (const RewriteRule* rule = rewrite_rule(name)) {
    const auto of_x = [&](const Tree& tree) {  // the conditions of the parts are those of the whole
      const std::size_t known = conditions_->size();
      const auto outer = std::exchange(argument_, x);
      const Fraction result = translate(tree);
      argument_ = outer;  // if something is thrown, at the next round
      conditions_->erase(conditions_->begin() + static_cast<std::ptrdiff_t>(known), conditions_->end());
      return result;
    };
    for (const auto& [value, signs] : rule->domain) require(of_x(value), signs, put_in(value, "u", argument));
    if (rule->result) return of_x(rule->result);
  }
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

const RewriteRule* rewrite_rule(const std::string& function) {
  static const auto read = [](const char* text) {
    Symbols symbols;
    symbols.declare({"u", "u", "u", "1", all_numbers, "", ""});
    return parse(text, symbols);
  };
  static const auto rule = [](const std::vector<std::pair<const char*, Signs>>& domain,
                              const char* result = nullptr) {
    RewriteRule made{{}, result == nullptr ? nullptr : read(result)};
    for (const auto& [value, signs] : domain) made.domain.emplace_back(read(value), signs);
    return made;
  };
  constexpr Signs nonzero = Signs::nonzero(), positive = Signs::positive(),
                  nonnegative = Signs::nonnegative();
  static const std::map<std::string, RewriteRule> rules = {
      {"tan", rule({{"cos(u)", nonzero}}, "sin(u)/cos(u)")},
      {"sec", rule({{"cos(u)", nonzero}}, "1/cos(u)")},
      {"cot", rule({{"sin(u)", nonzero}}, "cos(u)/sin(u)")},
      {"csc", rule({{"sin(u)", nonzero}}, "1/sin(u)")},
      {"sqrt", rule({{"u", nonnegative}})},
      {"log", rule({{"u", positive}})},
      {"asin", rule({{"1-u^2", nonnegative}})},
      {"acos", rule({{"1-u^2", nonnegative}}, "pi/2-asin(u)")},
      {"sinh", rule({}, "(exp(u)-exp(-u))/2")},
      {"cosh", rule({}, "(exp(u)+exp(-u))/2")},
      {"tanh", rule({}, "(exp(u)-exp(-u))/(exp(u)+exp(-u))")},
      {"sech", rule({}, "2/(exp(u)+exp(-u))")},
      {"coth", rule({{"u", nonzero}}, "(exp(u)+exp(-u))/(exp(u)-exp(-u))")},
      {"csch", rule({{"u", nonzero}}, "2/(exp(u)-exp(-u))")},
      {"asinh", rule({}, "log(u+sqrt(u^2+1))")},
      {"acosh", rule({{"u-1", nonnegative}}, "log(u+sqrt(u^2-1))")},
      {"atanh", rule({{"1-u", positive}, {"1+u", positive}}, "log((1+u)/(1-u))/2")}};
  const auto found = rules.find(function);
  return found == rules.end() ? nullptr : &found->second;
}

}  // namespace rederive
