// Tree → text: what all notations have in common.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>

namespace rederive {

/// What may stand somewhere without parentheses.
enum class Place {
  whole,     ///< anything: a side, an argument
  term,      ///< a term after the first, or what a leading minus stands before: products and less
  factor,    ///< powers and less
  exponent,  ///< numbers, names and calls
};

/// How signs and names are written.
struct Signs {
  const char *minus, *pi, *opening, *closing;
  std::string Symbol::*name;
};

/// Parentheses go where the grammar of syntax.hpp needs them, and nowhere else, so that what is printed reads
/// back as the same tree.
class Printer {
 public:
  Printer(const Signs& signs, const Symbols& symbols) : signs_(signs), symbols_(symbols) {}
  virtual ~Printer() = default;

  std::string print(const Tree& tree, Place place = Place::whole) const;

 protected:
  std::string bracket(const std::string& text) const { return signs_.opening + text + signs_.closing; }
  virtual std::string number(const std::string& digits) const { return digits; }
  virtual std::string product(const Node& node) const = 0;
  virtual std::string power(const Node& node) const = 0;
  virtual std::string call(const Node& node) const = 0;

 private:
  bool needs_parentheses(const Node& node, Place place) const;
  std::string bare(const Node& node) const;
  std::string symbol(const std::string& name) const;
  std::string sum(const Node& node) const;

  const Signs& signs_;
  const Symbols& symbols_;
};

/// "\\frac{3 g}{4 R}", "\\sin^2\\alpha", "\\dot\\theta^2", for mathematics mode.
std::string print_latex(const Tree& tree, const Symbols& symbols);

}  // namespace rederive
