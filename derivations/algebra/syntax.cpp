// Tokens → tree, by recursive descent: a function a level of the grammar.
#include <algorithm>
#include <derivations/algebra/advice.hpp>
#include <derivations/algebra/functions.hpp>
#include <derivations/algebra/syntax.hpp>
#include <derivations/algebra/tokens.hpp>
#include <utility>

namespace rederive {

namespace {

Tree make(Node::Kind kind, std::string text, std::vector<Tree> children, std::size_t position) {
  return std::make_shared<const Node>(Node{kind, std::move(text), std::move(children), {}, position});
}

class Parser {
 public:
  Parser(std::string_view text, const Symbols& symbols, const Limits& limits)
      : symbols_(symbols),
        limits_(limits),
        tokens_(tokenize(text, symbols, limits)),
        advice_(text, tokens_, symbols) {}

  Relation statement() {
    if (now().kind == Token::Kind::end) refuse("empty", "there is no formula here");
    Relation relation;
    relation.sides.push_back(sum());
    while (now().kind == Token::Kind::relation) {
      relation.operators.push_back(take().text);
      relation.sides.push_back(sum());
    }
    if (now().is(")")) refuse("syntax", "this parenthesis closes nothing");
    if (now().is(",")) throw advice_.stray_comma(at_);
    return relation;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& take() { return tokens_[at_++]; }
  bool take_if(std::string_view mark) {
    const bool there = now().is(mark);
    if (there) ++at_;
    return there;
  }
  [[noreturn]] void refuse(const char* note, const std::string& message) const {
    refuse(note, message, now());
  }
  [[noreturn]] static void refuse(const char* note, const std::string& message, const Token& where) {
    throw SyntaxError(note, where.position, message);
  }

  /// Counts how deep the recursion is, and refuses to go deeper than asked, or than the stack can bear.
  struct Deeper {
    explicit Deeper(Parser& parser) : parser_(parser) {
      constexpr std::size_t bearable = 500;
      if (++parser_.depth_ > std::min(parser_.limits_.depth, bearable)) {
        parser_.refuse("too_deep",
                       "this is nested deeper than " + std::to_string(parser_.depth_ - 1) + " levels");
      }
    }
    ~Deeper() { --parser_.depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    Parser& parser_;
  };

  Tree sum() {
    const Deeper deeper(*this);
    const std::size_t position = now().position;
    const bool minus = take_if("-");
    if (!minus) take_if("+");
    Tree first = product();
    if (minus) first = make(Node::Kind::negative, "", {first}, position);
    if (!now().is("+") && !now().is("-")) return first;
    Node node{Node::Kind::sum, "", {first}, {false}, position};
    while (now().is("+") || now().is("-")) {
      node.inverse.push_back(take().text == "-");
      node.children.push_back(product());
    }
    return std::make_shared<const Node>(std::move(node));
  }

  Tree product() {
    const std::size_t position = now().position, outer = std::exchange(product_, at_);
    Tree first = factor();
    if (!now().is("*") && !now().is("/")) {
      product_ = outer;
      return first;
    }
    Node node{Node::Kind::product, "", {first}, {false}, position};
    while (now().is("*") || now().is("/")) {
      node.inverse.push_back(take().text == "/");
      node.children.push_back(factor());
    }
    product_ = outer;
    return std::make_shared<const Node>(std::move(node));
  }

  Tree factor() {
    if (now().is("-") || now().is("+")) {
      const Deeper deeper(*this);
      const Token& sign = take();
      Tree operand = factor();
      return sign.text == "+" ? operand : make(Node::Kind::negative, "", {operand}, sign.position);
    }
    const std::size_t first = at_;
    Tree operand = power();
    if (starts_operand(now())) throw advice_.juxtaposition(product_, first, at_);
    return operand;
  }

  Tree power() {
    const std::size_t position = now().position;
    Tree base = primary();
    if (now().kind == Token::Kind::superscript) {
      base = make(Node::Kind::power, "", {base, superscript()}, position);
      if (now().is("^") || now().kind == Token::Kind::superscript) {
        refuse("syntax", "a power of a power needs parentheses: (x^2)^3");
      }
    }
    if (!now().is("^")) return base;
    const Deeper deeper(*this);
    take();
    const Token& start = now();
    Tree exponent = this->exponent();
    check_exponent(*exponent, start);
    return make(Node::Kind::power, "", {base, exponent}, position);
  }

  Tree exponent() {
    if (now().is("-") || now().is("+")) {
      const Deeper deeper(*this);
      const Token& sign = take();
      Tree operand = exponent();
      return sign.text == "+" ? operand : make(Node::Kind::negative, "", {operand}, sign.position);
    }
    return power();
  }

  Tree superscript() {
    const Token& token = take();
    const bool minus = token.text[0] == '-';
    Tree digits = make(Node::Kind::number, token.text.substr(minus ? 1 : 0), {}, token.position);
    check_exponent(*digits, token);
    return minus ? make(Node::Kind::negative, "", {digits}, token.position) : digits;
  }

  void check_exponent(const Node& exponent, const Token& where) const {
    if (exponent.kind == Node::Kind::negative) return check_exponent(*exponent.children[0], where);
    if (exponent.kind != Node::Kind::number || exact(exponent.text) <= limits_.exponent) return;
    refuse("too_large", "exponents go up to " + std::to_string(limits_.exponent), where);
  }

  Tree primary() {
    const Token& token = now();
    if (token.kind == Token::Kind::number) return make(Node::Kind::number, take().text, {}, token.position);
    if (token.kind == Token::Kind::name) return name();
    if (take_if("(")) {
      Tree inside = sum();
      close(token);
      return inside;
    }
    if (take_if("sqrt")) {
      const Deeper deeper(*this);
      return make(Node::Kind::call, "sqrt", {primary()}, token.position);
    }
    throw advice_.missing_operand(at_);
  }

  void close(const Token& opened) {
    if (take_if(")")) return;
    if (now().kind == Token::Kind::relation) refuse("relation", "a relation cannot stand inside parentheses");
    if (now().is(",")) throw advice_.stray_comma(at_);
    refuse("syntax", "this parenthesis is never closed", opened);
  }

  Tree name() {
    const Token& token = take();
    if (arity(token.text) > 0 && symbols_.find(token.text) == nullptr) return call(token);
    if (token.text != "pi" && symbols_.find(token.text) == nullptr) throw advice_.unknown_name(at_ - 1);
    if (now().is("(")) throw advice_.called_symbol(at_ - 1);
    return make(Node::Kind::symbol, token.text, {}, token.position);
  }

  Tree call(const Token& function) {
    Tree exponent;
    const bool raised = now().kind == Token::Kind::superscript;
    if (raised && now().text[0] == '-') {
      refuse("syntax", "this may mean 1/" + function.text + "(x) or a" + function.text + "(x): write which");
    }
    if (raised) exponent = superscript();
    if (!now().is("(")) throw advice_.bare_function(raised ? at_ - 2 : at_ - 1);
    const Token& opened = take();
    std::vector<Tree> arguments;
    if (!now().is(")")) arguments.push_back(sum());
    while (take_if(",")) arguments.push_back(sum());
    close(opened);
    check_arguments(function, arguments.size());
    const bool is_power = function.text == "pow";
    Tree value =
        make(is_power ? Node::Kind::power : Node::Kind::call,
             is_power ? "" : canonical_function(function.text), std::move(arguments), function.position);
    return raised ? make(Node::Kind::power, "", {value, exponent}, function.position) : value;
  }

  static void check_arguments(const Token& function, std::size_t given) {
    const auto wanted = static_cast<std::size_t>(arity(function.text));
    if (given == wanted) return;
    const std::string comma = given == 2 ? "; decimal numbers are written with a point" : "";
    refuse("arguments",
           "'" + function.text + "' takes " + std::to_string(wanted) +
               (wanted == 1 ? " argument, not " : " arguments, not ") + std::to_string(given) + comma,
           function);
  }

  const Symbols& symbols_;
  const Limits& limits_;
  std::vector<Token> tokens_;
  Advice advice_;
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
  Relation relation = parse_statement(text, symbols, limits);
  if (relation.operators.empty()) return relation.sides[0];
  std::size_t position = 0;  // of the operator: the first one after the first side's start
  for (const Token& token : tokenize(text, symbols, limits)) {
    if (token.kind == Token::Kind::relation) {
      position = token.position;
      break;
    }
  }
  throw SyntaxError("relation", position,
                    "an expression is wanted here, without '" + relation.operators[0] + "'");
}

}  // namespace rederive
