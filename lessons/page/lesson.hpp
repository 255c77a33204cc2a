// What a lesson is made of.
//
// A lesson is a list of steps. Each step is a function that writes passages on a Page: sentences, formulas
// computed at that moment, verdicts of the ledger, tables, figures, things to try. The renderers turn them
// into text for a terminal, LaTeX, Markdown, a notebook or HTML; a lesson knows nothing about formats.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <functional>
#include <lessons/page/passages.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rederive::page {

/// Values for symbols, in our syntax: {{"theta", "0"}, {"u_gddot", "g*tan(alpha)"}}.
using Values = std::map<std::string, std::string>;
/// The passages that a step writes about a paper. The functions throw std::out_of_range for an id that the
/// ledger does not have and for an undeclared symbol, and SyntaxError for a value that cannot be read.
class Page {
 public:
  explicit Page(const paper::Paper& paper) : paper_(paper) {}
  const paper::Paper& paper() const { return paper_; }

  /// Returns the derivation of an equation of the paper, and the result of a derivation.
  mechanics::Derivation derived(const std::string& id) const;
  language::Relation derived_relation(const mechanics::Derivation& derivation) const {
    return rederive::paper::derived_relation(derivation, paper_.symbols);
  }
  language::Relation derived_relation(const std::string& id) const { return derived_relation(derived(id)); }
  /// Returns what the paper prints.
  language::Relation printed(const std::string& id) const;
  GiNaC::ex with(const GiNaC::ex& expression, const Values& values) const;
  /// Returns a special case of what is derived, or of what is printed (of the last two sides of a chain).
  language::Relation derived_with(const std::string& id, const Values& values) const;
  language::Relation printed_with(const std::string& id, const Values& values) const;
  /// Returns the value of an expression. Throws std::invalid_argument if a symbol has no value.
  double number_of(const GiNaC::ex& expression, const Values& values = {}) const;

  /// Adds sentences. A blank line begins a new paragraph.
  void say(const std::string& text);
  /// Adds a relation or an expression of a derivation, never one that is typed into a lesson.
  void show(const language::Relation& relation, const std::string& number = "", const std::string& mark = "");
  void show(const GiNaC::ex& expression);
  void show(const GiNaC::ex& left, const std::string& relation, const GiNaC::ex& right,
            const std::string& number = "");
  /// Adds the derived form of an equation of the paper, with its number.
  void result(const std::string& id);
  /// Adds every step of a derivation, as it is computed, and the result, as one text with formulas. Steps
  /// that are on this page already, on the way to the same formula, are left out, and so are those that lead
  /// to `known`, a result on the way. Throws std::invalid_argument if `known` is not on the way.
  void argue(const std::string& id, const std::string& known = "");
  void argue(const mechanics::Derivation& derivation, const std::string& number = "",
             const std::string& known = "");
  /// Adds what the paper prints and what the ledger found.
  void verdict(const std::string& id);
  /// Adds a row as a lemma of Coq, or a theorem of the project by its name. Throws std::invalid_argument if
  /// there is no script for it.
  void lemma(const std::string& id);
  /// Adds what the decision procedure finds when it compares two statements.
  void compare(const language::Relation& left, const language::Relation& right);
  void table(std::vector<std::string> header, std::vector<std::vector<std::string>> rows) {
    blocks_.push_back(Table{std::move(header), std::move(rows)});
  }
  void figure(Figure figure) { blocks_.push_back(std::move(figure)); }
  void commands(std::vector<std::string> lines) { blocks_.push_back(Commands{std::move(lines)}); }
  /// Adds a case to play with. The options are those of `rocking response`; only the workbench reads them.
  void workbench(const std::string& options);
  void points(std::vector<std::string> items) { blocks_.push_back(BulletList{std::move(items)}); }

  void add(Passage passage) { blocks_.push_back(std::move(passage)); }

  const std::vector<Passage>& blocks() const { return blocks_; }

 private:
  const paper::Paper& paper_;
  std::vector<Passage> blocks_;
  std::set<std::string> told_;  ///< the steps of derivations on this page
};

struct LessonStep {
  std::string heading;
  std::function<void(Page&)> write;
};

/// The ids of the rows that each lesson covers, by its number.
using Coverage = std::map<int, std::vector<std::string>>;

/// The lessons to which a lesson belongs.
struct LessonSeries {
  std::vector<std::string> pages;  ///< the names of their web pages without ".html", in order
  Coverage coverage;
};

struct Lesson {
  int number;
  std::string title, teaches, builds_on;
  std::vector<LessonStep> steps;
};

/// Reads equations_of_lessons.toml. Throws BadInput, with the line, for a row that the paper does not have.
Coverage read_coverage(const paper::Paper& paper);
/// Returns the number of the first lesson that covers a row, or 0.
int lesson_with(const std::string& id, const Coverage& coverage);

}  // namespace rederive::page
