// Reads back the LaTeX that `print` writes, by the conventions of mathematics: the argument of a function
// without parentheses goes on to the next function, or to the end of the product.
#pragma once

#include <cctype>
#include <derivations/language/functions.hpp>
#include <stdexcept>
#include <tests/block.hpp>

namespace rederive::test {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;

class LatexReader {
 public:
  explicit LatexReader(const std::string& text) : text_(text) {}

  Tree whole() {
    const Tree tree = sum();
    if (at_ != text_.size()) fail();
    return tree;
  }

 private:
  using Kind = Node::Kind;

  [[noreturn]] void fail() const { throw std::runtime_error("at " + std::to_string(at_) + " of " + text_); }
  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool next_is(const std::string& part) {
    skip_blanks();
    const bool is_command = part[0] == '\\' && std::isalpha(static_cast<unsigned char>(part.back()));
    const std::size_t end = at_ + part.size();
    const bool goes_on =
        is_command && end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end]));
    return text_.compare(at_, part.size(), part) == 0 && !goes_on;
  }
  bool take(const std::string& part) {
    if (!next_is(part)) return false;
    at_ += part.size();
    return true;
  }
  void expect(const std::string& part) {
    if (!take(part)) fail();
  }

  Tree group() {
    expect("{");
    Tree inside = sum();
    expect("}");
    return inside;
  }

  Tree sum() {
    const bool is_negative = take("-");
    Tree first = product();
    if (is_negative) first = make_tree(Kind::negative, "", {first});
    std::vector<Tree> terms{first};
    std::vector<bool> inverse{false};
    while (next_is("+") || next_is("-")) {
      inverse.push_back(take("-") || !take("+"));
      terms.push_back(product());
    }
    return terms.size() == 1 ? first : make_tree(Kind::sum, "", terms, inverse);
  }

  bool at_end_of_product() {
    skip_blanks();
    if (at_ == text_.size()) return true;
    for (const char* mark : {"+", "-", "}", "\\right"})
      if (next_is(mark)) return true;
    return false;
  }
  bool at_function() {
    for (const Function& f : functions())
      if (!f.latex.empty() && next_is(std::string(f.latex))) return true;
    return false;
  }

  Tree product(bool is_argument = false) {
    std::vector<Tree> factors;
    while (!at_end_of_product() && !(is_argument && at_function())) {
      (void)take("\\cdot");
      factors.push_back(factor());
    }
    if (factors.empty()) fail();
    return factors.size() == 1 ? factors[0]
                               : make_tree(Kind::product, "", factors, std::vector<bool>(factors.size()));
  }

  /// Reads what follows ^: a group, or one character.
  Tree exponent() {
    skip_blanks();
    return next_is("{") ? group() : LatexReader(std::string(1, text_.at(at_++))).whole();
  }

  Tree factor() {
    Tree base = operand();
    while (take("^")) base = make_tree(Kind::power, "", {base, exponent()});
    return base;
  }

  Tree operand() {
    if (take("\\left(")) return closed(sum(), "\\right)");
    if (take("\\left|")) return make_tree(Kind::call, "fabs", {closed(sum(), "\\right|")});
    if (take("\\frac")) {
      // a quotient of what a symbol is written with is that symbol
      if (const Tree symbol = symbol_at(at_ - 5)) return symbol;
      const Tree above = group();
      return make_tree(Kind::product, "", {above, group()}, {false, true});
    }
    if (take("\\sqrt")) return make_tree(Kind::call, "sqrt", {group()});
    if (take("\\mathrm{e}^")) return make_tree(Kind::call, "exp", {group()});
    if (const Tree function = call()) return function;
    if (next_is("{")) return group();
    if (const Tree symbol = symbol_at(at_)) return symbol;
    return number();
  }
  Tree closed(Tree inside, const char* mark) {
    expect(mark);
    return inside;
  }

  Tree call() {
    for (const Function& f : functions()) {
      if (f.latex.empty() || !take(std::string(f.latex))) continue;
      const Tree raised = take("^") ? exponent() : nullptr;
      const Tree argument = take("\\left(") ? closed(sum(), "\\right)") : product(true);
      const Tree value = make_tree(Kind::call, std::string(f.name), {argument});
      return raised ? make_tree(Kind::power, "", {value, raised}) : value;
    }
    return nullptr;
  }

  /// Returns the longest name at this place.
  Tree symbol_at(std::size_t place) {
    const std::size_t before = std::exchange(at_, place);
    std::string best = "", name;
    const auto look_at = [&](const std::string& latex, const std::string& its_name) {
      if (next_is(latex) && latex.size() > best.size()) best = latex, name = its_name;
    };
    look_at("\\pi", "pi");
    for (const auto& [its_name, symbol] : paper_symbols().table()) look_at(symbol.latex, its_name);
    at_ = best.empty() ? before : at_ + best.size();
    return best.empty() ? nullptr : make_tree(Kind::symbol, name);
  }

  Tree number() {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_not_of("0123456789.", at_), text_.size());
    if (end == at_) fail();
    const std::string digits = text_.substr(at_, end - at_);
    at_ = end;
    return make_tree(Kind::number, digits);
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace rederive::test
