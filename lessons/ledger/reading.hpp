// What is wrong with a text that a user typed, said with a caret under it.
#pragma once

#include <derivations/emit/command_line.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

/// Runs `read`; what it finds wrong with `text` becomes BadInput.
template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(explain(error, text));
  }
}

}  // namespace rederive
