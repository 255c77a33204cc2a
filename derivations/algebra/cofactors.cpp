#include <algorithm>
#include <derivations/algebra/cofactors.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// times·polynomial = Σ cofactors[k]·r_k, where the r_k are the residuals of the links, and the last one that
/// of the target. All are polynomials in symbols and in names for functions; times is never 0.
struct Row {
  ex polynomial, times = 1;
  std::vector<ex> cofactors;
};

/// A row, and a symbol in which it is linear.
struct Pivot {
  std::size_t row;
  ex symbol;
};

class Elimination {
 public:
  Elimination(const std::vector<Asked>& links, const std::vector<ex>& divisors, const Symbols& symbols)
      : links_(links), divisors_(divisors), symbols_(symbols) {}

  std::optional<Consequence> run(const Asked& asked) {
    Row target = row(asked.residual, links_.size());
    std::vector<Row> rows;
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (links_[k].claim == Claim::zero) rows.push_back(row(links_[k].residual, k)), divide(rows.back());
    while (const auto pivot = next(rows)) {
      const Row solved = rows[pivot->row];
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(pivot->row));
      if (!reduce(target, solved, pivot->symbol)) return std::nullopt;
      for (Row& other : rows) {
        if (!reduce(other, solved, pivot->symbol)) return std::nullopt;
        divide(other);
      }
    }
    return consequence_of(target, asked.claim);
  }

 private:
  /// denominator·r_k = numerator
  Row row(const ex& residual, std::size_t k) {
    const ex parts = residual.to_rational(names_).numer_denom();
    Row result{parts.op(0).expand(), 1, std::vector<ex>(links_.size() + 1)};
    result.cofactors[k] = parts.op(1).expand();
    return result;
  }
  ex meaning(const ex& e) const { return e.subs(names_, GiNaC::subs_options::no_pattern); }

  /// Without the factors that are never 0.
  void divide(Row& row) const {
    const ex factors = row.polynomial.nops() < 40 ? GiNaC::factor(row.polynomial) : row.polynomial;
    if (!is_a<GiNaC::mul>(factors)) return;
    ex rest = 1;
    for (const ex& factor : factors)
      (is_never_zero(meaning(factor), divisors_, symbols_) ? row.times : rest) *= factor;
    row.polynomial = rest.expand();
  }

  /// Slopes that are numbers come first, then the order of the links and that of the alphabet.
  std::optional<Pivot> next(const std::vector<Row>& rows) const {
    for (const bool by_number : {true, false})
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (const std::string& name : symbols_in(rows[k].polynomial)) {
          const ex &symbol = symbols_[name], &polynomial = rows[k].polynomial;
          if (polynomial.degree(symbol) != 1) continue;
          const ex slope = polynomial.coeff(symbol, 1);
          if (by_number ? is_a<numeric>(slope) : is_never_zero(meaning(slope), divisors_, symbols_))
            return Pivot{k, symbol};
        }
    return std::nullopt;
  }
  std::set<std::string> symbols_in(const ex& e) const {
    std::set<std::string> names;
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
      if (const Symbol* symbol = is_a<GiNaC::symbol>(*part) ? symbols_.find(*part) : nullptr)
        names.insert(symbol->name);
    return names;
  }

  /// Division by a polynomial that is linear in the symbol, without fractions. False where it grows long.
  static bool reduce(Row& row, const Row& by, const ex& symbol) {
    const ex slope = by.polynomial.coeff(symbol, 1);
    for (int n = row.polynomial.degree(symbol); n > 0; n = row.polynomial.degree(symbol)) {
      const ex lead = row.polynomial.coeff(symbol, n) * GiNaC::pow(symbol, n - 1);
      row.polynomial = (slope * row.polynomial - lead * by.polynomial).expand();
      for (std::size_t k = 0; k < row.cofactors.size(); ++k)
        row.cofactors[k] = slope * by.times * row.cofactors[k] - lead * row.times * by.cofactors[k];
      row.times *= by.times;
      if (row.polynomial.nops() > 100 || n > 8) return false;
      cancel(row);
    }
    return true;
  }
  /// What all terms have in common.
  static void cancel(Row& row) {
    ex common = row.times.expand();
    for (ex& cofactor : row.cofactors) common = GiNaC::gcd(common, cofactor = cofactor.expand());
    if (is_a<numeric>(common)) return;
    row.times = (row.times / common).normal();
    for (ex& cofactor : row.cofactors) cofactor = (cofactor / common).normal().expand();
  }

  std::optional<Consequence> consequence_of(const Row& target, Claim claim) const {
    const ex more = meaning(target.times * target.polynomial), times = meaning(target.cofactors.back());
    const auto text = [&](const ex& e) { return print(e, Notation::plain, symbols_); };
    const int known = sign_of(times, symbols_);
    const numeric sign = known != 0 ? known : text(times) <= text((-times).expand()) ? 1 : -1;
    Consequence result{{}, sign * more, sign * times};
    if (claim == Claim::zero && !more.is_zero()) {
      if (!vanishes(more, symbols_)) return std::nullopt;
      result.more = 0;
    }
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (!target.cofactors[k].is_zero()) result.terms.push_back({-sign * meaning(target.cofactors[k]), {k}});
    return result;
  }

  const std::vector<Asked>& links_;
  const std::vector<ex>& divisors_;
  const Symbols& symbols_;
  GiNaC::exmap names_;  ///< for functions and constants
};

}  // namespace

std::optional<Consequence> by_elimination(const Asked& target, const std::vector<Asked>& links,
                                          const std::vector<ex>& divisors, const Symbols& symbols) {
  const auto is_equation = [](const Asked& link) { return link.claim == Claim::zero; };
  if (std::none_of(links.begin(), links.end(), is_equation)) return std::nullopt;
  return Elimination(links, divisors, symbols).run(target);
}

bool is_never_zero(const ex& product, const std::vector<ex>& divisors, const Symbols& symbols) {
  if (product.is_zero()) return false;
  if (sign_of(product, symbols) != 0) return true;
  const auto parts = checked_quotient(product, 1, symbols);
  return parts && assess(*parts, divisors, symbols).zeros.empty();
}

bool exclude_zero(const std::vector<Asked>& links, const ex& symbol, const Symbols& symbols) {
  return std::any_of(links.begin(), links.end(), [&](const Asked& link) {
    if (link.claim != Claim::zero) return false;
    const ex numerator = link.residual.normal().numer();
    return numerator.is_polynomial(symbol) && sign_of(numerator.subs(symbol == 0), symbols) != 0;
  });
}

}  // namespace rederive
