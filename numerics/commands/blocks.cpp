#include <derivations/program/toml_table.hpp>
#include <numerics/commands/blocks.hpp>

namespace rederive::numerics::commands {
namespace {

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
