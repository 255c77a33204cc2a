// Lessons as Jupyter notebooks: valid, the same bytes each time, and Jupyter runs them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run_program.hpp"

using nlohmann::json;

namespace {

const std::string python = "/usr/bin/python3";  // Debian's, whose packages the modules are

/// Reads each file that argv[2:] names, which must be valid, runs it in argv[1] by one kernel and writes it back.
const std::string script = R"(
import json, sys, nbformat
from jupyter_client.manager import KernelManager
from nbclient import NotebookClient
kernel = KernelManager(kernel_name="python3")
kernel.start_kernel(cwd=sys.argv[1])
try:
    for file in sys.argv[2:]:
        notebook = nbformat.read(file, 4)
        nbformat.validate(notebook)
        NotebookClient(notebook, km=kernel, timeout=300).execute()
        json.dump(notebook, open(file, "w"))
finally:
    kernel.shutdown_kernel(now=True)
)";

/// What is wrong with the notebook of one lesson that was run; empty if nothing is.
std::string complaints(const std::string& lesson, const std::string& file) {
  std::string said;
  int commands = 0;
  const json notebook = json::parse(read_file(file));
  for (const auto& cell : notebook["cells"]) {
    if (cell["cell_type"] != "code") continue;
    ++commands;
    std::string out;
    for (const auto& output : cell["outputs"]) {
      if (output["output_type"] != "stream") said += lesson + ": " + output.dump() + "\n";
      if (output.value("name", "") == "stdout") out += output["text"].get<std::string>();
      if (output.value("name", "") == "stderr") said += lesson + ": " + output["text"].get<std::string>();
    }
    if (out.empty()) said += lesson + ": nothing came of " + cell["source"].get<std::string>() + "\n";
  }
  return said + (commands == 0 ? lesson + ": no cell runs anything\n" : "");
}

}  // namespace

TEST_CASE("a notebook has text and commands in cells, with the mathematics that Jupyter reads") {
  for (const std::size_t k : {0, 6, 10}) {
    const std::string lesson = lesson_programs().at(k);
    CAPTURE(lesson);
    const std::string text = run_program(lesson, {"--format", "notebook"}).out;
    const json notebook = json::parse(text);
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
  const std::string first = lesson_programs().at(0);
  CHECK(run_program(first, {"--format", "notebook"}).out == run_program(first, {"--format", "notebook"}).out);
  const json step = json::parse(run_program(first, {"--format", "notebook", "--step", "1"}).out);
  CHECK(step["cells"][0]["source"].get<std::string>().starts_with("## 1. "));
}

TEST_CASE("Jupyter runs every lesson") {
  if (!has_tool("jupyter-execute")) return;
  TemporaryFolder folder;
  ::setenv("PATH", (std::string(REDERIVE_PROGRAMS) + ":" + std::getenv("PATH")).c_str(), 1);
  ::setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1", 1);
  ::setenv("IPYTHONDIR", (folder.path / "ipython").c_str(), 1);
  ::setenv("REDERIVE_PROGRESS", (folder.path / "progress.txt").c_str(), 1);
  std::vector<std::string> arguments = {"-c", script, folder.path};
  for (const auto& lesson : lesson_programs()) {
    arguments.push_back(folder.path / (lesson + ".ipynb"));
    REQUIRE(run_program(lesson, {"--format", "notebook", "--out", arguments.back()}).exit_code == 0);
  }
  const Result ran = run_program(python, arguments);
  REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
  for (std::size_t k = 0; k < lesson_programs().size(); ++k)
    CHECK(complaints(lesson_programs()[k], arguments[k + 3]) == "");
}
