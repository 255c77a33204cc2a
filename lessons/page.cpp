#include <derivations/algebra/print.hpp>
#include <derivations/rocking_block/table.hpp>
#include <lessons/lesson.hpp>
#include <lessons/prose.hpp>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace rederive {
namespace {

const std::vector<Row>& all_rows() {
  static const std::vector<Row> rows = read_rows(equations_file());
  return rows;
}

/// A step's words with a capital letter, and with a colon where a formula follows.
std::string as_sentence(std::string words, bool formula) {
  if (words.empty()) return words;
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  const bool ended = words.back() == '.' || words.back() == ':' || words.back() == '?';
  return ended ? words : words + (formula ? ":" : ".");
}

}  // namespace

Derivation derived(const std::string& id) {
  const auto& table = derivation_table();
  const auto found = table.find(id);
  if (found == table.end()) throw std::out_of_range("no derivation of equation (" + id + ")");
  return found->second();
}

Entry judged(const std::string& id) {
  const auto& rows = all_rows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.id == id; });
  if (found == rows.end()) throw std::out_of_range("the ledger has no row (" + id + ")");
  return judge(*found, rows);
}

Relation relation_of(const Derivation& derivation) {
  return {{to_tree(derivation.left), to_tree(derivation.right)}, {derivation.relation}};
}

void Page::say(const std::string& text) {
  for (auto& paragraph : paragraphs(text)) blocks_.push_back(Paragraph{std::move(paragraph)});
}

void Page::show(const Relation& relation, const std::string& number) {
  blocks_.push_back(Formula{relation, number});
}

void Page::show(const GiNaC::ex& expression) { show(Relation{{to_tree(expression)}, {}}); }

void Page::show(const GiNaC::ex& left, const std::string& relation, const GiNaC::ex& right,
                const std::string& number) {
  show(Relation{{to_tree(left), to_tree(right)}, {relation}}, number);
}

void Page::result(const std::string& id) { show(relation_of(derived(id)), id); }

void Page::argue(const std::string& id) {
  const Derivation derivation = derived(id);
  for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
    const Step& step = derivation.steps[i];
    const bool formula = !step.left.is_zero() || !step.right.is_zero();
    const bool last = i + 1 == derivation.steps.size() && formula;
    say(as_sentence(marked(step.says), formula));
    if (formula) show(step.left, step.relation, step.right, last ? id : "");
  }
}

void Page::verdict(const std::string& id) { blocks_.push_back(Judgement{judged(id)}); }

void Page::table(std::vector<std::string> header, std::vector<std::vector<std::string>> rows) {
  blocks_.push_back(Table{std::move(header), std::move(rows)});
}

void Page::figure(Figure figure) { blocks_.push_back(std::move(figure)); }

void Page::commands(std::vector<std::string> lines) { blocks_.push_back(Commands{std::move(lines)}); }

void Page::points(std::vector<std::string> items) { blocks_.push_back(Points{std::move(items)}); }

}  // namespace rederive
