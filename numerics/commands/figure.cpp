// rocking figure N: the paper's figures, computed.
#include <fmt/format.h>

#include <numerics/commands/options.hpp>
#include <numerics/commands/sweep.hpp>
#include <numerics/pictures/figures.hpp>

namespace rederive::numerics::commands {
using namespace program;
namespace {

struct FigureCommand {
  std::string number, out, data, ground_acceleration = "0.24", threads;
  Engine engine = Engine::taylor;
};

int run_figure(const FigureCommand& options) {
  const double number = number_between("figure", options.number, 8, 16);
  if (number != static_cast<int>(number))
    throw BadInput("the number of the figure must be a whole number from 8 to 16, but it is '" +
                   options.number + "'");
  FigureOptions wanted;
  wanted.ground_acceleration = number_between("--ground-acceleration", options.ground_acceleration, 0, 10);
  wanted.engine = options.engine;
  wanted.work = sweep_work(options.threads, 1, "");
  wanted.work.progress = {};
  const Plot figure = paper_figure(static_cast<int>(number), wanted);
  if (was_interrupted(wanted.work, "nothing is written")) return not_as_expected;
  if (!options.out.empty()) draw(figure, options.out);
  if (!options.data.empty()) write_whole(options.data, figure_data(figure));
  fmt::print("Figure {}. {}\n", static_cast<int>(number), figure.caption);
  if (options.out.empty() && options.data.empty()) fmt::print("\n{}", figure_data(figure));
  return as_expected;
}

}  // namespace

void add_figure(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand("figure", "Compute and draw a figure of the paper, 8 to 16.");
  FigureCommand& options = options_for(*command, run, run_figure);
  add_text(*command, "number", options.number, "NUMBER", "Number of the figure, from 8 to 16.")->required();
  add_plot(*command, "--out", options.out, "Draw the figure to a file .svg, .png or .pdf.");
  add_file(*command, "--data", options.data, "Write the curves as CSV.");
  add_text(*command, "--ground-acceleration", options.ground_acceleration, "NUMBER",
           "Set a_g/g of figure 16, from 0 to 10. Default: 0.24.");
  add_engine(*command, options.engine);
  add_text(*command, "--threads", options.threads, "T",
           "Use T threads, from 1 to 1024. Default: all processors.");
  command->footer("Example:\n  $ rocking figure 10 --out figure.svg --data figure.csv\n");
}

}  // namespace rederive::numerics::commands
