#include <map>
#include <numerics/commands/record_options.hpp>

namespace rederive::numerics::commands {
namespace {

const std::map<std::string, RecordUnit>& units() {
  static const std::map<std::string, RecordUnit> all{{"g", RecordUnit::g},
                                                     {"m/s2", RecordUnit::metres_per_second_squared},
                                                     {"cm/s2", RecordUnit::gal},
                                                     {"gal", RecordUnit::gal}};
  return all;
}

}  // namespace

void add_record_flags(CLI::App& app, RecordFlags& flags, CLI::Option* record) {
  const auto add = [&](const char* name, std::string& into, const char* type, const char* what) {
    return app.add_option(name, into, what)->type_name(type)->needs(record);
  };
  add("--step", flags.step, "SECONDS",
      "Set the time step, from 1e-9 to 1e6 s, of records that contain values alone.");
  add("--unit", flags.unit, "NAME", "Set the unit of columns. Default: g, if no value is above 10.")
      ->check(CLI::IsMember({"g", "gal", "cm/s2", "m/s2"}));
  add("--gaps", flags.gaps, "NAME",
      "Refuse a record with missing values or times, or interpolate between neighbours. Default: refuse.")
      ->check(CLI::IsMember({"refuse", "interpolate"}));
  add("--accept", flags.accept, "VALUE", "Accept a value such as -999, which usually marks a missing one.");
}

RecordOptions options_of(const RecordFlags& flags) {
  RecordOptions options;
  if (!flags.unit.empty()) options.unit = units().at(flags.unit);
  if (!flags.step.empty()) options.step = number_between("--step", flags.step, 1e-9, 1e6);
  options.interpolate = flags.gaps == "interpolate";
  if (!flags.accept.empty()) options.accept = number("--accept", flags.accept);
  return options;
}

std::string option_of_columns(const RecordFlags& flags) {
  if (!flags.step.empty()) return "--step";
  return flags.unit.empty() ? "" : "--unit";
}

}  // namespace rederive::numerics::commands
