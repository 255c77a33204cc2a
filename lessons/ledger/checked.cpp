#include <lessons/ledger/checked.hpp>
#include <tests/certificate_relations.hpp>

namespace rederive {

std::string objection_to(const nlohmann::ordered_json& certificate) {
  try {
    certificate_checker::check(nlohmann::json::parse(certificate.dump()));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace rederive
