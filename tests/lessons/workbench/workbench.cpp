// The workbench in a browser: its motions are those of `rocking response`, its map is that of `rocking map`,
// and it asks nothing of anybody.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <tests/run_program.hpp>

namespace {

using Json = nlohmann::json;
using Options = std::map<std::string, std::string>;

std::vector<std::string> arguments_of(const std::string& subcommand, const Options& options) {
  std::vector<std::string> arguments{subcommand};
  for (const auto& [name, value] : options) arguments.push_back("--" + name + "=" + value);
  return arguments;
}

/// Cases at random: both models and pulses, from rest and not, e by its law and not.
std::vector<Options> cases_at_random(int count) {
  std::mt19937 random(20);
  const auto between = [&](double low, double high) {
    std::string text = std::to_string(low + (high - low) * static_cast<double>(random() % 100'000) / 1e5);
    return text.substr(0, text.find('.') + 5);
  };
  std::vector<Options> cases;
  for (int i = 0; i < count; ++i) {
    const double alpha = 0.1 + 0.1 * (i % 5);
    Options options{{"omega", between(0.5, 9)},
                    {"amplitude", between(1.2, 9)},
                    {"alpha", std::to_string(alpha)},
                    {"restitution", i % 3 == 0 ? between(0.5, 1) : "auto"},
                    {"model", i % 2 == 0 ? "linear" : "nonlinear"},
                    {"pulse", i / 2 % 2 == 0 ? "sine" : "cosine"}};
    if (i / 4 % 2 == 1) {
      options["theta0"] = between(-alpha / 2, alpha / 2);
      options["thetadot0"] = between(-alpha, alpha);
      options["frequency-parameter"] = between(1, 4);
    }
    cases.push_back(options);
  }
  return cases;
}

/// All modes of the map.
std::vector<Options> maps() {
  std::vector<Options> all;
  for (const std::string model : {"linear", "nonlinear"})
    for (const std::string pulse : {"sine", "cosine"})
      for (const std::string velocity : {"0", "-0.2"})
        all.push_back({{"model", model}, {"pulse", pulse}, {"thetadot0", velocity}});
  return all;
}

/// What the scripts of the page say of the cases, in a browser. The document of a frame is open until all
/// workers are done: so long the browser waits.
constexpr auto probe = R"(<pre id="out"></pre><iframe hidden></iframe><script>
const frame = document.querySelector("iframe").contentDocument;
frame.open();
frame.write("waiting");
const text = (options) => Object.entries(options).map(([name, value]) => `--${name}=${value}`).join(" ");
async function mapOf(options) {
  return new Promise((resolve) => {
    const map = new OutcomeMap(() => map.seconds !== null && resolve(map.cells));
    map.start(caseOf(stateFrom(text(options))), { from: 0.5, to: 9, count: 18 }, { from: 1.1, to: 9, count: 15 });
  });
}
(async () => {
  const found = { motions: asked.cases.map((options) => {
    const { code, time, events } = motionOf(caseOf(stateFrom(text(options))));
    return { code, time, impacts: events.filter((event) => event.kind === "impact").map((event) => event.time) };
  }), maps: [] };
  for (const options of asked.maps) found.maps.push(await mapOf(options));
  const rests = caseOf(stateFrom(""));
  found.forms = [2, 3, 5, 6.5].map((omega) => curvesOf(rests, { from: omega, to: omega, count: 1 }));
  const tau = 1.0863845219098776;
  found.printed = [tau, tau + 0.5].map((t) => emitted.overturning_impact_during_pulse_as_printed(3, 1, 0.7, tau, t, 0.9) -
    emitted.overturning_impact_during_pulse(3, 0.7, tau, 0.9));
  found.opened = commandOf(workbenches[0].state);
  found.said = document.querySelector(".state").textContent;
  found.requests = performance.getEntriesByType("resource").map((one) => one.name).filter((name) => !/^(data|blob):/.test(name));
  document.getElementById("out").textContent = JSON.stringify(found);
  frame.close();
})();
</script></body>)";

std::string page_at(const std::filesystem::path& folder) {
  const std::string file = (folder / "page.html").string();
  REQUIRE(
      run_program("rocking", {"response", "--omega", "3", "--amplitude", "1.41", "--page", file}).exit_code ==
      0);
  return read_file(file);
}

const Json& found_in_browser() {
  static const Json found = [] {
    TemporaryFolder folder;
    std::string page = page_at(folder.path);
    const Json asked{{"cases", cases_at_random(200)}, {"maps", maps()}};
    page.replace(page.rfind("</body>"), 7, "<script>const asked = " + asked.dump() + ";</script>" + probe);
    std::ofstream(folder.path / "probe.html") << page;
    const Result shown = run_program(
        "/usr/bin/env",
        {"timeout", "3000", "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
         "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--user-data-dir=" + (folder.path / "profile").string(), "--dump-dom",
         "file://" + (folder.path / "probe.html").string()});
    const auto from = shown.out.find("<pre id=\"out\">"), to = shown.out.find("</pre>", from);
    REQUIRE_MESSAGE(from != std::string::npos, shown.err);
    return Json::parse(
        std::regex_replace(shown.out.substr(from + 14, to - from - 14), std::regex("&[lg]t;"), "?"));
  }();
  return found;
}

}  // namespace

TEST_CASE("the workbench moves and falls as rocking response says, at 200 points") {
  if (!has_tool("chromium")) return;
  const std::vector<Options> cases = cases_at_random(200);
  const Json& motions = found_in_browser()["motions"];
  REQUIRE(motions.size() == cases.size());
  int impacts = 0;
  std::set<int> codes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::vector<std::string> arguments = arguments_of("response", cases[i]);
    arguments.push_back("--json");
    const Json expected = Json::parse(run_program("rocking", arguments).out);
    CAPTURE(Json(cases[i]).dump());
    CHECK(motions[i]["code"] == expected["code"]);
    codes.insert(expected["code"].get<int>());
    std::vector<double> times;
    for (const Json& event : expected["events"])
      if (event["kind"] == "impact") times.push_back(event["time"]);
    REQUIRE(motions[i]["impacts"].size() == times.size());
    for (std::size_t k = 0; k < times.size(); ++k, ++impacts)
      CHECK(std::abs(motions[i]["impacts"][k].get<double>() - times[k]) < 1e-9);
    REQUIRE(motions[i]["time"].is_null() == expected["time"].is_null());
    if (!expected["time"].is_null())
      CHECK(std::abs(motions[i]["time"].get<double>() - expected["time"].get<double>()) < 1e-9);
  }
  CHECK(impacts > 500);
  CHECK(codes.size() >= 4);
}

TEST_CASE("the map of the workbench is that of rocking map, cell by cell, in all modes") {
  if (!has_tool("chromium")) return;
  const Json& found = found_in_browser()["maps"];
  for (std::size_t i = 0; i < maps().size(); ++i) {
    Options options = maps()[i];
    options["omega"] = "0.5:9:18", options["amplitude"] = "1.1:9:15";
    std::vector<std::string> arguments = arguments_of("map", options);
    arguments.push_back("--json");
    CAPTURE(Json(options).dump());
    const Json expected = Json::parse(run_program("rocking", arguments).out);
    Json cells = Json::array();
    for (const Json& column : expected["codes"]) cells.insert(cells.end(), column.begin(), column.end());
    CHECK(found[i] == cells);
    CHECK(std::set<Json>(cells.begin(), cells.end()).size() > 1);
  }
}

TEST_CASE("the curves are the closed forms of rocking threshold, those that are true and the others") {
  if (!has_tool("chromium")) return;
  const std::vector<std::string> omegas{"2", "3", "5", "6.5"};
  int compared = 0, real = 0;
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    const Json expected =
        Json::parse(run_program("rocking", {"threshold", "--omega", omegas[i], "--json"}).out);
    for (const Json& curve : found_in_browser()["forms"][i]) {
      std::vector<double> amplitudes = curve["points"][0][1];
      const std::vector<bool> is_real = curve["points"][0][2];
      CAPTURE(curve.dump());
      for (const Json& form : expected["closed_forms"]) {
        const Json& numbers = form["equations"];
        const bool same =
            curve["name"] == "(" + numbers[0].get<std::string>() + ")" +
                                 (numbers.size() > 1 ? ", (" + numbers[1].get<std::string>() + ")" : "");
        if (!same) continue;
        const double amplitude = form["amplitude"];
        const auto at = std::find_if(amplitudes.begin(), amplitudes.end(), [&](double found) {
          return std::abs(found - amplitude) < 1e-9 * amplitude;
        });
        if (form["admissible"] == true) REQUIRE(at != amplitudes.end());
        if (at == amplitudes.end()) continue;  // an impact after the pulse by an equation for one during it
        ++compared;
        const bool drawn = is_real[static_cast<std::size_t>(at - amplitudes.begin())];
        const bool ends =
            form["why_not"].is_string() && form["why_not"].get<std::string>().starts_with("not a minimum");
        CHECK(drawn == (form["admissible"] == true || ends));
        real += drawn ? 1 : 0;
      }
    }
  }
  CHECK(compared > 12);
  CHECK(real > 8);
  CHECK(std::abs(found_in_browser()["printed"][0].get<double>()) <
        1e-12);  // (88) as printed holds at t = t_i alone
  CHECK(std::abs(found_in_browser()["printed"][1].get<double>()) > 0.1);
}

TEST_CASE("a page is opened at its case, says it in words, and asks nothing of the network") {
  if (!has_tool("chromium")) return;
  CHECK(found_in_browser()["opened"] == "rocking response --omega=3 --amplitude=1.41");
  CHECK(found_in_browser()["said"].get<std::string>().find("after one impact") != std::string::npos);
  CHECK(found_in_browser()["requests"] == Json::array());
}

TEST_CASE("the page is small and holds no address, and all scripts of ours have at most 1,200 lines") {
  TemporaryFolder folder;
  const std::string page = page_at(folder.path);
  CHECK(page.size() < 400'000);
  CHECK(page.find("http:") == std::string::npos);
  CHECK(page.find("https:") == std::string::npos);
  CHECK_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:)")));
  int lines = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(REDERIVE_SOURCE "/lessons")) {
    const std::string text = file.path().extension() == ".js" ? read_file(file.path()) : "";
    lines += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }
  MESSAGE("the scripts of the pages have ", lines, " lines");
  CHECK(lines <= 1200);
}

TEST_CASE("a page is written whole or not at all") {
  const std::vector<std::string> asked{"response", "--omega", "3", "--amplitude", "1.41", "--page"};
  TemporaryFolder folder;
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), asked.begin(), asked.end());
    return run_program("rocking", more);
  };
  const Result folder_given = with({folder.path.string()});
  CHECK(folder_given.exit_code == 2);
  CHECK(folder_given.err.find("it is a folder") != std::string::npos);
  CHECK(with({(folder.path / "no/page.html").string()}).exit_code == 2);
  CHECK(with({""}).exit_code == 2);
  std::ofstream(folder.path / "record") << "0 0\n1 1\n";
  const Result record =
      with({(folder.path / "page.html").string(), "--record", (folder.path / "record").string()});
  CHECK(record.exit_code == 2);
  CHECK(record.err.find("--page shows a pulse") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path / "page.html"));
}

TEST_CASE("ten lessons hold the workbench at a case of theirs, and show the command elsewhere") {
  int with = 0;
  for (const std::string& lesson : lesson_programs()) {
    const std::string html = run_program(lesson, {"--format", "html"}).out;
    CHECK(html.size() < 400'000);
    std::smatch match;
    if (!std::regex_search(html, match, std::regex("data-case=\"(--omega [^\"]+)\""))) continue;
    ++with;
    CHECK(run_program(lesson, {"--format", "plain"}).out.find("rocking response " + match[1].str()) !=
          std::string::npos);
  }
  CHECK(with == 10);
}
