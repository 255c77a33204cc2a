// The desk of the module, natively: requests and replies, a line each.
#include <doctest/doctest.h>

#include <tests/run_program.hpp>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

const fs::path rod = fs::path(REDERIVE_SOURCE) / "lessons/papers/rod";

std::vector<Json> replies_to(const std::vector<Json>& requests) {
  const TemporaryFolder home;
  std::string text;
  for (const Json& request : requests) text += request.dump() + "\n";
  const Result result = run_program(
      "/usr/bin/env", {"XDG_STATE_HOME=" + home.path.string(), REDERIVE_PROGRAMS "/../lessons/judge_lines"},
      text);
  std::vector<Json> replies;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) replies.push_back(Json::parse(line));
  REQUIRE(replies.size() == requests.size());
  return replies;
}

/// The request that hands over the files of a paper's folder.
Json paper_in(const fs::path& folder) {
  Json files;
  for (const auto& file : fs::directory_iterator(folder))
    files[file.path().filename().string()] = read_file(file.path());
  return {{"paper", files}};
}

}  // namespace

TEST_CASE("a paper that is handed over is judged as rederive judges its folder") {
  const auto replies = replies_to({paper_in(rod),
                                   {{"show", "ledger"}},
                                   {{"exercise", "inertia"}, {"button", "check"}, {"answer", "m*L^2/12"}},
                                   {{"exercise", "inertia"}, {"button", "check"}, {"answer", "m*L^2/3"}},
                                   {{"exercise", "barrier"}, {"button", "check"}, {"answer", "m*g*R"}}});
  CHECK(replies[0] == Json::object());
  CHECK(replies[1] == json_from("rederive", {rod, "--json"}));
  CHECK(replies[2]["opinion"]["note"] == "middle");
  CHECK(replies[3]["opinion"]["verdict"] == "correct");
  CHECK(contains(replies[4]["error"], "barrier"));  // of the built-in paper
}

TEST_CASE("a paper that cannot be read is refused, and the one before remains") {
  Json broken = paper_in(rod), outside = paper_in(rod);
  broken["paper"]["paper.toml"] = "title = ";
  outside["paper"]["../paper.toml"] = "";
  const auto replies =
      replies_to({broken, outside, {{"exercise", "barrier"}, {"button", "check"}, {"answer", "0"}}});
  CHECK(contains(replies[0]["error"], "paper.toml:1"));
  CHECK(contains(replies[1]["error"], "../paper.toml"));
  CHECK(replies[2]["opinion"]["verdict"] == "wrong");
}
