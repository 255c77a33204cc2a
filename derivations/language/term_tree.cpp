#include <algorithm>
#include <derivations/language/term.hpp>
#include <sstream>

namespace rederive {

using GiNaC::numeric;

namespace {

Tree integer(const numeric& value) {
  std::ostringstream text;
  text << value;
  return make_tree(Node::Kind::number, text.str());
}

/// A multiple of pi: 2*pi - psi is the way round that everybody writes.
bool is_pi(const Term& part) {
  return part.factors.size() == 1 && part.factors[0].base->text == "pi" && part.factors[0].exponent == 1;
}

/// -x*(y - z) is x*(z - y).
Term presented(Term term) {
  if (!term.coefficient.is_negative()) return term;
  for (auto factor = term.factors.rbegin(); factor != term.factors.rend(); ++factor) {
    std::vector<Term>& parts = factor->parts;
    const auto minus = std::count_if(parts.begin(), parts.end(),
                                     [](const Term& part) { return part.coefficient.is_negative(); });
    const bool either_way = !parts.empty() && 2 * static_cast<std::size_t>(minus) == parts.size();
    if (!either_way || factor->exponent.is_even()) continue;
    if (std::any_of(parts.begin(), parts.end(), is_pi)) continue;
    turn(parts);
    term.coefficient = -term.coefficient;
    return term;
  }
  return term;
}

Tree power(const Factor& factor, bool present) {
  const Tree base = present && !factor.parts.empty() ? sum_tree(factor.parts, true) : factor.base;
  const numeric exponent = GiNaC::abs(factor.exponent);
  if (factor.symbolic) return make_tree(Node::Kind::power, "", {base, factor.symbolic});
  if (exponent == 1) return base;
  if (exponent == numeric(1, 2)) return make_tree(Node::Kind::call, "sqrt", {base});
  const Tree above = integer(exponent.numer());
  if (exponent.is_integer()) return make_tree(Node::Kind::power, "", {base, above});
  const Tree ratio = make_tree(Node::Kind::product, "", {above, integer(exponent.denom())}, {false, true});
  return make_tree(Node::Kind::power, "", {base, ratio});
}

Tree times(const std::vector<Tree>& factors) {
  if (factors.size() == 1) return factors[0];
  return make_tree(Node::Kind::product, "", factors, std::vector<bool>(factors.size(), false));
}

}  // namespace

bool asks_to_turn(const std::vector<Term>& parts) {
  int surplus = 0;
  for (const Term& part : parts) surplus += part.coefficient.is_negative() ? 1 : -1;
  if (surplus != 0) return surplus > 0;
  const auto pi = std::find_if(parts.begin(), parts.end(), is_pi);
  return (pi == parts.end() ? parts.begin() : pi)->coefficient.is_negative();
}

void turn(std::vector<Term>& parts) {
  for (Term& part : parts) part.coefficient = -part.coefficient;
}

Tree sum_tree(std::vector<Term> parts, bool present) {
  if (present) std::transform(parts.begin(), parts.end(), parts.begin(), presented);
  const auto leader = std::find_if(parts.begin(), parts.end(),
                                   [](const Term& part) { return part.coefficient.is_positive(); });
  if (leader != parts.end()) std::rotate(parts.begin(), leader, leader + 1);
  std::vector<Tree> children;
  std::vector<bool> inverse;
  for (const Term& part : parts) {
    const bool minus = part.coefficient.is_negative(), first = children.empty();
    const Tree value = product_tree(part, present);
    children.push_back(first && minus ? make_tree(Node::Kind::negative, "", {value}) : value);
    inverse.push_back(minus && !first);
  }
  return make_tree(Node::Kind::sum, "", children, inverse);
}

Tree product_tree(const Term& term, bool present) {
  const numeric over = GiNaC::abs(term.coefficient.numer()), under = term.coefficient.denom();
  std::vector<Tree> above, below;
  for (const Factor& factor : term.factors)
    (factor.exponent.is_negative() ? below : above).push_back(power(factor, present));
  const bool lone_symbol = above.size() == 1 && above[0]->kind == Node::Kind::symbol;
  if (under != 1 && below.empty() && !above.empty() && !lone_symbol) {  // 1/2*m*R^2, but alpha/2
    above.insert(above.begin(), {integer(over), integer(under)});
    std::vector<bool> inverse(above.size(), false);
    inverse[1] = true;
    return make_tree(Node::Kind::product, "", above, inverse);
  }
  if (over != 1 || above.empty()) above.insert(above.begin(), integer(over));
  if (under != 1) below.insert(below.begin(), integer(under));
  if (below.empty()) return times(above);
  std::vector<bool> inverse(above.size(), false);
  above.push_back(times(below));
  inverse.push_back(true);
  return make_tree(Node::Kind::product, "", above, inverse);
}

Tree term_tree(const Term& term, bool present) {
  const Term shown = present ? presented(term) : term;
  const Tree value = product_tree(shown, present);
  return shown.coefficient.is_negative() ? make_tree(Node::Kind::negative, "", {value}) : value;
}

}  // namespace rederive
