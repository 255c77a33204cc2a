#include <algorithm>
#include <derivations/algebra/in_square.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

constexpr int most_squares = 2;
constexpr std::size_t most_terms = 12;

bool has_root(const ex& e) {
  return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    const bool is_root = GiNaC::is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::rational) &&
                         !part.op(1).info(GiNaC::info_flags::integer);
    return name_of(part) == "abs" || (is_root && !GiNaC::is_a<GiNaC::numeric>(part.op(0)));
  });
}

/// The terms with roots that are not negative.
ex root_of(const ex& sum, const Symbols& symbols) {
  ex root = 0;
  for (const ex& term : sum)
    if (has_root(term) && is_nonnegative(term, symbols)) root += term;
  return root;
}

}  // namespace

std::optional<InSquare> shown_in_square(const ex& expression, const Symbols& symbols) {
  InSquare result{{}, prepare(expression, symbols).expand(), false};
  for (int k = 0; k < most_squares; ++k) {
    const ex sum = result.rest;
    if (!GiNaC::is_a<GiNaC::add>(sum) || sum.nops() > most_terms || !has_root(sum)) return std::nullopt;
    const ex root = root_of(sum, symbols);
    if (root.is_zero() || root.is_equal(sum)) return std::nullopt;
    result.roots.push_back(root);
    result.rest = prepare((GiNaC::pow(root, 2) - GiNaC::pow(root - sum, 2)).expand(), symbols).expand();
    if (vanishes(result.rest, symbols)) return result.rest = 0, result;
    result.is_strict = sign_of(result.rest, symbols) > 0;
    if (result.is_strict || is_nonnegative(result.rest, symbols)) return result;
  }
  return std::nullopt;
}

}  // namespace rederive
