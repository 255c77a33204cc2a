// The module of WebAssembly answers as the native programs do, to the byte: in Node and in Chromium.
#include <doctest/doctest.h>
#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <tests/run_program.hpp>

namespace {

using Json = nlohmann::ordered_json;
const std::filesystem::path folder = std::filesystem::path(REDERIVE_SOURCE) / "build-wasm";

bool is_built() {
  if (std::filesystem::exists(folder / "judge.wasm")) return has_tool("node");
  skip("build-wasm/judge.wasm does not exist: .setup/wasm/build makes it");
  return false;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const std::vector<Json>& requests) {
  std::string text;
  for (const Json& request : requests) text += request.dump() + "\n";
  return text;
}

/// Returns the replies of the native program, which begins without progress.
std::vector<std::string> native_replies(const std::vector<Json>& requests) {
  const TemporaryFolder home;
  const Result result = run_program("/usr/bin/env",
                                    {"REDERIVE_PROGRESS=" + (home.path / "progress.txt").string(),
                                     std::string(REDERIVE_PROGRAMS) + "/../lessons/judge_lines"},
                                    text_of(requests));
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return lines_of(result.out);
}

void compare(const std::vector<Json>& requests) {
  const std::vector<std::string> native = native_replies(requests);
  const Result result = run_program("/usr/bin/env",
                                    {"node", "--no-experimental-fetch",
                                     std::string(REDERIVE_SOURCE) + "/tests/lessons/module/lines.js", folder},
                                    text_of(requests));
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  const std::vector<std::string> found = lines_of(result.out);
  REQUIRE(native.size() == requests.size());
  REQUIRE(found.size() == requests.size());
  for (std::size_t k = 0; k < requests.size(); ++k) {
    INFO(requests[k].dump());
    CHECK(found[k] == native[k]);
  }
}

Json check(const std::string& exercise, const std::string& answer) {
  return {{"exercise", exercise}, {"button", "check"}, {"answer", answer}};
}

/// Returns answers to all exercises: the right ones, and those with one character changed, until there are
/// 500.
std::vector<Json> answers() {
  const Json right = Json::parse(native_replies({{{"show", "exercises"}}}).at(0));
  std::vector<Json> requests;
  for (const auto& [id, answer] : right.items()) requests.push_back(check(id, answer));
  std::mt19937 random(1);  // NOLINT: the same answers on every run
  const std::string characters = "+-*/()^0123456789aeghmpRt ";
  while (requests.size() < 500)
    for (const auto& [id, answer] : right.items()) {
      std::string text = answer;
      text[random() % text.size()] = characters[random() % characters.size()];
      requests.push_back(check(id, text));
    }
  return requests;
}

std::vector<Json> proofs() {
  const toml::table table = toml::parse_file(std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml");
  std::vector<Json> requests;
  for (const auto& row : *table["row"].as_array()) {
    Json request;
    for (const auto& [key, value] : *row.as_table())
      if (const auto* texts = value.as_array(); texts != nullptr)
        for (const auto& text : *texts)
          request[std::string(key.str())].push_back(text.value<std::string>().value());
      else if (value.is_integer())
        request[std::string(key.str())] = value.value<int>().value();
      else
        request[std::string(key.str())] = value.value<std::string>().value();
    requests.push_back({{"prove", request}});
  }
  return requests;
}

}  // namespace

TEST_CASE("the module answers 500 answers to exercises as judge_lines does") {
  if (is_built()) compare(answers());
}

TEST_CASE("the module proves all rows of the table as judge_lines does") {
  if (is_built()) compare(proofs());
}

TEST_CASE("the module has the same ledger, and its selftest finds nothing") {
  if (is_built()) compare({{{"show", "ledger"}}, {{"selftest", true}}});
}

TEST_CASE("judge.wasm has at most 2.5 MB, as browsers load it") {
  if (!is_built() || !has_tool("brotli")) return;
  const Result packed = run_program("/usr/bin/env", {"brotli", "--stdout", "--best", folder / "judge.wasm"});
  REQUIRE(packed.exit_code == 0);
  CHECK(packed.out.size() <= 2'500'000);
}

TEST_CASE("the module answers in Chromium as judge_lines does") {
  if (!is_built() || !has_tool("chromium") || !has_tool("base64")) return;
  std::vector<Json> requests = proofs(), more = answers();
  requests.resize(100);
  requests.insert(requests.end(), more.begin(), more.begin() + 100);
  const TemporaryFolder temporary;
  const std::string wasm = run_program("/usr/bin/env", {"base64", "-w0", folder / "judge.wasm"}).out;
  write_file(
      temporary.path / "page.html",
      "<meta charset=utf-8><pre></pre><script>" + read_file(folder / "judge.js") + "</script><script>" +
          "const bytes = Uint8Array.from(atob('" + wasm + "'), (c) => c.charCodeAt(0));" +
          "rederive({wasmBinary: bytes, print: () => {}}).then((judge) => {" +
          "document.querySelector('pre').textContent = btoa(unescape(encodeURIComponent(" +
          Json(requests).dump() + ".map((request) => judge.ccall('rederive_reply', 'string', ['string'], " +
          "[JSON.stringify(request)])).join('\\n'))));});</script>");
  const Result shown = run_program(
      "/usr/bin/env",
      {"timeout", "3000", "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
       "--no-first-run", "--user-data-dir=" + (temporary.path / "profile").string(),
       "--virtual-time-budget=1000000", "--dump-dom", (temporary.path / "page.html").string()});
  const std::size_t from = shown.out.find("<pre>") + 5;
  const std::string encoded = shown.out.substr(from, shown.out.find("</pre>") - from);
  const std::vector<std::string> found = lines_of(run_program("/usr/bin/env", {"base64", "-d"}, encoded).out),
                                 native = native_replies(requests);
  REQUIRE(found.size() == requests.size());
  for (std::size_t k = 0; k < requests.size(); ++k) {
    INFO(requests[k].dump());
    CHECK(found[k] == native[k]);
  }
}
