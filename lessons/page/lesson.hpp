// What a lesson is made of.
//
// A lesson is a list of steps. Each step is a function that writes passages on a Page: sentences, formulas
// computed at that moment, verdicts of the ledger, tables, figures, things to try. The renderers turn them
// into text for a terminal, LaTeX, Markdown, a notebook or HTML; a lesson knows nothing about formats.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <lessons/page/passages.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rederive {

/// What a step writes on, about a paper. An id that the ledger does not have throws std::out_of_range that
/// names it. Values in our syntax may be put in for symbols: {{"theta", "0"}, {"u_gddot", "g*tan(alpha)"}};
/// one that cannot be read throws SyntaxError, and an undeclared name throws std::out_of_range.
using Values = std::map<std::string, std::string>;
class Page {
 public:
  explicit Page(const Paper& paper) : paper_(paper) {}
  const Paper& paper() const { return paper_; }

  /// The derivation of an equation of the paper, and what a derivation says.
  Derivation derived(const std::string& id) const;
  Relation derived_relation(const Derivation& derivation) const {
    return rederive::derived_relation(derivation, paper_.symbols);
  }
  Relation derived_relation(const std::string& id) const { return derived_relation(derived(id)); }
  /// What the paper prints.
  Relation printed(const std::string& id) const;
  GiNaC::ex with(const GiNaC::ex& expression, const Values& values) const;
  /// A special case of what was derived, or of what is printed (the last two sides of its chain).
  Relation derived_with(const std::string& id, const Values& values) const;
  Relation printed_with(const std::string& id, const Values& values) const;
  /// The number that an expression comes to. Throws std::invalid_argument if a symbol is left.
  double number_of(const GiNaC::ex& expression, const Values& values = {}) const;

  /// Sentences; a blank line begins a new paragraph.
  void say(const std::string& text);
  /// A relation or an expression that a derivation holds, never one typed into a lesson.
  void show(const Relation& relation, const std::string& number = "", const std::string& mark = "");
  void show(const GiNaC::ex& expression);
  void show(const GiNaC::ex& left, const std::string& relation, const GiNaC::ex& right,
            const std::string& number = "");
  /// The derived form of an equation of the paper, under its number.
  void result(const std::string& id);
  /// Every step of a derivation, as it is computed, and the result at the end: one text, of which the
  /// formulas are parts. A step that stands on this page already is left out. `known` is a result on the way
  /// that was shown before: what leads to it is left out. Throws std::invalid_argument if it is not on the
  /// way.
  void argue(const std::string& id, const std::string& known = "");
  void argue(const Derivation& derivation, const std::string& number = "", const std::string& known = "");
  /// What the paper prints and what the ledger found.
  void verdict(const std::string& id);
  /// The row as a lemma of Coq; or a theorem that ships, by its name. Throws std::invalid_argument if there
  /// is no script for it.
  void lemma(const std::string& id);
  /// Lets the decision procedure compare two statements, and says what it found.
  void compare(const Relation& left, const Relation& right);
  void table(std::vector<std::string> header, std::vector<std::vector<std::string>> rows) {
    blocks_.push_back(Table{std::move(header), std::move(rows)});
  }
  void figure(Figure figure) { blocks_.push_back(std::move(figure)); }
  void commands(std::vector<std::string> lines) { blocks_.push_back(Commands{std::move(lines)}); }
  /// A case to play with, by the options of `rocking response`, as typed: they are read by the workbench
  /// alone.
  void workbench(const std::string& options);
  void points(std::vector<std::string> items) { blocks_.push_back(BulletList{std::move(items)}); }

  const std::vector<Passage>& blocks() const { return blocks_; }

 private:
  const Paper& paper_;
  std::vector<Passage> blocks_;
  std::set<std::string> told_;  ///< the steps of derivations on this page
};

struct LessonStep {
  std::string heading;
  void (*write)(Page&);
};

struct Lesson {
  int number;
  std::string title, teaches, builds_on;
  std::vector<LessonStep> steps;
};

/// Which rows the lessons cover: number of a lesson → ids.
using Coverage = std::map<int, std::vector<std::string>>;
/// Reads equations_of_lessons.toml. Throws BadInput for a row that the paper does not have.
Coverage read_coverage(const Paper& paper);
/// The first lesson that covers a row, 0 if none does.
int lesson_with(const std::string& id, const Coverage& coverage);

}  // namespace rederive
