// equations.toml → rows. Every complaint names the file, the line, the row and what would be right.
#include <derivations/paper/rows.hpp>
#include <derivations/program/toml_table.hpp>
#include <set>
#include <string_view>
#include <unordered_map>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace program;

namespace {

using Words = std::vector<std::string>;

/// The words are in the order of RowKind.
const Words kinds{"equation", "inequality", "definition", "result"};
/// The words are in the order of RowError.
const Words error_words{"sign",     "factor",       "argument",   "subscript",      "swapped symbols",
                        "symbol",   "missing_term", "extra_term", "missing_factor", "extra_factor",
                        "exponent", "reciprocal",   "function",   "relation",       "limit",
                        "domain",   "dimension",    "constant",   "missing_dot"};

constexpr std::string_view joint = " and ";  ///< between several errors

std::vector<RowError> errors_in(const TomlTable& table, const std::string& text) {
  std::vector<RowError> errors;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(joint, start), text.size());
    errors.push_back(table.one_of<RowError>("error", text.substr(start, end - start), error_words));
    start = end + joint.size();
  }
  return errors;
}

/// Returns the verdicts that a row may be expected to have, in the order of decide::Verdict.
Words verdicts() {
  Words words;
  for (int k = 0; k <= static_cast<int>(Verdict::undecided); ++k)
    words.push_back(to_string(static_cast<Verdict>(k)));
  return words;
}

Row read_row(TomlTable& table) {
  Row row;
  row.id = table.needed_line("id");
  if (!row.id.empty()) table.call_it("row " + row.id);
  row.section = table.text("section");
  row.kind = table.needed_one_of<RowKind>("kind", kinds);
  row.printed = table.text("printed");
  row.statement = table.text("statement");
  row.latex = table.text("latex");
  row.domain = table.text("domain");
  row.expected = table.needed_one_of<Verdict>("expected", verdicts());
  const std::string error = table.text("error");
  row.consequence = table.text("consequence");
  row.note = table.text("note");
  row.scan_repaired = table.text("scan_repaired");
  row.follows_from = table.texts("follows_from");
  row.assume = table.lines("assume");
  row.order = static_cast<int>(table.whole("order", 1, 12).value_or(0));
  row.small = table.line("small");
  table.done();
  for (const std::string& key : table.keys()) row.places[key] = table.where(key);
  row.places[""] = table.where();
  if ((row.order == 0) != row.small.empty())
    table.fail("'order' and 'small' must be given together", row.order == 0 ? "small" : "order");
  row.errors = errors_in(table, error);
  if ((row.kind == RowKind::result) != !row.statement.empty())
    table.fail("a row of kind 'result', and no other, has a 'statement' of ours", "statement");
  return row;
}

/// Follows, from row to row, where each of them follows from, and refuses a way that comes back to a row on
/// it.
class Ancestry {
 public:
  Ancestry(const std::vector<Row>& rows, const std::vector<TomlTable>& tables)
      : rows_(rows), tables_(tables) {
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (!numbers_.emplace(rows[k].id, k).second)
        tables[k].fail(fmt::format("a second row has this id; the first is at {}",
                                   tables[numbers_.at(rows[k].id)].where()),
                       "id");
  }

  void check() {
    for (std::size_t start = 0; start < rows_.size(); ++start) {
      enter(start);
      while (!path_.empty()) go_on();
    }
  }

 private:
  struct Step {
    std::size_t row, next;  ///< next: the source that is looked at next
  };
  enum class State { unseen, on_the_way, done };

  void enter(std::size_t row) {
    if (states_[row] == State::unseen) path_.push_back({row, 0});
    if (states_[row] == State::on_the_way) refuse_cycle(row);
    states_[row] = std::max(states_[row], State::on_the_way);
  }

  void go_on() {
    const auto [row, next] = path_.back();
    const std::vector<std::string>& sources = rows_[row].follows_from;
    if (next == sources.size()) {
      states_[row] = State::done;
      path_.pop_back();
      return;
    }
    ++path_.back().next;
    const auto source = numbers_.find(sources[next]);
    if (source == numbers_.end())
      tables_[row].fail(fmt::format("it follows from '{}', which is not a row{}", sources[next],
                                    did_you_mean(nearest(sources[next], ids()))),
                        "follows_from");
    enter(source->second);
  }

  [[noreturn]] void refuse_cycle(std::size_t row) const {
    std::string way;
    for (auto step = std::ranges::find(path_, row, &Step::row); step != path_.end(); ++step)
      way += rows_[step->row].id + " from ";
    tables_[row].fail("it follows from itself: " + way + rows_[row].id, "follows_from");
  }

  std::vector<std::string> ids() const {
    std::vector<std::string> all;
    for (const Row& row : rows_) all.push_back(row.id);
    return all;
  }

  const std::vector<Row>& rows_;
  const std::vector<TomlTable>& tables_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<State> states_ = std::vector<State>(rows_.size(), State::unseen);
  std::vector<Step> path_;
};

/// Sets `rests_on_it` of all rows, in the order of the paper.
void set_dependents(std::vector<Row>& rows) {
  std::unordered_map<std::string_view, std::vector<std::size_t>> followers;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const std::string& from : rows[k].follows_from) followers[from].push_back(k);
  for (Row& row : rows) {
    std::set<std::size_t> reached;
    for (std::vector<std::string_view> open{row.id}; !open.empty();) {
      const std::string_view next = open.back();
      open.pop_back();
      for (const std::size_t k : followers[next])
        if (reached.insert(k).second) open.push_back(rows[k].id);
    }
    for (const std::size_t k : reached) row.rests_on_it.push_back(rows[k].id);
  }
}

}  // namespace

std::string to_string(RowKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::string in_words(const std::vector<RowError>& errors) {
  std::string words;
  for (const RowError error : errors)
    words.append(words.empty() ? "" : joint).append(error_words[static_cast<std::size_t>(error)]);
  return words;
}

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::vector<TomlTable> tables = tables_of(file, "equation");
  for (TomlTable& table : tables) rows.push_back(read_row(table));
  Ancestry(rows, tables).check();
  set_dependents(rows);
  return rows;
}

}  // namespace rederive::paper
