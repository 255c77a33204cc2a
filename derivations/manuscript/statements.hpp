// The lines of a display: statements, and how each is connected with the one before.
#pragma once

#include <derivations/manuscript/tokens.hpp>

namespace rederive::manuscript {

/// How a line follows from the one before.
enum class Connective { none, implies, equivalent };

/// A line, or a part of one: sides with relations between them. Its first side is empty if it goes on with
/// the last side before.
struct Statement {
  std::vector<TexTokens> sides;
  TexTokens relations;  ///< "=", "<", "<=", ">", ">=", "!=", "≈", ":=", or a command that is not read
  Connective connective = Connective::none;
  std::string words = {};  ///< before it, on the same line
  std::size_t place = 0;
  bool goes_on = false;    ///< it begins with a relation
  bool is_listed = false;  ///< it is one of several on its line
};

/// Returns the statements of a display, in order. `labels` receives the labels.
std::vector<Statement> statements_of(const TexTokens& tokens, const std::string& environment,
                                     std::vector<std::string>& labels);

}  // namespace rederive::manuscript
