// What is proved has been checked.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rederive {

/// What the checker of certificates (tests/certificate_relations.hpp, which shares no code with what proves)
/// objects to in a certificate, read as it is written; empty where it accepts it.
std::string objection_to(const nlohmann::ordered_json& certificate);

}  // namespace rederive
