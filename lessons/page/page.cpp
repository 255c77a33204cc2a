#include <algorithm>
#include <cctype>
#include <derivations/kernel/scripts.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <derivations/rocking_block/table.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>
#include <stdexcept>
#include <utility>

namespace rederive {
namespace {

const std::vector<Row>& all_rows() {
  static const std::vector<Row> rows = read_rows(equations_file());
  return rows;
}

/// Tangents as quotients, double angles halved, and what cancels cancelled, where that makes the expression
/// shorter.
GiNaC::ex simplified(const GiNaC::ex& expression) {
  const GiNaC::ex any = GiNaC::wild();
  const GiNaC::lst rules{GiNaC::tan(any) == GiNaC::sin(any) / GiNaC::cos(any),
                         GiNaC::sin(2 * any) == 2 * GiNaC::sin(any) * GiNaC::cos(any)};
  const GiNaC::ex shorter = expression.subs(rules).normal();
  return print(shorter).size() < print(expression).size() ? shorter : expression;
}

/// Whether a step's words begin a sentence: they are written with a capital letter then. Small letters go on
/// with the sentence before.
bool begins_sentence(const std::string& words) {
  const unsigned char first = words.empty() ? 'A' : static_cast<unsigned char>(words[0]);
  return first >= 0x80 || !std::islower(first);
}

/// Whether words lead into what follows them without a mark: "and", "so that the potential is".
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

Derivation derived(const std::string& id) {
  const auto& table = derivation_table();
  const auto found = table.find(id);
  if (found == table.end()) throw std::out_of_range("there is no derivation of equation (" + id + ")");
  return found->second();
}

Entry judged(const std::string& id) {
  const auto& rows = all_rows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.id == id; });
  if (found == rows.end()) throw std::out_of_range("the ledger has no row (" + id + ")");
  return judge(*found, rows);
}

GiNaC::ex with(const GiNaC::ex& expression, const Values& values) {
  GiNaC::exmap map;
  for (const auto& [name, value] : values) map[paper_symbols()[name]] = lower(parse(value));
  return expression.subs(map);
}

Relation derived_with(const std::string& id, const Values& values) {
  const Derivation derivation = derived(id);
  const auto side = [&](const GiNaC::ex& value) { return to_tree(simplified(with(value, values))); };
  return {{side(derivation.left), side(derivation.right)}, {derivation.relation}};
}

Relation printed_with(const std::string& id, const Values& values) {
  const Relation printed = parse_relation(judged(id).row.printed);
  const std::size_t last = printed.sides.size() - 1;
  const auto side = [&](std::size_t i) { return to_tree(simplified(with(lower(printed.sides[i]), values))); };
  return {{side(last - 1), side(last)}, {printed.operators.back()}};
}

double number_of(const GiNaC::ex& expression, const Values& values) {
  const GiNaC::ex value = with(expression, values).evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(value))
    throw std::invalid_argument("the value is not a number: " + print(value));
  return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
}

void Page::say(const std::string& text) {
  for (auto& paragraph : paragraphs(text)) blocks_.push_back(Paragraph{std::move(paragraph)});
}

void Page::show(const Relation& relation, const std::string& number, const std::string& mark) {
  blocks_.push_back(Formula{relation, number, mark});
}

void Page::show(const GiNaC::ex& expression) { show(Relation{{to_tree(expression)}, {}}); }

void Page::show(const GiNaC::ex& left, const std::string& relation, const GiNaC::ex& right,
                const std::string& number) {
  show(Relation{{to_tree(left), to_tree(right)}, {relation}}, number);
}

void Page::result(const std::string& id) { show(derived_relation(derived(id)), id); }

void Page::argue(const std::string& id, const std::string& known) { argue(derived(id), id, known); }

void Page::argue(const Derivation& derivation, const std::string& id, const std::string& known) {
  const auto text_of = [](const Step& step) { return print(step.left) + step.relation + print(step.right); };
  std::size_t first = 0;
  if (!known.empty()) {
    const Derivation shown = derived(known);
    const std::string conclusion = text_of({"", shown.left, shown.right, shown.relation});
    for (std::size_t i = 0; i < derivation.steps.size(); ++i)
      if (text_of(derivation.steps[i]) == conclusion) first = i + 1;
    if (first == 0) throw std::invalid_argument("(" + known + ") is not on the way to (" + id + ")");
    say("Begin with (" + known + ").");
  }
  std::vector<Step> steps;
  for (std::size_t i = first; i < derivation.steps.size(); ++i) {
    const Step& step = derivation.steps[i];
    if (told_.insert(step.says + text_of(step)).second || i + 1 == derivation.steps.size())
      steps.push_back(step);
  }
  std::string words;  // up to the next formula
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const bool formula = !step.left.is_zero() || !step.right.is_zero(), last = i + 1 == steps.size();
    const bool goes_on = !last && !begins_sentence(steps[i + 1].says);
    const bool fresh = i == 0 || begins_sentence(step.says);
    words += (words.empty() ? "" : " ") + as_sentence(marked(step.says), fresh, formula, goes_on);
    if (!formula && !last) continue;
    say(std::exchange(words, ""));
    if (formula)
      show(Relation{{to_tree(step.left), to_tree(step.right)}, {step.relation}}, last ? id : "",
           goes_on ? "," : ".");
  }
}

void Page::verdict(const std::string& id) { blocks_.push_back(Judgement{judged(id)}); }

void Page::compare(const Relation& left, const Relation& right) {
  const Proof proof = decide(left, right, paper_symbols());
  std::string verdict = to_string(proof.verdict);
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  std::string text = "The decision procedure says: *" + verdict + "*";
  if (!proof.factor.empty() && proof.factor != "1") text += ", up to the factor $" + proof.factor + "$";
  say(text + ".");
}

void Page::lemma(const std::string& id) {
  for (const Lemma& theorem : shipped_theorems())
    if (theorem.name == id)
      return void(blocks_.push_back(CoqLemma{theorem.id, text_of(theorem),
                                             "`" + id + "` in `derivations/kernel/" + theorem.file + "`"}));
  const auto found = lemma_of(judged(id));
  if (!found || found->text.empty())
    throw std::invalid_argument("there is no lemma of equation (" + id + ")");
  blocks_.push_back(CoqLemma{id, found->text, "`build/bin/ledger show " + id + " --coq`"});
}

void Page::workbench(const std::string& options) {
  say("This case, to play with:");
  blocks_.push_back(Commands{{"build/bin/rocking response " + options}, options});
}

}  // namespace rederive
