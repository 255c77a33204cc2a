// Trees as single operations, each of which is there only once, and operations as infix expressions.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/language/tree.hpp>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace rederive::emit {

/// One step of a computation. Operands are indices of earlier operations.
struct Operation {
  enum class Kind { number, symbol, add, subtract, multiply, divide, negate, call };
  Kind kind;
  std::string text;  ///< of numbers, symbols ("pi" is π) and calls
  std::vector<std::size_t> operands;
  bool constant = false;  ///< made of numbers alone: the compiler computes it

  bool is_leaf() const { return kind == Kind::number || kind == Kind::symbol; }
};

/// The operations that some expressions need, each before its first use. Integer powers are multiplications.
class Operations {
 public:
  explicit Operations(const std::vector<language::Tree>& trees);

  const std::vector<Operation>& all() const { return operations_; }
  const std::vector<std::size_t>& results() const { return results_; }  ///< one for each tree
  /// Returns how often each operation is used, as an operand or as a result.
  std::vector<std::size_t> uses() const;
  std::size_t count() const;           ///< the operations, without numbers and symbols
  std::size_t count_unshared() const;  ///< the same if everything were computed where it is used

 private:
  std::size_t add(const language::Node& node);
  std::size_t add_sum(const language::Node& node);
  std::size_t add_product(const language::Node& node);
  std::size_t add_power(const language::Node& node);
  std::size_t whole_power(std::size_t base, long exponent);
  std::size_t one_of(Operation::Kind kind, const std::string& text, std::vector<std::size_t> operands);

  std::vector<Operation> operations_;
  std::map<std::tuple<Operation::Kind, std::string, std::vector<std::size_t>>, std::size_t> known_;
  std::vector<std::size_t> results_;
};

/// Writes operations as infix expressions, with parentheses where precedence needs them. With `sharing`, what
/// is used more than once gets a name. It keeps references to its arguments, which must live longer.
class Infix {
 public:
  Infix(const Operations& operations, const Dialect& dialect, bool sharing);

  const std::vector<std::pair<std::string, std::string>>& shared() const { return shared_; }
  std::string text(std::size_t index) const { return text(index, 0); }

 private:
  /// `place` is 0 anywhere, 1 after a minus, 2 to the left of * and /, 3 to the right of them.
  std::string text(std::size_t index, int place) const;

  const std::vector<Operation>& all_;
  const Dialect& dialect_;
  std::vector<std::string> names_;
  std::vector<std::pair<std::string, std::string>> shared_;
};

}  // namespace rederive::emit
