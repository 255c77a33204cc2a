#include <algorithm>
#include <cctype>
#include <derivations/kernel/scripts.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <stdexcept>
#include <utility>

namespace rederive::page {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;
using namespace kernel;
namespace {

/// Tangents as quotients, double angles halved, and what cancels cancelled, where that makes the expression
/// shorter.
GiNaC::ex simplified(const GiNaC::ex& expression, const Symbols& symbols) {
  const GiNaC::ex any = GiNaC::wild();
  const GiNaC::lst rules{GiNaC::tan(any) == GiNaC::sin(any) / GiNaC::cos(any),
                         GiNaC::sin(2 * any) == 2 * GiNaC::sin(any) * GiNaC::cos(any)};
  const GiNaC::ex shorter = expression.subs(rules).normal();
  const auto size = [&](const GiNaC::ex& e) { return print(e, Notation::plain, symbols).size(); };
  return size(shorter) < size(expression) ? shorter : expression;
}

/// Returns whether a step's words begin a sentence and are written with a capital letter. Words with a small
/// letter continue the sentence before.
bool begins_sentence(const std::string& words) {
  const unsigned char first = words.empty() ? 'A' : static_cast<unsigned char>(words[0]);
  return first >= 0x80 || !std::islower(first);
}

/// Returns whether words lead into what follows them without a mark: "and", "so that the potential is".
bool leads_on(const std::string& words) {
  static const std::set<std::string> links{"and", "with", "is",   "by",   "at", "in",    "into",
                                           "put", "are",  "from", "that", "so", "where", "Hence"};
  return links.contains(words.substr(words.rfind(' ') + 1));
}

/// A step's words as part of a text; `fresh` where a sentence has to begin, `goes_on` where it does not end.
std::string as_sentence(std::string words, bool fresh, bool formula, bool goes_on) {
  if (words.empty()) return words;
  const bool ended = std::string_view(".:?,").find(words.back()) != std::string_view::npos;
  const std::string mark = ended || (formula && leads_on(words)) ? ""
                           : formula                             ? (words.back() == ')' ? "," : ":")
                           : goes_on                             ? ";"
                                                                 : ".";
  if (fresh) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + mark;
}

}  // namespace

Derivation Page::derived(const std::string& id) const {
  if (auto derivation = derivation_of(paper_, id)) return *std::move(derivation);
  throw std::out_of_range("there is no derivation of equation (" + id + ")");
}

Relation Page::printed(const std::string& id) const {
  return parse_relation(row_of(paper_, id).printed, paper_.symbols);
}

GiNaC::ex Page::with(const GiNaC::ex& expression, const Values& values) const {
  GiNaC::exmap map;
  for (const auto& [name, value] : values)
    map[paper_.symbols[name]] = lower(parse(value, paper_.symbols), paper_.symbols);
  return expression.subs(map);
}

Relation Page::derived_with(const std::string& id, const Values& values) const {
  const Derivation derivation = derived(id);
  const auto side = [&](const GiNaC::ex& value) {
    return to_tree(simplified(with(value, values), paper_.symbols), paper_.symbols);
  };
  return {{side(derivation.left), side(derivation.right)}, {derivation.relation}};
}

Relation Page::printed_with(const std::string& id, const Values& values) const {
  const Relation relation = printed(id);
  const std::size_t last = relation.sides.size() - 1;
  const auto side = [&](std::size_t i) {
    const GiNaC::ex value = with(lower(relation.sides[i], paper_.symbols), values);
    return to_tree(simplified(value, paper_.symbols), paper_.symbols);
  };
  return {{side(last - 1), side(last)}, {relation.operators.back()}};
}

double Page::number_of(const GiNaC::ex& expression, const Values& values) const {
  const GiNaC::ex value = with(expression, values).evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(value))
    throw std::invalid_argument("the value is not a number: " +
                                print(value, Notation::plain, paper_.symbols));
  return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
}

void Page::say(const std::string& text) {
  for (auto& paragraph : paragraphs(text)) blocks_.push_back(Paragraph{std::move(paragraph)});
}

void Page::show(const Relation& relation, const std::string& number, const std::string& mark) {
  blocks_.push_back(Formula{relation, number, mark});
}

void Page::show(const GiNaC::ex& expression) { show(Relation{{to_tree(expression, paper_.symbols)}, {}}); }

void Page::show(const GiNaC::ex& left, const std::string& relation, const GiNaC::ex& right,
                const std::string& number) {
  show(Relation{{to_tree(left, paper_.symbols), to_tree(right, paper_.symbols)}, {relation}}, number);
}

void Page::result(const std::string& id) { show(derived_relation(id), id); }

void Page::argue(const std::string& id, const std::string& known) { argue(derived(id), id, known); }

void Page::argue(const Derivation& with_ids, const std::string& id, const std::string& known) {
  const Derivation derivation = with_citations(paper_, with_ids);
  const Symbols& symbols = paper_.symbols;
  const auto text_of = [&](const Step& step) {
    return print(step.left, Notation::plain, symbols) + step.relation +
           print(step.right, Notation::plain, symbols);
  };
  std::size_t first = 0;
  if (!known.empty()) {
    const Derivation shown = derived(known);
    const std::string conclusion = text_of({"", shown.left, shown.right, shown.relation});
    for (std::size_t i = 0; i < derivation.steps.size(); ++i)
      if (text_of(derivation.steps[i]) == conclusion) first = i + 1;
    if (first == 0) throw std::invalid_argument("(" + known + ") is not on the way to (" + id + ")");
    say("Begin with (" + known + ").");
  }
  const auto has_formula = [](const Step& step) { return !step.left.is_zero() || !step.right.is_zero(); };
  const std::size_t count = derivation.steps.size();
  std::vector<std::string> told(count + 1);  // from each step to the formula that it leads to
  for (std::size_t i = count; i-- > first;) {
    const Step& step = derivation.steps[i];
    told[i] = step.says + text_of(step) + (has_formula(step) ? "" : told[i + 1]);
  }
  std::vector<Step> steps;
  for (std::size_t i = first; i < count; ++i)
    if (told_.insert(told[i]).second || i + 1 == count) steps.push_back(derivation.steps[i]);
  std::string words;  // up to the next formula
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const bool formula = has_formula(step), last = i + 1 == steps.size();
    const bool goes_on = !last && !begins_sentence(steps[i + 1].says);
    const bool fresh = i == 0 || begins_sentence(step.says);
    words += (words.empty() ? "" : " ") + as_sentence(marked(step.says, paper_), fresh, formula, goes_on);
    if (!formula && !last) continue;
    say(std::exchange(words, ""));
    if (formula)
      show(Relation{{to_tree(step.left, symbols), to_tree(step.right, symbols)}, {step.relation}},
           last ? id : "", goes_on ? "," : ".");
  }
}

void Page::verdict(const std::string& id) { blocks_.push_back(findings(judged(paper_, id), paper_)); }

void Page::compare(const Relation& left, const Relation& right) {
  const Proof proof = decide::decide(left, right, paper_.symbols);
  std::string verdict = to_string(proof.verdict);
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  std::string text = "The decision procedure says: *" + verdict + "*";
  if (!proof.factor.empty() && proof.factor != "1") text += ", up to the factor $" + proof.factor + "$";
  say(text + ".");
}

void Page::lemma(const std::string& id) {
  for (const Lemma& theorem : theorems_of(paper_).lemmas)
    if (theorem.name == id)
      return void(blocks_.push_back(Theorem{theorem.id, text_of(paper_, theorem),
                                            "`" + id + "` in `derivations/kernel/" + theorem.file + "`"}));
  const auto found = lemma_of(paper_, judged(paper_, id));
  if (!found || found->text.empty())
    throw std::invalid_argument("there is no lemma of equation (" + id + ")");
  blocks_.push_back(Theorem{id, found->text, "`" + command_on(paper_, "ledger show " + id + " --coq") + "`"});
}

void Page::workbench(const std::string& options) {
  say("This case, to play with:");
  blocks_.push_back(Commands{{"build/bin/rocking response " + options}, options});
}

Coverage read_coverage(const Paper& paper) {
  constexpr int most_lessons = 99;
  std::vector<std::string> ids;
  for (const Row& row : rows_of(paper)) ids.push_back(row.id);
  Coverage lessons;
  for (TomlTable& table : tables_of(data_folder() / "equations_of_lessons.toml", "lesson")) {
    const auto number = table.whole("number", 1, most_lessons);
    const std::vector<std::string> equations = table.texts("equations");
    table.done();
    if (!number) table.fail("'number' is missing");
    for (const std::string& id : equations) table.check_word("equations", id, ids);
    if (!lessons.emplace(static_cast<int>(*number), equations).second)
      table.fail(fmt::format("lesson {} is listed twice", *number), "number");
  }
  return lessons;
}

int lesson_with(const std::string& id, const Coverage& coverage) {
  for (const auto& [lesson, ids] : coverage)
    if (std::ranges::find(ids, id) != ids.end()) return lesson;
  return 0;
}

}  // namespace rederive::page
