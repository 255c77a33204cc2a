#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <derivations/decide/problem.hpp>
#include <derivations/language/text.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/laws.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/exercises/why_wrong.hpp>
#include <lessons/exercises/working.hpp>
#include <lessons/page/prose.hpp>
#include <regex>
#include <sstream>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;
using namespace page;
namespace {

/// A step: one link of a line.
struct Step {
  std::size_t line = 0;  ///< its place among the lines
  int number = 0;        ///< of the line
  std::string text;
  Relation says = {};                   ///< an equation, or an expression
  std::vector<Relation> assumed = {};   ///< for this step
  std::vector<std::string> small = {};  ///< symbols, to first order in which it is to hold
  std::optional<Cited> law = {};        ///< of which the statement, if there is one, is a consequence

  bool is_under_assumptions() const { return !assumed.empty() || !small.empty(); }
};

/// Returns the only reading of a line. Throws SyntaxError if there are several; the message has their texts.
Relation read_one(const Exercise& exercise, const Symbols& symbols, const std::string& text) {
  std::vector<std::string> given = exercise.symbols;
  for (const std::string& name : symbols.names())
    if (name != "e") given.push_back(name);
  const reader::Readings readings = reader::generous_readings(text, {.symbols = symbols, .given = given});
  if (readings.all.size() == 1) return readings.all[0];
  throw SyntaxError(Mistake::syntax, 0,
                    "it is not clear " + readings.reason + ": " + as_typed(print(readings.all[0])) + " or " +
                        as_typed(print(readings.all[1])));
}

/// Reads what is in brackets into the step, each part at its place, and returns the line without it.
std::string without_brackets(std::string text, const Symbols& symbols, Step& step) {
  const std::size_t from = text.find('[');
  const bool is_apart =
      from != std::string::npos && (from == 0 || text[from - 1] == ' ');  // not in cos[alpha]
  if (!is_apart || (text.find_first_of("<>=", from) == std::string::npos && text.find("[small ") != from))
    return text;
  if (text.back() != ']')
    throw SyntaxError(Mistake::syntax, from, "an assumption must end with ], at the end of the line");
  constexpr std::string_view small = "small ";
  const std::size_t first = text.find_first_not_of(' ', from + 1);
  const bool is_small = text.compare(first, small.size(), small) == 0;
  for (std::size_t at = is_small ? first + small.size() : from + 1; at < text.size();
       at = text.find_first_of(",]", at) + 1) {
    const std::size_t end = text.find_first_of(",]", at);
    const Relation part = parse_statement(std::string(at, ' ') + text.substr(at, end - at), symbols);
    if (part.operators.empty() != is_small || (is_small && part.sides[0]->kind != Node::Kind::symbol))
      throw SyntaxError(Mistake::assumption, at,
                        "an assumption must be a relation, [theta > 0], or [small theta, alpha]");
    if (is_small)
      step.small.push_back(part.sides[0]->text);
    else
      step.assumed.push_back(part);
  }
  return text.substr(0, from);
}

/// Reads lines one after the other, with the names that they introduce.
class LineReader {
 public:
  explicit LineReader(const Exercise& exercise) : exercise_(exercise), symbols_(exercise.language()) {}

  /// Reads a line that comes after `steps`, and adds its links. Returns `name`, `cited` or `follows`.
  LineStatus read(std::size_t line, int number, const std::string& typed, std::vector<Step>& steps) {
    static const std::regex naming(R"(\s*(?:let|put|set|write)\s+([^\s=:]+)\s*:?=(.+))", std::regex::icase);
    std::smatch found;
    Step step{.line = line, .number = number, .text = typed};
    std::string text = typed;
    if (std::regex_match(typed, found, naming)) {
      const auto place = static_cast<std::size_t>(found.position(2));
      if (introduce(found[1], std::string(place, ' ') + found[2].str())) return LineStatus::name;
      const auto name = static_cast<std::size_t>(found.position(1));
      text.replace(0, name, name, ' ');
    }
    step.law = take_law(text);
    if (trimmed(text).empty() && step.law) {
      steps.push_back(step);
      return LineStatus::cited;
    }
    text = without_brackets(text, symbols_, step);
    const bool goes_on = trimmed(text)[0] == '=';
    if (goes_on) text[text.find('=')] = ' ';
    const bool is_first = steps.empty() || steps.back().says.sides.empty();
    if (goes_on && is_first) throw SyntaxError(Mistake::syntax, 0, "the first line must not begin with =");
    Relation read = read_one(exercise_, symbols_, text);
    for (const auto& [name, value] : names_) read = decide::put_in(read, name, value);
    for (const auto& side : read.sides) lower(side, exercise_.language());  // refuses what is undefined: R/0
    add_links(read, goes_on, step, steps);
    return LineStatus::follows;
  }

 private:
  /// Introduces a name. Returns false if it has a meaning already.
  bool introduce(const std::string& typed, const std::string& text) {
    std::string name;
    for (std::string_view rest = typed; !rest.empty();) {
      const auto [code, bytes] = first_character(rest);
      const std::string letter = greek_name(code);
      name += letter.empty() ? std::string(rest.substr(0, std::max<std::size_t>(bytes, 1))) : letter;
      rest.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    Tree value = parse(text, symbols_);
    for (const auto& [other, known] : names_) value = language::put_in(value, other, known);
    lower(value, exercise_.language());
    if (exercise_.language().find(name) != nullptr && is_used(name)) {
      const bool is_same = is_known(name, value);
      if (is_same) names_.insert_or_assign(name, value);
      return is_same;
    }
    try {
      symbols_.declare(Symbol(name, name, name, "1", all_numbers, "", ""));
    } catch (const std::invalid_argument&) {
      throw SyntaxError(Mistake::assumption, 0, "'" + printable_line(name) + "' cannot be a name");
    }
    names_.insert_or_assign(name, value);
    return true;
  }

  /// Returns whether the paper defines a symbol by this value.
  bool is_known(const std::string& name, const Tree& value) const {
    const Symbols& symbols = exercise_.language();
    const auto& known = exercise_.course->definitions;
    return std::ranges::any_of(known, [&](const Given& given) {
      return given.name.is_equal(symbols[name]) &&
             is_right(decide::decide({{value}, {}}, {{to_tree(given.value, symbols)}, {}}, symbols, known)
                          .verdict);
    });
  }

  /// Returns whether a symbol of the paper has a meaning in the exercise, which a line may state but not
  /// change.
  bool is_used(const std::string& name) const {
    const auto is_of = [&](const Given& given) { return given.name.is_equal(exercise_.language()[name]); };
    return std::ranges::count(exercise_.symbols, name) > 0 || exercise_.name == name ||
           exercise_.answer.put.contains(name) || std::ranges::any_of(exercise_.course->definitions, is_of);
  }

  /// Takes "Newton:", "by (13)" or "[by Newton]" out of a line, in whose place are blanks.
  std::optional<Cited> take_law(std::string& text) const {
    static const std::regex before(R"(\s*(by|from|with)?\s*([^:=\[]+?)\s*(:|$))", std::regex::icase),
        behind(R"([,;]?\s*\[?\s*\b(?:by|from)\s+([^=\[\]]+?)\s*\]?\s*$)", std::regex::icase);
    std::smatch found;
    if (std::regex_search(text, found, before, std::regex_constants::match_continuous) &&
        (found[1].matched || is_law(exercise_, found[2]))) {
      const auto place = static_cast<std::size_t>(found.position(2));
      const std::string name = found[2];
      text.replace(0, static_cast<std::size_t>(found.length(0)), static_cast<std::size_t>(found.length(0)),
                   ' ');
      return cited(exercise_, name, place);
    }
    if (!std::regex_search(text, found, behind)) return {};
    const auto place = static_cast<std::size_t>(found.position(1));
    const std::string name = found[1];
    text.erase(static_cast<std::size_t>(found.position(0)));
    return cited(exercise_, name, place);
  }

  void add_links(Relation& read, bool goes_on, Step& step, std::vector<Step>& steps) const {
    for (const auto& op : read.operators)
      if (op != "=")
        throw SyntaxError(Mistake::equation_wanted, 0, "the lines of a working must use =, not inequalities");
    const bool has_foreign_name = read.sides.size() > 1 && !goes_on && is_symbol(read.sides[0]);
    const bool is_equation = exercise_.kind == Kind::equation || step.law || has_foreign_name ||
                             names_of(read).contains(exercise_.name) ||
                             (read.sides.size() > 1 && is_asked_for(exercise_, read.sides[0]));
    Tree left;
    if (goes_on && !steps.back().says.operators.empty()) left = steps.back().says.sides[0];
    if (!goes_on && is_equation) {
      if (read.sides.size() == 1 && !exercise_.name.empty())
        read.sides.insert(read.sides.begin(), parse(exercise_.name, exercise_.language()));
      if (read.sides.size() == 1)
        throw SyntaxError(Mistake::equation_wanted, 0, "an equation is expected: left = right");
      left = read.sides[0];
      read.sides.erase(read.sides.begin());
    }
    for (const auto& side : read.sides) {
      step.says = left == nullptr ? Relation{{side}, {}} : Relation{{left, side}, {"="}};
      steps.push_back(step);
      step.law.reset();
    }
  }

  const Exercise& exercise_;
  Symbols symbols_;  ///< with the names that lines introduced
  std::map<std::string, Tree> names_;
};

/// Returns a for "y_c = a", if y_c is what is asked for.
Relation as_value(const Exercise& exercise, const Relation& says) {
  const bool is_named =
      exercise.kind == Kind::expression && !says.operators.empty() && is_asked_for(exercise, says.sides[0]);
  return is_named ? Relation{{says.sides[1]}, {}} : says;
}

/// Returns what two steps say as statements of one kind: as expressions if possible, else as equations.
std::pair<Relation, Relation> of_one_kind(const Exercise& exercise, const Step& before, const Step& after) {
  std::pair<Relation, Relation> both{as_value(exercise, before.says), as_value(exercise, after.says)};
  if (both.first.operators == both.second.operators) return both;
  for (auto* one : {&both.first, &both.second})
    if (one->operators.empty()) *one = {{parse(exercise.name, exercise.language()), one->sides[0]}, {"="}};
  return both;
}

/// Decides a step that holds under its assumptions; nothing if it does not.
std::optional<Opinion> judge_assumed(const Prepared& step, const Step& after, const Relation& first,
                                     const Relation& second) {
  std::vector<Relation> assumed = step.assumed;
  assumed.insert(assumed.end(), after.assumed.begin(), after.assumed.end());
  if (contradict(assumed, step.symbols))
    return invalid(Slip::assumption,
                   "No numbers in the ranges of the symbols satisfy all that is assumed here.");
  const auto& given = step.answer.given;
  const Proof proof = after.small.empty()
                          ? decide::decide(second, first, step.symbols, given, assumed)
                          : decide_to_order(second, first, after.small, 1, step.symbols, given, assumed);
  if (is_right(proof.verdict) || proof.verdict == Verdict::approximation) return right_answer();
  if (proof.verdict == Verdict::undecided) return undecided(proof.reason);
  return {};
}

Opinion judge_step(const Prepared& whole, const Step& before, const Step& after) {
  const auto [first, second] = of_one_kind(whole.exercise, before, after);
  const Prepared step = prepare_step(whole, first, second);
  if (after.is_under_assumptions())
    if (const auto opinion = judge_assumed(step, after, first, second)) return *opinion;
  Opinion opinion;
  try {
    opinion = judge_formula(step, second);
  } catch (const SyntaxError& error) {
    return invalid(error, after.text);
  }
  if (exit_code(opinion) == 1 && !opinion.witness) opinion.witness = by_hand(step, second);
  if (exit_code(opinion) == 1 && !opinion.witness && first.operators.empty())
    opinion.witness = proof_of(step, second, first).witness;
  const Slip slip = opinion.note.slip;
  if (slip == Slip::small_angle || slip == Slip::not_linear)
    opinion.feedback =
        "It does for small angles only: say so at the end of the line, as in [small alpha, theta].";
  if (slip == Slip::other)
    opinion.feedback = std::string("It is none of the usual slips.") +
                       (opinion.witness ? " Try both at one point, by hand:" : "");
  return opinion;
}

/// What was found to hold so far: equations, solved for a symbol where that can be done.
class Facts {
 public:
  Facts(const Prepared& whole, const std::vector<Step>& steps) : whole_(whole), given_(whole.answer.given) {
    const auto& symbols = whole.exercise.symbols;
    names_.insert(symbols.begin(), symbols.end());
    for (const Step& step : steps) {
      names_.merge(names_of(step.says));
      if (!step.law) continue;
      for (const Relation& equation : step.law->equations) names_.merge(names_of(equation));
      for (const Given& item : step.law->given)
        if (std::ranges::none_of(given_, [&](const Given& other) { return other.name.is_equal(item.name); }))
          given_.push_back(item);
    }
    add_definitions(given_, names_, whole.exercise.name, *whole.exercise.course);
  }

  void add(const Relation& equation) {
    if (!equation.operators.empty()) known_.push_back(equation);
  }
  std::size_t size() const { return known_.size(); }

  /// Decides whether an equation follows; if not, the witness has small numbers where they were found.
  Proof proof_of(const Relation& equation) const {
    Facts all = *this;
    for (const Relation& known : known_) all.use(known);
    return all.proof_with_values(equation);
  }

 private:
  /// Solves an equation for a symbol, and puts that into the others.
  void use(const Relation& equation) {
    Relation known = reduced(equation);
    if (auto value = solved(known)) {
      for (auto& [name, other] : values_) other = language::put_in(other, value->first, value->second);
      for (Relation& other : others_) other = decide::put_in(other, value->first, value->second);
      values_.push_back(std::move(*value));
    } else if (!is_right(
                   decide::decide({{known.sides[0]}, {}}, {{known.sides[1]}, {}}, whole_.symbols).verdict)) {
      others_.push_back(known);
    }
  }

  Proof proof_with_values(const Relation& equation) const {
    const Relation left{{equation.sides[0]}, {}}, right{{equation.sides[1]}, {}};
    std::vector<Relation> assumed = whole_.assumed;
    for (const auto& [name, value] : values_)
      assumed.push_back({{make_tree(Node::Kind::symbol, name), value}, {"="}});
    Proof proof = decide::decide(left, right, whole_.symbols, given_, assumed);
    if (is_right(proof.verdict) || others_.empty()) return with_numbers(std::move(proof), equation);
    assumed.insert(assumed.end(), others_.begin(), others_.end());
    proof = decide::decide(left, right, whole_.symbols, given_, assumed);
    return with_numbers(std::move(proof), equation);
  }

  Relation reduced(const Relation& equation) const {
    Relation result = put_in(equation, given_, whole_.symbols);
    for (const auto& [name, value] : values_) result = decide::put_in(result, name, value);
    return result;
  }

  /// Solves an equation for a symbol whose factor is never 0.
  std::optional<std::pair<std::string, Tree>> solved(const Relation& equation) const {
    const Symbols& symbols = whole_.symbols;
    const GiNaC::ex rest = (lower(equation.sides[0], symbols) - lower(equation.sides[1], symbols)).expand();
    std::vector<std::string> order;
    for (const Tree& side : equation.sides)
      if (is_symbol(side)) order.push_back(side->text);
    if (!whole_.exercise.pivot.empty()) order.push_back(whole_.exercise.pivot);
    for (const std::string& name : names_of(equation))
      if (std::ranges::count(whole_.exercise.symbols, name) == 0) order.push_back(name);
    for (const std::string& name : order) {
      const GiNaC::symbol& symbol = symbols[name];
      const GiNaC::ex factor = rest.diff(symbol);
      if (factor.is_zero() || factor.has(symbol)) continue;
      const Tree size = to_tree(factor, symbols);
      const bool is_never_0 = std::ranges::any_of(std::array{"<", ">"}, [&](const char* sign) {
        return is_right(decide::decide({{size, number("0")}, {sign}}, {{number("0"), number("1")}, {"<"}},
                                       symbols, given_, whole_.assumed)
                            .verdict);
      });
      if (is_never_0) return std::pair{name, to_tree(-rest.subs(symbol == 0) / factor, symbols)};
    }
    return {};
  }

  Proof with_numbers(Proof proof, const Relation& equation) const {
    if (proof.verdict != Verdict::refuted) return proof;
    Witness& found = *proof.witness;
    char *end = nullptr, *other_end = nullptr;
    const double left = std::strtod(found.printed.c_str(), &end),
                 right = std::strtod(found.derived.c_str(), &other_end);
    const bool has_values = end != found.printed.c_str() && other_end != found.derived.c_str();
    found.printed = has_values ? fmt::format("{:.6g}", left - right) : "no value";
    found.derived = "0";
    if (!others_.empty()) return proof;
    const Relation put = reduced(equation);
    const Relation difference{{decide::difference(put.sides[0], put.sides[1])}, {}};
    Prepared step = prepare_step(whole_, Relation{{number("0")}, {}}, difference);
    step.answer.given = given_;
    if (auto witness = by_hand(step, difference)) {
      RoughPoint at;
      for (const auto& [name, value] : witness->at) at[name] = rough_value(parse(value, whole_.symbols), {});
      std::vector<Relation> must_hold = whole_.assumed;
      for (const auto& [name, value] : values_) {
        at[name] = rough_value(value, at);
        const auto [low, high] = parse_range(whole_.symbols.find(name)->range);
        if (low.infinite == 0) must_hold.push_back({{tree_of(low), value}, {"<"}});
        if (high.infinite == 0) must_hold.push_back({{value, tree_of(high)}, {"<"}});
        if (names_of(equation).contains(name)) witness->at[name] = fmt::format("{:.6g}", at[name]);
      }
      if (holds(must_hold, at)) proof.witness = witness;
    }
    return proof;
  }

  const Prepared& whole_;
  std::vector<Given> given_;
  std::set<std::string> names_;
  std::vector<std::pair<std::string, Tree>> values_;
  std::vector<Relation> others_, known_;
};

/// Returns the opinion on an equation that must follow from facts; `from` says which.
Opinion judge_implied(const Facts& facts, const Relation& says, const std::string& from) {
  const Proof proof = facts.proof_of(says);
  if (is_right(proof.verdict)) {
    Opinion opinion = right_answer();
    opinion.note = {"implied"};
    return opinion;
  }
  if (proof.verdict != Verdict::refuted) return undecided(proof.reason);
  Opinion opinion =
      wrong_answer(Slip::other, "It does not follow from " + from +
                                    (proof.witness ? ": there is a point at which that holds, and "
                                                     "this line does not."
                                                   : "."));
  opinion.witness = proof.witness;
  opinion.read_as = as_typed(print_statement(says, Notation::plain, {}));
  return opinion;
}

/// Returns the value of a side of a line in base units: of a number with a unit, or of a formula whose
/// symbols have the values in `known`.
double side_value(const std::string& text, std::size_t from, std::size_t end, const RoughPoint& known,
                  const Symbols& symbols) {
  const std::string side = text.substr(from, end - from);
  try {
    return parse_quantity(side).value;
  } catch (const SyntaxError&) {
    return rough_value(parse(std::string(from, ' ') + side, symbols), known);
  }
}

/// Judges a line of a working of a number: a chain a = b = c that must be true to three digits with the
/// values in `known`. A symbol without a value there gets the first one that a line states.
Opinion judge_chain(const std::string& text, RoughPoint& known, const Symbols& symbols) {
  std::optional<double> before;
  std::string unknown;
  for (std::size_t from = 0, end; from <= text.size(); from = end + 1) {
    end = std::min(text.find('=', from), text.size());
    const double value = side_value(text, from, end, known, symbols);
    const bool is_new = std::isnan(value) && from == 0 && end < text.size();
    if (is_new) unknown = print(parse(text.substr(0, end), symbols));
    if (is_new) continue;
    if (!std::isfinite(value))
      throw SyntaxError(Mistake::not_real, from,
                        "this has no value, or it contains a symbol without a value");
    if (!unknown.empty()) known[std::exchange(unknown, "")] = value;
    if (before && !(std::abs(value - *before) <= 0.006 * std::abs(*before)))
      return wrong_answer(
          Slip::other, fmt::format("{} is {:.4g}, but the part before it is {:.4g}, with the numbers of the "
                                   "exercise.",
                                   trimmed(text.substr(from, end - from)), value, *before));
    before = value;
  }
  return right_answer();
}

/// Adds the marks of a working that is not right: at most a half, by the part of its steps that follow.
void add_marks(Working& working, bool begins_rightly) {
  if (working.opinion.outcome == Outcome::correct || !begins_rightly) return;
  const auto count = [&](LineStatus status) {
    return static_cast<double>(std::ranges::count(working.lines, status, &WorkingLine::status));
  };
  const double good = count(LineStatus::follows);
  const double all = good + count(LineStatus::does_not_follow) + count(LineStatus::undecided) +
                     count(LineStatus::unreadable);
  if (all > 0) working.opinion.score = std::max(working.opinion.score, std::round(50 * good / all) / 100);
}

/// Keeps the opinion on a line: the first wrong one, else the first unreadable one, else the first undecided
/// one. What comes after an unreadable line may need it, and so is not wrong.
class Worst {
 public:
  void add(WorkingLine& line, LineStatus status, Opinion opinion, const Exercise& about) {
    line.status = status;
    opinion.line = line.number;
    const auto rank = [&](LineStatus one) {
      if (one == LineStatus::does_not_follow) return 3;
      return one == LineStatus::unreadable ? 2 : 1;
    };
    if (is_found_ && (rank(status) <= rank(worst_) || worst_ == LineStatus::unreadable)) return;
    is_found_ = true;
    worst_ = status;
    opinion_ = opinion;
    about_ = about;
  }
  /// Puts what was found into the result. An unreadable line matters only if the answer is not right.
  bool decide(Working& result) const {
    if (!is_found_) return false;
    const bool is_needed =
        worst_ != LineStatus::unreadable || result.lines.back().status == worst_ || spoils_;
    if (!is_needed) return false;
    result.opinion = opinion_;
    result.about = about_;
    return true;
  }
  void spoil() { spoils_ = is_found_ && worst_ == LineStatus::unreadable; }
  bool is_unreadable() const { return is_found_ && worst_ == LineStatus::unreadable; }

 private:
  bool is_found_ = false, spoils_ = false;
  LineStatus worst_ = LineStatus::follows;
  Opinion opinion_;
  Exercise about_;
};

/// Judges chains that must all be true; the last side of the last one is the answer.
void judge_chains(const Prepared& whole, Working& result, const Bound& bound) {
  RoughPoint known;
  Worst worst;
  for (const auto& [name, value] : whole.answer.values) known[name] = rough_value(value, {});
  for (WorkingLine& line : result.lines) try {
      const Opinion opinion = judge_chain(line.text, known, whole.symbols);
      if (opinion.outcome == Outcome::correct) continue;
      if (worst.is_unreadable()) worst.spoil();
      worst.add(line, LineStatus::does_not_follow, opinion, whole.exercise);
    } catch (const SyntaxError& error) {
      worst.add(line, LineStatus::unreadable, invalid(error, line.text), whole.exercise);
    }
  if (worst.decide(result)) return;
  result.opinion = bound([&] { return judge_answer(whole, result.answer); });
  if (exit_code(result.opinion) == 1 && result.lines.size() > 1)
    result.opinion.feedback = "Each line is true, but the last is not the answer. " + result.opinion.feedback;
}

/// Judges a working about a formula.
class Follower {
 public:
  Follower(const Prepared& whole, Working& result, const Bound& bound)
      : whole_(whole), result_(result), bound_(bound) {}

  void run() {
    read();
    const Facts nothing(whole_, steps_);
    Facts facts = nothing;
    for (std::size_t k = 0; k < steps_.size(); ++k) judge(k, facts);
    if (worst_line_.decide(result_)) return add_marks(result_, begins_rightly(nothing));
    if (steps_.empty() || steps_.back().says.sides.empty()) {
      result_.opinion = invalid({"empty"}, "The last line must be the answer.");
      return;
    }
    result_.answer = print_statement(as_value(whole_.exercise, steps_.back().says), Notation::plain, {});
    Opinion& opinion = result_.opinion = bound_([&] { return judge_answer(whole_, result_.answer); });
    if (opinion.outcome == Outcome::invalid)  // its line could be read: it has other symbols than an answer
      opinion = wrong_answer(opinion.note, opinion.feedback.substr(0, opinion.feedback.find('\n')));
    if (opinion.outcome == Outcome::correct) {
      opinion.feedback = "Right, and each line follows from the one before.";
      if (!is_chain_) opinion.feedback = "Right, and each line follows from those before.";
      if (worst_line_.is_unreadable()) opinion.feedback += " A line could not be read, and was not needed.";
    } else if (steps_.size() > 1) {
      const bool is_exact = is_chain_ && std::none_of(steps_.begin() + 1, steps_.end(), [](const Step& step) {
                              return step.is_under_assumptions();
                            });
      opinion.feedback =
          std::string(is_chain_ ? "Each line follows from the one before"
                                : "Each line follows from those before") +
          ", but the last is not the answer" +
          (is_exact && opinion.outcome == Outcome::wrong ? ", and so the first is wrong already. " : ". ") +
          opinion.feedback;
    }
    add_marks(result_, begins_rightly(nothing));
  }

 private:
  void read() {
    constexpr std::size_t most = 40;
    LineReader reader(whole_.exercise);
    for (std::size_t k = 0; k < result_.lines.size(); ++k) {
      WorkingLine& line = result_.lines[k];
      const std::size_t before = steps_.size();
      try {
        line.status = reader.read(k, line.number, line.text, steps_);
        if (steps_.size() > before && steps_[before].law) line.remark = steps_[before].law->remark;
      } catch (const SyntaxError& error) {
        steps_.resize(before);
        worst_line_.add(line, LineStatus::unreadable, invalid(error, line.text), whole_.exercise);
      }
      if (steps_.size() <= most) continue;
      steps_.resize(before);
      worst_line_.add(line, LineStatus::unreadable,
                      invalid({"too_long"}, fmt::format("A working may have at most {} steps.", most)),
                      whole_.exercise);
      result_.lines.resize(k + 1);
    }
  }

  void judge(std::size_t k, Facts& facts) {
    const Step& step = steps_[k];
    WorkingLine& line = result_.lines[step.line];
    if (step.law) {
      is_chain_ = false;
      Facts of_law(whole_, steps_);
      for (const Relation& equation : step.law->equations) {
        of_law.add(equation);
        facts.add(equation);
      }
      if (step.says.sides.empty()) return;
      Opinion opinion = bound_([&] { return judge_implied(of_law, step.says, step.law->name); });
      if (opinion.outcome != Outcome::correct && of_law.size() < facts.size())
        opinion =
            bound_([&] { return judge_implied(facts, step.says, step.law->name + " and the lines before"); });
      if (!step.law->remark.empty()) opinion.feedback += " " + step.law->remark;
      return take(line, opinion, step, facts, about(step.says), LineStatus::cited);
    }
    const bool has_before = k > 0 && !steps_[k - 1].says.sides.empty();
    if (k == 0) {
      line.status = LineStatus::start;
      return facts.add(step.says);
    }
    const bool is_equation = !step.says.operators.empty();
    if (is_equation && is_given(step.says)) {
      is_chain_ = false;
      return take(line, right_answer(), step, facts, whole_.exercise, LineStatus::cited);
    }
    std::optional<Opinion> compared;
    const bool is_one_kind =
        has_before && (is_equation != steps_[k - 1].says.operators.empty() || !whole_.exercise.name.empty());
    if (is_one_kind) compared = bound_([&] { return judge_step(whole_, steps_[k - 1], step); });
    if (compared && compared->outcome == Outcome::correct)
      return take(line, right_answer(), step, facts, whole_.exercise, LineStatus::follows);
    const Relation says = equation_of(step.says, k);
    Opinion implied;
    if (!says.operators.empty() && !step.is_under_assumptions())
      implied = bound_([&] { return judge_implied(facts, says, "the lines before"); });
    if (implied.outcome == Outcome::correct) {
      is_chain_ = false;
      return take(line, implied, step, facts, whole_.exercise, LineStatus::follows);
    }
    const bool is_about_one =
        compared && (is_chain_ || says.operators.empty() || step.is_under_assumptions());
    if (is_about_one || (compared && implied.outcome == Outcome::undecided && exit_code(*compared) != 1))
      return take_compared(line, *compared, k, facts);
    if (says.operators.empty())
      implied = undecided("there is nothing before it with which it could be compared.");
    take(line, implied, step, facts, about(says), LineStatus::follows);
  }

  /// Returns whether the exercise gives an equation: theta = alpha, where its answer is the value there.
  bool is_given(const Relation& says) const {
    const Exercise& exercise = whole_.exercise;
    std::vector<std::string> given = exercise.given;
    for (const auto& [name, value] : exercise.answer.put) given.push_back(name + " = " + value);
    return std::ranges::any_of(given, [&](const std::string& text) {
      const Relation known = parse_relation(text, exercise.language());
      return known.operators == says.operators && is_same(known.sides[0], says.sides[0]) &&
             is_right(decide::decide({{known.sides[1]}, {}}, {{says.sides[1]}, {}}, whole_.symbols).verdict);
    });
  }

  /// Returns an equation as a step of its own, whose sides are compared.
  Exercise about(const Relation& says) const {
    Exercise step = step_of(whole_.exercise, says, says);
    step.pivot.clear();
    return step;
  }

  /// Returns an expression as an equation with the one before it, or with what is asked for.
  Relation equation_of(const Relation& says, std::size_t k) const {
    if (!says.operators.empty()) return says;
    if (k > 0 && steps_[k - 1].says.sides.size() == 1)
      return {{steps_[k - 1].says.sides[0], says.sides[0]}, {"="}};
    if (whole_.exercise.name.empty()) return says;
    return {{parse(whole_.exercise.name, whole_.exercise.language()), says.sides[0]}, {"="}};
  }

  /// Takes the opinion on a step from the line before.
  void take_compared(WorkingLine& line, Opinion opinion, std::size_t k, Facts& facts) {
    const Step &before = steps_[k - 1], &after = steps_[k];
    const std::string from =
        before.line == after.line ? "the part before it" : fmt::format("line {}", before.number);
    if (opinion.outcome == Outcome::undecided)
      opinion.feedback = fmt::format("Does it follow from {}? {}", from, opinion.feedback);
    if (exit_code(opinion) == 1)
      opinion.feedback = fmt::format("It does not follow from {}. {}", from, opinion.feedback);
    if (opinion.outcome == Outcome::correct_if) {
      opinion.outcome = Outcome::wrong;
      opinion.score = 0;
    }
    const auto [first, second] = of_one_kind(whole_.exercise, before, after);
    take(line, opinion, after, facts, step_of(whole_.exercise, first, second), LineStatus::follows);
  }

  void take(WorkingLine& line, const Opinion& opinion, const Step& step, Facts& facts, const Exercise& meant,
            LineStatus good) {
    if (opinion.outcome == Outcome::correct) {
      if (line.status == LineStatus::follows || line.status == LineStatus::start) line.status = good;
      if (!step.is_under_assumptions()) facts.add(step.says);
      return;
    }
    if (worst_line_.is_unreadable() && opinion.outcome == Outcome::wrong) worst_line_.spoil();
    LineStatus status = LineStatus::does_not_follow;
    if (opinion.outcome == Outcome::undecided) status = LineStatus::undecided;
    if (opinion.outcome == Outcome::invalid) status = LineStatus::unreadable;
    worst_line_.add(line, status, opinion, meant);
  }

  /// Returns whether the first statement is a law, or follows from the right answer.
  bool begins_rightly(const Facts& nothing) const {
    if (steps_.empty()) return false;
    if (steps_[0].law) return true;
    const Exercise& exercise = whole_.exercise;
    const Relation& answer = whole_.answer.relation;
    Relation says = steps_[0].says;
    Facts facts = nothing;
    if (!answer.operators.empty())
      facts.add(answer);
    else if (!exercise.name.empty() && is_symbol(parse(exercise.name, exercise.language())))
      facts.add({{parse(exercise.name, exercise.language()), answer.sides[0]}, {"="}});
    if (says.operators.empty()) says = {{says.sides[0], answer.sides[0]}, {"="}};
    return bound_([&] { return judge_implied(facts, says, ""); }).outcome == Outcome::correct;
  }

  const Prepared& whole_;
  Working& result_;
  const Bound& bound_;
  std::vector<Step> steps_;
  Worst worst_line_;
  bool is_chain_ = true;  ///< each line says the same as the one before
};

/// The words are in the order of LineStatus.
constexpr std::array status_words{"start",           "cited",     "name",      "follows",
                                  "does_not_follow", "undecided", "unreadable"};

}  // namespace

std::string to_string(LineStatus status) { return status_words[static_cast<std::size_t>(status)]; }

NumberedLines numbered_lines(const std::string& text) {
  std::istringstream stream(text);
  NumberedLines lines;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
    if (const std::string inside = trimmed(line); !inside.empty() && inside[0] != '#')
      lines.emplace_back(number, inside);
  return lines;
}

Working judge_working(const Exercise& exercise, const NumberedLines& lines, const Bound& bound) {
  Working result{{}, "", exercise, {}};
  for (const auto& [number, text] : lines) result.lines.push_back({number, text});
  if (lines.empty()) {
    result.opinion = refused(Trouble::empty);
    return result;
  }
  result.answer = lines.back().second;
  const Prepared whole = prepare(exercise);
  const bool is_number = exercise.kind == Kind::number && !whole.answer.relation.sides.empty();
  if (!is_number && !exercise.asks_for_formula())
    throw BadInput(
        fmt::format("'{0}' does not ask for a formula, so its working cannot be followed. Judge its answer "
                    "alone with {1} check {0} ANSWER",
                    exercise.id, exercise.course->program));
  if (is_number) {
    result.answer = trimmed(result.answer.substr(result.answer.rfind('=') + 1));
    judge_chains(whole, result, bound);
    add_marks(result, true);
  } else {
    Follower(whole, result, bound).run();
  }
  return result;
}

nlohmann::ordered_json working_json(const Exercise& exercise, const Working& working) {
  Json json = report_json(working.about, working.opinion), lines = Json::array();
  json["exercise"] = exercise.id;
  for (const WorkingLine& line : working.lines)
    lines.push_back({{"line", line.number},
                     {"text", line.text},
                     {"status", to_string(line.status)},
                     {"remark", line.remark.empty() ? Json() : Json(line.remark)}});
  json["lines"] = lines;
  return json;
}

std::string working_text(const Working& working) {
  std::string text;
  for (const WorkingLine& line : working.lines) {
    std::string word = to_string(line.status);
    std::ranges::replace(word, '_', ' ');
    text += fmt::format("{:>4}  {:<16}{}\n", line.number, word, printable_line(line.text));
    if (!line.remark.empty()) text += wrap(line.remark, 80, "      ", "      ");
  }
  if (working.opinion.outcome != Outcome::correct)
    text += fmt::format("Marks by step: {} of 1\n", working.opinion.score);
  return text;
}

}  // namespace rederive::classroom
