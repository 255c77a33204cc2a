#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/overturning_without_impact.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <derivations/rocking_block/table.hpp>

namespace rederive {

const std::map<std::string, Derive>& derivation_table() {
  static const std::map<std::string, Derive> table{
      // The equation of motion
      {"1", equation_1}, {"2a", equation_2a}, {"2b", equation_2b}, {"3", equation_3}, {"4a", equation_4a},
      {"4b", equation_4b}, {"5", equation_5}, {"6", equation_6}, {"7a", equation_7a}, {"7b", equation_7b},
      {"8", equation_8}, {"9", equation_9}, {"10", equation_10}, {"11", equation_11}, {"12a", equation_12a},
      {"12b", equation_12b}, {"13", equation_13}, {"14", equation_14}, {"15a", equation_15a},
      {"15b", equation_15b}, {"16a", equation_16a}, {"16b", equation_16b}, {"17a", equation_17a},
      {"17b", equation_17b}, {"18", equation_18}, {"19", equation_19}, {"20", equation_20},
      {"21a", equation_21a}, {"21b", equation_21b}, {"22a", equation_22a}, {"22b", equation_22b},
      {"23", equation_23}, {"24a", equation_24a}, {"24b", equation_24b}, {"25a", equation_25a},
      {"25b", equation_25b}, {"26a", equation_26a}, {"26b", equation_26b}, {"27", equation_27},
      {"28a", equation_28a}, {"28b", equation_28b}, {"30", equation_30}, {"31", equation_31},
      {"32a", equation_32a}, {"32b", equation_32b}, {"33", equation_33},
      {"35", equation_35}, {"37a", equation_37a}, {"37b", equation_37b}, {"38", equation_38},
      {"39", equation_39}, {"40a", equation_40a}, {"40b", equation_40b}, {"41", equation_41},
      {"42a", equation_42a}, {"42b", equation_42b}, {"43a", equation_43a}, {"43b", equation_43b},
      {"45a", equation_45a}, {"45b", equation_45b}, {"46a", equation_46a}, {"46b", equation_46b},
      {"47a", equation_47a}, {"47b", equation_47b}, {"48a", equation_48a}, {"48b", equation_48b},
      {"48c", equation_48c}, {"49a", equation_49a}, {"49b", equation_49b}, {"49c", equation_49c},
      {"50a", equation_50a}, {"50b", equation_50b}, {"50", equation_50}, {"50c", equation_50c},
      {"51a", equation_51a}, {"51b", equation_51b}, {"51c", equation_51c},
      {"t1", moment_of_inertia_about_centre}, {"t2", moment_of_inertia_about_pivot}, {"t3", frequency_parameter},
      {"t4", ground_at_alpha_by_21a}, {"t5", ground_at_alpha_by_21b},
      {"t6", energy_loss}, {"t7", mass_of_the_block},{"t8", contact_positive}, {"t9", friction_demand_positive},{"t10",share_at_least},
  {"53a", equation_53a}, {"53b", equation_53b}, {"53c", equation_53c}, {"54", equation_54}, {"55a", equation_55a}, {"55b", equation_55b}, {"56a", equation_56a}, {"56b", equation_56b}, {"57a", equation_57a}, {"57b", equation_57b}, {"58a", equation_58a}, {"58b", equation_58b}, {"58c", equation_58c}, {"58d", equation_58d}, {"59a", equation_59a}, {"59b", equation_59b}, {"61a", equation_61a}, {"61b", equation_61b}, {"62a", equation_62a}, {"62b", equation_62b}, {"63a", equation_63a}, {"63b", equation_63b}, {"64a", equation_64a}, {"64b", equation_64b}, {"64c", equation_64c}, {"64d", equation_64d}, {"65a", equation_65a}, {"65b", equation_65b}, {"66a", equation_66a}, {"66b", equation_66b}, {"67", equation_67}, {"68", equation_68}, {"69a", equation_69a}, {"69b", equation_69b}, {"70a", equation_70a}, {"70b", equation_70b}, {"71", equation_71}, {"72a", equation_72a}, {"72b", equation_72b}, {"73a", equation_73a}, {"73b", equation_73b}, {"74", equation_74}, {"75", equation_75}, {"76a", equation_76a}, {"76b", equation_76b}, {"77a", equation_77a}, {"77b", equation_77b}, {"78", equation_78},
  };
  return table;
}

}  // namespace rederive
