#include <derivations/rocking_block/paper.hpp>
#include <lessons/rocking_block/claims.hpp>
#include <lessons/rocking_block/claims_bench.hpp>
#include <memory>
#include <stdexcept>

namespace rederive::rocking_block {
using namespace paper;
using namespace ledger;

Claims claims() {
  Claims all{.file = equations_file(paper()).parent_path() / "claims.toml", .checks = {}};
  const auto bench = std::make_shared<Bench>();
  for (const Checks& part :
       {checks_of_symbols(), checks_of_start(), checks_of_impact(), checks_of_linear_model(),
        checks_of_cosine(), checks_of_figures(), checks_of_spectra()})
    for (const auto& [name, check] : part)
      if (!all.checks
               .emplace(name, [bench, check = check](const Claim& claim) { return check(*bench, claim); })
               .second)
        throw std::logic_error("the check " + name + " is listed twice");
  return all;
}

}  // namespace rederive::rocking_block
