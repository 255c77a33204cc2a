// Theorems written by hand, spoiled on purpose: false at a point, and refused by Coq.
#include <doctest/doctest.h>

#include <future>
#include <tests/derivations/kernel/coq_spoil.hpp>
#include <tests/run_program.hpp>

using namespace rederive::kernel;
using namespace rederive::rocking_block;
using namespace rederive::test;

namespace {

Result coqc(const std::filesystem::path& folder, const std::string& file) {
  return run_program("/bin/sh", {"-c", "cd " + quoted(folder) + " && coqc -R . Rederive " + file});
}

/// What a spoiled theorem says, and the kind of slip.
struct Spoiled {
  std::string kind, statement;
};
/// One that is false at some point.
std::optional<Spoiled> spoiled(const rederive::coq::Theorem& theorem, const std::string& statement,
                               std::size_t turn) {
  static const std::vector<std::string> kinds{"sign", "hypothesis", "factor", "function"};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const std::string& kind = kinds[(k + turn) % kinds.size()];
    int tried = 0;
    for (const std::string& slip : rederive::coq::slips_in(statement, kind)) {
      if (++tried > 4) break;
      if (rederive::coq::counterexample(rederive::coq::with_statement(theorem, slip, theorem.around)))
        return Spoiled{kind, slip};
    }
  }
  return std::nullopt;
}

/// A file with spoiled theorems before the right ones, whose proofs have the same form; from the end, so that
/// places stay.
std::string with_spoiled(const std::string& name, std::map<std::string, int>& kinds) {
  std::string text = rederive::coq::without_comments(theorem_file(name));
  const auto theorems = rederive::coq::File(name).theorems;
  for (std::size_t k = theorems.size(); k-- > 0;) {
    const rederive::coq::Theorem& theorem = theorems[k];
    const std::size_t full_stop = rederive::coq::end_of_sentence(text, theorem.words);
    const auto slip = spoiled(theorem, text.substr(theorem.words, full_stop - theorem.words), k);
    if (!slip) continue;
    ++kinds[slip->kind];
    const std::string tactic = rederive::coq::Script(text.substr(theorem.proof, theorem.end - theorem.proof))
                                   .tactic(),
                      head = text.substr(theorem.start, theorem.words - theorem.start),
                      right = text.substr(theorem.start, full_stop - theorem.start);
    text.replace(theorem.start, theorem.end - theorem.start,
                 rederive::coq::head_of(theorem, head) + slip->statement +
                     ".\nProof.\nassert_fails (solve [ " + tactic + " ]).\nAbort.\n" + right +
                     ".\nProof.\nsolve [ " + tactic + " ].\n");
  }
  return text;
}

}  // namespace

TEST_CASE("no theorem written by hand that is spoiled passes Coq") {
  if (!has_tool("coqc")) return;
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> halves{{"Critical.v", "Derivations.v", "Claims.v"},
                                                     {"Responses.v", "Impact.v", "Initiation.v"}};
  const auto prelude_compiles = [&] {
    for (const char* name : {"Rederive.v", "Solutions.v", "Limits.v"}) {
      std::ofstream(folder.path / name) << theorem_file(name);
      if (const Result r = coqc(folder.path, name); r.exit_code != 0) return r.err;
    }
    return std::string();
  };
  auto compiling = std::async(std::launch::async, prelude_compiles);
  std::map<std::string, int> kinds;
  for (const auto& half : halves)
    for (const std::string& name : half) std::ofstream(folder.path / name) << with_spoiled(name, kinds);
  REQUIRE(compiling.get() == "");
  INFO(kinds["sign"] << " signs, " << kinds["factor"] << " factors and bounds, " << kinds["function"]
                     << " functions, " << kinds["hypothesis"] << " hypotheses");
  CHECK(kinds["sign"] >= 25);
  CHECK(kinds["factor"] >= 25);
  CHECK(kinds["function"] >= 15);
  CHECK(kinds["hypothesis"] >= 15);
  const auto refused = [&](const std::vector<std::string>& half) {
    std::string errors;
    for (const std::string& name : half) {
      const Result r = coqc(folder.path, name);
      if (r.exit_code != 0) errors += r.out + r.err;
    }
    return errors;
  };
  auto other = std::async(std::launch::async, refused, halves[1]);
  CHECK(refused(halves[0]) == "");
  CHECK(other.get() == "");
}
