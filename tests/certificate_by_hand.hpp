// Certificates made up by hand, and what the checker says of them.
#pragma once

#include <tests/certificate_relations.hpp>

namespace by_hand {

using Json = nlohmann::json;

/// Without givens, with one piece, or the same in all.
inline Json certificate(const Json& left, const Json& right, const Json& ranges, const Json& links,
                        const Json& steps = Json::array(), const Json& cut = Json::array()) {
  const Json piece{{"steps", steps}, {"links", links}};
  return {{"format", "rederive certificate 11"},
          {"left", left},
          {"right", right},
          {"given", Json::object()},
          {"divisors", Json::array()},
          {"never zero", Json::array()},
          {"parts of divisors", Json::object()},
          {"slopes", Json::object()},
          {"ranges", ranges},
          {"declared", Json::object()},
          {"cut", cut},
          {"pieces", Json(1 << cut.size(), piece)}};
}

/// What the checker says of that.
inline std::string verdict_of_links(const Json& left, const Json& right, const Json& ranges,
                                    const Json& steps, const Json& links, const Json& cut = Json::array(),
                                    const Json& divisors = Json::array(),
                                    const Json& parts_of_divisors = Json::object()) {
  Json c = certificate(left, right, ranges, links, steps, cut);
  c["divisors"] = divisors, c["parts of divisors"] = parts_of_divisors;
  try {
    certificate_checker::check(c);
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// With one link.
inline std::string verdict(const Json& left, const Json& right, const Json& ranges, const Json& steps,
                           const Json& link, const Json& cut = Json::array(),
                           const Json& divisors = Json::array(),
                           const Json& parts_of_divisors = Json::object()) {
  return verdict_of_links(left, right, ranges, steps, Json::array({link}), cut, divisors, parts_of_divisors);
}

/// The residuals of the first links of both statements, and the factor between them.
inline Json linked(const std::string& left, const std::string& right, const std::string& cofactor = "1",
                   const Json& factor = Json::object()) {
  const auto side = [](const std::string& residual) -> Json {
    return {{"links", {{{"link", 0}}}}, {"residual", residual}};
  };
  return {{"left", side(left)}, {"right", side(right)}, {"factor", factor}, {"cofactor", cofactor}};
}

inline const char* const real = "(-inf, inf)";

}  // namespace by_hand
