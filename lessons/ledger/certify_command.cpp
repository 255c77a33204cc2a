#include <fmt/format.h>

#include <algorithm>
#include <derivations/kernel/lemma.hpp>
#include <derivations/program/bounded.hpp>
#include <lessons/ledger/certify_command.hpp>
#include <lessons/ledger/check.hpp>
#include <lessons/ledger/rests.hpp>
#include <lessons/ledger/steps.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace rederive::ledger {
using namespace language;
using namespace identity;
using namespace decide;
using namespace program;
using namespace paper;
using namespace kernel;
using namespace page;

namespace {

using Json = nlohmann::ordered_json;

std::vector<Lemma> lemmas_of(const Paper& paper, const std::vector<Entry>& entries,
                             const std::vector<std::string>& ids) {
  std::vector<Lemma> lemmas;
  for (const std::string& id : ids)
    if (std::none_of(entries.begin(), entries.end(), [&](auto& e) { return e.row.id == id; }))
      throw BadInput("there is no equation '" + printable_line(id) +
                     "'; ledger without a subcommand lists all equations");
  const auto is_wanted = [&](const std::string& id) {
    return ids.empty() || std::ranges::count(ids, id) > 0;
  };
  for (const Entry& entry : entries)
    if (const auto lemma = is_wanted(entry.row.id) ? lemma_of(paper, entry) : std::nullopt)
      lemmas.push_back(*lemma);
  for (auto* more : {&corrections_of, &steps_of})
    for (Lemma& lemma : more(paper, entries, is_wanted)) lemmas.push_back(std::move(lemma));
  if (ids.empty())
    for (Lemma& theorem : theorems_of(paper).lemmas) lemmas.push_back(std::move(theorem));
  return lemmas;
}

std::string first_error(const std::string& output) {
  const auto at = output.find("Error:");
  const auto start = output.find_first_not_of(" \n", at == std::string::npos ? 0 : at + 6);
  return start == std::string::npos ? "" : output.substr(start, output.find('\n', start) - start);
}

int count(const std::vector<Lemma>& lemmas, Lemma::Kind kind) {
  return static_cast<int>(std::ranges::count(lemmas, kind, &Lemma::kind));
}

/// The scripts, and with all rows the page of what rests on what.
void write_all(const Paper& paper, const std::filesystem::path& folder, const std::vector<Entry>& entries,
               const std::vector<Lemma>& lemmas, bool has_all_rows) {
  if (!has_all_rows) return write_scripts(paper, folder, lemmas);
  const auto supports = supports_of(paper, entries, lemmas);
  write_scripts(paper, folder, lemmas,
                {{"README.md", rests_page(entries, supports)}, {"rests.svg", rests_drawing(supports)}});
}

int report(const std::vector<Lemma>& lemmas, const std::vector<Checked>& checked,
           const std::vector<Support>& supports, bool json) {
  Json list = Json::array();
  std::set<std::string> axioms;
  int passed = 0, skipped = 0;
  for (std::size_t k = 0; k < lemmas.size(); ++k) {
    const Lemma& lemma = lemmas[k];
    const Checked& found = checked[k];
    list.push_back({{"id", lemma.id},
                    {"file", lemma.file},
                    {"name", lemma.name},
                    {"kind", to_string(lemma.kind)},
                    {"passed", found.passed},
                    {"axioms", found.axioms}});
    if (is_skipped(lemma)) list.back()["skipped"] = lemma.why, ++skipped;
    axioms.insert(found.axioms.begin(), found.axioms.end());
    passed += found.passed ? 1 : 0;
    if (json) continue;
    const std::string said = found.passed        ? "passed"
                             : is_skipped(lemma) ? "skipped: there is no script: " + lemma.why
                                                 : "failed: " + first_error(found.error);
    fmt::print("{:<6} {:<24} {}\n", lemma.id, lemma.name, said);
  }
  const int failed = static_cast<int>(lemmas.size()) - passed - skipped;
  if (json) {
    const Json counts{{"rows", count(lemmas, Lemma::Kind::row)},
                      {"refutations", count(lemmas, Lemma::Kind::refutation)},
                      {"derivations", count(lemmas, Lemma::Kind::derivation)},
                      {"rest_wholly_on_theorems", whole(supports)},
                      {"passed", passed},
                      {"failed", failed},
                      {"skipped", skipped}};
    fmt::print("{}\n", Json{{"lemmas", list}, {"counts", counts}}.dump(2));
  } else {
    fmt::print("\n{}: {} passed, {} failed{}. What they assume:\n", counted(lemmas.size(), "lemma"), passed,
               failed, skipped > 0 ? fmt::format(", {} skipped", skipped) : "");
    for (const std::string& axiom : axioms) fmt::print("  {}\n", axiom);
    if (!supports.empty()) fmt::print("{}.\n", summary(supports));
  }
  return failed == 0 ? as_expected : not_as_expected;
}

}  // namespace

int certify(const Paper& paper, const std::vector<Entry>& entries, const CertifyOptions& options) {
  if (options.folder.empty() && !options.checks)
    throw BadInput("certify needs a folder for the scripts, or --check; for example: certify proofs");
  if (std::ranges::any_of(entries, [&](auto& e) { return e.row.id == options.folder; }))
    throw BadInput("'" + printable_name(options.folder) +
                   "' is a row, but the folder comes first; for example: certify proofs " +
                   printable_name(options.folder));
  const std::vector<Lemma> lemmas = lemmas_of(paper, entries, options.ids);
  if (!options.folder.empty()) write_all(paper, options.folder, entries, lemmas, options.ids.empty());
  if (options.checks) {
    if (!has_coq()) {
      std::fputs(
          "there is no coqc; install coq, coquelicot and coq-interval (on Debian coq libcoq-coquelicot "
          "libcoq-interval)\n",
          stderr);
      return undecided_or_failed;
    }
    const auto progress = [](const std::string& file) {
      if (is_lively(2)) fmt::print(stderr, "\rcoqc {:<20}\r", file);
    };
    const std::vector<Checked> checked = check(paper, lemmas, progress);
    const auto supports = options.ids.empty() ? supports_of(paper, entries, lemmas) : std::vector<Support>{};
    return report(lemmas, checked, supports, options.json);
  }
  for (const Lemma& lemma : lemmas)
    if (is_skipped(lemma))
      std::fprintf(stderr, "%s: there is no script: %s\n", lemma.name.c_str(),
                   printable_line(lemma.why).c_str());
  const auto written = lemmas.size() - static_cast<std::size_t>(std::ranges::count_if(lemmas, is_skipped));
  if (options.json)
    fmt::print("{}\n", Json{{"folder", printable_name(options.folder)}, {"lemmas", written}}.dump(2));
  else
    fmt::print("{} in {}; make in that folder runs coqc{}\n", counted(written, "lemma"),
               printable_name(options.folder),
               options.ids.empty() ? ", README.md says what rests on what" : "");
  return as_expected;
}

std::string lemma_page(const Paper& paper, const Entry& entry) {
  const auto lemma = lemma_of(paper, entry);
  if (!lemma) throw BadInput("row " + entry.row.id + " is a definition: there is nothing to prove");
  if (lemma->text.empty()) throw BadInput("row " + entry.row.id + " has no script: " + lemma->why);
  return lemma->text;
}

int write_certificate(const Paper& paper, const ProveRequest& request, const std::string& file) {
  const std::string library = shipped("Rederive.v");
  const auto work = [&]() -> std::string {  // the script, or why there is none
    Json answer;
    try {
      const Proof proof = paper::decide(paper, request);
      const Problem problem = problem_of(paper, request);
      const bool is_proved = proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
      const Question question{problem.left, problem.right, problem.symbols, {}, problem.assumptions};
      if (!is_proved)
        answer["refused"] = to_string(proof.verdict) + ": there is no certificate";
      else if (proof.by != By::identity)
        answer["refused"] = "there is no script for a proof by " + word_of(proof.by);
      else
        answer["script"] = library + "\n" + lemma("proved", question, proof);
    } catch (const BadInput& error) {
      answer["bad_input"] = error.what();
    } catch (const Undecidable& error) {
      answer["refused"] = std::string("this proof is by identity, but ") + error.what();
    }
    return answer.dump();
  };
  const Bounded outcome = run_bounded(work, 4, 480);
  if (!outcome.result) throw std::runtime_error("the proof was given up: " + outcome.why);
  const Json answer = Json::parse(*outcome.result);
  if (answer.contains("bad_input")) throw BadInput(answer["bad_input"].get<std::string>());
  if (answer.contains("refused")) {
    std::fprintf(stderr, "%s\n", answer["refused"].get<std::string>().c_str());
    return undecided_or_failed;
  }
  write_whole(file, answer["script"].get<std::string>());
  return as_expected;
}

}  // namespace rederive::ledger
