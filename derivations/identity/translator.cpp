#include <algorithm>
#include <derivations/identity/translator.hpp>
#include <utility>

namespace rederive {

using cln::cl_RA;
using Kind = Generator::Kind;

/// The work, as often as it meets phases that need another basis.
template <class Work>
auto Translator::in_rounds(const Work& work) {
  for (int round = 0; round < 24; ++round) try {
      argument_.reset();
      return work();
    } catch (const AnotherRound&) {
      ++bases_, arguments_.clear();
    } catch (const std::domain_error&) {
      throw NoValue("a divisor is 0");
    }
  throw Undecidable("functions of functions, too deep");
}

Fraction Translator::operator()(const Tree& tree, std::vector<DomainCondition>& conditions) {
  return in_rounds([&] {
    std::vector<DomainCondition> found;
    conditions_ = &found;
    const Fraction result = translate(tree);
    conditions.insert(conditions.end(), found.begin(), found.end());
    return result;
  });
}

std::pair<Fraction, Fraction> Translator::circular_of(const Fraction& argument) {
  return in_rounds([&] { return circular(argument); });
}

Fraction Translator::exponential_of(const Fraction& argument) {
  return in_rounds([&] { return exponential(argument); });
}

Fraction Translator::logarithm_of(const Fraction& value) {
  return in_rounds([&] { return logarithm(value); });
}

std::vector<Translator::Multiple> Translator::phases_of(const Fraction& argument, cl_RA* turns) {
  return in_rounds([&] {
    std::vector<Multiple> result;
    for (const auto& [number, term] : terms_of(argument))
      if (turns != nullptr && term == pi())
        *turns = number;
      else
        result.push_back(multiple_of_phase(turns != nullptr ? "cos " : "exp ", number, term));
    return result;
  });
}

void Translator::require(const Fraction& value, Signs allowed, const Tree& tree) {
  if (value.is_constant()) {
    if (!ring_.signs_of(value).within(allowed)) throw NoValue("a part of it has no value anywhere");
    return;
  }
  conditions_->push_back({value, allowed, tree});
}

Fraction Translator::translate(const Tree& tree) {
  switch (tree->kind) {
    case Node::Kind::number:
      return Fraction(exact(tree->text));
    case Node::Kind::symbol:
      if (argument_ && tree->text == "u") return *argument_;
      return tree->text == "pi" ? pi() : symbol(tree->text);
    case Node::Kind::negative:
      return -translate(tree->children[0]);
    case Node::Kind::sum: {
      Fraction sum = 0;
      for (std::size_t k = 0; k < tree->children.size(); ++k) {
        const Fraction term = translate(tree->children[k]);
        sum = tree->inverse[k] ? sum - term : sum + term;
      }
      return ring_.normal(sum);
    }
    case Node::Kind::product:
      return product(*tree);
    case Node::Kind::power:
      return power_of(*tree);
    case Node::Kind::call:
      return call(*tree);
  }
  throw Undecidable("a form that is not known");
}

Fraction Translator::product(const Node& node) {
  Fraction result = 1;
  for (std::size_t k = 0; k < node.children.size(); ++k) {
    const Fraction factor = translate(node.children[k]);
    if (node.inverse[k]) require(factor, Signs::nonzero(), node.children[k]);
    result = ring_.normal(node.inverse[k] ? result / factor : result * factor);
  }
  return result;
}

/// b^e: roots where the exponent is a fraction, else e^{e log b} of a base that is positive.
Fraction Translator::power_of(const Node& node) {
  const Fraction base = translate(node.children[0]), exponent = translate(node.children[1]);
  if (!exponent.is_constant()) {
    if (ring_.signs_of(base) !=
        Signs::positive())  // of a negative one there are values for whole exponents only
      throw Undecidable("a power with a symbolic exponent, of a base that is not known to be positive");
    return exponential(ring_.normal(exponent * logarithm(base)));
  }
  const cl_RA number = exponent.constant();
  if (cln::abs(number) > 64 || cln::denominator(number) > 12)
    throw Undecidable("an exponent that is too large");
  const int n = cln::cl_I_to_int(cln::numerator(number)), order = cln::cl_I_to_int(cln::denominator(number));
  if (order > 1) require(base, n > 0 ? Signs::nonnegative() : Signs::positive(), node.children[0]);
  if (order == 1 && n < 0) require(base, Signs::nonzero(), node.children[0]);
  Fraction result = 1;
  const Fraction factor = order > 1 ? root(base, order) : base;
  for (int k = 0; k < std::abs(n); ++k) result = ring_.normal(result * factor);
  return n < 0 ? ring_.normal(1 / result) : result;
}

Fraction Translator::call(const Node& node) {
  const std::string& name = node.text;
  const Tree& argument = node.children[0];
  const Fraction x = translate(argument);
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
  if (name == "sin") return circular(x).second;
  if (name == "cos") return circular(x).first;
  if (name == "sqrt") return square_root(argument);
  if (name == "fabs") return absolute(x);
  if (name == "exp") return exponential(x);
  if (name == "log") return logarithm(x);
  if (name == "atan" || name == "asin") return angle(name == "asin", x);
  throw Undecidable("the function " + name);
}

Fraction Translator::symbol(const std::string& name) {
  return ring_.generator(name, [&] {
    const Symbol* known = symbols_.find(name);
    if (known == nullptr) throw Undecidable("the symbol " + name + ", which is not declared");
    return Generator{Kind::symbol, known->ginac, parse_range(known->range)};
  });
}

Fraction Translator::pi() {
  return ring_.generator("pi", [] { return Generator{Kind::pi, GiNaC::Pi, point({0, 1})}; });
}

}  // namespace rederive
