// What stands around a theorem of our Coq files: variables, hypotheses and definitions, sections opened and
// closed.
#pragma once

#include <algorithm>
#include <derivations/kernel/scripts.hpp>
#include <tests/block.hpp>
#include <tests/derivations/kernel/coq_text.hpp>

namespace rederive::coq {
using namespace language;
using namespace kernel;

struct Item {
  enum class Kind { number, function, hypothesis, definition };
  Kind kind;
  std::string name;
  Text text;              ///< of a hypothesis, or of a definition: with its arguments as a fun
  bool is_local = false;  ///< Let: goes with its section
};

struct Theorem {
  std::string file, name;
  std::vector<Item> around;  ///< with those that its own text binds
  Text statement;
  std::size_t start, proof, end;         ///< in the file: "Theorem", behind "Proof.", "Qed."
  std::size_t words;                     ///< where its statement starts, behind the colon
  std::set<std::string> functions = {};  ///< names that it has for functions
};

inline void names_in(const Text& text, std::set<std::string>& names) {
  names.insert(text->head);
  for (const Text& part : text->parts) names_in(part, names);
}

/// What is applied in a text, or given to a definition that wants a function there.
inline void functions_in(const Text& text, const std::vector<Item>& items, std::set<std::string>& names) {
  names.insert(text->functions.begin(), text->functions.end());
  for (const Text& part : text->parts) functions_in(part, items, names);
  if (text->head != "apply") return;
  names.insert(text->parts[0]->head);
  const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) {
    return item.kind == Item::Kind::definition && item.name == text->parts[0]->head;
  });
  std::size_t k = 1;
  for (Text body = found == items.end() ? nullptr : found->text;
       body && (body->head == "fun" || body->head == "let"); body = body->parts.back())
    for (const std::string& bound : body->binders)
      if (body->head == "fun" && k < text->parts.size() && text->parts[k++]->parts.empty() &&
          body->functions.contains(bound))
        names.insert(text->parts[k - 1]->head);
}

/// Comments as blanks, so that places stay.
inline std::string without_comments(std::string text) {
  for (std::size_t at; (at = text.find("(*")) != std::string::npos;) {
    const std::size_t end = text.find("*)", at) + 2;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(end),
              ' ');
  }
  return text;
}

/// From one that starts there to its full stop, which is followed by a space.
inline std::size_t end_of_sentence(const std::string& text, std::size_t at) {
  while (at < text.size() && !(text[at] == '.' && (at + 1 == text.size() || std::isspace(text[at + 1]) != 0)))
    ++at;
  return at;
}

/// A file of ours, with the definitions of those that it imports.
class File {
 public:
  explicit File(const std::string& name) : name_(name) {
    const std::string text = without_comments(test::theorem_file(name));
    for (std::size_t at = 0; (at = text.find_first_not_of(" \n", at)) != std::string::npos;) {
      const std::size_t end = end_of_sentence(text, at);
      read(text, at, end);
      at = end + 1;
    }
  }
  std::vector<Theorem> theorems;

 private:
  void read(const std::string& text, std::size_t start, std::size_t end) {
    const std::string sentence = text.substr(start, end - start);
    const auto tokens = tokens_of(sentence);
    const std::string head = tokens.empty() ? "" : tokens[0].text;
    if (is_in_proof_) {
      if (head == "Qed") is_in_proof_ = false, close_theorem(start);
    } else if (head == "Proof") {
      is_in_proof_ = true;
      if (is_theorem_) theorems.back().proof = end + 1;
    } else if (head == "From" && tokens[1].text == "Rederive") {
      for (const Token& token : tokens) {
        if (std::ranges::count(test::theorems().files, token.text + ".v") == 0) continue;
        const File imported(token.text + ".v");
        items_.insert(items_.end(), imported.items_.begin(), imported.items_.end());
      }
    } else if (head == "Section") {
      sections_.push_back(items_.size());
    } else if (head == "End") {
      close_section();
    } else if (head == "Variable" || head == "Variables" || head.starts_with("Hypothes")) {
      declare(sentence.substr(tokens[1].position), head[0] == 'H');
    } else if (head == "Let" || head == "Definition" || head == "Lemma" || head == "Theorem") {
      Parser parser(sentence.substr(tokens[1].position));
      const std::string name = parser.next();
      const bool is_definition = head == "Let" || head == "Definition";
      const Term arguments = parser.binders({":=", ":"});
      parser.expect(is_definition ? ":=" : ":");
      if (is_definition) {
        const Text body = parser.whole();
        items_.push_back(
            {Item::Kind::definition, name,
             arguments.binders.empty() ? body : term("fun", {body}, arguments.binders, arguments.functions),
             head == "Let"});
      } else if ((is_theorem_ = head == "Theorem")) {
        const std::size_t words = start + tokens[1].position + parser.position();
        Theorem& theorem =
            theorems.emplace_back(Theorem{name_, name, items_, parser.whole(), start, 0, 0, words});
        theorem.functions = arguments.functions;
        functions_in(theorem.statement, items_, theorem.functions);
        for (const std::string& bound : arguments.binders)
          theorem.around.push_back(
              {theorem.functions.contains(bound) ? Item::Kind::function : Item::Kind::number, bound,
               nullptr});
      }
    }
  }
  void close_theorem(std::size_t at) {
    if (is_theorem_) theorems.back().end = at;
    is_theorem_ = false;
  }
  /// "a b : R", "f : R -> R", "a : statement", "(a : statement) (b : statement)"
  void declare(const std::string& text, bool is_hypothesis) {
    if (text[0] == '(') {
      for (std::size_t at = 0, end; at < text.size(); at = text.find('(', end)) {
        int depth = 0;
        for (end = at; end == at || depth > 0; ++end)
          depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        declare(text.substr(at + 1, end - at - 2), is_hypothesis);
      }
      return;
    }
    const std::size_t colon = text.find(':');
    const bool is_function = !is_hypothesis && text.find("->") != std::string::npos;
    const Text statement = is_hypothesis ? parse(text.substr(colon + 1)) : nullptr;
    for (const Token& name : tokens_of(text.substr(0, colon)))
      items_.push_back({is_hypothesis ? Item::Kind::hypothesis
                        : is_function ? Item::Kind::function
                                      : Item::Kind::number,
                        name.text, statement});
  }
  /// Outside its section a definition takes the variables that it uses, and has its Lets with it.
  void close_section() {
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(sections_.back());
    const std::vector<Item> inside(first, items_.end());
    items_.erase(first, items_.end()), sections_.pop_back();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      if (inside[k].kind != Item::Kind::definition || inside[k].is_local) continue;
      std::set<std::string> used, seen;
      names_in(inside[k].text, used);
      Text body = inside[k].text;
      std::vector<std::string> variables;
      std::set<std::string> functions;
      for (std::size_t j = inside.size();
           j-- > 0;) {  // backwards, so that what a definition uses comes in time
        const Item& item = inside[j];
        if (!used.contains(item.name) || j == k || (item.kind == Item::Kind::definition && j > k)) continue;
        if (item.kind == Item::Kind::definition) {
          names_in(item.text, used), body = term("let", {item.text, body}, {item.name});
        } else if (item.kind != Item::Kind::hypothesis) {
          variables.insert(variables.begin(), item.name);
          if (item.kind == Item::Kind::function) functions.insert(item.name);
        }
      }
      items_.push_back({Item::Kind::definition, inside[k].name,
                        variables.empty() ? body : term("fun", {body}, variables, functions)});
    }
  }

  std::string name_;
  std::vector<Item> items_;
  std::vector<std::size_t> sections_;
  bool is_in_proof_ = false, is_theorem_ = false;
};

/// All theorems that are written by hand.
inline const std::vector<Theorem>& theorems() {
  static const std::vector<Theorem> all = [] {
    std::vector<Theorem> result;
    for (const std::string& name : test::theorems().files)
      for (Theorem& theorem : File(name).theorems) result.push_back(std::move(theorem));
    return result;
  }();
  return all;
}

}  // namespace rederive::coq
