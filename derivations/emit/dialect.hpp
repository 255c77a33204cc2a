// How one programming language writes a function: numbers, calls, declarations, comments.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rederive::emit {

enum class Target { c, cpp, javascript, latex, python };

/// The parts of one function, as text in the target language.
struct Body {
  std::vector<std::string> functions_used;  ///< "sin", "sqrt" …
  bool uses_pi = false;
  std::vector<std::string> unused;                           ///< arguments that do not occur
  std::vector<std::pair<std::string, std::string>> shared;   ///< name, expression
  std::vector<std::pair<std::string, std::string>> results;  ///< "value" or "d_psi", expression
};

/// Describes how a programming language writes expressions. LaTeX is not one of them; see emit.cpp.
class Dialect {
 public:
  virtual ~Dialect() = default;
  virtual std::string number(const std::string& digits) const = 0;
  virtual std::string pi() const = 0;
  /// Returns a call of a function, named as in C, with its arguments.
  virtual std::string call(const std::string& function, const std::string& arguments) const {
    return function + "(" + arguments + ")";
  }
  virtual std::string comment(const std::vector<std::string>& lines) const = 0;
  virtual std::string prologue() const = 0;
  virtual std::string epilogue() const { return ""; }
  /// Returns the definition of a function: of one that returns a number if there is one result, else a record
  /// with a member for each result.
  virtual std::string function(const std::string& name, const std::vector<std::string>& arguments,
                               const std::vector<std::string>& documentation, const Body& body) const = 0;
};

/// A target of `emit --target`, with its name. The dialect of LaTeX is nullptr.
struct TargetLanguage {
  Target target;
  std::string name;
  const Dialect* dialect;
};
/// Returns all targets.
const std::vector<TargetLanguage>& target_languages();

/// Returns the dialect of a target. Throws std::invalid_argument for LaTeX.
const Dialect& dialect(Target target);

/// Returns a line, broken after separators so that no line is longer than 110 columns where that is possible.
/// `indent` begins each further line.
std::string wrapped(const std::string& line, const std::string& indent, const std::string& separator = " ");

}  // namespace rederive::emit
