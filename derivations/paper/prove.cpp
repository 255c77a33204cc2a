#include <fmt/format.h>

#include <algorithm>
#include <derivations/decide/decide.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/text.hpp>
#include <derivations/paper/conditions.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/reader/generous.hpp>
#include <regex>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;

namespace {

const std::vector<std::string> greek{
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta",  "eta", "theta", "iota", "kappa", "lambda",
    "mu",    "nu",   "xi",    "rho",   "sigma",   "tau",   "phi", "chi",   "psi",  "omega", "upsilon",
    "Gamma", "Xi",   "Delta", "Theta", "Lambda",  "Sigma", "Phi", "Psi",   "Omega"};

/// Declares a letter as any real number, unless it is a symbol or the way in which one is written.
void declare_free(Symbols& symbols, const std::string& name) {
  const auto is_written_so = [&](const auto& entry) { return entry.second.unicode == name; };
  if (symbols.find(name) == nullptr && std::ranges::none_of(symbols.table(), is_written_so))
    symbols.declare({name, name, name, "1", all_numbers, "a real number", ""});
}

/// Letters stand for real numbers, alone or with an index or dots: x, x1, k_2, omega_0, betadot. Not so
/// alphaa, a slip of the pen.
void declare_names_in(const std::string& text, Symbols& symbols) {
  static const std::regex tail("([0-9]{0,3}|_[A-Za-z0-9]{1,3}|d?dot)(_[A-Za-z0-9]{1,3})?");
  if (text.size() > Limits{}.characters) return;  // the parser says so
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t start = 0, end; start < text.size(); start = end) {
    end = start;
    while (end < text.size() && belongs(text[end])) ++end;
    if (end == start || !is_letter(text[start])) {
      end = std::max(end, start + 1);
      continue;
    }
    const std::string name = text.substr(start, end - start);
    const auto after = text.find_first_not_of(' ', end);
    if (name.size() > 24 || name == "pi" || (after != std::string::npos && text[after] == '(')) continue;
    const bool indexed =
        name.size() > 1 && (name[1] == '_' || std::isdigit(static_cast<unsigned char>(name[1])) != 0);
    std::size_t stem = indexed || name.ends_with("dot") ? 1 : 0;
    for (const std::string& letter : greek)
      if (name.starts_with(letter)) stem = std::max(stem, letter.size());
    if (stem > 0 && std::regex_match(name.substr(stem), tail)) declare_free(symbols, name);
  }
}

/// Returns the only reading of what people write. Throws BadInput if there are several, with their texts.
Relation read_generously(const std::string& text, const Symbols& symbols) {
  const reader::Readings readings = reader::generous_readings(text, {.symbols = symbols});
  if (readings.all.size() == 1) return readings.all[0];
  throw BadInput("it is not clear " + readings.reason + ": write '" + print(readings.all[0]) + "' or '" +
                 print(readings.all[1]) + "'");
}

/// A statement that a user typed. Throws BadInput, with a caret.
Relation read(const std::string& text, const Symbols& symbols, bool generous = false) {
  return reading(text, symbols, [&] {
    Relation relation = generous ? read_generously(text, symbols) : parse_statement(text, symbols);
    for (const Tree& side : relation.sides) (void)lower(side, symbols);  // refuses what has no value at once
    return relation;
  });
}

}  // namespace

Relation read_assumption(const std::string& text, const Symbols& symbols) {
  const auto at = text.find("!=");
  if (at == std::string::npos) {
    Relation relation = read(text, symbols);
    if (relation.operators.empty())
      throw BadInput("the assumption '" + text + "' must be a relation such as x > 0");
    return relation;
  }
  // the right side is read at its place, so that an error is shown there
  const auto side = [&](const std::string& it) {
    return reading(text, symbols, [&] { return parse(it, symbols); });
  };
  return {{side(text.substr(0, at)), side(std::string(at + 2, ' ') + text.substr(at + 2))}, {"!="}};
}

namespace {

/// A request, after it was read.
struct Question {
  Symbols symbols;
  Relation left, right;
  std::vector<Relation> assumptions;
};

Question read(const Paper& paper, const ProveRequest& request) {
  Question question{declared_symbols(paper, request), {}, {}, {}};
  question.left = read(request.left, question.symbols, request.generous);
  question.right = read(request.right, question.symbols, request.generous);
  std::set<std::string> names = names_of(question.left);
  names.merge(names_of(question.right));
  for (const std::string& text : request.assumptions) {
    question.assumptions.push_back(read_assumption(text, question.symbols));
    names.merge(names_of(question.assumptions.back()));
    if (names_of(question.assumptions.back()).empty())
      throw BadInput("the assumption '" + text + "' contains no symbol");
  }
  for (const Relation& condition : declared_conditions_on(paper, names))
    question.assumptions.push_back(condition);
  if (contradict(question.assumptions, question.symbols))
    throw BadInput(
        "no values in the ranges satisfy all assumptions: they contradict each other, or have no value");
  return question;
}

void check_order(const ProveRequest& request, const Question& question) {
  if (request.order.has_value() == request.small.empty())
    throw BadInput("--small and --order must be given together");
  if (request.order && (*request.order < 0 || *request.order > 12))
    throw BadInput(fmt::format("--order must be from 0 to 12, but it is {}", *request.order));
  for (const std::string& name : request.small) {
    const Symbol* symbol = question.symbols.find(name);
    if (symbol == nullptr)
      throw BadInput("--small names '" + printable_line(name) + "', which is not a symbol of the statements");
    if (std::count(request.small.begin(), request.small.end(), name) > 1)
      throw BadInput("--small names '" + name + "' twice");
    Interval range = parse_range(symbol->range);
    range.low.closed = range.high.closed = true;
    if (!range.contains_zero())
      throw BadInput("--small names '" + name + "', which is in " + symbol->range +
                     ", so it cannot be small");
    for (const Relation& a : question.assumptions)
      if (a.operators[0] == "=" && (a.sides[0]->text == name || a.sides[1]->text == name))
        throw BadInput("--small names '" + name +
                       "', which an assumption replaces; name the symbols of its value");
  }
}

Proof decide_once(const Question& q, const ProveRequest& request) {
  Proof proof = decide::decide(q.left, q.right, q.symbols, {}, q.assumptions);
  if (request.order && proof.verdict != Verdict::proved && proof.verdict != Verdict::proved_under)
    proof = decide_to_order(q.left, q.right, request.small, *request.order, q.symbols, {}, q.assumptions);
  return proof;
}

/// Returns the link as a reader writes it: 0 < x is x > 0, and a != b is a - b != 0.
Relation for_a_reader(const Relation& link, const Symbols& symbols) {
  const auto side = [&](std::size_t k) { return to_tree(lower(link.sides[k], symbols), symbols); };
  std::string op = link.operators[0];
  const bool turn =
      op != "=" && link.sides[1]->kind == Node::Kind::symbol && link.sides[0]->kind != Node::Kind::symbol;
  if (op == "!=")
    return {{to_tree(lower(difference(link.sides[0], link.sides[1]), symbols), symbols), zero()}, {op}};
  if (turn) op[0] = op[0] == '<' ? '>' : '<';
  return {{side(turn ? 1 : 0), side(turn ? 0 : 1)}, {op}};
}

bool has_condition(const Proof& proof, const Relation& condition) {
  return std::ranges::any_of(proof.side_conditions,
                             [&](const Relation& other) { return print(other) == print(condition); });
}

/// The assumed inequalities without which the proof does not go through, or needs another condition in their
/// place, and the declared ranges without which it does not go through.
std::vector<Relation> conditions_used(Question q, const ProveRequest& request, const Proof& proof) {
  constexpr std::size_t most = 10;
  std::vector<Relation> used;
  const auto holds_too = [&](const Question& other, std::size_t& tried) {
    if (tried++ >= most) return false;
    const Proof again = decide_once(other, request);
    return again.verdict == proof.verdict &&
           std::ranges::all_of(again.side_conditions,
                               [&](const Relation& condition) { return has_condition(proof, condition); });
  };
  std::vector<Relation> links;
  for (const Relation& a : q.assumptions)
    for (Relation& link : links_of(a)) links.push_back(std::move(link));
  q.assumptions = links;
  for (std::size_t k = 0, tried = 0; k < q.assumptions.size();) {
    if (q.assumptions[k].operators[0] == "=") {
      ++k;
      continue;
    }
    Question other = q;
    other.assumptions.erase(other.assumptions.begin() + static_cast<std::ptrdiff_t>(k));
    if (holds_too(other, tried)) {
      q = std::move(other);
      continue;
    }
    used.push_back(for_a_reader(q.assumptions[k], q.symbols)), ++k;
  }
  std::set<std::string> names = names_of(q.left);
  names.merge(names_of(q.right));
  for (const Relation& a : q.assumptions) names.merge(names_of(a));
  std::size_t tried = 0;
  for (const std::string& name : names) {
    const std::string range = q.symbols.find(name)->range;
    if (range == all_numbers) continue;
    Question other = q;
    other.symbols.narrow(name, {"-inf", "inf"});
    if (holds_too(other, tried)) {
      q = std::move(other);
      continue;
    }
    const Range ends = read_range(range);
    const auto end = [&](const char* op, const std::string& value) {
      used.push_back({{parse(name, q.symbols), parse(value, q.symbols)}, {op}});
    };
    if (ends.lower != "-inf") end(ends.lower_closed ? ">=" : ">", ends.lower);
    if (ends.upper != "inf") end(ends.upper_closed ? "<=" : "<", ends.upper);
  }
  return used;
}

}  // namespace

Symbols declared_symbols(const Paper& paper, const ProveRequest& request) {
  Symbols symbols = paper.symbols;
  for (const std::string& name : paper.free_letters)
    symbols.declare({name, name, name, symbols.find(name)->unit, all_numbers, "a real number", ""});
  for (char c = 'a'; c <= 'z'; ++c) declare_free(symbols, std::string(1, c));
  for (char c = 'A'; c <= 'Z'; ++c) declare_free(symbols, std::string(1, c));
  for (const std::string& letter : greek) declare_free(symbols, letter);
  declare_names_in(request.left, symbols);
  declare_names_in(request.right, symbols);
  for (const std::string& text : request.assumptions) declare_names_in(text, symbols);
  return symbols;
}

Problem problem_of(const Paper& paper, const ProveRequest& request) {
  const Question q = read(paper, request);
  return {q.left, q.right, q.assumptions, q.symbols};
}

Proof decide(const Paper& paper, const ProveRequest& request) {
  const Question question = read(paper, request);
  check_order(request, question);
  Proof proof = decide_once(question, request);
  if (proof.verdict == Verdict::refuted || proof.verdict == Verdict::undecided) return proof;
  for (const Relation& condition : conditions_used(question, request, proof))
    if (!has_condition(proof, condition)) proof.side_conditions.push_back(condition);
  return proof;
}

std::string word_of(Mistake mistake) {
  // clang-format off
  constexpr const char* words[] = {
    "syntax", "character", "empty", "unknown_symbol", "unknown_function", "arguments",
    "implicit_multiplication", "relation", "too_long", "too_deep", "too_large", "undefined",
    "symbol_not_given", "expression_wanted", "equation_wanted", "one_relation_wanted", "value_wanted",
    "number_wanted", "not_real", "unit", "unit_not_wanted", "unknown_unit", "ambiguous_unit",
    "decimal_comma", "assumption"};
  // clang-format on
  return words[static_cast<int>(mistake)];
}

std::string word_of(By by) {
  constexpr const char* words[] = {"", "identity", "sign", "points", "expansion"};
  return words[static_cast<int>(by)];
}

std::string explain(const SyntaxError& error, std::string_view text, const Symbols& symbols) {
  const std::string message = error.what() + reader::advice(error, text, symbols);
  return explain(SyntaxError(error.mistake, error.position, message), text);
}

std::string explain(const SyntaxError& error, std::string_view text) {
  constexpr std::size_t before = 80, after = 60;  // bytes
  const std::size_t position = std::min(error.position, text.size());
  const auto is_inside = [&](std::size_t at) { return at < text.size() && (text[at] & 0xC0) == 0x80; };
  std::size_t first = text.substr(0, position).rfind('\n') + 1,  // 0 on the first line
      last = std::min(text.find('\n', position), text.size());
  const bool is_cut = position - first > before, is_cut_behind = last - position > after;
  if (is_cut) first = position - before;
  if (is_cut_behind) last = position + after;
  while (is_cut && is_inside(first)) ++first;
  while (is_inside(last)) ++last;
  std::string indent = is_cut ? " " : "";
  for (std::size_t at = first; at < position;
       at += std::max<std::size_t>(first_character(text.substr(at)).bytes, 1)) {
    const char32_t code = first_character(text.substr(at)).code;
    if (code < 0x300 || code >= 0x370) indent += ' ';  // others stand above the character before
  }
  return std::string(error.what()) + "\n  " + (is_cut ? "…" : "") +
         printable_line(std::string(text.substr(first, last - first))) + (is_cut_behind ? "…" : "") + "\n  " +
         indent + "^";
}

std::vector<std::string> in_words(const Witness& witness) {
  std::vector<std::string> words;
  for (const auto& [name, value] : witness.at) {
    const auto bounds = witness.between.find(name);
    const auto exact = witness.exactly.find(name);
    if (bounds != witness.between.end())
      words.push_back(fmt::format("{} between {} and {} where {}", name, bounds->second.first,
                                  bounds->second.second, witness.solves));
    else if (exact != witness.exactly.end() || value.find('.') == std::string::npos)
      words.push_back(name + " = " + (exact != witness.exactly.end() ? exact->second : value));
    else
      words.push_back(name + " ≈ " + value);
  }
  return words;
}

}  // namespace rederive::paper
