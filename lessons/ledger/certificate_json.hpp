// Parts of a certificate as JSON, as certificate.hpp says what they are.
#pragma once

#include <lessons/ledger/certificate_links.hpp>
#include <nlohmann/json.hpp>

namespace rederive {

/// A statement in pieces: sides and operators.
nlohmann::ordered_json statement_json(const Relation& relation, const CertifiedStatement& statement);

/// The ranges of all names in these texts.
nlohmann::ordered_json ranges_json(const std::vector<Tree>& trees, const CertifiedStatement& statement);

/// Parts with their exponents.
nlohmann::ordered_json factor_json(const CertifiedFactor& factor, const CertifiedStatement& statement);

/// One link of a side by its number, and what is taken off its sides.
nlohmann::ordered_json part_json(const CertifiedSide& side, std::size_t k,
                                 const CertifiedStatement& statement);

/// All of them, and the residual in generators.
nlohmann::ordered_json side_json(const CertifiedSide& side, const GiNaC::ex& residual,
                                 const CertifiedStatement& statement);

/// What a link follows from.
nlohmann::ordered_json consequence_json(const CertifiedConsequence& why, const CertifiedStatement& statement);

/// What is in the factors because it divides a divisor.
nlohmann::ordered_json parts_of_divisors(const std::vector<CertifiedLink>& links,
                                         const CertifiedStatement& statement);

/// What shows the signs of forms and parts of factors that their ranges do not.
nlohmann::ordered_json slopes_json(const std::vector<CertifiedLink>& links,
                                   const CertifiedStatement& statement);

}  // namespace rederive
