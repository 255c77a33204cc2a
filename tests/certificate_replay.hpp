// Certificates of which certificate_checker.hpp alone is enough.
#pragma once

#include <algorithm>
#include <tests/certificate_checker.hpp>

namespace rederive {

/// Whether an identity is all there is to replay in a certificate: of two expressions, or of relations of one
/// link each.
inline bool is_identity(const nlohmann::json& certificate) {
  const auto is_plain = [](const nlohmann::json& link) {
    return link.contains("factor") && !link["left"]["links"][0].contains("layers") &&
           !link["right"]["links"][0].contains("layers");
  };
  if (certificate.contains("cells") || certificate.contains("cases") || certificate["left"].size() > 3 ||
      certificate["right"].size() > 3)
    return false;
  for (const nlohmann::json& piece : certificate["pieces"])
    if (!std::all_of(piece["links"].begin(), piece["links"].end(), is_plain)) return false;
  return true;
}

/// What the replay by itself says of an identity, without a look at signs, branches and side conditions.
inline std::string replay(const nlohmann::json& certificate) {
  const auto residual = [](const nlohmann::json& statement, const nlohmann::json& side) -> std::string {
    const std::size_t k = side["links"][0]["link"];
    if (statement.size() == 1) return statement.at(2 * k);
    const bool is_less = statement.at(2 * k + 1).get<std::string>().starts_with('<');
    const std::string more = statement[is_less ? 2 : 0], less = statement[is_less ? 0 : 2];
    return "(" + more + ")-(" + less + ")";
  };
  try {
    for (std::size_t k = 0; k < certificate["pieces"].size(); ++k)
      for (certificate_checker::Replay replay(certificate, k);
           const nlohmann::json& link : certificate["pieces"][k]["links"])
        replay.compare(link, residual(certificate["left"], link["left"]),
                       residual(certificate["right"], link["right"]));
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace rederive
