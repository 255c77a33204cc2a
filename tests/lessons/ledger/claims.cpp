// The claims of the text: decided by computation, so that another printed number gives another verdict.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <lessons/rocking_block/claims_ratios.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>
#include <set>
#include <tests/run_program.hpp>

namespace {

using Json = nlohmann::json;

const std::string original = std::string(REDERIVE_SOURCE) + "/derivations/rocking_block/claims.toml";

/// One claim of a copy of claims.toml in which `from` is replaced by `to` after the line with its id.
Result with_change(const std::string& id, const std::string& from, const std::string& to) {
  TemporaryFolder folder;
  std::string text = read_file(original);
  const auto place = text.find(from, text.find("id = \"" + id + "\""));
  REQUIRE(place != std::string::npos);
  text.replace(place, from.size(), to);
  const std::string file = (folder.path / "claims.toml").string();
  std::ofstream(file) << text;
  return run_program("ledger", {"claims", id, "--json", "--claims", file});
}

/// The block of the captions with e = 0.9 under a one-sine pulse.
const rederive::numerics::PulseCase statue = [] {
  rederive::numerics::PulseCase asked;
  asked.block = rederive::numerics::make_block(0.25, 2.14, 0.9);
  return asked;
}();

Json claim_of(const Result& result) { return Json::parse(result.out)["claims"].at(0); }

TEST_CASE(
    "all claims together: every verdict as expected, every one with what was found, the same bytes twice") {
  const Result first = run_program("ledger", {"claims", "--json"});
  CHECK(first.exit_code == 0);
  CHECK(first.err.empty());
  const Json claims = Json::parse(first.out)["claims"];
  CHECK(claims.size() >= 100);
  std::map<std::string, int> verdicts;
  std::set<std::string> ids;
  for (const Json& claim : claims) {
    const std::string id = claim["id"];
    CAPTURE(id);
    CHECK(ids.insert(id).second);
    CHECK(claim["verdict"] == claim["expected"]);
    for (const char* key : {"where", "statement", "found", "explanation"})
      CHECK_FALSE(claim[key].get<std::string>().empty());
    CHECK(claim["printed"].is_string());
    ++verdicts[claim["verdict"]];
  }
  CHECK(verdicts["refuted"] >= 40);
  CHECK(verdicts["undecided"] <= 6);
  CHECK(run_program("ledger", {"claims", "--json"}).out == first.out);
}

TEST_CASE("a verdict that is not the expected one ends with 1") {
  const Result changed = with_change("c25", "expected = \"confirmed\"", "expected = \"refuted\"");
  CHECK(changed.exit_code == 1);
  CHECK(claim_of(changed)["verdict"] == "confirmed");
}

TEST_CASE("other printed numbers get other verdicts") {
  struct Change {
    std::string id, from, to, verdict;
  };
  const std::vector<Change> changes{
      {"c25", "printed = \"0.982\"", "printed = \"0.992\"", "refuted"},
      {"c54", "printed = \"2.35766/2.35771\"", "printed = \"2.3495/2.3498\"", "refuted"},
      {"c54b", "printed = \"2.35766/2.35771\"", "printed = \"2.34988/2.34992\"", "confirmed"},
      {"c61b", "printed = \"0.71156/0.71157\"", "printed = \"1.40009/1.40011\"", "confirmed"},
      {"c71", "printed = \"2.201\"", "printed = \"2.202\"", "confirmed"},
      {"c74", "printed = \"0.672\"", "printed = \"0.673\"", "confirmed"},
      {"c45", "printed = \"4.8\"", "printed = \"3.2\"", "refuted"},
      {"c57b", "printed = \"6.7\"", "printed = \"6.6\"", "qualified"},
  };
  for (const Change& change : changes) {
    CAPTURE(change.id);
    const Result result = with_change(change.id, change.from, change.to);
    CHECK(claim_of(result)["verdict"] == change.verdict);
  }
  const Result as_labelled =
      with_change("c54", "printed = \"2.35766/2.35771\"", "printed = \"2.34985/2.34995\"");
  CHECK(claim_of(as_labelled)["verdict"] == "confirmed");
  CHECK(as_labelled.exit_code == 1);
}

TEST_CASE("printed numbers are read in every way that has a name") {
  const auto found = [](const std::string& id) {
    return claim_of(run_program("ledger", {"claims", id, "--json"}))["found"].get<std::string>();
  };
  CHECK(found("c54").find("nonlinear, alpha = 0.25, in g*tan(alpha): 2.35768") != std::string::npos);
  CHECK(found("c55").find("nonlinear, alpha = 0.25, in g*tan(alpha): 5.32301") != std::string::npos);
  CHECK(found("c61").find("nonlinear, alpha = 0.25, e = 0.9, reciprocal of g*tan(alpha): 0.71155") !=
        std::string::npos);
  CHECK(found("c71").find("2*pi = 6.28") != std::string::npos);
  CHECK(found("c57b").find("none of") != std::string::npos);
}

TEST_CASE("the claims tell the ratios at which overturning after one impact changes") {
  const auto found = [](const std::string& id) {
    return claim_of(run_program("ledger", {"claims", id, "--json"}))["found"].get<std::string>();
  };
  CHECK(found("c45").find(fmt::format("{:.7g}", rederive::rocking_block::handover(statue)->omega_ratio)) !=
        std::string::npos);
  CHECK(found("c57b").find(fmt::format(
            "{:.7g}", rederive::rocking_block::end_of_mode_2(statue)->omega_ratio)) != std::string::npos);
}

TEST_CASE("the linear hand-over solves (86) and (88) with t_i = T_ex") {
  const auto change = rederive::rocking_block::handover(statue);
  REQUIRE(change);
  rederive::numerics::PulseCase there = statue;
  there.omega_ratio = change->omega_ratio * (1 - 1e-10);
  const auto roots = closed_forms(there);
  const auto root = std::find_if(roots.begin(), roots.end(), [](const auto& each) {
    return each.form == rederive::numerics::Form::eq86_88 && each.admissible();
  });
  REQUIRE(root != roots.end());
  CHECK(*root->impact_time == doctest::Approx(root->pulse_end).epsilon(1e-8));
  CHECK(root->amplitude == doctest::Approx(change->amplitude).epsilon(1e-8));
}

TEST_CASE("the hand-over has its impact at the end of the pulse, and mode 2 ends where it should") {
  for (rederive::numerics::Model model :
       {rederive::numerics::Model::linear, rederive::numerics::Model::nonlinear}) {
    rederive::numerics::PulseCase of = statue;
    of.model = model;
    const auto change = rederive::rocking_block::handover(of);
    REQUIRE(change);
    rederive::numerics::PulseCase there = of;
    there.omega_ratio = change->omega_ratio;
    const auto windows = overturning_windows(there);
    CHECK(windows.front().from == doctest::Approx(change->amplitude).epsilon(1e-9));
    const auto end = rederive::rocking_block::end_of_mode_2(of);
    REQUIRE(end);
    there.omega_ratio = end->omega_ratio * (1 - 1e-6);
    CHECK(outcome_at(there, end->amplitude).code == 2);
    there.omega_ratio = end->omega_ratio * (1 + 1e-6);
    for (int i = -50; i <= 50; ++i) CHECK(outcome_at(there, end->amplitude * (1 + i * 1e-3)).code == 0);
  }
}

TEST_CASE("one claim is told in full, an unknown one is refused") {
  const Result page = run_program("ledger", {"claims", "c81"});
  CHECK(page.exit_code == 0);
  CHECK(page.out.find("refuted") != std::string::npos);
  const Result unknown = run_program("ledger", {"claims", "c999"});
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.out.empty());
  CHECK(unknown.err.find("c999") != std::string::npos);
}

TEST_CASE("a claims file that cannot be used is refused with its place") {
  const Result unknown_check =
      with_change("c25", "check = \"restitution_of_statues\"", "check = \"guesswork\"");
  CHECK(unknown_check.exit_code == 2);
  CHECK(unknown_check.err.find("guesswork") != std::string::npos);
  const Result unknown_key = with_change("c25", "where = ", "whence = ");
  CHECK(unknown_key.exit_code == 2);
  CHECK(unknown_key.err.find("whence") != std::string::npos);
}

}  // namespace
