// Theorems spoiled on purpose, proofs as one tactic, and whether what is left is false.
#pragma once

#include <tests/block.hpp>
#include <tests/derivations/kernel/coq_points.hpp>

namespace rederive::coq {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace kernel;

/// A proof script as one tactic: t. { a. } b. is t; [ a | b ], and bullets are the goals of what stands
/// before them.
class Script {
 public:
  explicit Script(std::string text) : text_(std::move(text)) {}
  std::string tactic() { return block(""); }

 private:
  char peek() {
    at_ = std::min(text_.find_first_not_of(" \n", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '}';
  }
  std::string bullet() {
    const char c = peek();
    if (c != '-' && c != '+' && c != '*') return "";
    return text_.substr(at_, text_.find_first_not_of(c, at_) - at_);
  }
  /// Up to a bullet of those around it, or a brace.
  std::string block(const std::string& around) {
    std::string first, goals;
    while (peek() != '}') {
      if (const std::string mark = bullet(); !mark.empty()) {
        if (around.find(" " + mark + " ") != std::string::npos) break;
        std::string all;
        while (bullet() == mark)
          at_ += mark.size(), all += (all.empty() ? "" : " | ") + block(around + " " + mark + " ");
        return joined(first, goals + (goals.empty() ? "" : " | ") + all);
      }
      if (peek() == '{') {
        ++at_;
        goals += (goals.empty() ? "" : " | ") + block("");
        peek(), ++at_;
        continue;
      }
      if (!goals.empty()) return joined(first, goals + " | " + block(around));
      const std::size_t end = end_of_sentence(text_, at_);
      const std::string next = "(" + text_.substr(at_, end - at_) + ")";
      first += (first.empty() ? "" : "; ") + next;
      at_ = end + 1;
    }
    return joined(first, goals);
  }
  static std::string joined(const std::string& first, const std::string& goals) {
    const std::string start = first.empty() ? "idtac" : first;
    return goals.empty() ? start : start + "; [ " + goals + " ]";
  }

  std::string text_;
  std::size_t at_ = 0;
};

/// "Theorem name (a : R) (b : R) :", where a name that the statement has lost would have no type.
inline std::string head_of(const Theorem& theorem, const std::string& text) {
  std::string result;
  const auto tokens = tokens_of(text);
  int depth = 0;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    depth += tokens[k].text == "(" ? 1 : tokens[k].text == ")" ? -1 : 0;
    const bool is_number =
        k > 1 && depth == 0 && is_letter(tokens[k].text[0]) && !theorem.functions.contains(tokens[k].text);
    result += (is_number ? "(" + tokens[k].text + " : R)" : tokens[k].text) + " ";
  }
  return result;
}

/// The same theorem with another statement.
inline Theorem with_statement(Theorem theorem, const std::string& text, const std::vector<Item>& items) {
  theorem.statement = parse(text);
  functions_in(theorem.statement, items, theorem.functions);
  return theorem;
}

inline void equations_in(const Text& text, std::vector<Text>& equations) {
  if (text->head == "=") equations.push_back(text);
  if (text->head == "<->" || text->head == "/\\")
    for (const Text& part : text->parts) equations_in(part, equations);
}

/// A point at which all hypotheses hold, and what it says does not; nothing where none is found.
inline std::optional<std::string> counterexample(const Theorem& theorem) {
  const Parts parts = parts_of(theorem);
  std::vector<Text> sides;
  equations_in(parts.conclusion, sides);
  sides.push_back(nullptr);
  int unknown = 0;
  for (unsigned long seed = 1; seed < 16 && unknown < 6; ++seed)
    for (const Text& side : sides) {
      Solver solver(theorem, parts, seed);
      if (side) solver.satisfy(side), solver.settle();
      const auto holds = solver.world.holds(parts.conclusion);
      if (holds == false && solver.meets_all()) return solver.point();
      unknown += holds ? 0 : 1;
    }
  return std::nullopt;
}

/// Statements with a slip: a sign, a factor or a bound, a function; or with 1 = 1 in the place of a
/// hypothesis.
inline std::vector<std::string> slips_in(const std::string& statement, const std::string& kind) {
  std::vector<std::string> result;
  const auto tokens = tokens_of(statement);
  const auto put = [&](const Token& token, const std::string& text) {
    result.push_back(std::string(statement).replace(token.position, token.text.size(), text));
  };
  static const std::map<std::string, std::string> functions{
      {"sin", "cos"}, {"cos", "sin"}, {"sinh", "cosh"}, {"cosh", "sinh"}, {"tan", "sin"}, {"cot", "tan"}};
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const Token& token = tokens[k];
    depth += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
    const bool is_binary = k > 0 && (is_letter(tokens[k - 1].text[0]) || tokens[k - 1].text == ")");
    if (kind == "sign" && is_binary && token.text == "+") put(token, "-");
    if (kind == "sign" && is_binary && token.text == "-") put(token, "+");
    if (kind == "factor" && token.text.find_first_not_of("0123456789") == std::string::npos &&
        token.text.size() < 3)
      put(token, std::to_string(std::stoi(token.text) + 1));
    if (kind == "factor" && (token.text == "alpha" || token.text == "R'" || token.text == "p") &&
        tokens[k - (k > 0)].text != "forall")
      put(token, "(2 * " + token.text + ")");
    if (const auto found = functions.find(token.text); kind == "function" && found != functions.end())
      put(token, found->second);
    if (depth == 0 && token.text == "->") {
      if (kind == "hypothesis")
        result.push_back(std::string(statement).replace(start, token.position - start, " 1 = 1 "));
      start = token.position + 2;
    }
    if (depth == 0 && token.text == "in") start = token.position + 2;
  }
  std::reverse(result.begin(), result.end());  // the conclusion first
  return result;
}

}  // namespace rederive::coq
