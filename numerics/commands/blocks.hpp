// Blocks by name, out of a file.
#pragma once

#include <numerics/motion/block.hpp>
#include <string>
#include <vector>

namespace rederive::numerics::commands {

struct NamedBlock {
  std::string name;
  Block block;
};

/// Reads TOML: tables [[block]] with a name; half_width and half_height in metres, or alpha in rad and
/// frequency_parameter in 1/s; and, if it is not that of eq (46), restitution.
/// Throws BadInput with file and line for what cannot be read or is out of range.
std::vector<NamedBlock> read_blocks(const std::string& file);

}  // namespace rederive::numerics::commands
