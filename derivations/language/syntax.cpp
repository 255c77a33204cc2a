// Tokens → tree, by recursive descent: a function a level of the grammar.
#include <algorithm>
#include <derivations/language/functions.hpp>
#include <derivations/language/suggestions.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/language/unicode.hpp>
#include <utility>

namespace rederive {

namespace {

using Kind = Node::Kind;

class Parser {
 public:
  Parser(std::string_view text, const Symbols& symbols, const Limits& limits)
      : limits_(limits), tokens_(tokenize(text, symbols, limits)), formula_{text, tokens_, symbols} {}

  Relation statement() {
    if (now().kind == Token::Kind::end) refuse("empty", "there is no formula here", now());
    Relation relation;
    relation.sides.push_back(sum());
    while (now().kind == Token::Kind::relation) {
      relation.operators.push_back(take().text);
      relation.sides.push_back(sum());
    }
    if (now().is(")")) refuse("syntax", "this parenthesis closes nothing", now());
    if (now().is(",")) throw stray_comma(formula_, at_);
    return relation;
  }

  Tree expression() {
    Relation relation = statement();
    if (relation.operators.empty()) return relation.sides[0];
    const Token& sign = *std::ranges::find(tokens_, Token::Kind::relation, &Token::kind);
    refuse("relation", "an expression is wanted here, without '" + sign.text + "'", sign);
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& take() { return tokens_[at_++]; }
  bool take_if(std::string_view mark) { return now().is(mark) && ++at_ > 0; }
  bool is_either(std::string_view a, std::string_view b) const { return now().is(a) || now().is(b); }
  [[noreturn]] static void refuse(const char* note, const std::string& message, const Token& where) {
    throw SyntaxError(note, where.position, message);
  }

  /// Counts how deep the recursion is, and refuses to go deeper than asked, or than the stack can bear.
  void go_down() {
    constexpr std::size_t bearable = 500;
    if (++depth_ <= std::min(limits_.depth, bearable)) return;
    refuse("too_deep", "this is nested deeper than " + std::to_string(depth_ - 1) + " levels", now());
  }
  Tree back_up(Tree result) {
    --depth_;
    return result;
  }

  /// One operand, or a sum or a product of several.
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
    const std::size_t position = now().position, outer = std::exchange(product_, at_);
    Tree result = chain(Kind::product, factor(), "*", "/", &Parser::factor, position);
    product_ = outer;
    return result;
  }

  /// The signs before an operand.
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
    const std::size_t first = at_;
    Tree operand = power();
    if (starts_operand(now())) throw juxtaposition(formula_, product_, first, at_);
    return operand;
  }

  Tree power() {
    const std::size_t position = now().position;
    Tree base = primary();
    if (now().kind == Token::Kind::superscript) {
      base = make_tree(Kind::power, "", {base, superscript()}, {}, position);
      if (now().is("^") || now().kind == Token::Kind::superscript)
        refuse("syntax", "a power of a power needs parentheses: (x^2)^3", now());
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
    refuse("too_large", "exponents go up to " + std::to_string(limits_.exponent), where);
  }

  Tree primary() {
    const Token& token = now();
    if (token.kind == Token::Kind::number)
      return make_tree(Kind::number, take().text, {}, {}, token.position);
    if (token.kind == Token::Kind::name) return name();
    if (take_if("(")) {
      Tree inside = sum();
      close(token);
      return inside;
    }
    if (!take_if("sqrt")) throw missing_operand(formula_, at_);
    go_down();
    return back_up(make_tree(Kind::call, "sqrt", {primary()}, {}, token.position));
  }

  void close(const Token& opened) {
    if (take_if(")")) return;
    if (now().kind == Token::Kind::relation)
      refuse("relation", "a relation cannot stand inside parentheses", now());
    if (now().is(",")) throw stray_comma(formula_, at_);
    refuse("syntax", "this parenthesis is never closed", opened);
  }

  Tree name() {
    const Token& token = take();
    const bool is_known = token.text == "pi" || formula_.symbols.find(token.text) != nullptr;
    if (!is_known && is_function(token)) return call(token);
    if (!is_known) throw unknown_name(formula_, at_ - 1);
    if (now().is("(")) throw called_symbol(formula_, at_ - 1);
    return make_tree(Kind::symbol, token.text, {}, {}, token.position);
  }

  Tree call(const Token& function) {
    Tree exponent;
    const bool raised = now().kind == Token::Kind::superscript;
    if (raised && now().text[0] == '-') throw ambiguous_inverse(function, now());
    if (raised) exponent = superscript();
    if (!now().is("(")) throw bare_function(formula_, raised ? at_ - 2 : at_ - 1);
    const Token& opened = take();
    std::vector<Tree> arguments;
    if (!now().is(")")) arguments.push_back(sum());
    while (take_if(",")) arguments.push_back(sum());
    close(opened);
    const bool is_power = function.text == "pow";
    check_arguments(function, arguments.size(), is_power ? 2 : 1);
    Tree value = make_tree(is_power ? Kind::power : Kind::call,
                           is_power ? "" : std::string(find_function(function.text)->name),
                           std::move(arguments), {}, function.position);
    return raised ? make_tree(Kind::power, "", {value, exponent}, {}, function.position) : value;
  }

  static void check_arguments(const Token& function, std::size_t given, std::size_t wanted) {
    if (given == wanted) return;
    const std::string arguments = std::to_string(wanted) + (wanted == 1 ? " argument" : " arguments"),
                      counts = "' takes " + arguments + ", not " + std::to_string(given),
                      point = given == 2 ? "; decimal numbers are written with a point" : "";
    refuse("arguments", "'" + function.text + counts + point, function);
  }

  const Limits& limits_;
  std::vector<Token> tokens_;
  Formula formula_;
  std::size_t at_ = 0, depth_ = 0, product_ = 0;  ///< product_: where the innermost one begins
};

}  // namespace

Relation parse_statement(std::string_view text, const Symbols& symbols, const Limits& limits) {
  return Parser(text, symbols, limits).statement();
}

Relation parse_relation(std::string_view text, const Symbols& symbols, const Limits& limits) {
  Relation relation = parse_statement(text, symbols, limits);
  if (!relation.operators.empty()) return relation;
  throw SyntaxError("relation", text.size(), "a relation is wanted here: a = b, a < b …");
}

Tree parse(std::string_view text, const Symbols& symbols, const Limits& limits) {
  return Parser(text, symbols, limits).expression();
}

std::string explain(const SyntaxError& error, std::string_view text) {
  const std::size_t position = std::min(error.position, text.size());
  const std::size_t start = text.substr(0, position).rfind('\n') + 1;  // 0 on the first line
  const std::string_view line = text.substr(start, text.find('\n', position) - start);
  std::vector<std::string> characters;  // as a terminal can show them: what cannot be shown becomes '?'
  std::size_t at_fault = 0;
  for (std::size_t at = 0; at < line.size();) {
    const auto [code, bytes] = first_character(line.substr(at));
    const bool is_shown = bytes > 0 && !is_control(code) && !is_invisible(code);
    characters.push_back(is_shown ? std::string(line.substr(at, bytes)) : is_space(code) ? " " : "?");
    at_fault += start + at < position ? 1 : 0;
    at += std::max<std::size_t>(bytes, 1);
  }

  // A long line is shown around the character at fault.
  constexpr std::size_t before = 60, after = 40;
  const std::size_t first = at_fault > before ? at_fault - before : 0;
  const std::size_t last = std::min(characters.size(), at_fault + after);
  std::string shown = first > 0 ? "…" : "", indent = first > 0 ? " " : "";
  for (std::size_t i = first; i < last; ++i) {
    shown += characters[i];
    if (i < at_fault && !is_combining(first_character(characters[i]).code)) indent += ' ';
  }
  if (last < characters.size()) shown += "…";
  return std::string(error.what()) + "\n  " + shown + "\n  " + indent + "^";
}

}  // namespace rederive
