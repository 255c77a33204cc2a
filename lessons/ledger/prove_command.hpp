// `ledger prove`: the decision procedure on anything that a user types, within bounds.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <lessons/ledger/comparisons.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive {

/// What was asked.
struct ProveRequest {
  std::string left, right;
  std::vector<std::string> assumptions;  ///< "x > 0", "0 < x < 1", "b < h", "x != 0", "theta = 0"
  std::vector<std::string> small;        ///< expansion symbols, with order
  std::optional<int> order;              ///< compare the series up to this order
};

/// The symbols of the paper, and every letter and Greek letter (with an index or dots) that the texts use.
/// The names in `freed` are any real numbers, and so are t, r and d, which everybody uses for something else
/// than the paper does.
Symbols declared_symbols(const ProveRequest& request, const std::vector<std::string>& freed = {});

/// The declared symbols, and what the assumptions say of them; assumptions that are equations become givens.
struct Context {
  Symbols symbols;
  std::vector<Given> given;
  std::vector<Comparison> comparisons;    ///< of symbols with each other: a part of the ranges, as it were
  std::vector<std::string> inequalities;  ///< that are assumed: "b < h", "x > 0", "x - y != 0"
  std::vector<Tree> assumed = {};         ///< the sides of all inequalities and equations that are assumed
  std::set<std::string> periodic = {};    ///< symbols that are declared over one period, (-pi, pi]

  /// The comparisons, or the equations as well.
  std::vector<Given> put_in_at_once(bool equations_too) const;
};
/// Throws BadInput for an assumption that cannot be read, or that contradicts another. Of the
/// inequalities, those with the indices of `without` are left out.
Context make_context(const ProveRequest& request, const std::vector<std::string>& freed = {},
                     const std::set<std::size_t>& without = {});

/// What was asked, and all that stands for something in it.
struct Case {
  ProveRequest request;
  Context context;
  std::set<std::string> in_pieces = {};  ///< inequalities that are assumed, and say what is assumed besides
};
/// The request; or the same with one more assumption each, of which one always holds, where an assumption has
/// several solutions: x^2 = 4 with x > 0, and with x < 0; sin(x) > 0 with 0 < x < pi. Throws BadInput as
/// make_context().
std::vector<Case> cases_of(const ProveRequest& request);

/// A proof, and the certificate of what is proved (certificate.hpp), null of all else.
template <class AProof>
struct Certified {
  AProof proof;
  nlohmann::ordered_json certificate;
};

/// Decides, in every case. Nothing is proved but what has a certificate that the checker of certificates
/// accepts; and nothing, proved or refuted, that goes against the texts where the evaluator finds their
/// values (counterexample.hpp). The declared ranges that a proof rests on are among its side conditions.
/// Throws BadInput (with a caret) for what cannot be read. No bounds on time or memory.
Certified<Proof> decide(const ProveRequest& request);

/// Decides within two seconds and 500 MB; where the machine has less than half a processor for it, in more, but
/// not in more than `patience` seconds. The proof as `ledger prove --json` has it. Throws BadInput (with a
/// caret) for what cannot be read.
Certified<nlohmann::ordered_json> decide_bounded(const ProveRequest& request, double patience = 60);

}  // namespace rederive
