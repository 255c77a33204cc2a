// Reads tokens into a tree by recursive descent, with one function per level of the grammar.
#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/language/lexer.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <utility>

namespace rederive::language {
namespace {
using Kind = Node::Kind;
using Is = Token::Kind;

constexpr std::size_t longest_text = 60;  // that is repeated in a message

class Parser {
 public:
  Parser(std::string_view text, const Symbols& symbols, const Limits& limits)
      : text_(text), symbols_(symbols), limits_(limits), tokens_(tokenize(text, symbols, limits)) {}

  Relation statement() {
    if (now().kind == Is::end) refuse(Mistake::empty, "there is no formula here");
    Relation relation;
    relation.sides.push_back(sum());
    while (now().kind == Is::relation) {
      relation.operators.push_back(take().text);
      relation.sides.push_back(sum());
    }
    if (now().is(")")) refuse(Mistake::syntax, "this parenthesis closes nothing");
    if (now().is(",")) refuse_comma();
    return relation;
  }

  Tree expression() {
    Relation relation = statement();
    if (relation.operators.empty()) return relation.sides[0];
    const Token& sign = *std::ranges::find(tokens_, Is::relation, &Token::kind);
    refuse(Mistake::relation, "an expression is expected here, without '" + sign.text + "'", sign);
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& take() { return tokens_[at_++]; }
  bool take_if(std::string_view mark) { return now().is(mark) && ++at_ > 0; }
  bool is_either(std::string_view a, std::string_view b) const { return now().is(a) || now().is(b); }
  [[noreturn]] static void refuse(Mistake mistake, const std::string& message, const Token& where) {
    throw SyntaxError(mistake, where.position, message);
  }
  [[noreturn]] void refuse(Mistake mistake, const std::string& message) const {
    refuse(mistake, message, now());
  }
  std::string quoted(const Token& token) const {
    const std::string_view typed = text_.substr(token.position, token.end - token.position);
    return "'" + std::string(typed.size() <= longest_text ? typed : "…") + "'";
  }

  /// Counts the depth of the recursion. Throws beyond the limit that was given, or that the stack sets.
  void go_down() {
    constexpr std::size_t bearable = 500;
    if (++depth_ <= std::min(limits_.depth, bearable)) return;
    refuse(Mistake::too_deep, "this is nested deeper than " + std::to_string(depth_ - 1) + " levels");
  }
  Tree back_up(Tree result) {
    --depth_;
    return result;
  }

  /// Reads one operand, or a sum or a product of several.
  Tree chain(Kind kind, Tree first, std::string_view plain, std::string_view inverse, Tree (Parser::*next)(),
             std::size_t position) {
    if (!is_either(plain, inverse)) return first;
    Node node{kind, "", {std::move(first)}, {false}, position};
    while (is_either(plain, inverse)) {
      node.inverse.push_back(take().text == inverse);
      node.children.push_back((this->*next)());
    }
    return std::make_shared<const Node>(std::move(node));
  }

  Tree sum() {
    go_down();
    const std::size_t position = now().position;
    const bool minus = take_if("-");
    if (!minus) take_if("+");
    Tree first = product();
    if (minus) first = make_tree(Kind::negative, "", {first}, {}, position);
    return back_up(chain(Kind::sum, first, "+", "-", &Parser::product, position));
  }

  Tree product() {
    const std::size_t position = now().position;
    return chain(Kind::product, factor(), "*", "/", &Parser::factor, position);
  }

  /// Reads an operand with the signs before it.
  Tree with_signs(Tree (Parser::*operand)()) {
    if (!is_either("-", "+")) return (this->*operand)();
    go_down();
    const Token& sign = take();
    Tree inside = back_up(with_signs(operand));
    return sign.text == "+" ? inside : make_tree(Kind::negative, "", {inside}, {}, sign.position);
  }

  Tree factor() { return with_signs(&Parser::unsigned_factor); }
  Tree exponent() { return with_signs(&Parser::power); }

  Tree unsigned_factor() {
    const Tree first = power();
    if (!now().starts_operand()) return first;
    if (now().text == "and" || now().text == "or")
      refuse(Mistake::syntax, "one statement at a time: " + quoted(now()) + " is not read here");
    if (tokens_[at_ - 1].kind == Is::number && now().kind == Is::number)
      refuse(Mistake::implicit_multiplication,
             "two numbers side by side may be a sum, as in 1 1/2, or a product: the sign is missing");
    refuse(Mistake::implicit_multiplication, "a product needs its '*'");
  }

  Tree power() {
    const std::size_t position = now().position;
    Tree base = primary();
    if (now().kind == Is::superscript) {
      base = make_tree(Kind::power, "", {base, superscript()}, {}, position);
      if (now().is("^") || now().kind == Is::superscript)
        refuse(Mistake::syntax, "a power of a power needs parentheses: (x^2)^3");
    }
    if (!now().is("^")) return base;
    go_down();
    take();
    const Token& start = now();
    Tree exponent = back_up(this->exponent());
    check_exponent(*exponent, start);
    return make_tree(Kind::power, "", {base, exponent}, {}, position);
  }

  Tree superscript() {
    const Token& token = take();
    const bool minus = token.text[0] == '-';
    Tree digits = make_tree(Kind::number, token.text.substr(minus ? 1 : 0), {}, {}, token.position);
    check_exponent(*digits, token);
    return minus ? make_tree(Kind::negative, "", {digits}, {}, token.position) : digits;
  }

  void check_exponent(const Node& exponent, const Token& where) const {
    if (exponent.kind == Kind::negative) return check_exponent(*exponent.children[0], where);
    if (exponent.kind != Kind::number || exact(exponent.text) <= limits_.exponent) return;
    refuse(Mistake::too_large, "exponents go up to " + std::to_string(limits_.exponent), where);
  }

  Tree primary() {
    const Token& token = now();
    if (token.kind == Is::number) return make_tree(Kind::number, take().text, {}, {}, token.position);
    if (token.kind == Is::name) return name();
    if (take_if("(")) {
      Tree inside = sum();
      close(token);
      return inside;
    }
    if (!take_if("sqrt")) refuse_operand();
    go_down();
    return back_up(make_tree(Kind::call, "sqrt", {primary()}, {}, token.position));
  }

  void close(const Token& opened) {
    if (take_if(")")) return;
    if (now().kind == Is::relation) refuse(Mistake::relation, "a relation is not allowed inside parentheses");
    if (now().is(",")) refuse_comma();
    refuse(Mistake::syntax, "this parenthesis is never closed", opened);
  }

  /// Throws because an operand should begin here, but none does, as in x*, () or ².
  [[noreturn]] void refuse_operand() const {
    if (now().kind == Is::superscript) refuse(Mistake::syntax, "this exponent has no base");
    if (at_ == 0) refuse(Mistake::syntax, "an operand is missing before " + quoted(now()));
    const Token& before = tokens_[at_ - 1];
    if (before.is("(") && now().is(")")) refuse(Mistake::syntax, "there is nothing in these parentheses");
    refuse(Mistake::syntax, "an operand is missing after " + quoted(before));
  }

  /// Throws because of a comma that is not between the arguments of a function, as in 3,5.
  [[noreturn]] void refuse_comma() const {
    const Token &before = tokens_[at_ - 1], &after = tokens_[at_ + 1];
    if (before.kind != Is::number || after.kind != Is::number)
      refuse(Mistake::syntax, "a comma is only allowed between the arguments of a function");
    refuse(Mistake::syntax, "a decimal number is written with a point: " + before.text + "." + after.text);
  }

  Tree name() {
    const Token& token = take();
    const bool is_symbol = token.text == "pi" || symbols_.find(token.text) != nullptr;
    if (is_symbol) return make_tree(Kind::symbol, token.text, {}, {}, token.position);
    if (is_function(token.text)) return call(token);
    if (now().is("(") || (now().starts_operand() && !function_elsewhere(token.text).empty()))
      refuse(Mistake::unknown_function, unknown_function(token.text, quoted(token)), token);
    refuse(Mistake::unknown_symbol, unknown_symbol(token.text, quoted(token), symbols_), token);
  }

  Tree call(const Token& function) {
    Tree exponent = exponent_before_argument(function);
    if (!now().is("(")) refuse_bare_argument(function);
    const std::vector<Tree> arguments = this->arguments();
    const bool is_power = function.text == "pow";
    const std::string wanted = is_power ? "' takes 2 arguments, not " : "' takes 1 argument, not ";
    if (arguments.size() != (is_power ? 2 : 1))
      refuse(Mistake::arguments, "'" + function.text + wanted + std::to_string(arguments.size()), function);
    Tree value = make_tree(is_power ? Kind::power : Kind::call,
                           is_power ? "" : std::string(find_function(function.text)->name), arguments, {},
                           function.position);
    return exponent ? make_tree(Kind::power, "", {value, exponent}, {}, function.position) : value;
  }

  /// Reads the exponent of sin²(x). Throws for sin^2(x), and for sin⁻¹(x), which may mean two things.
  Tree exponent_before_argument(const Token& function) {
    const bool is_raised = now().kind == Is::superscript;
    if (!is_raised && !now().is("^")) return nullptr;
    if (is_raised ? now().text[0] == '-' : tokens_[at_ + 1].is("-"))
      refuse(Mistake::syntax,
             "this may mean 1/" + function.text + "(x) or a" + function.text + "(x): write which");
    if (is_raised) return superscript();
    refuse(Mistake::syntax, "an exponent comes after the argument", function);
  }

  std::vector<Tree> arguments() {
    const Token& opened = take();
    std::vector<Tree> arguments;
    if (!now().is(")")) arguments.push_back(sum());
    while (take_if(",")) arguments.push_back(sum());
    close(opened);
    return arguments;
  }

  [[noreturn]] void refuse_bare_argument(const Token& function) const {
    const bool is_raised = tokens_[at_ - 1].kind == Is::superscript;
    if (now().starts_operand())
      refuse(is_raised ? Mistake::syntax : Mistake::implicit_multiplication, "a function needs parentheses",
             function);
    refuse(Mistake::syntax, "a function needs its argument: write " + function.text + "(x)", function);
  }

  std::string_view text_;
  const Symbols& symbols_;
  const Limits& limits_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0, depth_ = 0;
};

}  // namespace

Relation parse_statement(std::string_view text, const Symbols& symbols, const Limits& limits) {
  return Parser(text, symbols, limits).statement();
}

Relation parse_relation(std::string_view text, const Symbols& symbols, const Limits& limits) {
  Relation relation = parse_statement(text, symbols, limits);
  if (!relation.operators.empty()) return relation;
  throw SyntaxError(Mistake::relation, text.size(), "a relation is expected here: a = b, a < b …");
}

Tree parse(std::string_view text, const Symbols& symbols, const Limits& limits) {
  return Parser(text, symbols, limits).expression();
}

}  // namespace rederive::language
