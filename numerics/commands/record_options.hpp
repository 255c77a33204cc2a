// The options of `rocking` that say how records are read.
#pragma once

#include <numerics/commands/options.hpp>
#include <numerics/records/record.hpp>
#include <string>

namespace rederive::numerics::commands {

/// As the user wrote them.
struct RecordFlags {
  std::string step, unit, gaps, accept;
};

/// Adds --step, --unit, --gaps and --accept; each needs `record`.
void add_record_flags(CLI::App& app, RecordFlags& flags, CLI::Option* record);

/// Throws BadInput naming the option.
RecordOptions options_of(const RecordFlags& flags);

/// The option that says what the headers of files say: "--step", "--unit", or "" if none was given.
std::string option_of_columns(const RecordFlags& flags);

}  // namespace rederive::numerics::commands
