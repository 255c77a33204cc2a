// The steps that turn a statement into an identity of fractions, and what its parts are in the ring.
#pragma once

#include <derivations/decide/comparison.hpp>
#include <set>

namespace rederive {

/// Phases and roots get names; arguments are written as sums of phases; squares of cosines and roots are
/// facts. All texts are Coq's (coq_text.hpp).
class Script {
 public:
  /// Of a problem with everything put in. Throws Undecidable where there is no script: roots of higher order,
  /// bars, logarithms, parts of a right angle.
  explicit Script(const Problem& problem);

  /// Tactics, one a line.
  std::string steps();
  /// Whether the ranges and the assumptions say it.
  bool grants(const Tree& need, Signs signs);
  /// The tactic that proves an identity of fractions with the facts.
  std::string identity() const;
  /// The tactic that proves that a part of the problem is not 0, positive, not negative. A sum is a multiple
  /// of what is assumed, or of a product of that and a sum of positive terms.
  std::string meets(const Tree& need, Signs signs);
  /// left/right, of expressions that are 0 at the same points because this is neither 0 nor infinite; nothing
  /// where one of them is always 0. Throws Undecidable where that is not known.
  std::optional<std::string> factor(const Tree& left, const Tree& right);

 private:
  Fraction value(const Tree& tree);
  std::string text_of(const Fraction& f) const;
  const Symbol& declare(const std::string& name);
  std::string name_of(const Fraction& phase);
  std::string base_of(const Generator& root, int index);
  void say_arguments(const Tree& tree);
  void say_argument(const Tree& argument, bool is_circular);
  void say_facts();
  void say_fact(std::string text);

  Problem problem_;
  Comparison known_;
  Symbols names_;
  std::vector<std::pair<std::string, std::string>> phases_;  ///< name, and what it stands for
  std::vector<std::string> arguments_, facts_;
  std::string names_of_facts_;
  std::vector<Tree> roots_;
  std::multiset<std::string> inverse_;
  std::map<std::string, Tree> exponentials_;
  std::vector<GiNaC::ex> meanings_;  ///< of the generators, in the names of the phases and roots
  bool has_arguments_ = false;
};

}  // namespace rederive
