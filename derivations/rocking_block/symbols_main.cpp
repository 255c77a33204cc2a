// Writes what paper.toml declares as C++, so that derivations can name its symbols: m, alpha, thetadot …
//
// Sample run:  declare_symbols derivations/rocking_block symbols.hpp
#include <fmt/format.h>

#include <derivations/paper/folder.hpp>
#include <derivations/program/program.hpp>

using namespace rederive;

namespace {

std::string in_quotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "\"";
}

std::string header(const paper::Paper& paper) {
  std::string symbols, names, look_alikes;
  for (const std::string& name : paper.symbols.names()) {
    const language::Symbol& symbol = *paper.symbols.find(name);
    symbols += (symbols.empty() ? "" : ",\n") + fmt::format("    {}{{", name);
    names += (names.empty() ? "" : ", ") + name;
    for (const std::string* text : {&symbol.name, &symbol.latex, &symbol.unicode, &symbol.unit, &symbol.range,
                                    &symbol.meaning, &symbol.introduced})
      symbols += (text == &symbol.name ? "" : ", ") + in_quotes(*text);
    symbols += "}";
  }
  for (const auto& [one, other] : paper.look_alikes)
    look_alikes += fmt::format("{{{}, {}}}, ", in_quotes(one), in_quotes(other));
  return fmt::format(R"(// Written by declare_symbols from paper.toml: not to be edited.
#pragma once

#include <derivations/language/symbols.hpp>
#include <map>
#include <vector>

namespace rederive::rocking_block {{

inline constexpr auto title = {};

inline const language::Symbol
{};

/// Returns all symbols, in the order in which products and sums are printed.
inline std::vector<language::Symbol> all_symbols() {{
  return {{{}}};
}}

/// Symbols that a typesetter may confuse.
inline const std::map<std::string, std::string> look_alikes{{{}}};

}}  // namespace rederive::rocking_block
)",
                     in_quotes(paper.title), symbols, names, look_alikes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: declare_symbols DIR FILE\n", stderr);
    return program::bad_input;
  }
  try {
    program::write_whole(argv[2], header(paper::read_declarations(argv[1])));
    return program::as_expected;
  } catch (const program::BadInput& error) {
    std::fprintf(stderr, "declare_symbols: %s\n", error.what());
    return program::bad_input;
  }
}
