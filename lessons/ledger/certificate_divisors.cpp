// What a statement divides by.
#include <algorithm>
#include <array>
#include <lessons/ledger/certificate_links.hpp>

namespace rederive {

namespace {

void collect_divisors(const Tree& tree, const CertifiedStatement& q, std::vector<CertifiedDivisor>& found) {
  const auto add = [&](const Tree& divisor) {
    found.push_back({put_in(lower(divisor, q.symbols), q.given), divisor});
  };
  for (const Tree& child : tree->children) collect_divisors(child, q, found);
  if (tree->kind == Node::Kind::product)
    for (std::size_t k = 0; k < tree->children.size(); ++k)
      if (tree->inverse[k] && !q.rational(tree->children[k])) add(tree->children[k]);
  if (tree->kind == Node::Kind::power && !q.is_root(tree) && q.rational(tree->children[1])->is_negative())
    add(tree->children[0]);
  if (tree->kind != Node::Kind::call) return;
  for (const auto& [divisor, names] : {std::pair{"cos", std::array{"tan", "sec"}},
                                       {"sin", {"cot", "csc"}},
                                       {"sinh", {"coth", "csch"}},
                                       {"cosh", {"tanh", "sech"}}})
    if (tree->text == names[0] || tree->text == names[1]) add(call(divisor, tree->children[0]));
}

}  // namespace

std::vector<CertifiedDivisor> divisors_of(const CertifiedStatement& q) {
  std::vector<CertifiedDivisor> found, different;
  for (const Relation* relation : {&q.left, &q.right})
    for (const Tree& side : relation->sides) collect_divisors(side, q, found);
  for (const Given& g : q.given) collect_divisors(to_tree(g.value, q.symbols), q, found);
  for (const GiNaC::ex& e : q.symbols.never_zero())
    found.push_back({put_in(e, q.given), to_tree(e, q.symbols)});
  for (const CertifiedDivisor& d : found)
    if (std::none_of(different.begin(), different.end(),
                     [&](const CertifiedDivisor& e) { return e.value.is_equal(d.value); }))
      different.push_back(d);
  return different;
}

}  // namespace rederive
