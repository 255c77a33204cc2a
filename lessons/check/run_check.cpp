#include <fmt/format.h>

#include <derivations/manuscript/check.hpp>
#include <derivations/program/command_line.hpp>
#include <derivations/program/program.hpp>
#include <lessons/check/run_check.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>
#include <thread>

namespace rederive::check {
using namespace program;
using namespace manuscript;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr Finding findings[] = {Finding::proved, Finding::wrong, Finding::undecided, Finding::not_read,
                                Finding::assumed};

struct CheckOptions {
  std::vector<std::string> files;
  std::string html, symbols;
  bool json = false, sarif = false, with_inline = false, strict = false, watch = false, verbose = false;
};

std::string in_words(Finding finding) {
  return finding == Finding::not_read ? "not read" : to_string(finding);
}

bool is_wrong(const Link& link, const CheckOptions& options) {
  return link.finding == Finding::wrong ||
         (options.strict && link.finding == Finding::proved && !link.conditions.empty());
}

std::string step_of(const Link& link) {
  return fmt::format("{} {} {}", link.left, link.relation, link.right);
}

/// Returns what is said of a step, behind its place.
std::string message_of(const Link& link) {
  std::string text = step_of(link);
  if (!link.witness.empty()) text += ": " + link.witness;
  if (!link.repair.empty()) text += "; it would be right with " + link.repair;
  if (link.finding != Finding::wrong && !link.reason.empty()) text += ": " + link.reason;
  for (const std::string& condition : link.conditions)
    text += (&condition == &link.conditions[0] ? ", if " : ", ") + condition;
  return text;
}

std::string place_of(const Link& link) {
  return fmt::format("{}:{}:{}", link.place.file, link.place.line, link.place.column);
}

std::string counts_of(const Report& report) {
  std::string text;
  for (const Finding finding : findings)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", report.count(finding), in_words(finding));
  return text;
}

std::string text_of(const Report& report, const CheckOptions& options) {
  std::string text;
  for (const JudgedDisplay& display : report.displays)
    for (const Link& link : display.links) {
      const bool is_shown = options.verbose || is_wrong(link, options);
      if (!is_shown) continue;
      const std::string word = link.finding == Finding::proved && options.strict && is_wrong(link, options)
                                   ? "wrong"
                                   : in_words(link.finding);
      text += printable_line(fmt::format("{}: {}: {}", place_of(link), word, message_of(link))) + "\n";
    }
  return text + printable_line(fmt::format("{}: {}", report.file, counts_of(report))) + "\n";
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json json_of(const Link& link) {
  return {{"line", link.place.line},
          {"column", link.place.column},
          {"left", link.left},
          {"relation", link.relation},
          {"right", link.right},
          {"verdict", to_string(link.finding)},
          {"conditions", link.conditions},
          {"witness", text_or_null(link.witness)},
          {"repair", text_or_null(link.repair)},
          {"reason", text_or_null(link.reason)}};
}

Json json_of(const std::vector<Report>& reports) {
  Json files = Json::array(), counts;
  for (const Finding finding : findings) {
    std::size_t total = 0;
    for (const Report& report : reports) total += report.count(finding);
    counts[to_string(finding)] = total;
  }
  for (const Report& report : reports) {
    Json displays = Json::array(), symbols = Json::array();
    for (const JudgedDisplay& display : report.displays) {
      Json links = Json::array();
      for (const Link& link : display.links) links.push_back(json_of(link));
      displays.push_back({{"line", display.place.line}, {"source", display.source}, {"links", links}});
    }
    for (const auto& [name, stated] : report.symbols)
      symbols.push_back(
          {{"name", name}, {"range", stated.range}, {"from", stated.is_from_text ? "text" : "directive"}});
    files.push_back({{"file", report.file}, {"displays", displays}, {"symbols", symbols}});
  }
  return {{"files", files}, {"counts", counts}};
}

/// Returns the wrong steps as SARIF 2.1.0.
Json sarif_of(const std::vector<Report>& reports, const CheckOptions& options) {
  Json results = Json::array();
  for (const Report& report : reports)
    for (const JudgedDisplay& display : report.displays)
      for (const Link& link : display.links) {
        if (!is_wrong(link, options)) continue;
        const Json region{{"startLine", link.place.line}, {"startColumn", link.place.column}};
        results.push_back(
            {{"ruleId", "wrong-step"},
             {"level", "error"},
             {"message", {{"text", message_of(link)}}},
             {"locations",
              Json::array({{{"physicalLocation",
                             {{"artifactLocation", {{"uri", link.place.file}}}, {"region", region}}}}})}});
      }
  const Json rule{{"id", "wrong-step"},
                  {"shortDescription", {{"text", "A step of a derivation does not follow."}}}};
  const Json driver{
      {"name", "rederive check"}, {"version", REDERIVE_VERSION}, {"rules", Json::array({rule})}};
  const Json run{{"tool", {{"driver", driver}}}, {"results", results}};
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({run})}};
}

constexpr const char* style =
    "body{font:1rem/1.5 "
    "system-ui,sans-serif;max-width:60rem;margin:auto;padding:1rem;color:#1b1b1b;background:#fff}"
    "table{border-collapse:collapse;width:100%}h2{overflow-wrap:anywhere}td,th{padding:.3rem "
    ".5rem;vertical-align:top;text-align:left;"
    "border-top:1px solid #ddd}code{white-space:pre-wrap;overflow-wrap:anywhere}.wrong td{background:#fde8e6}"
    ".proved .verdict{color:#1a6b2f}.wrong "
    ".verdict{color:#a3150b;font-weight:bold}.not_read,.undecided,.assumed{color:#555}";

std::string html_of(const std::vector<Report>& reports) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Checked formulas</title><style>{}</style></head><body>\n"
      "<h1>Checked formulas</h1>\n",
      style);
  for (const Report& report : reports) {
    html += fmt::format(
        "<h2>{}</h2>\n<p>{}</p>\n<table>\n<thead><tr><th>Line</th><th>Step</th><th>Verdict</th></tr></"
        "thead>\n"
        "<tbody>\n",
        page::escaped(report.file), page::escaped(counts_of(report)));
    for (const JudgedDisplay& display : report.displays)
      for (const Link& link : display.links) {
        std::string remark = link.witness;
        if (!link.repair.empty()) remark += "; it would be right with " + link.repair;
        if (remark.empty()) remark = link.reason;
        for (const std::string& condition : link.conditions)
          remark += (remark.empty() ? "if " : ", ") + condition;
        if (!remark.empty()) remark.insert(0, ": ");
        html += fmt::format(
            "<tr class=\"{}\"><td>{}</td><td><code>{}</code></td><td><span class=\"verdict\">{}</span> "
            "{}</td></tr>\n",
            to_string(link.finding), link.place.line, page::escaped(step_of(link)), in_words(link.finding),
            page::escaped(remark));
      }
    html += "</tbody></table>\n";
  }
  return html + "</body></html>\n";
}

std::vector<Report> reports_of(const CheckOptions& options, std::vector<fs::path>& read) {
  StatedSymbols symbols;
  if (!options.symbols.empty()) read_symbols(options.symbols, symbols);
  std::vector<Report> reports;
  for (const std::string& file : options.files) {
    const Manuscript manuscript{fs::path(file)};
    read.insert(read.end(), manuscript.files().begin(), manuscript.files().end());
    reports.push_back(manuscript::check(manuscript, symbols, options.with_inline));
  }
  return reports;
}

ExitCode run_once(const CheckOptions& options, std::vector<fs::path>& read) {
  const std::vector<Report> reports = reports_of(options, read);
  if (options.json) {
    fmt::print("{}\n", json_of(reports).dump(2));
  } else if (options.sarif) {
    fmt::print("{}\n", sarif_of(reports, options).dump(2));
  } else {
    for (const Report& report : reports) fmt::print("{}", text_of(report, options));
  }
  if (!options.html.empty()) write_whole(options.html, html_of(reports));
  std::fflush(stdout);
  for (const Report& report : reports)
    for (const JudgedDisplay& display : report.displays)
      for (const Link& link : display.links)
        if (is_wrong(link, options)) return not_as_expected;
  return as_expected;
}

/// Checks again whenever one of the files is saved.
[[noreturn]] void watch(const CheckOptions& options) {
  std::vector<fs::path> files(options.files.begin(), options.files.end());
  for (std::vector<fs::file_time_type> seen; true;) {
    std::vector<fs::file_time_type> now;
    for (const fs::path& file : files) {
      std::error_code missing;
      now.push_back(fs::last_write_time(file, missing));
    }
    if (now != seen) {
      std::vector<fs::path> read;
      try {
        (void)run_once(options, read);
        files = read;
        now.clear();
        for (const fs::path& file : files) {
          std::error_code missing;
          now.push_back(fs::last_write_time(file, missing));
        }
      } catch (const BadInput& error) {
        fmt::print(stderr, "rederive: {}\n", printable(error.what()));
      }
      seen = now;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace

int run_check(int argc, char** argv) {
  std::string verbose = "--verbose";  // of which -v is short; elsewhere it is a formula
  for (int k = 1; k < argc; ++k)
    if (std::string_view(argv[k]) == "-v") argv[k] = verbose.data();
  CheckOptions options;
  CLI::App app{
      "Judges the formulas of manuscripts step by step: which line does not follow from the one before, and "
      "at which "
      "values one sees it. Reads LaTeX, Markdown with $$ and Jupyter notebooks."};
  app.add_option("files", options.files, "Files: .tex, .md or .ipynb.")->required()->type_name("FILE");
  auto* json = app.add_flag("--json", options.json, "Write all steps as JSON.");
  app.add_flag("--sarif", options.sarif, "Write the wrong steps as SARIF, for code scanning.")
      ->excludes(json);
  app.add_option("--html", options.html, "Write a page with the formulas and their verdicts.")
      ->type_name("FILE");
  app.add_option("--symbols", options.symbols, "Declare symbols by a table [symbols] in a TOML file.")
      ->type_name("FILE");
  app.add_flag("--inline", options.with_inline, "Judge the formulas in the text, too.");
  app.add_flag("--strict", options.strict, "Count a step that holds under conditions only as wrong.");
  app.add_flag("--verbose", options.verbose,
               "Show every step, with the conditions under which it holds; -v for short.");
  app.add_flag("--watch", options.watch, "Check again whenever a file is saved. Ctrl-C ends it.");
  app.footer(R"(Examples:
  $ rederive check notes.tex
  $ rederive check -v --html notes.html chapter-*.tex

A comment in the file declares symbols, and says how the next display is judged:
  % rederive: x > 0; n integer; theta in (-pi/2, pi/2); f function; z complex
  % rederive: identity
  % rederive: from eq:motion, eq:inertia

)");
  return run_command(app, argc, argv, [&] {
    if (options.watch) watch(options);
    std::vector<fs::path> read;
    return run_once(options, read);
  });
}

}  // namespace rederive::check
