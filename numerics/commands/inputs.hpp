// The files that `rocking` reads: recorded ground motions, and blocks by name.
#pragma once

#include <numerics/commands/options.hpp>
#include <numerics/records/record.hpp>
#include <string>
#include <vector>

namespace rederive::numerics::commands {

/// The options as the user wrote them.
struct RecordFlags {
  std::string step, unit, gaps, accept;
};

/// Adds --step, --unit, --gaps and --accept; each needs `record`.
void add_record_flags(CLI::App& app, RecordFlags& flags, CLI::Option* record);

/// Returns what the options say. Throws BadInput that names the option with a value out of range.
RecordOptions options_of(const RecordFlags& flags);

/// Returns the option that says what the headers of files also say: "--step", "--unit", or "" if none was
/// given.
std::string option_of_columns(const RecordFlags& flags);

struct NamedBlock {
  std::string name;
  Block block;
};

/// Returns the blocks in a TOML file of tables [[block]]. Each has a name; half_width and half_height in
/// metres, or alpha in rad and frequency_parameter in 1/s; and a restitution, unless eq (46) gives it. Throws
/// BadInput with file and line for what cannot be read or is out of range.
std::vector<NamedBlock> read_blocks(const std::string& file);

}  // namespace rederive::numerics::commands
