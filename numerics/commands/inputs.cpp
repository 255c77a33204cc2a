#include <derivations/program/toml_table.hpp>
#include <map>
#include <numerics/commands/inputs.hpp>

namespace rederive::numerics::commands {
using namespace program;
namespace {

const std::map<std::string, RecordUnit>& units() {
  static const std::map<std::string, RecordUnit> all{{"g", RecordUnit::g},
                                                     {"m/s2", RecordUnit::metres_per_second_squared},
                                                     {"cm/s2", RecordUnit::gal},
                                                     {"gal", RecordUnit::gal}};
  return all;
}

constexpr std::size_t most_blocks = 1000, longest_block_name = 100;

Block block_in(TomlTable& table) {
  const auto half_width = table.number("half_width"), half_height = table.number("half_height"),
             alpha = table.number("alpha"), p = table.number("frequency_parameter"),
             restitution = table.number("restitution");
  table.done();
  try {
    if (half_width && half_height && !alpha && !p)
      return block_from_size(*half_width, *half_height, restitution);
    if (alpha && p && !half_width && !half_height) return make_block(*alpha, *p, restitution);
  } catch (const std::invalid_argument& error) {
    table.fail(error.what());
  }
  table.fail("a block needs half_width and half_height, or alpha and frequency_parameter");
}

NamedBlock named_block_in(TomlTable& table) {
  const std::string name = table.needed_line("name");
  if (name.size() > longest_block_name)
    table.fail(fmt::format("a name has at most {} bytes", longest_block_name), "name");
  return {.name = name, .block = block_in(table)};
}

}  // namespace

void add_record_flags(CLI::App& app, RecordFlags& flags, CLI::Option* record) {
  const auto add = [&](const char* name, std::string& into, const char* type, const char* what) {
    return add_text(app, name, into, type, what)->needs(record);
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

std::vector<NamedBlock> read_blocks(const std::string& file) {
  std::vector<NamedBlock> blocks;
  for (TomlTable& table : tables_of(file, "block")) {
    blocks.push_back(named_block_in(table));
    if (std::ranges::count(blocks, blocks.back().name, &NamedBlock::name) > 1)
      table.fail(fmt::format("a second block has the name '{}'", blocks.back().name), "name");
  }
  if (blocks.size() > most_blocks)
    throw BadInput(fmt::format("'{}' has more than {} blocks", file, most_blocks));
  return blocks;
}

}  // namespace rederive::numerics::commands
