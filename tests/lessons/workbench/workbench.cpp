// Tests the workbench in a browser: it shows the motions of `rocking response` and the map of `rocking map`,
// and makes no request. probe.html asks the scripts of the page; the document of its frame is open until all
// workers are done, and the browser waits until then.
#include <doctest/doctest.h>

#include <random>
#include <regex>
#include <tests/run_program.hpp>

namespace {

using Json = nlohmann::json;
using Options = std::map<std::string, std::string>;

/// Returns the JSON document of a subcommand of rocking.
Json rocking(const std::string& subcommand, const Options& options) {
  std::vector<std::string> arguments{subcommand, "--json"};
  for (const auto& [name, value] : options) arguments.push_back("--" + name + "=" + value);
  return json_from("rocking", arguments);
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
    const std::string probe = read_file(REDERIVE_SOURCE "/tests/lessons/workbench/probe.html");
    page.replace(page.rfind("</body>"), 7, "<script>const asked = " + asked.dump() + ";</script>" + probe);
    write_file(folder.path / "probe.html", page);
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
    const Json expected = rocking("response", cases[i]);
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
    CAPTURE(Json(options).dump());
    const Json expected = rocking("map", options);
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
    const Json expected = rocking("threshold", {{"omega", omegas[i]}});
    for (const Json& curve : found_in_browser()["forms"][i]) {
      std::vector<double> amplitudes = curve["points"][0][1];
      const std::vector<bool> is_real = curve["points"][0][2];
      CAPTURE(curve.dump());
      for (const Json& form : expected["closed_forms"]) {
        std::string name;
        for (const std::string number : form["equations"])
          name += (name.empty() ? "(" : ", (") + number + ")";
        if (curve["name"] != name) continue;
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
  CHECK(contains(found_in_browser()["said"], "after one impact"));
  CHECK(found_in_browser()["requests"] == Json::array());
}

TEST_CASE("the page is small and holds no address") {
  TemporaryFolder folder;
  const std::string page = page_at(folder.path);
  CHECK(page.size() < 400'000);
  CHECK_FALSE(contains(page, "http:"));
  CHECK_FALSE(contains(page, "https:"));
  CHECK_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:)")));
}

TEST_CASE("a page is written whole or not at all") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& more) {
    const Result r = run_script(folder.path, "rocking response --omega 3 --amplitude 1.41 --page " + more);
    CHECK(r.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(folder.path / "page.html"));
    return r.err;
  };
  write_file(folder.path / "record", "0 0\n1 1\n");
  CHECK(contains(refused("."), "it is a folder"));
  CHECK(contains(refused("page.html --record record"), "--page shows a pulse"));
  refused("no/page.html");
  refused("''");
}

TEST_CASE("ten lessons hold the workbench at a case of theirs, and show the command elsewhere") {
  int with = 0;
  for (const std::string& lesson : lesson_programs()) {
    const std::string html = run_program(lesson, {"--format", "html"}).out;
    CHECK(html.size() < 400'000);
    std::smatch match;
    if (!std::regex_search(html, match, std::regex("data-case=\"(--omega [^\"]+)\""))) continue;
    ++with;
    CHECK(contains(run_program(lesson, {"--format", "plain"}).out, "rocking response " + match[1].str()));
  }
  CHECK(with == 10);
}
