// Lessons as Jupyter notebooks: valid, the same bytes each time, and Jupyter runs them; what their cells get
// from the Python module is what the commands say.
#include <doctest/doctest.h>

#include <derivations/rocking_block/paper.hpp>
#include <lessons/page/render.hpp>
#include <regex>
#include <set>
#include <tests/cases.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::rocking_block;
using namespace rederive::page;
using nlohmann::json;

namespace {

const std::string python = "/usr/bin/python3";  // Debian's, whose packages the modules are

/// What came of a cell: the texts that it printed, and those of its values.
std::string output_of(const json& cell) {
  std::string text;
  for (const auto& output : cell["outputs"]) {
    if (output.contains("text")) text += output["text"].get<std::string>();
    for (const auto* kind : {"text/plain", "text/latex"})
      if (output.contains("data") && output["data"].contains(kind))
        text += output["data"][kind].get<std::string>();
  }
  return text;
}

/// What is wrong with the notebook of one lesson that was run; empty if nothing is.
std::string complaints(const std::string& lesson, const json& notebook) {
  std::string said;
  for (const auto& cell : notebook["cells"]) {
    if (cell["cell_type"] != "code") continue;
    const auto source = cell["source"].get<std::string>();
    for (const auto& output : cell["outputs"])
      if (output["output_type"] == "error" || output.value("name", "") == "stderr")
        said += lesson + ": " + output.dump() + "\n";
    if (output_of(cell).empty() && !in_python("import")->starts_with(source))
      said += lesson + ": nothing came of " + source + "\n";
  }
  return said;
}

/// The code cells that begin so, or that hold this.
std::vector<json> cells_with(const json& notebook, const std::string& part) {
  std::vector<json> cells;
  for (const auto& cell : notebook["cells"])
    if (cell["cell_type"] == "code" && cell["source"].get<std::string>().find(part) != std::string::npos)
      cells.push_back(cell);
  return cells;
}

bool is_module_built() {
  const auto folder = std::filesystem::path(REDERIVE_PROGRAMS).parent_path() / "python/rederive";
  for (std::filesystem::directory_iterator entry(folder), end; entry != end; ++entry)
    if (entry->path().extension() == ".so") return true;
  skip("the Python module was not built");
  return false;
}

}  // namespace

TEST_CASE("a notebook has text and commands in cells, with the mathematics that Jupyter reads") {
  for (const std::size_t k : {0, 6, 10}) {
    const std::string lesson = lesson_programs().at(k);
    CAPTURE(lesson);
    const json notebook = json_from(lesson, {"--format", "notebook"});
    CHECK(notebook["nbformat"] == 4);
    CHECK(notebook["nbformat_minor"] == 5);
    std::set<std::string> ids;
    bool has_formulas = false, has_commands = false;
    for (const auto& cell : notebook["cells"]) {
      CHECK(ids.insert(cell["id"]).second);
      const auto source = cell["source"].get<std::string>();
      CHECK(!source.empty());
      CHECK(source.find("```math") == std::string::npos);
      CHECK(source.find("$`") == std::string::npos);
      CHECK((cell["cell_type"] == "code") == cell.contains("outputs"));
      has_formulas = has_formulas || source.find("\n$$") != std::string::npos;
      has_commands = has_commands || cell["cell_type"] == "code";
    }
    CHECK(has_formulas);
    CHECK(has_commands);
  }
  const json step = json_from(lesson_programs().at(0), {"--format", "notebook", "--step", "1"});
  CHECK(step["cells"][0]["source"].get<std::string>().starts_with("## 1. "));
}

TEST_CASE(
    "a command with a counterpart in the module is a call of it, with all its options, and any other is "
    "itself") {
  each_case("calls", [](std::string command, std::string begin) {
    CHECK_MESSAGE(contains(in_python(command).value_or("nothing"), begin),
                  in_python(command).value_or("nothing"));
  });
  each_case("others", [](std::string command) { CHECK_FALSE(in_python(command)); });
}

TEST_CASE("without the module the cells run the commands, and the first cell says so") {
  Page page(rederive::rocking_block::paper());
  page.commands({"build/bin/rocking threshold --omega 2", "build/bin/exercises show barrier"});
  Setting setting{.paper = rederive::rocking_block::paper(), .format = Format::notebook};
  const auto notebook = [&] {
    return json::parse(rendered({"T", {{"Teaches", "t"}, {"Builds on", "b"}}}, page.blocks(), setting));
  };
  const json plain = notebook();
  CHECK(contains(plain["cells"][0]["source"], "was not built"));
  CHECK(cells_with(plain, "rederive").empty());
  CHECK(cells_with(plain, "%%sh --no-raise-error\nrocking threshold --omega 2").size() == 1);
  CHECK(cells_with(plain, "%%sh").size() == 2);
  setting.module = true;
  const json calling = notebook();
  CHECK(contains(calling["cells"][0]["source"], "PYTHONPATH"));
  CHECK(cells_with(calling, "rederive.threshold(").size() == 1);
  CHECK(calling["cells"].back()["source"] == "%%sh --no-raise-error\nexercises show barrier");
}

TEST_CASE("Jupyter runs every lesson, and the module says there what the commands say") {
  if (!has_tool("jupyter-execute") || !is_module_built()) return;
  TemporaryFolder folder;
  ::setenv("PATH", (std::string(REDERIVE_PROGRAMS) + ":" + std::getenv("PATH")).c_str(), 1);
  ::setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1", 1);
  ::setenv("IPYTHONDIR", (folder.path / "ipython").c_str(), 1);
  ::setenv("REDERIVE_PROGRESS", (folder.path / "progress.txt").c_str(), 1);
  std::vector<std::string> arguments = {REDERIVE_SOURCE "/tests/lessons/notebooks/run_notebooks.py",
                                        folder.path};
  for (const auto& lesson : lesson_programs()) {
    arguments.push_back(folder.path / (lesson + ".ipynb"));
    REQUIRE(run_program(lesson, {"--format", "notebook", "--out", arguments.back()}).exit_code == 0);
  }
  const Result ran = run_program(python, arguments);
  REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
  int thresholds = 0, rows = 0;
  for (std::size_t k = 0; k < lesson_programs().size(); ++k) {
    const json notebook = json::parse(read_file(arguments[k + 2]));
    CAPTURE(lesson_programs()[k]);
    CHECK(complaints(lesson_programs()[k], notebook) == "");
    CHECK(cells_with(notebook, "import rederive").size() == 1);
    CHECK(cells_with(notebook, "rederive.").size() > 1);
    for (const auto& cell : cells_with(notebook, "rederive.threshold(")) {
      const auto source = cell["source"].get<std::string>();
      std::smatch asked, said;
      const std::regex plain(R"(print\(rederive\.threshold\(rederive\.Pulse\(([0-9.]+)\)\)\)\n[^]*)"),
          threshold(R"(Threshold\(amplitude=([0-9.]+), code=(-?[0-9]+)\)[^]*)");
      if (!std::regex_match(source, asked, plain)) continue;
      const std::string out = output_of(cell);
      REQUIRE(std::regex_match(out, said, threshold));
      const json command = json_from("rocking", {"threshold", "--omega", asked[1], "--json"});
      CHECK(std::stod(said[1]) ==
            doctest::Approx(command["minimum"]["amplitude"].get<double>()).epsilon(1e-11));
      CHECK(std::stoi(said[2]) == command["minimum"]["code"]);
      ++thresholds;
    }
    for (const auto& cell : cells_with(notebook, "row.id == ")) {
      std::string id = cell["source"].get<std::string>();
      id = id.substr(id.find('"') + 1, id.rfind('"') - id.find('"') - 1);
      const json command = json_from("ledger", {"show", id, "--json"});
      const std::string verdict =
          std::regex_replace(command["verdict"].get<std::string>(), std::regex("_"), " ");
      CHECK_MESSAGE(contains(output_of(cell), "\\text{" + verdict + "}"), id);
      ++rows;
    }
  }
  CHECK(thresholds >= 4);
  CHECK(rows >= 7);
}
