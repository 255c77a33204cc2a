// The module of WebAssembly answers as the native programs do, to the byte: in Node and in Chromium.
#include <doctest/doctest.h>

#include <lessons/ledger/prove_table.hpp>
#include <random>
#include <tests/lessons/exercises/browser.hpp>
#include <tests/lessons/module/built.hpp>

namespace {

/// Returns the replies, a line each. What else is written is the report of the selftest.
std::vector<std::string> replies_in(const std::string& text) {
  std::vector<std::string> replies;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("{")) replies.push_back(line);
  return replies;
}

std::string text_of(const std::vector<Json>& requests) {
  std::string text;
  for (const Json& request : requests) text += request.dump() + "\n";
  return text;
}

/// Returns the replies of the native program, which begins without progress.
std::vector<std::string> native_replies(const std::vector<Json>& requests) {
  const TemporaryFolder home;
  const Result result = run_program(
      "/usr/bin/env", {"XDG_STATE_HOME=" + home.path.string(), REDERIVE_PROGRAMS "/../lessons/judge_lines"},
      text_of(requests));
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return replies_in(result.out);
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

/// Returns the rows of prove_table.toml, without what is expected of them.
std::vector<Json> proofs() {
  std::vector<Json> requests;
  for (const auto& row : rederive::ledger::read_table(REDERIVE_SOURCE "/tests/prove_table.toml")) {
    Json request{{"left", row.request.left},
                 {"right", row.request.right},
                 {"assume", row.request.assumptions},
                 {"small", row.request.small}};
    if (row.request.order) request["order"] = *row.request.order;
    requests.push_back({{"prove", request}});
  }
  return requests;
}

struct Asked {
  std::vector<Json> requests;
  std::vector<std::string> replies;  ///< of the native program
};

/// The table, the ledger, the selftest and the answers, as the native program answers them.
const Asked& asked() {
  static const Asked all = [] {
    std::vector<Json> requests = proofs();
    for (const Json& answer : answers()) requests.push_back(answer);
    requests.push_back({{"show", "ledger"}});
    requests.push_back({{"selftest", true}});
    return Asked{requests, native_replies(requests)};
  }();
  REQUIRE(all.replies.size() == all.requests.size());
  REQUIRE(all.replies.back() == R"({"code":0})");
  return all;
}

void compare(const std::vector<std::string>& found) {
  REQUIRE(found.size() == asked().requests.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    INFO(asked().requests[k].dump());
    CHECK(found[k] == asked().replies[k]);
  }
}

}  // namespace

TEST_CASE("in Node the module answers as judge_lines does") {
  if (!is_module_built() || !has_tool("node")) return;
  const Result result = run_program("/usr/bin/env",
                                    {"node", "--no-experimental-fetch",
                                     REDERIVE_SOURCE "/tests/lessons/module/lines.js", folder_of_module()},
                                    text_of(asked().requests));
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  compare(replies_in(result.out));
}

TEST_CASE("in Chromium the module answers as judge_lines does") {
  if (!is_module_built() || !has_tool("chromium") || !has_tool("base64")) return;
  const TemporaryFolder temporary;
  std::filesystem::copy(folder_of_module() / "judge.js", temporary.path);
  const std::string wasm =
      run_program("/usr/bin/env", {"base64", "-w0", folder_of_module() / "judge.wasm"}).out;
  write_file(
      temporary.path / "page.html",
      "<meta charset=utf-8><script src=judge.js></script><script>const wasm = '" + wasm + "'</script>");
  Browser browser;
  browser.call("Page.navigate", {{"url", "file://" + (temporary.path / "page.html").string()}});
  browser.wait_for(
      "typeof wasm !== 'undefined' && rederive({print() {}, wasmBinary: Uint8Array.from(atob(wasm), (byte) "
      "=> "
      "byte.charCodeAt(0))}).then((module) => (globalThis.judge = module, true))");
  const auto reply_to = "judge.ccall('rederive_reply', 'string', ['string'], [JSON.stringify(";
  std::vector<std::string> found;
  for (const Json& request : asked().requests)
    found.push_back(browser.wait_for(reply_to + request.dump() + ")])"));
  compare(found);
}

TEST_CASE("judge.wasm has at most 2.5 MB, as browsers load it") {
  if (!is_module_built() || !has_tool("brotli")) return;
  const Result packed =
      run_program("/usr/bin/env", {"brotli", "--stdout", "--best", folder_of_module() / "judge.wasm"});
  REQUIRE(packed.exit_code == 0);
  CHECK(packed.out.size() <= 2'500'000);
}
