// Reads statements, straight into fractions of polynomials. What names and functions are worth is said
// elsewhere.
#pragma once

#include <cctype>
#include <tests/polynomial.hpp>

namespace certificate_checker {

class StatementReader {
 public:
  virtual ~StatementReader() = default;

 protected:
  virtual Fraction symbol(const std::string& name) = 0;
  virtual Fraction call(const std::string& name, const Fraction& argument) = 0;
  virtual Fraction root(const Fraction& base, const Fraction& exponent) = 0;  ///< no whole exponent
  virtual Fraction divisor(const Fraction& d) = 0;                            ///< told of every one

  int depth_ = 0;

  struct Text {
    const std::string& all;
    std::size_t at = 0;
    char peek() {
      while (at < all.size() && all[at] == ' ') ++at;
      return at < all.size() ? all[at] : '\0';
    }
    bool eat(char c) { return peek() == c && ++at > 0; }
    std::string word() {
      const std::size_t start = at;
      while (at < all.size() && (std::isalnum(static_cast<unsigned char>(all[at])) != 0 || all[at] == '_' ||
                                 all[at] == '$' || all[at] == '.'))
        ++at;
      require(at > start, "cannot read '" + all + "'");
      return all.substr(start, at - start);
    }
  };
  Fraction value(const std::string& text) {
    require(++depth_ < 60, "what is given goes round in a circle");
    Text t{text};
    const Fraction result = read_sum(t);
    require(t.peek() == '\0', "cannot read '" + text + "'");
    return --depth_, result;
  }
  Fraction read_sum(Text& t) {
    Fraction total = read_product(t);
    for (;;)
      if (t.eat('+'))
        total = sum(total, read_product(t));
      else if (t.eat('-'))
        total = sum(total, read_product(t), -1);
      else
        return total;
  }
  Fraction read_product(Text& t) {
    Fraction total = read_factor(t);
    for (;;)
      if (t.eat('*'))
        total = product(total, read_factor(t));
      else if (t.eat('/'))
        total = over(total, divisor(read_factor(t)));
      else
        return total;
  }
  Fraction read_factor(Text& t) {
    if (t.eat('-')) return product(fraction(constant(-1)), read_factor(t));
    const Fraction base = read_atom(t);
    if (!t.eat('^')) return base;
    const Fraction exponent = read_factor(t);
    const Number* n = number(exponent);
    if (n == nullptr || cln::denominator(*n) != 1) return root(base, exponent);
    return power(cln::minusp(*n) ? divisor(base) : base, cln::cl_I_to_int(cln::numerator(*n)));
  }
  Fraction read_atom(Text& t) {
    if (t.eat('(')) {
      const Fraction inside = read_sum(t);
      require(t.eat(')'), "a parenthesis is missing");
      return inside;
    }
    std::string word = t.word();
    if (word.back() == 'e' && std::isdigit(static_cast<unsigned char>(word[0])) != 0 && t.eat('-'))
      word += "-" + t.word();
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) return fraction(constant(decimal(word)));
    if (t.peek() == '(') return call(word, read_atom(t));
    return symbol(word);
  }
  static Number decimal(std::string digits) {
    if (const auto e = digits.find('e'); e != std::string::npos) {
      const long tens = std::stol(digits.substr(e + 1));
      const Number scale = cln::expt_pos(cln::cl_I(10), std::labs(tens) + 1);
      return decimal(digits.substr(0, e)) * (tens < 0 ? 10 / scale : scale / 10);
    }
    const auto point = digits.find('.');
    const std::size_t places = point == std::string::npos ? 0 : digits.size() - point - 1;
    if (point != std::string::npos) digits.erase(point, 1);
    return Number(cln::cl_I(digits.c_str())) / cln::expt_pos(cln::cl_I(10), static_cast<long>(places) + 1) *
           10;
  }
};

}  // namespace certificate_checker
