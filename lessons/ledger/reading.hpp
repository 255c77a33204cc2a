// What is wrong with a text that a user typed, said with a caret under it.
#pragma once

#include <derivations/algebra/syntax.hpp>
#include <derivations/command_line.hpp>

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
