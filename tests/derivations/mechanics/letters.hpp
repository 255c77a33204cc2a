// The letters of the tests of mechanics, and proofs of what is said about them.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/mechanics/derivation.hpp>
#include <string>
#include <vector>

namespace rederive::test {

/// All letters that a test has declared so far.
inline language::Symbols& letters() {
  static language::Symbols table;
  return table;
}

/// Returns the letter of this name; the first call declares it.
inline language::SymbolExpression letter(const std::string& name, const std::string& range = "(0, inf)") {
  if (letters().find(name) == nullptr) letters().declare({name, name, name, "1", range, "a letter", "(1)"});
  return letters()[name];
}

/// Returns whether the prover shows that two expressions are the same under assumptions in our syntax.
inline bool same(const GiNaC::ex& a, const GiNaC::ex& b, const std::vector<std::string>& assumptions = {}) {
  std::vector<language::Relation> relations;
  for (const std::string& text : assumptions) relations.push_back(language::parse_relation(text, letters()));
  const auto side = [](const GiNaC::ex& e) {
    return language::Relation{{language::to_tree(e, letters())}, {}};
  };
  const decide::Verdict verdict = decide::decide(side(a), side(b), letters(), {}, relations).verdict;
  return verdict == decide::Verdict::proved || verdict == decide::Verdict::proved_under;
}

inline std::string printed(const GiNaC::ex& e) {
  return language::print(e, language::Notation::plain, letters());
}

/// Returns the formulas of conditions or steps: "k - m*omega^2 != 0; m != 0".
inline std::string formulas(const std::vector<mechanics::Step>& steps) {
  std::string text;
  for (const mechanics::Step& step : steps)
    text += (text.empty() ? "" : "; ") + printed(step.left) + " " + step.relation + " " + printed(step.right);
  return text;
}

}  // namespace rederive::test
