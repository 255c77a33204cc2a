// How one programming language writes a function: numbers, calls, declarations, comments.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rederive {

enum class Target { c, cpp, javascript, latex, python };

/// The pieces of one function, ready to be framed.
struct Body {
  std::vector<std::string> functions_used;  ///< "sin", "sqrt" …
  bool uses_pi = false;
  std::vector<std::string> unused;                           ///< arguments that do not occur
  std::vector<std::pair<std::string, std::string>> shared;   ///< name, expression
  std::vector<std::pair<std::string, std::string>> results;  ///< "value" or "d_psi", expression
};

/// A programming language. LaTeX is none; see emit.cpp.
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
  /// One result: a plain function; several: a record with a member for each.
  virtual std::string function(const std::string& name, const std::vector<std::string>& arguments,
                               const std::vector<std::string>& documentation, const Body& body) const = 0;
};

/// A language by the name that `emit --target` knows. LaTeX has no dialect.
struct TargetLanguage {
  Target target;
  std::string name;
  const Dialect* dialect;
};
/// All that there are.
const std::vector<TargetLanguage>& target_languages();

/// The one of a target. Throws std::invalid_argument for LaTeX.
const Dialect& dialect(Target target);

/// Breaks a line after separators so that no line is longer than 110 columns, if that can be.
std::string wrapped(const std::string& line, const std::string& indent, const std::string& separator = " ");

}  // namespace rederive
