// Reads formulas in LaTeX as values.
#pragma once

#include <derivations/manuscript/tokens.hpp>
#include <derivations/manuscript/values.hpp>

namespace rederive::manuscript {

/// Reads tokens as one value. Throws SyntaxError, with the place in the manuscript, for what is not read.
Value read_value(const TexTokens& tokens, Meanings& meanings, Choices& choices);

/// A name at the start of tokens, such as x_1 with a dot, and the number of its tokens; 0 tokens for none.
struct Name {
  std::string name;
  std::size_t size = 0;
};
Name name_at(const TexTokens& tokens, std::size_t at);

}  // namespace rederive::manuscript
