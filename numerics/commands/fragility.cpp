// rocking fragility: the share of records that overturn a block, against what they are scaled to.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/csv.hpp>
#include <filesystem>
#include <map>
#include <numerics/commands/inputs.hpp>
#include <numerics/commands/options.hpp>
#include <numerics/commands/ranks.hpp>
#include <numerics/commands/sweep.hpp>
#include <numerics/pictures/plot.hpp>
#include <numerics/search/fragility.hpp>

namespace rederive::numerics::commands {
using namespace program;
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct FragilityCommand {
  CommonOptions common;
  std::string records, amplitudes, blocks, peak = "acceleration", csv, plot, threads;
  RecordFlags reading;
};

struct BlockFragility {
  NamedBlock of;
  std::vector<std::vector<char>> outcomes;  ///< of each record at each peak
  LognormalFit fit;

  int count(std::size_t level) const {
    return static_cast<int>(
        std::ranges::count_if(outcomes, [&](const std::vector<char>& record) { return record[level] != 0; }));
  }
};

struct Fragility {
  Peak peak;
  Model model;
  std::vector<std::string> records;
  std::vector<double> peaks;
  std::vector<BlockFragility> blocks;

  const char* unit() const { return peak == Peak::acceleration ? "g" : "m/s"; }
  std::string measure() const {
    return peak == Peak::acceleration ? "peak ground acceleration" : "peak ground velocity";
  }
  double share(int count) const { return static_cast<double>(count) / static_cast<double>(records.size()); }
};

/// Returns the files of a folder in the order of their names, without hidden ones.
std::vector<std::string> files_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (!entry->path().filename().string().starts_with('.') && !entry->is_directory(error))
      files.push_back(entry->path());
  if (error) throw BadInput("cannot read the folder '" + printable_name(folder) + "': " + error.message());
  if (files.empty()) throw BadInput("the folder '" + printable_name(folder) + "' contains no records");
  for (const std::string& file : files)
    if (!fs::is_regular_file(file, error))
      throw BadInput("'" + printable_name(file) + "' is not an ordinary file");
  std::ranges::sort(files);
  return files;
}

Record record_of(const FragilityCommand& options, const std::string& file) {
  return read_record(file, options_of(options.reading));
}

Fragility asked_of(const FragilityCommand& options) {
  Fragility asked;
  asked.peak = options.peak == "acceleration" ? Peak::acceleration : Peak::velocity;
  asked.model = options.common.model;
  const Span span = span_of("--amplitudes", options.amplitudes);
  if (!(span.from > 0 && span.to <= 1e6))
    throw BadInput(fmt::format("--amplitudes {} must lie above 0 and at most at 1e6", options.amplitudes));
  asked.peaks = span.values();
  if (asked.peaks.size() > 1 && !(asked.peaks.front() < asked.peaks.back()))
    throw BadInput(fmt::format(
        "--amplitudes {} are all the same: a curve needs at least two different values", options.amplitudes));
  if (options.blocks.empty())
    asked.blocks.push_back({{"block", block_of(options.common)}, {}, {}});
  else
    for (NamedBlock& block : read_blocks(options.blocks)) asked.blocks.push_back({std::move(block), {}, {}});
  if (!options.plot.empty() && asked.blocks.size() > 20)
    throw BadInput("--plot can draw at most 20 blocks in one picture");
  (void)options_of(options.reading);
  asked.records = files_in(options.records);
  return asked;
}

std::string csv_of(const Fragility& all) {
  std::string text = "block,amplitude,records,overturned,share,fit,low,high\n";
  for (const BlockFragility& block : all.blocks)
    for (std::size_t j = 0; j < all.peaks.size(); ++j) {
      const int count = block.count(j);
      text += fmt::format("{},{:.17g},{},{},{:.17g},", csv_cell(block.of.name, CsvQuotes::always),
                          all.peaks[j], all.records.size(), count, all.share(count));
      if (block.fit.curve) {
        const Estimate at = block.fit.curve->at(all.peaks[j]);
        text += fmt::format("{:.17g},{:.17g},{:.17g}\n", at.value, at.low, at.high);
      } else {
        text += ",,\n";
      }
    }
  return text;
}

Json json_of(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

Json json_of(const Fragility& all) {
  Json document{{"measure", all.measure()}, {"unit", all.unit()},       {"model", name_of(all.model)},
                {"confidence", 0.95},       {"records", Json::array()}, {"blocks", Json::array()}};
  for (const auto& record : all.records)
    document["records"].push_back(printable_line(fs::path(record).filename()));
  for (const BlockFragility& block : all.blocks) {
    const auto& curve = block.fit.curve;
    Json levels = Json::array();
    for (std::size_t j = 0; j < all.peaks.size(); ++j) {
      const int count = block.count(j);
      levels.push_back({{"amplitude", all.peaks[j]},
                        {"overturned", count},
                        {"share", all.share(count)},
                        {"fit", curve ? json_of(curve->at(all.peaks[j])) : Json()}});
    }
    document["blocks"].push_back({{"name", block.of.name},
                                  {"alpha", block.of.block.alpha},
                                  {"frequency_parameter", block.of.block.p},
                                  {"restitution", block.of.block.restitution},
                                  {"median", curve ? json_of(curve->median()) : Json()},
                                  {"beta", curve ? json_of(curve->beta()) : Json()},
                                  {"why_no_fit", curve ? Json() : Json(words_for(*block.fit.why_none))},
                                  {"levels", std::move(levels)}});
  }
  return document;
}

void print_table(const Fragility& all) {
  fmt::print("{} in {}, {} records, {} model\n", all.measure(), all.unit(), all.records.size(),
             name_of(all.model));
  for (const BlockFragility& block : all.blocks) {
    fmt::print("\n{}: alpha = {:.6g} rad, p = {:.6g} 1/s, e = {:.6g}\n{:>12} {:>10} {:>8}", block.of.name,
               block.of.block.alpha, block.of.block.p, block.of.block.restitution, all.unit(), "overturned",
               "share");
    fmt::print("{}\n", block.fit.curve ? fmt::format(" {:>8} {:>8} {:>8}", "fit", "low", "high") : "");
    for (std::size_t j = 0; j < all.peaks.size(); ++j) {
      const int count = block.count(j);
      fmt::print("{:>12.6g} {:>10} {:>8.4f}", all.peaks[j], count, all.share(count));
      if (block.fit.curve) {
        const Estimate at = block.fit.curve->at(all.peaks[j]);
        fmt::print(" {:>8.4f} {:>8.4f} {:>8.4f}", at.value, at.low, at.high);
      }
      fmt::print("\n");
    }
    if (block.fit.curve) {
      const Estimate median = block.fit.curve->median(), beta = block.fit.curve->beta();
      fmt::print("lognormal: median {:.6g} {} ({:.6g} to {:.6g}), beta {:.6g} ({:.6g} to {:.6g}); 95 %\n",
                 median.value, all.unit(), median.low, median.high, beta.value, beta.low, beta.high);
    } else {
      fmt::print("no lognormal curve: {}\n", words_for(*block.fit.why_none));
    }
  }
}

/// Returns a text as gnuplot's enhanced text.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += (std::string("\\{}^_@~").find(c) == std::string::npos ? "" : "\\") + std::string(1, c);
  return result;
}

Panel panel_of(const Fragility& all, const BlockFragility& block) {
  Curve shares{"share of the records", {}, 1, true}, fit{"lognormal curve", {}, 1},
      low{"its 95 % band", {}, 2}, high{"", {}, 2};
  shares.symbol = 6, low.grey = high.grey = true;
  for (std::size_t j = 0; j < all.peaks.size(); ++j)
    shares.points.emplace_back(all.peaks[j], all.share(block.count(j)));
  constexpr int points = 200;
  for (int i = 0; block.fit.curve && i <= points; ++i) {
    const double x = std::lerp(all.peaks.front(), all.peaks.back(), static_cast<double>(i) / points);
    const Estimate at = block.fit.curve->at(x);
    fit.points.emplace_back(x, at.value), low.points.emplace_back(x, at.low),
        high.points.emplace_back(x, at.high);
  }
  Panel panel;
  panel.title = plain(block.of.name) + (block.fit.curve ? "" : ": no lognormal curve");
  panel.x_label = fmt::format("{} ({})", all.measure(), all.unit());
  panel.y_label = "share that overturns (dimensionless)";
  panel.curves = {shares, fit, low, high};
  panel.y_range = {-0.02, 1.02};
  panel.key = "bottom right";
  return panel;
}

Plot figure_of(const Fragility& all) {
  Plot figure{fmt::format("{} records, {} model", all.records.size(), name_of(all.model)), {}};
  for (const BlockFragility& block : all.blocks) figure.panels.push_back(panel_of(all, block));
  return figure;
}

int run_fragility(const FragilityCommand& options) {
  Fragility all = asked_of(options);
  bool is_of_use = option_of_columns(options.reading).empty() || !is_first_rank();  // of one record at least
  for (const auto& file : is_first_rank() ? all.records : std::vector<std::string>()) {
    const Record record = record_of(options, file);
    is_of_use = is_of_use || !record.is_headed;
    if (!(peak_of(record, all.peak) > 0))
      throw BadInput(
          fmt::format("'{}' cannot be scaled: all of its accelerations are 0", printable_name(file)));
  }
  if (!is_of_use)
    throw BadInput(fmt::format("{} must be left out: the headers of all records already say it",
                               option_of_columns(options.reading)));
  const int records = static_cast<int>(all.records.size());
  for (BlockFragility& block : all.blocks) block.outcomes.resize(all.records.size());
  Work work = sweep_work(options.threads, records * static_cast<int>(all.blocks.size()), "motions");
  Task<char> task;
  task.compute = [&](int i) {
    const Record record = record_of(options, all.records[static_cast<std::size_t>(i % records)]);
    return overturned_at(all.blocks[static_cast<std::size_t>(i / records)].of.block, all.model, record,
                         all.peak, all.peaks);
  };
  task.accept = [&](int i, const std::vector<char>& outcomes) {
    all.blocks[static_cast<std::size_t>(i / records)].outcomes[static_cast<std::size_t>(i % records)] =
        outcomes;
  };
  share(work, task);
  if (was_interrupted(work, "nothing is written")) return not_as_expected;
  for (BlockFragility& block : all.blocks) block.fit = lognormal_fit(all.peaks, block.outcomes);
  if (!options.csv.empty()) write_whole(options.csv, csv_of(all));
  if (!options.plot.empty()) draw(figure_of(all), options.plot);
  options.common.json ? print_json(json_of(all)) : print_table(all);
  return as_expected;
}

}  // namespace

void add_fragility(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand(
      "fragility", "Compute the share of records that overturn a block, and its lognormal curve.");
  FragilityCommand& options = options_for(*command, run, run_fragility);
  auto* records = add_text(*command, "--records", options.records, "DIR",
                           "Read the recorded accelerations in this folder, as response --record does.")
                      ->required();
  add_text(*command, "--amplitudes", options.amplitudes, "A1:A2:N",
           "Scale the peak of each record to N values from A1 to A2, above 0 and up to 1e6.")
      ->required();
  add_text(*command, "--peak", options.peak, "NAME",
           "Scale the peak acceleration in g, or the peak velocity in m/s. Default: acceleration.")
      ->check(CLI::IsMember({"acceleration", "velocity"}));
  auto* blocks = add_text(
      *command, "--blocks", options.blocks, "FILE",
      "Read the blocks from a TOML file of [[block]] tables, each with name, restitution, and either\n"
      "half_width and half_height or alpha and frequency_parameter.");
  add_block_options(*command, options.common);
  for (const char* name : {"--alpha", "--frequency-parameter", "--half-width", "--restitution"})
    blocks->excludes(command->get_option(name));
  add_model(*command, options.common.model);
  add_record_flags(*command, options.reading, records);
  add_threads(*command, options.threads);
  add_file(*command, "--csv", options.csv, "Write the table as CSV.");
  add_plot(*command, "--plot", options.plot, "Draw the curves to a file .svg, .png or .pdf.");
  add_json(*command, options.common.json);
  command->footer(
      "Example:\n  $ rocking fragility --records quakes --amplitudes 0.1:1:10 --half-width 0.3 --half-height "
      "1\n");
}

}  // namespace rederive::numerics::commands
