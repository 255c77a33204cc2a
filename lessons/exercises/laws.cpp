#include <fmt/format.h>

#include <derivations/language/text.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/laws.hpp>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;
namespace {

/// Returns 13 for "(13)", "eq. (13)" and "Equation (13)"; "" for other texts.
std::string number_in(const std::string& name) {
  static const std::regex form(R"((?:equation|eqn?\.?)?\s*\(\s*([^()\s]+)\s*\)\s*)", std::regex::icase);
  std::smatch found;
  return std::regex_match(name, found, form) ? found[1].str() : "";
}

const Law* law_of(const Exercise& exercise, const std::string& name) {
  for (const Law& law : exercise.laws)
    for (const std::string& known : law.names)
      if (lower_case(known) == lower_case(trimmed(name))) return &law;
  return nullptr;
}

/// Returns an equation of the paper as it is derived; of a definition, as it is printed.
Cited equation_cited(const Exercise& exercise, const std::string& id, std::size_t place) {
  const Reference& answer = exercise.answer;
  const bool is_asked_for = (answer.derivation == id || answer.row == id) && answer.put.empty() &&
                            answer.solve_for.empty() && answer.differentiate.empty();
  if (is_asked_for)
    throw SyntaxError(Mistake::assumption, place,
                      "(" + id + ") is what the exercise asks for: begin with what it comes from");
  Cited found{"(" + id + ")", {}};
  const Symbols& symbols = exercise.language();
  const std::vector<paper::Row>& rows = rows_of(exercise.paper());
  const auto row = std::ranges::find(rows, id, &paper::Row::id);
  Reference asked;
  asked.derivation = id;
  try {
    const Derivation derivation = derivation_for(asked, *exercise.course);
    found.equations = {derived_relation(derivation, symbols)};
    found.given = derivation.given;
    if (row != rows.end() && judged(exercise.paper(), id).proof.verdict == Verdict::refuted)
      found.remark =
          fmt::format("The paper prints ({}) with an error, so it is used here as it is derived.", id);
  } catch (const std::out_of_range&) {
    if (row == rows.end() || row->kind != paper::RowKind::definition)
      throw SyntaxError(Mistake::assumption, place, "there is no equation (" + id + ") to begin with");
    found.equations = {parse_statement(row->printed, symbols)};
  }
  return found;
}

}  // namespace

bool is_law(const Exercise& exercise, const std::string& name) {
  return law_of(exercise, name) != nullptr || !number_in(name).empty();
}

Cited cited(const Exercise& exercise, const std::string& name, std::size_t place) {
  if (const Law* law = law_of(exercise, name)) {
    Cited found{law->names[0], {}};
    for (const std::string& equation : law->equations)
      found.equations.push_back(parse_relation(equation, exercise.language()));
    return found;
  }
  if (const std::string id = number_in(name); !id.empty()) return equation_cited(exercise, id, place);
  std::string known;
  for (const Law& law : exercise.laws) known += law.names[0] + ", ";
  throw SyntaxError(
      Mistake::assumption, place,
      fmt::format("there is no law '{}' here; begin with {}or an equation by its number, such as (1)",
                  printable_line(trimmed(name)), known));
}

}  // namespace rederive::classroom
