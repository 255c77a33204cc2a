// The tactics that turn a statement into an identity of fractions, and the parts of the statement in the
// ring.
#pragma once

#include <derivations/decide/comparison.hpp>
#include <set>

namespace rederive::kernel {

/// A script names phases and roots, writes arguments as sums of phases, and uses squares of cosines and roots
/// as facts. All texts are in Coq's syntax (coq_text.hpp).
class Script {
 public:
  /// Makes the script of a problem in which everything is put in. Throws Undecidable if there is no script:
  /// for roots of higher order, absolute values, logarithms, parts of a right angle.
  explicit Script(const decide::Problem& problem);

  /// Returns the tactics, one per line.
  std::string steps();
  /// Returns whether the ranges and the assumptions imply the signs.
  bool grants(const language::Tree& need, identity::Signs signs);
  /// Returns the tactic that proves an identity of fractions from the facts.
  std::string identity() const;
  /// Returns the tactic that proves that a part of the problem is not 0, positive or not negative. A sum must
  /// be a multiple of an assumption, or of a product of an assumption and a sum of positive terms.
  std::string meets(const language::Tree& need, identity::Signs signs);
  /// Returns left/right for two expressions that are 0 at the same points because this is neither 0 nor
  /// infinite; nothing if one of them is always 0. Throws Undecidable if that is not known.
  std::optional<std::string> factor(const language::Tree& left, const language::Tree& right);

 private:
  identity::Fraction value(const language::Tree& tree);
  std::string text_of(const identity::Fraction& f) const;
  const language::Symbol& declare(const std::string& name);
  std::string name_of(const identity::Fraction& phase);
  std::string base_of(const identity::Generator& root, int index);
  bool has_root_of_product(const language::Tree& tree);
  void say_arguments(const language::Tree& tree);
  void say_argument(const language::Tree& argument, bool is_circular);
  void say_facts();
  void say_fact(std::string text);

  decide::Problem problem_;
  decide::Comparison known_;
  language::Symbols names_;
  std::vector<std::pair<std::string, std::string>> phases_;  ///< name and value
  std::vector<std::string> arguments_, facts_;
  std::string names_of_facts_;
  std::vector<language::Tree> roots_;
  std::multiset<std::string> inverse_;
  std::map<std::string, language::Tree> exponentials_;
  std::vector<GiNaC::ex> meanings_;  ///< of the generators, in the names of the phases and roots
  bool has_arguments_ = false;
};

}  // namespace rederive::kernel
