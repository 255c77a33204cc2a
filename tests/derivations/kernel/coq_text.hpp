// A small reader of Coq's text: sentences, terms, and what stands around a theorem. It knows what our files
// say, no more.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace rederive::coq {

/// A term or a proposition: "sin", "2", "+", "neg", "inv", "apply", "forall", "let", "<->" …
struct Term {
  std::string head;
  std::vector<std::shared_ptr<const Term>> parts;
  std::vector<std::string> binders;  ///< of forall, exists, fun; of let: the name
  std::set<std::string> functions;   ///< those of them that are declared R -> R
};
using Text = std::shared_ptr<const Term>;
inline Text term(std::string head, std::vector<Text> parts = {}, std::vector<std::string> binders = {},
                 std::set<std::string> functions = {}) {
  return std::make_shared<const Term>(
      Term{std::move(head), std::move(parts), std::move(binders), std::move(functions)});
}

struct Token {
  std::string text;
  std::size_t position;
};

inline bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'';
}

inline std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  for (std::size_t at = 0, size = 1; at < text.size(); at += size, size = 1) {
    if (std::isspace(static_cast<unsigned char>(text[at])) != 0) continue;
    if (is_letter(text[at])) {
      while (at + size < text.size() && is_letter(text[at + size])) ++size;
    } else {
      for (const char* symbol : {"<->", "->", "=>", ":=", "<=", ">=", "<>", "/\\", "\\/"})
        if (size == 1 && text.compare(at, std::string(symbol).size(), symbol) == 0)
          size = std::string(symbol).size();
    }
    tokens.push_back({text.substr(at, size), at});
  }
  return tokens;
}

/// Terms, by precedence as in Coq: - a * b is (- a) * b, - a ^ 2 is - (a ^ 2).
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text), tokens_(tokens_of(text)) {}

  Text whole() {
    const Text result = proposition();
    if (at_ != tokens_.size()) fail();
    return result;
  }
  /// What is bound before a colon or :=, "A_1 (x v : R -> R)": names, and which are functions.
  Term binders(const std::set<std::string>& ends) {
    Term result;
    while (at_ < tokens_.size() && !ends.contains(peek())) {
      const bool is_typed = accept("(");
      std::vector<std::string> names;
      while (at_ < tokens_.size() && is_letter(peek()[0])) names.push_back(next());
      const bool is_function = (is_typed || !ends.contains(":")) && accept(":") && type();
      if (is_typed) expect(")");
      for (const std::string& name : names) {
        result.binders.push_back(name);
        if (is_function) result.functions.insert(name);
      }
      if (names.empty()) fail();
    }
    return result;
  }
  std::string next() { return at_ < tokens_.size() ? tokens_[at_++].text : (fail(), ""); }
  std::string peek() const { return at_ < tokens_.size() ? tokens_[at_].text : ""; }
  bool accept(const std::string& token) { return peek() == token && ++at_; }
  void expect(const std::string& token) {
    if (!accept(token)) fail();
  }
  std::size_t position() const { return at_ < tokens_.size() ? tokens_[at_].position : text_.size(); }
  Text proposition() {
    return right_associative("->", [&] { return equivalence(); });
  }
  /// Whether a type is one of functions.
  bool type() {
    bool is_function = false;
    while (peek() == "R" || peek() == "real" || peek() == "->") is_function = next() == "->" || is_function;
    return is_function;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error("the reader does not know this text: " + text_.substr(position(), 60) + " in " +
                             text_);
  }
  template <class F>
  Text right_associative(const std::string& op, const F& operand) {
    const Text left = operand();
    return accept(op) ? term(op, {left, right_associative(op, operand)}) : left;
  }
  Text equivalence() {
    const Text left = disjunction();
    return accept("<->") ? term("<->", {left, disjunction()}) : left;
  }
  Text disjunction() {
    return right_associative("\\/", [&] { return right_associative("/\\", [&] { return relation(); }); });
  }
  Text relation() {  // a < b < c is a < b /\ b < c
    Text left = sum(), result;
    static const std::set<std::string> operators{"=", "<", "<=", ">", ">=", "<>"};
    while (operators.contains(peek())) {
      const std::string op = next();
      const Text right = sum(), link = term(op, {left, right});
      result = result ? term("/\\", {result, link}) : link, left = right;
    }
    return result ? result : left;
  }
  Text sum() {
    Text left = product();
    while (peek() == "+" || peek() == "-") {
      const std::string op = next();
      left = term(op, {left, product()});
    }
    return left;
  }
  Text product() {
    Text left = signed_one();
    while (peek() == "*" || peek() == "/") {
      const std::string op = next();
      left = term(op, {left, signed_one()});
    }
    return left;
  }
  Text signed_one() {
    if (accept("-")) return term("neg", {signed_one()});
    if (accept("/")) return term("inv", {signed_one()});
    return right_associative("^", [&] { return application(); });
  }
  Text application() {
    std::vector<Text> parts{atom()};
    while (at_ < tokens_.size() && (peek() == "(" || (is_letter(peek()[0]) && !is_word(peek()))))
      parts.push_back(atom());
    return parts.size() == 1 ? parts[0] : term("apply", parts);
  }
  static bool is_word(const std::string& text) {
    return text == "forall" || text == "exists" || text == "fun" || text == "let" || text == "in";
  }
  Text atom() {
    if (accept("(")) {
      const Text inside = proposition();
      return expect(")"), inside;
    }
    if (!is_letter(peek()[0])) fail();
    const std::string head = next();
    if (head == "let") {
      const std::string name = next();
      const Term arguments = binders({":="});
      expect(":=");
      const Text body = proposition();
      expect("in");
      return term("let",
                  {arguments.binders.empty() ? body : term("fun", {body}, arguments.binders), proposition()},
                  {name});
    }
    if (!is_word(head)) return term(head);
    const std::string end = head == "fun" ? "=>" : ",";
    const Term bound = binders({end});
    expect(end);
    return term(head, {proposition()}, bound.binders, bound.functions);
  }

  std::string text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

inline Text parse(const std::string& text) { return Parser(text).whole(); }

}  // namespace rederive::coq
