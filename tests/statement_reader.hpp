// Reads expressions as `ledger prove` prints them, straight into fractions of polynomials. What names,
// functions and powers without a whole exponent are worth is said elsewhere.
#pragma once

#include <cctype>
#include <stdexcept>
#include <string_view>
#include <tests/polynomial.hpp>

namespace certificate_checker {

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

class StatementReader {
 public:
  virtual ~StatementReader() = default;
  /// Throws std::runtime_error.
  Fraction value(const std::string& text) {
    std::string_view rest = text;
    const Fraction result = read(rest, 0);
    return require(rest.empty(), "cannot read " + text), result;
  }

 protected:
  virtual Fraction symbol(const std::string& name) = 0;
  virtual Fraction call(const std::string& function, const Fraction& argument) = 0;
  virtual Fraction raised(const Fraction& base, const Fraction& exponent) = 0;
  virtual Fraction divisor(const Fraction& d) = 0;  ///< told of every one

 private:
  /// A sum (level 0), a product (1), a power (2) or an atom (3).
  Fraction read(std::string_view& s, int level) {
    const auto eat = [&](char c) {
      s.remove_prefix(std::min(s.find_first_not_of(' '), s.size()));
      return s.starts_with(c) ? s.remove_prefix(1), true : false;
    };
    const bool inside = eat('('), negative = !inside && eat('-');
    Fraction total = inside ? read(s, 0) : negative ? whole(-1) * read(s, 2) : read_atom(s);
    require(!inside || eat(')'), "a parenthesis is missing");
    for (;;)
      if (level < 3 && eat('^'))
        total = raised(total, read(s, 2));
      else if (level < 2 && eat('*'))
        total = total * read(s, 2);
      else if (level < 2 && eat('/'))
        total = total / divisor(read(s, 2));
      else if (level < 1 && eat('+'))
        total = total + read(s, 1);
      else if (level < 1 && eat('-'))
        total = total - read(s, 1);
      else
        return total;
  }
  Fraction read_atom(std::string_view& s) {
    const auto end =
        std::find_if(s.begin(), s.end(), [](char c) { return std::isalnum(c) == 0 && c != '_' && c != '$'; });
    const std::string word(s.begin(), end);
    require(!word.empty(), "cannot read '" + std::string(s) + "'");
    s.remove_prefix(word.size());
    if (std::isdigit(word[0]) != 0) return whole(word.c_str());
    if (s.starts_with('(')) return call(word, read(s, 3));
    return symbol(word);
  }
};

}  // namespace certificate_checker
