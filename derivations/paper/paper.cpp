#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/paper.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <set>
#include <stdexcept>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace mechanics;
using namespace program;

namespace {

bool has_symbols(const Tree& tree) {
  return (tree->kind == Node::Kind::symbol && tree->text != "pi") ||
         std::ranges::any_of(tree->children, has_symbols);
}

/// A number as an end of a range that is not beyond `end`, an end of the range of another symbol: the end of
/// that one, or infinity.
std::string number_beyond(const Tree& end, bool is_upper, const Symbols& symbols) {
  const std::string infinity = is_upper ? "inf" : "-inf";
  if (end->kind != Node::Kind::symbol) return infinity;
  const Range other = read_range(symbols.find(end->text)->range);
  const std::string& number = is_upper ? other.upper : other.lower;
  return number.ends_with("inf") || has_symbols(parse(number, symbols)) ? infinity : number;
}

/// Makes numbers of the ends of a symbol's range, and conditions of those that are none.
void settle_range(const std::string& name, Symbols& symbols, std::vector<Relation>& conditions) {
  Range range = read_range(symbols.find(name)->range);
  for (const bool is_upper : {false, true}) {
    std::string& end = is_upper ? range.upper : range.lower;
    if (end == "inf" || end == "-inf") continue;
    const Tree tree = parse(end, symbols);
    if (!has_symbols(tree)) continue;
    const bool is_closed = is_upper ? range.upper_closed : range.lower_closed;
    const std::string sign = is_upper ? "<" : ">";
    conditions.push_back({{make_tree(Node::Kind::symbol, name), tree}, {is_closed ? sign + "=" : sign}});
    end = number_beyond(tree, is_upper, symbols);
  }
  symbols.narrow(name, range);
}

void check_range(const std::string& range) {
  if (range == all_numbers || range == "(0, inf)" || range == "[0, inf)") return;
  if (parse_range(range).is_empty()) throw std::invalid_argument("the range " + range + " is empty");
}

/// Refuses a second symbol that is written as another one is, or as another one is called.
void check_spelling(const Symbol& symbol, const Symbols& symbols) {
  for (const auto& [name, other] : symbols.table()) {
    if (name == symbol.name || (symbol.unicode != other.unicode && symbol.unicode != name)) continue;
    throw std::invalid_argument("the symbols " + name + " and " + symbol.name + " are both written '" +
                                symbol.unicode + "'; each needs a spelling of its own in Unicode");
  }
}

/// What `check` finds wrong, with the name of the symbol before it.
template <class Check>
void about(const Symbol& symbol, const Check& check) {
  try {
    check();
  } catch (const std::exception& error) {
    throw std::invalid_argument("the symbol " + symbol.name + ": " + error.what());
  }
}

/// Refuses a row that cites itself, or one that does. `path` leads from the first row to this one.
void check_citations(const Derivations& derivations, const std::string& id, std::vector<std::string>& path,
                     std::set<std::string>& done) {
  if (std::ranges::find(path, id) != path.end())
    throw std::logic_error("(" + id + ") is derived from itself");
  if (!done.insert(id).second) return;
  path.push_back(id);
  for (const Step& step : derivations.at(id).steps) {
    if (step.cites.empty()) continue;
    if (!derivations.contains(step.cites))
      throw std::logic_error("it cites (" + step.cites + "), which is not derived");
    check_citations(derivations, step.cites, path, done);
  }
  path.pop_back();
}

}  // namespace

void Paper::declare(const std::vector<Symbol>& all) {
  for (const Symbol& symbol : all) about(symbol, [&] { symbols.declare(symbol); });
  for (const Symbol& symbol : all) {
    std::erase_if(conditions, [&](const Relation& link) { return link.sides[0]->text == symbol.name; });
    std::erase(free_letters, symbol.name);
  }
  for (const Symbol& symbol : all)
    about(symbol, [&] {
      (void)parse_unit(symbol.unit);
      settle_range(symbol.name, symbols, conditions);
      check_range(symbols.find(symbol.name)->range);
    });
  for (const Symbol& symbol : all) check_spelling(symbol, symbols);
}

std::filesystem::path equations_file(const Paper& paper) {
  namespace fs = std::filesystem;
  if (paper.equations.is_absolute()) return paper.equations;
  std::set<std::string> tried;
  for (const fs::path& folder : {fs::path(paper.source).parent_path(), loaded_from().parent_path(),
                                 loaded_from().parent_path().parent_path(), fs::current_path()}) {
    const fs::path file = folder / paper.equations;
    if (fs::exists(file)) return file;
    tried.insert("'" + file.string() + "'");
  }
  throw BadInput(
      fmt::format("there is no file {}; give another one with --equations", fmt::join(tried, ", ")));
}

const std::vector<Row>& rows_of(const Paper& paper) {
  return paper.rows([&] { return rows_in(paper, equations_file(paper)); });
}

std::string row_id(const std::string& derivation) { return derivation.substr(0, derivation.find('[')); }

const Row& row_of(const Paper& paper, const std::string& id) {
  const std::vector<Row>& rows = rows_of(paper);
  const auto found = std::ranges::find(rows, id, &Row::id);
  if (found == rows.end()) throw std::out_of_range("the ledger has no row (" + id + ")");
  return *found;
}

std::optional<Derivation> derivation_of(const Paper& paper, const std::string& id) {
  if (!paper.derivations.contains(id)) return std::nullopt;
  std::vector<std::string> path;
  std::set<std::string> done;
  check_citations(paper.derivations, id, path, done);
  return with_citations(paper, paper.derivations.at(id));
}

Derivation with_citations(const Paper& paper, Derivation derivation) {
  for (Step& step : derivation.steps) {
    if (step.cites.empty()) continue;
    const Derivation& cited = paper.derivations.at(step.cites);
    step.left = cited.left, step.right = cited.right, step.relation = cited.relation;
  }
  return derivation;
}

}  // namespace rederive::paper
