#include <lessons/ledger/claims_checks.hpp>
#include <stdexcept>

namespace rederive {

const std::map<std::string, Check>& claim_checks() {
  static const std::map<std::string, Check> table = [] {
    std::map<std::string, Check> all;
    for (const auto& part : {checks_of_symbols(), checks_of_rows(), checks_of_start(), checks_of_impact(),
                             checks_of_linear_model(), checks_of_one_impact(), checks_of_cosine(),
                             checks_of_figures(), checks_of_minima(), checks_of_spectra()})
      for (const auto& [name, check] : part)
        if (!all.emplace(name, check).second)
          throw std::logic_error("the check " + name + " is listed twice");
    return all;
  }();
  return table;
}

}  // namespace rederive
