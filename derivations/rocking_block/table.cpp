#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initial_conditions.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <derivations/rocking_block/table.hpp>
#include <stdexcept>

namespace rederive {

namespace {

using Table = std::map<std::string, Derive>;

void add(const Derivations& section, Table& all) {
  for (const auto& [id, derive] : section)
    if (!all.emplace(id, derive).second)
      throw std::invalid_argument("equation (" + id + ") is derived twice");
}

Table& table() {
  static Table all = [] {
    Table sections;
    for (const Derivations& section :
         {derivations_of_kinematics(), derivations_of_equation_of_motion(), derivations_of_energy(),
          derivations_of_initiation(), derivations_of_impact(), derivations_of_sliding(),
          derivations_of_pulse(), derivations_of_linear_response(),
          derivations_of_overturning_without_impact(), derivations_of_overturning_impact_during_pulse(),
          derivations_of_overturning_impact_after_pulse(), derivations_of_initial_conditions()})
      add(section, sections);
    return sections;
  }();
  return all;
}

}  // namespace

const Table& derivation_table() { return table(); }

void derive_instead(const Derivations& other) {
  Table all;
  add(other, all);
  table() = std::move(all);
}

}  // namespace rederive
