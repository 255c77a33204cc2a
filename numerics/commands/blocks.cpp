#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <derivations/emit/program.hpp>
#include <numerics/commands/blocks.hpp>
#include <optional>

namespace rederive::inline numeric {
namespace {

constexpr std::array keys{"name", "half_width", "half_height", "alpha", "frequency_parameter", "restitution"};
constexpr std::size_t most_blocks = 1000;

NamedBlock block_in(const toml::table& table) {
  for (const auto& [key, value] : table)
    if (std::ranges::find(keys, key.str()) == keys.end())
      throw BadInput(fmt::format("'{}' is no key of a block: {}", key.str(), fmt::join(keys, ", ")));
  const auto size = [&](const char* key) -> std::optional<double> {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) throw BadInput(fmt::format("'{}' must be a number", key));
    return value;
  };
  NamedBlock found;
  found.name = table["name"].value<std::string>().value_or("");
  if (found.name.empty() || found.name.size() > 100 || printable_line(found.name) != found.name)
    throw BadInput("a block wants a name, of at most 100 bytes in one line");
  const auto b = size("half_width"), h = size("half_height"), alpha = size("alpha"),
             p = size("frequency_parameter"), e = size("restitution");
  if (b && h && !alpha && !p)
    found.block = block_from_size(*b, *h, e);
  else if (alpha && p && !b && !h)
    found.block = make_block(*alpha, *p, e);
  else
    throw BadInput("a block wants half_width and half_height, or alpha and frequency_parameter");
  return found;
}

}  // namespace

std::vector<NamedBlock> read_blocks(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(1'000'001, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) throw BadInput("cannot read '" + file + "'");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > 1'000'000) throw BadInput("'" + file + "' is larger than a megabyte");
  const auto refusal = [&](const toml::source_region& where, std::string_view why) {
    return BadInput(fmt::format("{}:{}: {}", file, where.begin.line, why));
  };
  std::vector<NamedBlock> blocks;
  try {
    const toml::table document = toml::parse(text);
    for (const auto& [key, value] : document)
      if (key.str() != "block" || !value.is_array_of_tables())
        throw refusal(value.source(), fmt::format("'{}' is no [[block]]", key.str()));
    const toml::array* tables = document["block"].as_array();
    if (tables == nullptr) throw BadInput("'" + file + "' has no [[block]] in it");
    for (const toml::node& node : *tables) {
      try {
        blocks.push_back(block_in(*node.as_table()));
      } catch (const std::exception& error) {
        throw refusal(node.source(), error.what());
      }
      if (std::ranges::count(blocks, blocks.back().name, &NamedBlock::name) > 1)
        throw refusal(node.source(), fmt::format("a second block of the name '{}'", blocks.back().name));
    }
  } catch (const toml::parse_error& error) {
    throw refusal(error.source(), error.description());
  }
  if (blocks.size() > most_blocks) throw BadInput("'" + file + "' has more than 1000 blocks");
  return blocks;
}

}  // namespace rederive::inline numeric
