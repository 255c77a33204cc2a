#include <derivations/paper/derivation_file.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/paper/run_derive.hpp>
#include <derivations/program/command_line.hpp>

namespace rederive::paper {
using namespace program;

int run_derive(const DeriveRows& derive, int argc, char** argv) {
  CLI::App app{"Derives the rows of a paper, and writes derivations.json into its folder."};
  std::string folder;
  app.add_option("DIR", folder, "Folder of the paper.")->required()->check(CLI::ExistingDirectory);
  return run_command(app, argc, argv, [&] {
    const Paper paper = read_declarations(folder);
    Derivations rows;
    try {
      derive(paper.symbols, rows);
    } catch (const std::exception& error) {  // an undeclared symbol, a row that is derived twice
      throw BadInput(error.what());
    }
    write_whole(paper.folder / "derivations.json", derivations_text(rows, paper.symbols, digest_of(folder)));
    return as_expected;
  });
}

}  // namespace rederive::paper
