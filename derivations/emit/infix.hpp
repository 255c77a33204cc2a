// Operations as infix expressions.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/emit/operations.hpp>

namespace rederive {

/// Writes operations as infix expressions, with parentheses where precedence needs them. `sharing` = what is
/// used more than once gets a name.
class Infix {
 public:
  Infix(const Operations& operations, const Dialect& dialect, bool sharing);

  const std::vector<std::pair<std::string, std::string>>& shared() const { return shared_; }
  std::string text(std::size_t index) const { return text(index, 0); }

 private:
  /// `place`: 0 anywhere, 1 after a minus, 2 left of * and /, 3 right of them or after a unary minus.
  std::string text(std::size_t index, int place) const;

  const std::vector<Operation>& all_;
  const Dialect& dialect_;
  std::vector<std::string> names_;
  std::vector<std::pair<std::string, std::string>> shared_;
};

}  // namespace rederive
