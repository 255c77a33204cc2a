// The command line of rederive check.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

using Json = nlohmann::json;
using Text = std::string;

namespace {

/// Runs the program on one file with this text.
Result checked(const TemporaryFolder& folder, std::vector<Text> options, const Text& text,
               const Text& name = "notes.tex") {
  write_file(folder.path / name, text);
  options.insert(options.begin(), "check");
  options.push_back((folder.path / name).string());
  return run_program("rederive", options);
}

const Text wrong = "\\begin{align}\n 2x + 3 &= 7 \\\\\n 2x &= 10\n\\end{align}\n";

}  // namespace

TEST_CASE("a wrong line is a message with its place, and exit code 1") {
  const TemporaryFolder folder;
  const Result run = checked(folder, {}, wrong);
  CHECK(run.exit_code == 1);
  CHECK(contains(run.out,
                 "notes.tex:3:6: wrong: 2x = 10: at x = 2 the line before holds, and this one does not"));
  CHECK(contains(run.out, "0 proved, 1 wrong, 0 undecided, 0 not read, 1 assumed"));
  CHECK(checked(folder, {}, "\\[ x + x = 2x = x \\cdot 2 \\]").exit_code == 0);
}

TEST_CASE("-v shows every step, and --strict refuses conditions") {
  const TemporaryFolder folder;
  const Text text = "\\[ \\sqrt{x^2} + 1 = x + 1 = 1 + x \\]";
  CHECK(contains(checked(folder, {"-v"}, text).out, "proved: \\sqrt{x^2} + 1 = x + 1, if x > 0"));
  CHECK(checked(folder, {}, text).exit_code == 0);
  CHECK(checked(folder, {"--strict"}, text).exit_code == 1);
}

TEST_CASE("JSON and SARIF say the same") {
  const TemporaryFolder folder;
  const Json json = Json::parse(checked(folder, {"--json"}, "For $x > 0$:\n" + wrong).out);
  const Json& link = json["files"][0]["displays"][0]["links"][1];
  CHECK(link["verdict"] == "wrong");
  CHECK(link["line"] == 4);
  CHECK(link["left"] == "2x");
  CHECK(link["relation"] == "=");
  CHECK(link["right"] == "10");
  CHECK(json["counts"]["wrong"] == 1);
  CHECK(json["files"][0]["symbols"][0] == Json{{"name", "x"}, {"range", "(0, inf)"}, {"from", "text"}});
  const Json sarif = Json::parse(checked(folder, {"--sarif"}, wrong).out);
  CHECK(sarif["version"] == "2.1.0");
  const Json& result = sarif["runs"][0]["results"][0];
  CHECK(result["locations"][0]["physicalLocation"]["region"]["startLine"] == 3);
}

TEST_CASE("a page, notebooks, Markdown, declared symbols") {
  const TemporaryFolder folder;
  const Text page = (folder.path / "page.html").string();
  CHECK(checked(folder, {"--html", page}, wrong).exit_code == 1);
  CHECK(contains(read_file(page), "<tr class=\"wrong\"><td>3</td>"));
  const Json cell{{"cell_type", "markdown"}, {"source", {"Text\n", "$$ (a+b)^2 = a^2 + b^2 = b^2 + a^2 $$"}}};
  const Json notebook{{"cells", Json::array({cell})}};
  const Result run = checked(folder, {}, notebook.dump(1), "notes.ipynb");
  CHECK(run.exit_code == 1);
  CHECK(contains(run.out, "notes.ipynb:7:"));
  CHECK(checked(folder, {}, "```\n$$ 1 = 2 = 3 $$\n```\n", "notes.md").exit_code == 0);
  write_file(folder.path / "symbols.toml", "[symbols]\nx = { range = \"(0, inf)\" }\n");
  CHECK(checked(folder, {"--strict", "--symbols", (folder.path / "symbols.toml").string()},
                "\\[ \\sqrt{x^2} + 1 = x + 1 = 1 + x \\]")
            .exit_code == 0);
}

TEST_CASE("files that a manuscript reads are read, with their macros and places") {
  const TemporaryFolder folder;
  write_file(folder.path / "mine.sty", "\\newcommand{\\half}{\\frac12}\n");
  write_file(folder.path / "part.tex", "\n\\[ 1 + 1 = 2 = 3 \\]\n");
  const Result run =
      checked(folder, {"-v"}, "\\usepackage{mine}\n\\include{part}\n\\[ \\half x + \\half x = x = x \\]\n");
  CHECK(contains(run.out, "part.tex:2:14: wrong: 2 = 3"));
  CHECK(contains(run.out, "notes.tex:3:22: proved: \\half x + \\half x = x"));
}

TEST_CASE("bad files and options are errors") {
  const TemporaryFolder folder;
  CHECK(run_program("rederive", {"check", (folder.path / "none.tex").string()}).exit_code == 2);
  CHECK(run_program("rederive", {"check"}).exit_code == 2);
  CHECK(checked(folder, {}, "{}", "notes.ipynb").exit_code == 2);
  write_file(folder.path / "symbols.toml", "[symbols]\nx = 3\n");
  const Result run = checked(folder, {"--symbols", (folder.path / "symbols.toml").string()}, wrong);
  CHECK(run.exit_code == 2);
  CHECK(contains(run.err, "symbols.toml:2: x"));
}
