#include <fmt/format.h>

#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/claims_rows.hpp>
#include <lessons/ledger/claims_verdicts.hpp>
#include <lessons/ledger/claims_workbench.hpp>

namespace rederive {

std::shared_ptr<JudgedRows> make_judged_rows() { return std::make_shared<JudgedRows>(); }

const Entry& JudgedRows::at(const std::string& id) {
  const auto found = entries_.find(id);
  if (found != entries_.end()) return found->second;
  for (const Row& row : rows_)
    if (row.id == id) return entries_.emplace(id, judge(row, rows_)).first->second;
  throw std::out_of_range("there is no row " + id);
}

std::string fixed(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", value, digits);
  return text.find_first_of("123456789") == std::string::npos && text[0] == '-' ? text.substr(1)
                                                                                : text;  // no "-0.0000"
}

std::string paired(const std::vector<std::pair<double, double>>& pairs, int digits) {
  std::string text;
  for (const auto& [at, value] : pairs)
    text += fmt::format("{}{:g}: {:.{}f}", text.empty() ? "" : ", ", at, value, digits);
  return text;
}

Finding confirmed(std::string found, std::string explanation) {
  return {ClaimVerdict::confirmed, std::move(found), std::move(explanation)};
}
Finding refuted(std::string found, std::string explanation) {
  return {ClaimVerdict::refuted, std::move(found), std::move(explanation)};
}
Finding qualified(std::string found, std::string explanation) {
  return {ClaimVerdict::qualified, std::move(found), std::move(explanation)};
}
Finding undecided(std::string found, std::string explanation) {
  return {ClaimVerdict::undecided, std::move(found), std::move(explanation)};
}

Finding decided(bool holds, std::string found, std::string if_so, std::string if_not) {
  return holds ? confirmed(std::move(found), std::move(if_so)) : refuted(std::move(found), std::move(if_not));
}

std::string row_verdict(Workbench& bench, const std::string& id) {
  return to_string(bench.rows().at(id).proof.verdict);
}

bool rows_stand(Workbench& bench, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    const Verdict verdict = bench.rows().at(id).proof.verdict;
    if (verdict != Verdict::proved && verdict != Verdict::proved_under && verdict != Verdict::approximation)
      return false;
  }
  return true;
}

std::string rows_say(Workbench& bench, const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) {
    const Entry& entry = bench.rows().at(id);
    text += fmt::format("{}({}) {}", text.empty() ? "" : ", ", id, to_string(entry.proof.verdict));
    if (!entry.correction.empty())
      text += ": right is " + print(parse_statement(entry.correction), Notation::unicode);
  }
  return text;
}

}  // namespace rederive
