#include <fmt/format.h>

#include <derivations/program/command_line.hpp>
#include <derivations/program/data_folder.hpp>
#include <lessons/papers/new_paper.hpp>

namespace rederive::papers {
using namespace program;
namespace fs = std::filesystem;

namespace {

struct NewOptions {
  std::string folder, from = "rod";
  bool python = false, cpp = false;
};

/// Returns the text of a file in which commands name the new folder instead of the example.
std::string with_name(std::string text, const NewOptions& options) {
  const std::string before = "rederive " + options.from + " ",
                    after =
                        "rederive " + fs::path(options.folder).lexically_normal().filename().string() + " ";
  for (std::size_t place = 0; (place = text.find(before, place)) != text.npos; place += after.size())
    text.replace(place, before.size(), after);
  return text;
}

int copy_example(const NewOptions& options) {
  if (fs::exists(options.folder) && !fs::is_empty(options.folder))
    throw BadInput("'" + printable_name(options.folder) + "' exists already; give the name of a new folder");
  const fs::path papers = data_folder() / "papers", example = papers / options.from;
  const std::string own = fs::exists(example / "derive.py") ? ".py" : ".cpp";
  const std::string language = options.python ? ".py" : options.cpp ? ".cpp" : own;
  std::vector<std::pair<fs::path, std::string>> files;
  for (const auto& file : fs::directory_iterator(example)) {
    const std::string name = file.path().filename();
    // derivations of the other language are not those of this file
    if (language != own && (name == "derivations.json" || name == "derive" + own)) continue;
    files.emplace_back(fs::path(options.folder) / name, with_name(read_whole(file.path()), options));
  }
  if (language != own)
    files.emplace_back(fs::path(options.folder) / ("derive" + language),
                       read_whole(papers / "other-language" / (options.from + language)));
  make_output_folder(options.folder);
  write_together(files);
  const std::string name = printable_name(options.folder);
  fmt::print("The paper is in {0}. Try:\n  rederive {0}{1}\n  rederive {0} show 1\n  rederive {0} test\n",
             name, language != own && language == ".cpp" ? " build\n  rederive " + name : "");
  return as_expected;
}

}  // namespace

int run_new(int argc, char** argv) {
  CLI::App app{"Writes the folder of a paper that passes its own test, to begin with."};
  NewOptions options;
  app.add_option("DIR", options.folder, "Folder for the paper. It must be new or empty.")->required();
  app.add_option("--from", options.from, "Begin with this example. Default: rod.")
      ->check(CLI::IsMember({"rod", "oscillator", "empty"}));
  auto* python = app.add_flag("--python", options.python, "Derive in Python: derive.py.");
  app.add_flag("--cpp", options.cpp, "Derive in C++: derive.cpp.")->excludes(python);
  app.footer("Examples:\n  $ rederive new my-paper\n  $ rederive new my-paper --from empty --python\n\n");
  return run_command(app, argc, argv, [&] { return copy_example(options); });
}

}  // namespace rederive::papers
