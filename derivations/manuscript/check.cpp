#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <derivations/decide/decide.hpp>
#include <derivations/decide/problem.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/manuscript/algebra.hpp>
#include <derivations/manuscript/check.hpp>
#include <derivations/manuscript/compare.hpp>
#include <derivations/manuscript/facts.hpp>
#include <derivations/manuscript/formula.hpp>
#include <derivations/manuscript/operators.hpp>
#include <derivations/manuscript/statements.hpp>
#include <derivations/program/program.hpp>
#include <regex>

namespace rederive::manuscript {
using namespace language;

namespace {

constexpr unsigned most_readings = 8;

/// The values of two sides in one reading.
struct Reading {
  Value left, right;
  Choices choices;
};

std::string trimmed_source(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool is_blank = c == '\n' || c == '\t' || c == ' ';
    if (!is_blank || (!result.empty() && result.back() != ' ')) result += is_blank ? ' ' : c;
  }
  return program::trimmed(result);
}

bool is_in(const std::string& prose, const std::regex& pattern) {
  const auto matches = [&](const std::string& sentence) { return std::regex_search(sentence, pattern); };
  return std::ranges::any_of(sentences_of(prose), matches);
}
bool has_word(const std::string& prose, const char* words) {
  return is_in(prose, std::regex(std::string("\\b(") + words + ")\\b", std::regex::icase));
}

constexpr const char* headings =
    R"(\\(?:chapter|section|subsection|subsubsection|paragraph|item|exercise|problem|question)\b|(?:^|\n)#+ )";

class Checker {
 public:
  Checker(const Manuscript& manuscript, const StatedSymbols& symbols, bool with_inline)
      : manuscript_(manuscript), given_(symbols), with_inline_(with_inline) {
    for (const Item& item : manuscript.items()) survey(item);
  }

  Report run() {
    for (is_judging_ = false;; is_judging_ = true) {
      walk();
      if (is_judging_) break;
    }
    Report report;
    report.file = manuscript_.files().empty() ? "" : manuscript_.files()[0].string();
    report.displays = std::move(displays_);
    report.symbols = stated_;
    return report;
  }

 private:
  // --- What the whole text says about names
  // ------------------------------------------------------------------

  /// Finds functions, and whether i is the imaginary unit.
  void survey(const Item& item) {
    if (item.kind == Item::Kind::prose) {
      if (has_word(item.text, "complex|imaginary")) is_complex_text_ = true;
      survey_smallness(item.text);
      return;
    }
    if (item.kind == Item::Kind::directive) return;
    const TexTokens& tokens = item.tokens;
    const auto is = [&](std::size_t at, std::string_view text) {
      return at < tokens.size() && tokens[at].is(text);
    };
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (is(at, "i") && is(at + 1, "^") && is(at + 2, "2")) has_i_ = true;
      if (is(at, "^") && is(at + 1, "{") && (is(at + 2, "i") || (is(at + 2, "-") && is(at + 3, "i"))) &&
          at > 0 && is(at - 1, "e"))
        has_i_ = true;
      if (is(at, "_") && is(at + 1, "{") && is(at + 2, "i") && is(at + 3, "=")) is_index_ = true;
      const bool is_d = is(at, "d") || is(at, "\\mathrm{d}") || is(at, "\\partial");
      if (is_d && at > 1 && is(at - 1, "{") && tokens[at - 2].text.ends_with("frac")) {
        const std::size_t first = is(at + 1, "^") ? behind_argument(tokens, at + 2) : at + 1;
        const Name name = name_at(tokens, first);
        if (name.size > 0 && is(first + name.size, "}")) functions_.insert(name.name);
      }
      const Name varied = is(at, "\\delta") ? name_at(tokens, at + 1) : Name{};
      if (varied.size > 0 && varied.name != "t") base_.delta_is_an_operator = true;
      survey_name(tokens, at);
    }
    std::vector<std::string> labels;
    for (const Statement& statement : statements_of(tokens, item.environment, labels)) {
      const bool is_named = statement.sides.size() > 1 && statement.sides[0].size() == 1 &&
                            (statement.relations[0].is("=") || statement.relations[0].is(":="));
      if (!is_named) continue;
      if (statement.sides[0][0].is("\\pi")) base_.pi_is_a_name = true;
      if (statement.sides[0][0].is("e") && !names_euler(statement.sides[1])) base_.e_is_a_name = true;
    }
  }
  /// Notes the sections that approximate, and the names that they call small.
  void survey_smallness(const std::string& text) {
    static const std::regex heading(headings),
        word(R"(\b(small|approximat\w*|linearis\w*|lineariz\w*|neglect\w*|leading order|first order)\b)"),
        named(R"(small\s+(?:\w+\s+){0,2}\$([^$]+)\$|\$([^$]+)\$\s+(?:is|are|be)\s+(?:very\s+|so\s+)?small)");
    if (is_in(text, heading)) ++section_;
    if (is_in(text, word)) approximate_[section_];
    for (const std::string& sentence : sentences_of(text))
      for (std::sregex_iterator found(sentence.begin(), sentence.end(), named), end; found != end; ++found) {
        const std::string formula = (*found)[1].matched ? (*found)[1] : (*found)[2];
        const TexTokens tokens = tokens_of(formula, 0, formula.size());
        if (const Name name = name_at(tokens, 0); name.size == tokens.size())
          approximate_[section_].insert(name.name);
      }
  }

  static bool names_euler(const TexTokens& tokens) {
    return !tokens.empty() && (tokens[0].starts("2.7") || tokens[0].is("\\lim") || tokens[0].is("\\sum"));
  }

  /// Counts f(x), and f( with anything else in the brackets.
  void survey_name(const TexTokens& tokens, std::size_t at) {
    const bool begins = at == 0 || !(tokens[at - 1].is("_") || tokens[at - 1].is("\\begin"));
    const Name name = begins ? name_at(tokens, at) : Name{};
    if (name.size == 0) return;
    if (tokens[at].is("\\dot") || tokens[at].is("\\ddot")) {
      const std::size_t first = at + 1 + (at + 1 < tokens.size() && tokens[at + 1].is("{") ? 1 : 0);
      if (const Name inside = name_at(tokens, first); inside.size > 0) {
        functions_.insert(inside.name);
        base_.variables[inside.name] = "t";
      }
    }
    std::size_t next = at + name.size;
    while (next < tokens.size() && tokens[next].is("'")) ++next;
    const bool has_prime = next > at + name.size;
    if (next >= tokens.size() || !tokens[next].is("(")) return;
    const Name inside = name_at(tokens, next + 1);
    const std::size_t close = next + 1 + inside.size;
    const bool is_call =
        inside.size > 0 && close < tokens.size() && tokens[close].is(")") && inside.name != name.name;
    static const std::set<std::string> usual{"g", "h", "G", "H", "phi", "psi", "Phi", "Psi"},
        of{"x", "t", "s", "u", "y", "z"};
    const bool is_usual = name.name == "f" || name.name == "F" ||
                          (usual.contains(name.name) && is_call && of.contains(inside.name));
    if (has_prime || is_usual) functions_.insert(name.name);
    auto& [calls, others] = uses_[name.name];
    (is_call ? calls : others) += 1;
    const bool is_of_time = is_call && (inside.name == "t" || inside.name == "x");
    if (is_of_time) uses_of_time_.insert(name.name);
  }

  Meanings first_meanings() const {
    Meanings meanings = base_;
    meanings.functions = functions_;
    for (const auto& [name, uses] : uses_)
      if (uses.second == 0 && (uses.first > 1 || uses_of_time_.contains(name)))
        meanings.functions.insert(name);
    meanings.has_imaginary_unit = (is_complex_text_ || has_i_) && !is_index_;
    return meanings;
  }

  // --- The walk through the text
  // -----------------------------------------------------------------------------

  void walk() {
    meanings_ = first_meanings();
    stated_ = given_;
    displays_.clear();
    labelled_.clear();
    before_.clear();
    prose_.clear();
    directive_ = {};
    section_ = display_ = 0;
    const auto& items = manuscript_.items();
    for (std::size_t k = 0; k < items.size(); ++k) {
      const Item& item = items[k];
      if (item.kind == Item::Kind::prose) take_prose(item.text);
      if (item.kind == Item::Kind::directive) take_directive(item);
      if (item.kind == Item::Kind::formula) take_formula(item);
      if (item.kind != Item::Kind::display) continue;
      if (k + 1 < items.size() && items[k + 1].kind == Item::Kind::prose) take_following(items[k + 1].text);
      use_stated();
      ++display_;
      take_display(item);
      directive_ = {};
      prose_.clear();
    }
  }

  void take_prose(const std::string& text) {
    static const std::regex heading(headings);
    if (is_in(text, heading)) {
      before_.clear();
      ++section_;
    }
    take_stated(text, stated_);
    prose_ += text;
  }
  /// "… where x > 0" behind a display holds for it, too.
  void take_following(const std::string& text) {
    static const std::regex following(
        R"(^[\s,.;]*(?:where|for|with|if|when|provided|assuming|valid)\b[^.]*\.?)");
    std::smatch found;
    const std::string beginning = text.substr(0, 2'000);
    if (std::regex_search(beginning, found, following)) take_stated(found[0], stated_);
  }

  void take_directive(const Item& item) {
    try {
      Directive directive = read_directive(item.text, stated_);
      directive_.is_identity = directive_.is_identity || directive.is_identity;
      directive_.from.insert(directive_.from.end(), directive.from.begin(), directive.from.end());
    } catch (const program::BadInput& error) {
      const Place place = manuscript_.place_of(item.place);
      throw program::BadInput(
          fmt::format("{}:{}:{}: {}", place.file, place.line, place.column, error.what()));
    }
    use_stated();
  }

  void use_stated() {
    for (const auto& [name, stated] : stated_) {
      if (stated.is_function) meanings_.functions.insert(name);
      if (stated.is_complex) {
        meanings_.complex.insert(name);
        meanings_.has_imaginary_unit = true;
      }
    }
  }

  /// Takes an equation of the text as a fact; judges it if that is asked for.
  void take_formula(const Item& item) {
    std::vector<std::string> labels;
    const std::vector<Statement> statements = statements_of(item.tokens, "$", labels);
    if (with_inline_ && is_judging_) {
      before_.clear();
      judge_statements(item, statements);
      return;
    }
    for (const Statement& statement : statements)
      if (statement.sides.size() > 1 && !statement.goes_on) assume(statement, 0);
  }

  void take_display(const Item& item) {
    std::vector<std::string> labels;
    const std::vector<Statement> statements = statements_of(item.tokens, item.environment, labels);
    const bool goes_on = has_word(last_sentence(),
                                  "hence|so|thus|therefore|then|gives|yields|becomes|obtain|follows|"
                                  "simplif\\w+|i\\.e|that is|solving|dividing|multiplying|squaring|"
                                  "subtracting|adding");
    if (!goes_on) before_.clear();
    if (!directive_.from.empty()) {
      before_.clear();
      for (const std::string& label : directive_.from) {
        const auto found = labelled_.find(label);
        if (found == labelled_.end() && is_judging_) {
          const Place place = manuscript_.place_of(item.place);
          throw program::BadInput(
              fmt::format("{}:{}: no display before this one has the label '{}', or it is not read",
                          place.file, place.line, label));
        }
        if (found != labelled_.end())
          before_.insert(before_.end(), found->second.begin(), found->second.end());
      }
    }
    const std::vector<Relation> equations = judge_statements(item, statements);
    for (const std::string& label : labels) labelled_[label] = equations;
    before_ = equations;
  }
  std::string last_sentence() const {
    const std::string prose = program::trimmed(prose_);
    const std::size_t point = prose.find_last_of(".:", prose.size() < 2 ? 0 : prose.size() - 2);
    const std::string last = point == prose.npos ? prose : prose.substr(point + 1);
    return last.size() > 160 ? "" : last;
  }

  // --- Statements
  // ---------------------------------------------------------------------------------------------

  /// Judges the statements of a display, and returns its equations.
  std::vector<Relation> judge_statements(const Item& item, const std::vector<Statement>& statements) {
    JudgedDisplay display{manuscript_.place_of(first_place(item)), trimmed_source(item.text)};
    std::vector<Relation> equations;
    TexTokens last_side;
    for (std::size_t k = 0; k < statements.size(); ++k) {
      Statement statement = statements[k];
      if (statement.goes_on && last_side.empty()) continue;
      if (statement.goes_on) statement.sides[0] = last_side;
      const bool next_goes_on = k + 1 < statements.size() && statements[k + 1].goes_on;
      const bool is_equation = statement.sides.size() == 2 && !statement.goes_on && !next_goes_on;
      if (statement.sides.size() == 1) {  // there is nothing to judge
      } else if (is_equation && !directive_.is_identity) {
        if (has_word(statement.words, "and|or|where|with")) before_.clear();
        judge_equation(statement, equations, display);
      } else {
        judge_chain(statement, display);
      }
      last_side = statement.sides.back();
    }
    take_back_settings(display);
    if (is_judging_ && !display.links.empty()) displays_.push_back(std::move(display));
    return equations;
  }
  static void take_back(Link& link, const std::string& reason) {
    link.finding = Finding::undecided;
    link.witness.clear();
    link.repair.clear();
    link.reason = reason;
  }

  /// A chain such as l = g = 1 sets its sides to one, which says nothing about identities; a list of
  /// solutions on several lines loses none.
  static void take_back_settings(JudgedDisplay& display) {
    const auto sets_to_one = [](const Link& link) {
      const bool has_one = link.left == "1" || link.right == "1";
      return has_one && link.left != link.right && link.finding == Finding::undecided;
    };
    for (std::size_t k = 0; k + 1 < display.links.size(); ++k) {  // x = 1, and x = 2 on the next line
      Link& link = display.links[k];
      const bool is_listed = link.is_loss && display.links[k + 1].left == link.left;
      if (is_listed && link.finding == Finding::wrong)
        take_back(link, "the next line may be another solution");
    }
    if (std::ranges::none_of(display.links, sets_to_one)) return;
    for (Link& link : display.links) {
      if (link.finding != Finding::wrong) continue;
      take_back(link, "the chain may set its sides to 1");
    }
  }

  static std::size_t first_place(const Item& item) {
    return item.tokens.empty() ? item.place : item.tokens[0].place;
  }

  Link link_of(const Statement& statement, std::size_t k) const {
    const std::size_t place = statement.relations[k].place;
    return {manuscript_.place_of(place), source_of(statement.sides[k]), statement.relations[k].text,
            source_of(statement.sides[k + 1])};
  }
  std::string source_of(const TexTokens& tokens) const {
    if (tokens.empty()) return "";
    const std::size_t from = tokens.front().place;
    std::size_t to =
        tokens.back().end != 0 ? tokens.back().end : tokens.back().place + tokens.back().text.size();
    const std::string& text = manuscript_.text();
    to = std::min(std::max(to, from), text.size());
    return trimmed_source(text.substr(from, to - from));
  }

  /// Judges each link of a chain; a name at its beginning is given the value behind it.
  void judge_chain(const Statement& statement, JudgedDisplay& display) {
    for (std::size_t k = 0; k + 1 < statement.sides.size(); ++k) {
      Link link = link_of(statement, k);
      const bool is_first = k == 0 && !statement.goes_on && !directive_.is_identity;
      const bool is_definition =
          is_first && is_plain(statement.sides[0]) && is_equal_sign(statement.relations[k]);
      if (is_definition) {
        assume(statement, k);
        link.finding = is_readable(statement, k) ? Finding::assumed : Finding::not_read;
        if (link.finding == Finding::not_read) link.reason = unread_;
      } else if (is_judging_) {
        judge_link(statement, k, link);
      }
      if (is_judging_) display.links.push_back(std::move(link));
    }
  }
  static bool is_equal_sign(const TexToken& relation) {
    return relation.is("=") || relation.is(":=") || relation.is("≈");
  }

  /// Returns whether a side is a name, f(x) or f'(x) whose value the text has not given, or dy/dx.
  bool is_plain(const TexTokens& side) const {
    std::size_t at = name_at(side, 0).size;
    if (at == 0 && side.size() == 1 && side[0].is("\\pi")) at = 1;
    if (at == 0 && !side.empty() && side[0].is("e")) at = 1;
    if (at == 0) return is_rate(side);
    while (at < side.size() && side[at].is("'")) ++at;
    if (at < side.size() && side[at].is("(")) {
      if (!meanings_.functions.contains(name_at(side, 0).name)) return false;
      const std::size_t close = static_cast<std::size_t>(
          std::ranges::find_if(side, [](const TexToken& token) { return token.is(")"); }) - side.begin());
      const bool is_value = close + 1 == side.size();
      const bool is_known = meanings_.defined.contains(name_at(side, 0).name);
      const bool is_by_name = name_at(side, at + 1).size == close - at - 1;
      return is_value && (is_by_name || !is_known);
    }
    return at == side.size();
  }
  static bool is_rate(const TexTokens& side) {
    if (side.size() < 3 || !side[0].text.ends_with("frac")) return false;
    const std::size_t above = 1, below = behind_argument(side, above), end = behind_argument(side, below);
    const bool is_d = side[1].is("{") && side.size() > 2 &&
                      (side[2].is("d") || side[2].is("\\partial") || side[2].is("\\mathrm{d}"));
    return is_d && end == side.size() && below - above > 2;
  }

  /// Returns whether a side is a rate or a value of what the text defines: f'(x), dy/dx, f(2).
  bool is_known_value(const TexTokens& side) const {
    if (is_rate(side)) {
      const std::size_t first = side[3].is("^") ? behind_argument(side, 4) : 3;
      return meanings_.defined.contains(name_at(side, first).name);
    }
    const Name name = name_at(side, 0);
    const auto known = meanings_.defined.find(name.name);
    const bool has_argument = name.size > 0 && name.size < side.size() && known != meanings_.defined.end();
    return has_argument && side[name.size].is("'") && !known->second.variable.empty();
  }

  // --- Reading
  // -------------------------------------------------------------------------------------------------

  std::vector<Reading> readings_of(const TexTokens& left, const TexTokens& right, bool is_lower,
                                   Meanings& meanings) {
    std::vector<Reading> readings;
    std::vector<unsigned> waiting{0};
    std::optional<SyntaxError> error;
    for (std::size_t k = 0; k < waiting.size() && k < most_readings; ++k) {
      Reading reading;
      reading.choices = {.second = waiting[k], .is_lower = is_lower};
      try {
        reading.left = read_value(left, meanings, reading.choices);
        reading.right = read_value(right, meanings, reading.choices);
        for (const Value* value : {&reading.left, &reading.right})
          for (const Number& n : value->entries)
            for (const Tree& part : {n.real, n.imaginary})
              if (part) (void)lower(part, meanings.symbols);
        readings.push_back(reading);
      } catch (const SyntaxError& mistake) {
        if (!error) error = mistake;
        bound_ = reading.choices.bound;
      }
      for (unsigned bit = 1; bit <= reading.choices.asked; bit <<= 1)
        if ((reading.choices.asked & bit) != 0 && std::ranges::count(waiting, waiting[k] | bit) == 0)
          waiting.push_back(waiting[k] | bit);
    }
    if (readings.empty() && error) throw *error;
    return readings;
  }

  bool is_readable(const Statement& statement, std::size_t k) {
    try {
      Meanings meanings = meanings_;
      (void)readings_of(statement.sides[k], statement.sides[k + 1], false, meanings);
      return true;
    } catch (const SyntaxError& error) {
      unread_ = error.what();
      return false;
    }
  }

  /// Takes a link as a fact: a definition of a name, or an equation that binds its names.
  void assume(const Statement& statement, std::size_t k) {
    if (!is_equal_sign(statement.relations[k])) return;
    const Name name = name_at(statement.sides[k], 0);
    try {
      const auto readings = readings_of(statement.sides[k], statement.sides[k + 1], false, meanings_);
      const Value &left = readings[0].left, &right = readings[0].right;
      const bool is_real =
          left.is_number() && right.is_number() && !left.entries[0].imaginary && !right.entries[0].imaginary;
      std::set<std::string> names = names_in(left);
      names.merge(names_in(right));
      const bool gives_number = names.size() == 1 && is_plain(statement.sides[k]) && names_in(right).empty();
      if (!is_judging_ && gives_number) facts_.add_number(*names.begin());
      if (!is_judging_ && !gives_number)
        facts_.add({names, section_, display_, is_plain(statement.sides[k])});
      if (is_real && readings.size() == 1) define(statement.sides[k], right.entries[0].real);
    } catch (const SyntaxError&) {
      // A value that is not read still changes what is known about the name.
      if (name.size > 0) meanings_.defined.erase(name.name);
      Meanings meanings = meanings_;
      std::set<std::string> names;
      for (const TexTokens* side : {&statement.sides[k], &statement.sides[k + 1]})
        for (std::size_t at = 0; at < side->size(); ++at)
          if (const Name one = name_at(*side, at); one.size > 0) names.insert(one.name);
      if (!is_judging_ && !names.empty())
        facts_.add({names, section_, display_, is_plain(statement.sides[k])});
    }
  }

  void define(const TexTokens& side, const Tree& value) {
    const Name name = name_at(side, 0);
    if (name.size == 0 || !is_plain(side)) return;
    const bool is_recursive = decide::names_of(value).contains(name.name);
    if (name.size == side.size() && !is_recursive)
      meanings_.defined[name.name] = {"", value};
    else if (name.size + 1 < side.size() && side[name.size].is("(") && !is_recursive)
      if (const Name variable = name_at(side, name.size + 1); variable.size + name.size + 2 == side.size())
        meanings_.defined[name.name] = {variable.name, value};
  }

  static std::set<std::string> names_in(const Value& value) {
    std::set<std::string> names;
    for (const Number& n : value.entries)
      for (const Tree& part : {n.real, n.imaginary})
        if (part) names.merge(decide::names_of(part));
    return names;
  }

  // --- Judging
  // -------------------------------------------------------------------------------------------------

  void judge_link(const Statement& statement, std::size_t k, Link& link) {
    const std::string& relation = link.relation;
    static const std::set<std::string> read{"=", "<", "<=", ">", ">=", "≈", ":="};
    if (!read.contains(relation)) {
      link.finding = Finding::not_read;
      link.reason = "the relation " + relation + " is not judged";
      return;
    }
    try {
      Compared worst = judged(statement.sides[k], relation == ":=" ? "=" : relation, statement.sides[k + 1]);
      apply(worst, link);
    } catch (const SyntaxError& error) {
      if (!bound_.empty() && judge_up_to(statement, k, link)) return;
      link.finding = Finding::not_read;
      link.reason = error.what();
    } catch (const std::exception& error) {
      link.finding = Finding::undecided;
      link.reason = decide::in_plain_words(error);
    }
  }

  static void apply(const Compared& compared, Link& link) {
    link.conditions = compared.conditions;
    link.witness = compared.witness;
    link.repair = compared.repair;
    link.reason = compared.reason;
    link.is_loss = compared.is_loss;
    link.finding = Finding::undecided;
    if (compared.is == Compared::Is::proved) link.finding = Finding::proved;
    if (compared.is == Compared::Is::refuted) link.finding = Finding::wrong;
    if (link.finding != Finding::undecided) link.reason.clear();
    if (link.finding != Finding::wrong) link.witness.clear();
  }

  /// A remainder at the end of a side, + O(x^3).
  struct Remainder {
    std::string name;
    int order = 0;
  };
  static std::optional<Remainder> take_remainder(TexTokens& side) {
    std::size_t at = side.size();
    for (std::size_t k = 1; k < side.size(); ++k) {
      const bool is_letter = side[k].is("O") || (side[k].is("\\mathcal") && k + 1 < side.size());
      if (is_letter && side[k - 1].is("+")) at = k - 1;
    }
    if (at == side.size()) return std::nullopt;
    std::size_t open = at;
    while (open < side.size() && !side[open].is("(")) ++open;
    const Name name = name_at(side, open + 1);
    std::size_t next = open + 1 + name.size;
    Remainder remainder{name.name, 1};
    if (next < side.size() && side[next].is("^")) {
      next += 1;
      const bool is_group = next < side.size() && side[next].is("{");
      if (is_group) ++next;
      if (next >= side.size() || side[next].text.size() != 1 || side[next].text[0] < '1' ||
          side[next].text[0] > '9')
        return std::nullopt;
      remainder.order = side[next].text[0] - '0';
      next += is_group ? 2 : 1;
    }
    if (name.size == 0 || next + 1 != side.size() || !side[next].is(")")) return std::nullopt;
    side.resize(at);
    return remainder;
  }

  /// Compares the series of two sides up to the remainder that the text leaves out.
  Compared compared_series(const TexTokens& left, const TexTokens& right, const Remainder& remainder) {
    Compared result;
    const Reading reading = readings_of(left, right, false, meanings_).front();
    const Tree a = algebra::real_number(reading.left, 0), b = algebra::real_number(reading.right, 0);
    std::set<std::string> names = decide::names_of(a);
    names.merge(decide::names_of(b));
    Symbols symbols;
    for (const std::string& name : meanings_.symbols.names())
      if (names.contains(name)) symbols.declare(*meanings_.symbols.find(name));
    const bool is_sure = names.contains(remainder.name) && !reading.choices.is_uncertain &&
                         std::ranges::includes(decide::names_of(a), decide::names_of(b));
    result.reason = "the sides of this series have different names, or other readings";
    if (!is_sure) return result;
    const decide::Proof proof =
        decide::decide_to_order({{a}, {}}, {{b}, {}}, {remainder.name}, remainder.order - 1, symbols);
    const bool is_right =
        proof.verdict == decide::Verdict::approximation || proof.verdict == decide::Verdict::proved;
    result.reason = proof.reason;
    if (is_right) result.is = Compared::Is::proved;
    if (proof.verdict == decide::Verdict::refuted) {
      result.is = Compared::Is::refuted;
      result.witness = fmt::format("the series differ before order {}", remainder.order);
    }
    return result;
  }

  /// Judges both signs of ±, and all readings of each.
  Compared judged(TexTokens left, const std::string& relation, TexTokens right) {
    const auto one = take_remainder(left), other = take_remainder(right);
    if (relation == "=" && (one || other)) {
      const Remainder remainder = one && (!other || one->order < other->order) ? *one : *other;
      return compared_series(left, right, remainder);
    }
    Compared worst = judged_with_sign(left, relation, right, false);
    if (!has_sign_ || worst.is == Compared::Is::refuted) return worst;
    const Compared lower = judged_with_sign(left, relation, right, true);
    return lower.is == Compared::Is::proved ? worst : lower;
  }

  /// Returns proved if one reading is, refuted if the first one is for sure and the others are, too.
  Compared judged_with_sign(const TexTokens& left, const std::string& relation, const TexTokens& right,
                            bool is_lower) {
    has_sign_ = false;
    std::optional<Compared> first;
    bool are_refuted = true;
    for (const Reading& reading : readings_of(left, right, is_lower, meanings_)) {
      has_sign_ = has_sign_ || reading.choices.has_sign;
      Compared compared = compared_values(reading, relation);
      if (reading.choices.may_be_a_call) {
        compared = {};
        compared.reason = "a name before brackets may be a function";
        return compared;
      }
      if (compared.is == Compared::Is::proved) return compared;
      const bool is_refuted = compared.is == Compared::Is::refuted || compared.is_taken_back;
      are_refuted = are_refuted && is_refuted && !reading.choices.is_uncertain;
      if (!first) first = compared;
    }
    if (first->is == Compared::Is::refuted && !are_refuted) {
      first->is = Compared::Is::undecided;
      first->reason = "the formula has other readings";
    }
    return *first;
  }

  /// Compares all entries of two values.
  Compared compared_values(const Reading& reading, const std::string& relation) {
    const Value &left = reading.left, &right = reading.right;
    Compared total{.is = Compared::Is::proved};
    const bool is_zero_vector = right.is_number() && !left.is_number() && right.entries[0].real->text == "0";
    if ((left.rows != right.rows || left.columns != right.columns) && !is_zero_vector) {
      total.is = Compared::Is::undecided;
      total.reason = "the two sides have different sizes";
      return total;
    }
    if (relation != "=" && !left.is_number()) {
      total.is = Compared::Is::undecided;
      total.reason = "vectors are compared by = only";
      return total;
    }
    for (std::size_t k = 0; k < left.entries.size(); ++k) {
      const Number &a = left.entries[k], &b = right.entries[is_zero_vector ? 0 : k];
      const Tree zero = paper_zero();
      std::vector<std::pair<Tree, Tree>> pairs{{a.real, b.real}};
      if (a.imaginary || b.imaginary)
        pairs.emplace_back(a.imaginary ? a.imaginary : zero, b.imaginary ? b.imaginary : zero);
      for (const auto& [one, other] : pairs) {
        const Compared part = compared_real(one, relation, other);
        total.conditions.insert(total.conditions.end(), part.conditions.begin(), part.conditions.end());
        if (part.is == Compared::Is::proved || total.is == Compared::Is::refuted) continue;
        const std::vector<std::string> conditions = total.conditions;
        total = part;
        total.conditions = conditions;
      }
    }
    return total;
  }
  static Tree paper_zero() { return make_tree(Node::Kind::number, "0"); }

  Compared compared_real(Tree left, const std::string& relation, Tree right) {
    for (const auto& [name, integral] : std::map(meanings_.antiderivatives)) {
      const bool is_here = decide::names_of(left).contains(name) || decide::names_of(right).contains(name);
      if (!is_here || relation != "=") continue;
      left = derivative(left, integral.variable, meanings_);
      right = derivative(right, integral.variable, meanings_);
      break;
    }
    Compared compared = compare(left, relation, right, meanings_, stated_);
    if (compared.is != Compared::Is::refuted) return compared;
    // Definitions of the text may be meant.
    Tree one = left, other = right;
    for (int round = 0; round < 4; ++round)
      for (const auto& [name, definition] : meanings_.defined)
        if (definition.variable.empty() && !decide::names_of(definition.value).empty()) {
          one = put_in(one, name, definition.value);
          other = put_in(other, name, definition.value);
        }
    if (!is_same(one, left) || !is_same(other, right)) {
      Compared again = compare(one, relation, other, meanings_, stated_);
      again.conditions.push_back("with the values that the text gives names");
      if (again.is == Compared::Is::proved) return again;
    }
    guard(left, relation, right, compared);
    return compared;
  }

  /// Takes back a refutation that may rest on something that the text leaves unsaid.
  void guard(const Tree& left, const std::string& relation, const Tree& right, Compared& compared) {
    const std::set<std::string> a = decide::names_of(left), b = decide::names_of(right);
    if (compared.is_numbers) return;
    if (directive_.is_identity) {
      compared.repair = repair_of(left, right, meanings_, stated_);
      return;
    }
    const auto take_back = [&](const std::string& reason) {
      compared.is = Compared::Is::undecided;
      compared.is_taken_back = true;
      compared.reason = reason;
    };
    std::set<std::string> all = a;
    all.insert(b.begin(), b.end());
    if (!std::ranges::includes(a, b)) return take_back("the right side has a name that the left side lacks");
    const bool is_bound = facts_.bind(all, section_, display_);
    const bool is_stated =
        std::ranges::all_of(all, [&](const std::string& name) { return stated_.contains(name); });
    if (relation != "=" && !is_stated)
      return take_back("it is an assumption about names whose ranges are not stated");
    if (relation != "=") return is_bound ? take_back("an equation of the text relates these names") : void();
    if (is_word(left) && is_word(right))
      return take_back("each side is a product of names, which may be words");
    std::set<std::string> differing;
    std::ranges::set_symmetric_difference(a, b, std::inserter(differing, differing.end()));
    const bool is_put_in =
        std::ranges::any_of(differing, [&](const std::string& name) { return facts_.has_number(name); });
    if (is_put_in) return take_back("a value may have been put in");
    if (a.empty() || b.empty())
      return take_back("one side is a number, the other is not: a value may have been put in");
    const auto approximate = approximate_.find(section_);
    if (approximate != approximate_.end() &&
        is_first_order(left, right, approximate->second.empty() ? all : approximate->second))
      return take_back("it holds to first order, and the text approximates");
    compared.repair = repair_of(left, right, meanings_, stated_);
    if (compared.repair.empty() && is_bound) return take_back("an equation of the text relates these names");
    if (compared.repair.empty() && !differing.empty())
      take_back("the two sides have different names, and no single change makes them equal");
  }

  static bool is_word(const Tree& tree) {
    const bool is_product = tree->kind == Node::Kind::product &&
                            std::ranges::none_of(tree->inverse, [](bool divides) { return divides; });
    return decide::is_symbol(tree) || (is_product && std::ranges::all_of(tree->children, is_word));
  }

  bool is_first_order(const Tree& left, const Tree& right, const std::set<std::string>& small) const {
    std::set<std::string> names = decide::names_of(left);
    names.merge(decide::names_of(right));
    Symbols symbols;
    for (const std::string& name : meanings_.symbols.names())
      if (names.contains(name)) symbols.declare(*meanings_.symbols.find(name));
    for (const std::string& name : small) {
      if (!names.contains(name)) continue;
      const auto is_same = [&](const Tree& one, const Tree& other) {
        const decide::Proof proof = decide::decide_to_order({{one}, {}}, {{other}, {}}, {name}, 1, symbols);
        return proof.verdict == decide::Verdict::approximation || proof.verdict == decide::Verdict::proved;
      };
      if (is_same(left, right) && !is_same(left, paper_zero())) return true;
    }
    return false;
  }

  /// A sum up to n is tried for n = 1, 2, … 6: it is refuted at one of them, or undecided.
  bool judge_up_to(const Statement& statement, std::size_t k, Link& link) {
    const std::string name = bound_;
    std::size_t tried = 0;
    for (long n = 1; n <= 6; ++n) {
      meanings_.numbers[name] = n;
      Compared compared;
      try {
        compared = judged(statement.sides[k], link.relation, statement.sides[k + 1]);
      } catch (const std::exception&) {
        meanings_.numbers.erase(name);
        return false;
      }
      meanings_.numbers.erase(name);
      if (compared.is == Compared::Is::refuted && n > 1) {
        apply(compared, link);
        link.repair.clear();
        link.witness = fmt::format("at {} = {}: {}", name, n, compared.witness);
        return true;
      }
      tried += compared.is == Compared::Is::proved ? 1 : 0;
    }
    link.finding = Finding::undecided;
    link.reason =
        fmt::format("of {} = 1, 2, … 6, it holds for {}, which does not prove it for all", name, tried);
    return true;
  }

  /// Judges a single equation: it follows from the one before, or is taken as it is.
  void judge_equation(const Statement& statement, std::vector<Relation>& equations, JudgedDisplay& display) {
    Link link = link_of(statement, 0);
    std::optional<Relation> relation;
    static const std::set<std::string> read{"=", ":=", "<", "<=", ">", ">=", "≈"};
    const bool is_read = read.contains(link.relation);
    if (!is_read && link.relation != "!=" && link.relation != "\\in") {
      link.finding = Finding::not_read;
      link.reason = "the relation " + link.relation + " is not judged";
    }
    if (is_read) {
      try {
        const auto readings = readings_of(statement.sides[0], statement.sides[1], false, meanings_);
        const Value &left = readings[0].left, &right = readings[0].right;
        const bool is_real = left.is_number() && right.is_number() && !left.entries[0].imaginary &&
                             !right.entries[0].imaginary;
        if (is_real && readings.size() == 1 && !readings[0].choices.is_uncertain &&
            !readings[0].choices.has_sign && !readings[0].choices.may_be_a_call)
          relation = {{left.entries[0].real, right.entries[0].real},
                      {link.relation == ":=" ? "=" : link.relation}};
      } catch (const SyntaxError& error) {
        link.finding = Finding::not_read;
        link.reason = error.what();
      }
    }
    constexpr std::ptrdiff_t most_before = 12;  // a step rests on the lines before it, not on a long list
    std::vector<Relation> before = before_;
    before.insert(before.end(), equations.end() - std::min(most_before, std::ssize(equations)),
                  equations.end());
    const bool is_list = statement.is_listed && statement.connective == Connective::none;
    const bool is_new = link.relation == ":=" || is_list;
    const bool is_numbers = relation && decide::names_of(*relation).empty();
    const bool is_approximate = link.relation == "≈";
    const bool is_step =
        relation && !is_approximate && !before.empty() && !is_new && is_judging_ && !is_numbers;
    const bool is_value = is_known_value(statement.sides[0]) && link.relation == "=" && !before.empty();
    const bool is_worked_out =
        relation && before.empty() && link.relation == "=" && has_operator(statement.sides[0]);
    if (is_judging_ && (is_numbers || is_value))
      judge_link(statement, 0, link);
    else if (is_judging_ && is_worked_out)
      judge_worked_out(statement, link);
    else if (is_step)
      judge_step(statement, *relation, before, link);
    if (link.finding == Finding::assumed || link.finding == Finding::not_read) assume(statement, 0);
    if (relation && !is_numbers && !is_approximate) equations.push_back(*relation);
    if (!relation) equations.clear();
    if (is_judging_) display.links.push_back(std::move(link));
  }

  /// Returns whether a side says how something is worked out: a derivative or an integral of a formula, a
  /// sum.
  static bool has_operator(const TexTokens& side) {
    for (std::size_t at = 0; at < side.size(); ++at) {
      if (side[at].is("\\int") || side[at].is("\\sum") || side[at].is("\\prod") || side[at].is("\\lim") ||
          side[at].is("\\det") || side[at].is("\\begin{vmatrix}"))
        return true;
      const bool is_derivative =
          side[at].text.ends_with("frac") && at + 2 < side.size() && side[at + 1].is("{") &&
          (side[at + 2].is("d") || side[at + 2].is("\\partial") || side[at + 2].is("\\mathrm{d}"));
      if (!is_derivative) continue;
      const std::size_t behind = behind_argument(side, behind_argument(side, at + 1));
      if (behind < side.size() && side[behind].is("(")) return true;
    }
    return false;
  }

  /// Such an equation may also be a law: it is wrong only if a single change makes it right.
  void judge_worked_out(const Statement& statement, Link& link) {
    Link judged = link;
    judge_link(statement, 0, judged);
    if (judged.finding == Finding::proved || (judged.finding == Finding::wrong && !judged.repair.empty()))
      link = judged;
  }

  void judge_step(const Statement& statement, const Relation& equation, const std::vector<Relation>& before,
                  Link& link) {
    std::set<std::string> known;
    for (const Relation& one : before) known.merge(decide::names_of(one));
    const std::set<std::string> names = decide::names_of(equation);
    const bool has_new_names = !std::ranges::includes(known, names);
    const bool is_told = statement.connective != Connective::none || !directive_.from.empty();
    if (has_new_names && !is_told) return;
    // A list of values, x = 2 and y = 3, says nothing about each other.
    const bool is_same_names = decide::names_of(before.back()) == names;
    const bool is_fewer = std::ranges::includes(decide::names_of(before.back()), names);
    if (!is_same_names && !is_told && !is_fewer) return;
    Compared compared;
    try {
      compared =
          compare_step(equation, before, statement.connective != Connective::implies, meanings_, stated_);
    } catch (const std::exception& error) {
      compared.reason = decide::in_plain_words(error);
    }
    const bool is_certain = !directive_.from.empty();  // the text says from what it follows
    if (compared.is == Compared::Is::refuted && !is_same_names && !is_certain) {
      // A name may have been cancelled: then a change that makes the line right needs no other names.
      const auto repair = is_fewer ? repair_of(before.back(), equation, meanings_, stated_) : "";
      compared.repair = has_only(repair, names) ? repair : "";
      if (compared.repair.empty()) {
        compared.is = Compared::Is::undecided;
        compared.reason = "it has not the names of the line before: a value may have been put in";
      }
    } else if (compared.is == Compared::Is::refuted && !is_told &&
               are_alternatives(before.back(), equation)) {
      compared.is = Compared::Is::undecided;
      compared.reason = "it may be another value of the same name";
    } else if (compared.is == Compared::Is::refuted && !is_certain) {
      guard_step(equation, before, names, compared);
    }
    const bool is_assumed =
        compared.is != Compared::Is::proved && compared.is != Compared::Is::refuted && !is_told;
    if (!is_assumed) apply(compared, link);
  }

  /// Returns whether two equations give a name two values, as a list of solutions does: x = 1 and x = 2.
  static bool are_alternatives(const Relation& one, const Relation& other) {
    const auto is_value = [](const Relation& equation) {
      return decide::is_symbol(equation.sides[0]) &&
             !decide::names_of(equation.sides[1]).contains(equation.sides[0]->text);
    };
    if (!is_value(one) || !is_value(other) || !is_same(one.sides[0], other.sides[0])) return false;
    const bool is_worked_out = decide::names_of(one.sides[1]).empty() && !decimals_of(one.sides[1]);
    return !is_worked_out;  // x = 10/2 is one
  }

  bool has_only(const std::string& text, const std::set<std::string>& names) const {
    return !text.empty() &&
           std::ranges::includes(names, decide::names_of(parse_relation(text, meanings_.symbols)));
  }

  /// Takes back the refutation of a step that may be an equation of its own.
  void guard_step(const Relation& equation, const std::vector<Relation>& before,
                  const std::set<std::string>& names, Compared& compared) const {
    const auto take_back = [&](const std::string& reason) {
      compared.is = Compared::Is::undecided;
      compared.reason = reason;
    };
    if (compared.is_loss) return names.size() > 1 ? take_back(compared.witness) : void();
    compared.repair = repair_of(before.back(), equation, meanings_, stated_);
    if (names.size() == 1 || !compared.repair.empty()) return;
    take_back("it does not follow from the line before; it may be an equation of its own");
  }

  const Manuscript& manuscript_;
  const StatedSymbols given_;
  const bool with_inline_;
  bool is_judging_ = false, is_complex_text_ = false, has_i_ = false, is_index_ = false, has_sign_ = false;
  Meanings base_, meanings_;
  std::set<std::string> functions_, uses_of_time_;
  std::map<std::size_t, std::set<std::string>> approximate_;  ///< section → the names that it calls small
  std::map<std::string, std::pair<int, int>> uses_;
  StatedSymbols stated_;
  Facts facts_;
  std::string prose_, unread_, bound_;
  Directive directive_;
  std::size_t section_ = 0, display_ = 0;
  std::vector<Relation> before_;
  std::map<std::string, std::vector<Relation>> labelled_;
  std::vector<JudgedDisplay> displays_;
};

}  // namespace

std::string to_string(Finding finding) {
  constexpr std::array words{"proved", "wrong", "undecided", "not_read", "assumed"};
  return words[static_cast<std::size_t>(finding)];
}

std::size_t Report::count(Finding finding) const {
  std::size_t total = 0;
  for (const JudgedDisplay& display : displays)
    total += static_cast<std::size_t>(std::ranges::count(display.links, finding, &Link::finding));
  return total;
}

Report check(const Manuscript& manuscript, const StatedSymbols& symbols, bool with_inline) {
  return Checker(manuscript, symbols, with_inline).run();
}

}  // namespace rederive::manuscript
