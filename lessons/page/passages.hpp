// What a page consists of, whatever it is about and in whatever format it is written: passages, one after the
// other.
//
// A sentence is a text with marks: `$...$` encloses mathematics in our own syntax, `*...*` what is
// emphasised, backquotes what is typed, and `[words](target)` is a link. A backslash before a mark makes it
// an ordinary character.
#pragma once

#include <derivations/language/tree.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rederive::page {

struct Heading {
  std::string text;         ///< a sentence
  int number = 0;           ///< 0: without a number
  std::string anchor = {};  ///< the target of links to it in a web page
};
struct Paragraph {
  std::string text;  ///< a sentence
};
/// A displayed relation or expression.
struct Formula {
  language::Relation relation;
  std::string number = {};  ///< of the paper's equation; empty if it has none
  std::string mark = {};    ///< "," or "." if the formula is part of a sentence
};
/// One line of findings: a label, and a formula, a sentence, or a text that keeps its line breaks and blanks.
struct Remark {
  std::string label;
  std::optional<language::Relation> formula = {};
  std::string words = {};
  std::string verbatim = {};
};
/// A verdict with its reasons: of the ledger on a row, of the judge on an answer, of a check on a claim.
struct Findings {
  std::string headline;  ///< plain text
  std::vector<Remark> lines;
  std::string kind = {};  ///< the classes of the element in a web page: "ledger refuted", "said wrong"
  std::string row = {};   ///< the row that they are about, to which links lead
};
/// A table of sentences.
struct Table {
  std::vector<std::string> header;  ///< may be empty
  std::vector<std::vector<std::string>> rows;
  std::string summary = {};  ///< not empty: a web page shows this, and the table on demand
};
/// A picture: gnuplot commands without terminal and output. The name becomes the name of the file.
struct Figure {
  std::string name, caption, script;
};
/// Commands to type, one a line; or, in a web page, the workbench at the case that they ask for.
struct Commands {
  std::vector<std::string> lines;
  std::string workbench = {};  ///< options of `rocking response`
};
/// A list of sentences.
struct BulletList {
  std::vector<std::string> items;
};
/// A row as a lemma of Coq, with its proof: shown on demand where a format can do that.
struct Theorem {
  std::string id, text;
  std::string where;  ///< a sentence: the command that prints it, or its name and file
};
/// Buttons of a form, each with its value and its words, behind a sentence.
struct Buttons {
  std::string words;
  std::vector<std::pair<std::string, std::string>> buttons;
};

struct Passage;
/// An exercise, in a web page with a form for the answer.
struct ExerciseForm {
  std::string id, title, standing;
  std::vector<Passage> statement;
  /// The values and sentences to choose from. If there are none, the answer is typed.
  std::vector<std::pair<std::string, std::string>> choices = {};
  std::string prompt = {};  ///< a sentence: what is to be typed
  bool is_open = false;
  bool has_working = false;  ///< whether a working, line by line, may be handed in, too
  /// The names and the LaTeX of the symbols of an answer that is a formula.
  std::vector<std::pair<std::string, std::string>> symbols = {};
};

struct Passage : std::variant<Heading, Paragraph, Formula, Findings, Table, Figure, Commands, BulletList,
                              Theorem, Buttons, ExerciseForm> {
  using variant::variant;
};

/// The title of a page, and what it says about itself: labels with sentences.
struct Front {
  std::string title;  ///< plain text
  std::vector<std::pair<std::string, std::string>> about = {};
  std::string kind = {};  ///< the class of a web page
};

}  // namespace rederive::page
