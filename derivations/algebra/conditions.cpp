#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/factor_roots.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <map>
#include <tuple>

namespace rederive {

namespace {

struct Collector {
  const Symbols& symbols;
  const std::vector<Given>& given;
  std::vector<Condition> found;
  std::vector<GiNaC::ex> divisors;
  bool for_series = false;  ///< what a range grants may still be 0 to lowest order

  bool is_granted(const GiNaC::ex& value, const std::string& relation) const {
    if (for_series) return false;
    const GiNaC::ex e = put_in(value, given);
    return relation == ">="  ? is_nonnegative(e, symbols)
           : relation == ">" ? sign_of(e, symbols) > 0
                             : sign_of(e, symbols) != 0;
  }
  void note(const GiNaC::ex& value, const std::string& relation) {
    if (for_series) must_be_possible(value, relation);
    if (GiNaC::is_a<GiNaC::numeric>(value) || is_granted(value, relation)) return;
    const bool is_root = GiNaC::is_a<GiNaC::power>(value) && value.op(1).info(GiNaC::info_flags::positive) &&
                         !value.op(1).info(GiNaC::info_flags::integer);
    if (is_root && relation == ">") return note(value.op(0), relation);
    const GiNaC::ex whole = without_content(relation == "!=" ? numerator(value) : value);
    const GiNaC::ex said = relation == "!=" ? with_sign(whole) : whole;
    const auto is_it = [&](const Condition& c) { return c.relation == relation && c.value.is_equal(said); };
    if (std::none_of(found.begin(), found.end(), is_it)) found.push_back({said, relation});
  }
  /// A series is asked for where it has values; of a statement the points that are compared tell.
  void must_be_possible(const GiNaC::ex& value, const std::string& relation) const {
    const GiNaC::ex e = put_in(value, given);
    const bool is_beyond = relation == "!="   ? vanishes(e, symbols)
                           : relation == ">=" ? sign_of(e, symbols) < 0
                                              : is_nonnegative(-e, symbols);
    if (is_beyond) throw Undecidable("there is no value where what is small is nearly 0");
  }
  /// 2*x + 2 as x + 1, -2*x as -x.
  static GiNaC::ex without_content(const GiNaC::ex& value) {
    if (GiNaC::is_a<GiNaC::add>(value)) return (value / value.integer_content()).expand();
    const GiNaC::ex number = GiNaC::is_a<GiNaC::mul>(value) ? value.op(value.nops() - 1) : GiNaC::ex(1);
    return number.info(GiNaC::info_flags::rational) ? value / GiNaC::abs(number) : value;
  }
  /// Of a sum of fractions the numerator, if what they have below is never 0.
  GiNaC::ex numerator(const GiNaC::ex& value) const {
    if (!GiNaC::is_a<GiNaC::add>(value)) return value;
    const GiNaC::ex fraction = value.numer_denom(), below = fraction.op(1);
    const bool is_whole = GiNaC::is_a<GiNaC::numeric>(below) || sign_of(below, symbols) == 0;
    return is_whole ? value : fraction.op(0).expand();
  }
  /// Of x - 1 and 1 - x, which are not 0 together, the one that does not begin with a number or a minus; then
  /// the one whose first name comes first in the alphabet.
  GiNaC::ex with_sign(const GiNaC::ex& value) const {
    if (!GiNaC::is_a<GiNaC::add>(value)) return value;
    const GiNaC::ex negative = -value;
    return rank(negative) < rank(value) ? negative : value;
  }
  std::tuple<bool, bool, std::string> rank(const GiNaC::ex& sum) const {
    const std::string text = print(sum, Notation::plain, symbols);
    const std::size_t name = std::min(text.find_first_not_of("-0123456789*/()"), text.size());
    return {text[0] == '-', text.find(' ') <= name, text.substr(name)};
  }
  void nonzero(const GiNaC::ex& value) {
    if (GiNaC::is_a<GiNaC::mul>(value)) {
      std::map<std::string, GiNaC::ex> in_order;  // of the alphabet, which is the same in each run
      for (const GiNaC::ex& factor : value) in_order.emplace(print(factor, Notation::plain, symbols), factor);
      for (const auto& [text, factor] : in_order) nonzero(factor);
    } else if (GiNaC::is_a<GiNaC::power>(value) && sign_of(value.op(1), symbols) > 0) {
      nonzero(value.op(0));
    } else {
      divisors.push_back(value);
      const bool is_inverse = GiNaC::is_a<GiNaC::power>(value) && sign_of(value.op(1), symbols) < 0;
      if (!is_inverse) note(value, "!=");  // 1/y is not 0
    }
  }

  bool may_be_negative(const GiNaC::ex& exponent) const { return sign_of(exponent, symbols) <= 0; }

  void visit(const Tree& tree) {
    for (const Tree& child : tree->children) visit(child);
    const auto value = [&](std::size_t k) { return lower(tree->children[k], symbols); };
    switch (tree->kind) {
      case Node::Kind::product:
        for (std::size_t k = 0; k < tree->children.size(); ++k)
          if (tree->inverse[k]) nonzero(value(k));
        break;
      case Node::Kind::power: {
        const GiNaC::ex exponent = put_in(value(1), given);
        const bool is_symbolic = for_series && !GiNaC::is_a<GiNaC::numeric>(exponent);  // x^y, y small
        const bool whole =
            GiNaC::is_a<GiNaC::numeric>(exponent) && GiNaC::ex_to<GiNaC::numeric>(exponent).is_integer();
        if (!whole)
          note(value(0), may_be_negative(exponent) || is_symbolic ? ">" : ">=");
        else if (may_be_negative(exponent))
          nonzero(value(0));
        break;
      }
      case Node::Kind::call:
        call(tree->text, value(0));
        break;
      default:
        break;
    }
  }

  void call(const std::string& name, const GiNaC::ex& x) {
    if (name == "tan" || name == "sec") nonzero(GiNaC::cos(x));
    if (name == "cot" || name == "csc") nonzero(GiNaC::sin(x));
    if (name == "coth" || name == "csch") nonzero(GiNaC::sinh(x));
    if (name == "log") note(x, ">");
    if (name == "sqrt") note(x, ">=");
    if (name == "acosh") note(x - 1, ">=");
    if (name == "asin" || name == "acos") note(1 - x * x, ">=");
    if (name == "atanh") note(1 - x * x, ">");
    if (name == "fabs" && for_series) note(x, "!=");
  }
};

}  // namespace

std::vector<Condition> conditions_of(const Tree& tree, const Symbols& symbols,
                                     const std::vector<Given>& given) {
  Collector collector{symbols, given, {}, {}};
  collector.visit(tree);
  return collector.found;
}

std::string in_words(const Condition& condition, const Symbols& symbols) {
  return print(condition.value, Notation::plain, symbols) + " " + condition.relation + " 0";
}

std::vector<std::string> in_words(const std::vector<Condition>& conditions, const Symbols& symbols) {
  std::vector<std::string> said;
  add_in_words(said, conditions, symbols);
  return said;
}

std::vector<GiNaC::ex> divisors(const Tree& tree, const Symbols& symbols) {
  Collector collector{symbols, {}, {}, {}};
  collector.visit(tree);
  return collector.divisors;
}

std::vector<Condition> conditions_for_series(const Tree& tree, const Symbols& symbols,
                                             const std::vector<Given>& given) {
  Collector collector{symbols, given, {}, {}, true};
  collector.visit(tree);
  return collector.found;
}

std::vector<Condition> not_granted(const std::vector<Condition>& conditions, const Symbols& symbols,
                                   const std::vector<Given>& given) {
  Collector collector{symbols, given, {}, {}};
  for (const auto& [value, relation] : conditions) {
    const bool is_nonzero = relation == "!=" || (relation == ">" && is_nonnegative(value, symbols));
    const std::vector<GiNaC::ex> factors = is_nonzero ? factors_of(value, symbols) : std::vector<GiNaC::ex>{};
    for (const GiNaC::ex& factor : factors) collector.nonzero(factor);
    if (factors.empty()) collector.note(value, is_nonzero ? "!=" : relation);
  }
  return collector.found;
}

namespace {

/// "x - 1 != 0" as "x - 1" and "!="; nothing of what is not compared with 0.
std::pair<std::string, std::string> in_parts(const std::string& said) {
  const std::size_t zero = said.rfind(" 0");
  if (zero == std::string::npos || zero + 2 != said.size()) return {};
  const std::size_t relation = said.rfind(' ', zero - 1);
  return {said.substr(0, relation), said.substr(relation + 1, zero - relation - 1)};
}

}  // namespace

void add_in_words(std::vector<std::string>& said, const std::vector<Condition>& conditions,
                  const Symbols& symbols) {
  for (const Condition& condition : conditions) {
    const std::string value = print(condition.value, Notation::plain, symbols);
    const std::string negative = print((-condition.value).expand(), Notation::plain, symbols);
    const auto same = std::find_if(said.begin(), said.end(), [&](const std::string& s) {
      const auto [other, relation] = in_parts(s);
      const bool has_no_sign = relation == "!=" || condition.relation == "!=";
      return other == value || (other == negative && has_no_sign);
    });
    if (same == said.end()) {
      said.push_back(in_words(condition, symbols));
    } else if (const auto [other, relation] = in_parts(*same); relation != condition.relation) {
      *same = (relation == "!=" ? value : other) + " > 0";  // two of !=, > and >= are that
    }
  }
}

std::vector<std::string> side_conditions(const std::vector<Tree>& sides, const Symbols& symbols,
                                         const std::vector<Given>& given) {
  std::vector<Condition> all;
  for (const Tree& side : sides)
    for (const Condition& condition : conditions_of(side, symbols, given)) all.push_back(condition);
  return in_words(all, symbols);
}

}  // namespace rederive
