#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace {

nlohmann::json json_of(const std::vector<std::string>& arguments) {
  const Result result = run_program("rocking", arguments);
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return nlohmann::json::parse(result.out);
}

void check_refused(const std::vector<std::string>& arguments, const std::string& named) {
  const Result result = run_program("rocking", arguments);
  CAPTURE(named);
  CAPTURE(result.err);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK(result.err.find(named) != std::string::npos);
}

}  // namespace

TEST_CASE("rocking threshold --json keeps its contract") {
  const auto document = json_of({"threshold", "--omega", "2", "--json"});
  for (const char* name : {"omega_ratio", "alpha", "restitution", "model", "pulse", "unit", "minimum",
                           "windows", "closed_forms"})
    CHECK(document.contains(name));
  CHECK(document["unit"] == "alpha_g");
  CHECK(document["minimum"]["code"] == 2);
  CHECK(document["windows"].back()["to"].is_null());
  for (const auto& root : document["closed_forms"]) {
    for (const char* name :
         {"equations", "amplitude", "psi", "impact_time", "pulse_end", "admissible", "why_not"})
      CHECK(root.contains(name));
    CHECK(root["why_not"].is_null() == root["admissible"].get<bool>());
  }
}

TEST_CASE("every output of a search says how narrow windows may be missing") {
  const TemporaryFolder folder;
  const std::string words = "(in units of alpha g) may be missing", file = folder.path / "plot.svg";
  const auto has = [&](const std::string& text) { return text.find(words) != std::string::npos; };
  for (const bool least : {false, true}) {
    const std::vector<std::vector<std::string>> commands{
        {"threshold", "--omega", "2"},
        {"spectrum", "--from", "2", "--to", "3", "--points", "2", "--plot", file}};
    for (std::vector<std::string> command : commands) {
      if (least) command.emplace_back("--least");
      const Result said = run_program("rocking", command);
      CHECK(
          (has(said.out) || has(said.err)));  // a spectrum is a table of numbers, for other programs to read
      command.emplace_back("--json");
      CHECK(json_of(command)["windows_narrower_than_may_be_missing"] == (least ? 1e-9 : 1e-5));
    }
    CHECK(has(read_file(file)));
  }
}

TEST_CASE("the least amplitude without loss at impacts is below one that a response confirms") {
  const std::vector<std::string> common{"--omega", "0.1", "--restitution", "1", "--json"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), common.begin(), common.end());
    return json_of(arguments);
  };
  const auto least = with({"threshold", "--least"})["minimum"];
  CHECK(least["amplitude"].get<double>() < 1.00139806245156);
  CHECK(with({"response", "--amplitude", least["amplitude"].dump()})["code"] == least["code"]);
  CHECK(with({"response", "--amplitude", "1.00139806245156"})["code"] == least["code"]);
}

TEST_CASE("rocking threshold --digits gives that many figures, and no more than are right") {
  const auto figures = [](std::string number) {
    std::erase(number, '.');
    return number.size();
  };
  const std::vector<std::string> common{"threshold", "--omega", "0.5", "--digits", "50", "--json"};
  const auto document = json_of(common);
  for (const auto& root : document["closed_forms"]) CHECK(figures(root["amplitude"]) == 50);
  const auto& windows = document["windows"];
  CHECK(document["minimum"]["amplitude"] == windows[0]["from"]);
  CHECK(figures(windows[0]["from"]) == 12);  // after nine impacts: no closed form
  CHECK(windows.back()["code"] == -1);
  CHECK(windows.back()["from"] == document["closed_forms"][0]["amplitude"]);
  CHECK(windows.back()["to"].is_null());
  auto nonlinear = common;
  nonlinear.insert(nonlinear.end(), {"--model", "nonlinear"});
  const auto found = json_of(nonlinear);  // which the loop would outlive
  for (const auto& window : found["windows"]) CHECK(figures(window["from"]) == 10);
}

TEST_CASE("rocking response --json keeps its contract") {
  const auto document = json_of({"response", "--omega", "2", "--amplitude", "1.6", "--json"});
  CHECK(document["outcome"] == "overturned");
  CHECK(document["code"] == 2);
  CHECK(document["impacts"] == 1);
  CHECK(document["time"].is_number());
  for (const auto& event : document["events"])
    for (const char* name : {"time", "kind", "theta_over_alpha", "velocity_before", "velocity_after"})
      CHECK(event.contains(name));
  CHECK(json_of({"response", "--omega", "2", "--amplitude", "0.9", "--json"})["outcome"] == "safe");
}

TEST_CASE("a block that begins beyond the corner, and stays there, overturns at once") {
  CHECK(json_of({"response", "--omega", "1", "--amplitude", "1.01", "--theta0", "0.26", "--thetadot0", "0.75",
                 "--json"})["time"] == 0);
}

TEST_CASE("a block overturns where it passes the corner outward for the last time") {
  // Out, in and out again under one push; the times are those of an independent integration.
  struct Case {
    const char *model, *velocity, *omega, *amplitude;
    double time;
  };
  for (const Case& c : {Case{"linear", "0.5", "10", "5", 0.4392662041},
                        {"nonlinear", "0.5", "10", "5", 0.4395966180},
                        {"linear", "0.8", "6", "6", 0.8415892431},
                        {"nonlinear", "0.8", "6", "6", 0.8406894924}}) {
    CAPTURE(c.model);
    const auto document =
        json_of({"response", "--alpha", "0.3", "--theta0", "0.28", "--thetadot0", c.velocity, "--omega",
                 c.omega, "--amplitude", c.amplitude, "--model", c.model, "--json"});
    CHECK(document["time"].get<double>() == doctest::Approx(c.time).epsilon(1e-9));
  }
  const auto begun_beyond =
      json_of({"response", "--alpha", "0.30622113304675425", "--restitution", "0.9285949427828709",
               "--theta0", "-0.31289088796275305", "--thetadot0", "0.2436717414419347", "--omega",
               "5.091874141638044", "--amplitude", "10.031531443302486", "--json"});
  CHECK(begun_beyond["time"].get<double>() == doctest::Approx(0.1307833100).epsilon(1e-9));
}

TEST_CASE("histories, spectra and maps are written as CSV with their headers") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "out.csv";
  REQUIRE(
      run_program("rocking", {"response", "--omega", "2", "--amplitude", "1.6", "--csv", file}).exit_code ==
      0);
  CHECK(read_file(file).starts_with("tau,theta_over_alpha,thetadot_over_alpha_p,ground_over_g\n0,0,0,"));
  REQUIRE(run_program("rocking", {"spectrum", "--from", "2", "--to", "3", "--points", "2", "--csv", file})
              .exit_code == 0);
  CHECK(read_file(file).starts_with("omega_ratio,minimum,code,mode1,mode2_lower,mode2_upper\n2,1.2"));
  for (const char* threads : {"1", "3"}) {
    REQUIRE(run_program("rocking", {"map", "--omega", "1:5:4", "--amplitude", "1:3:3", "--threads", threads,
                                    "--csv", file + threads})
                .exit_code == 0);
    CHECK(read_file(file + threads).starts_with("omega_ratio,amplitude,code\n1,1,0\n"));
  }
  CHECK(read_file(file + "1") == read_file(file + "3"));
  for (const char* engine : {"gsl", "taylor"})
    REQUIRE(run_program("rocking", {"map", "--omega", "1:5:4", "--amplitude", "1:3:3", "--model", "nonlinear",
                                    "--engine", engine, "--tolerance", "1e-9", "--csv", file + engine})
                .exit_code == 0);
  CHECK(read_file(file + "gsl") == read_file(file + "taylor"));
  for (const char* model : {"linear", "nonlinear"}) {
    const auto threshold = [&](const std::vector<std::string>& more) {
      std::vector<std::string> all{"threshold", "--omega", "3", "--model", model, "--json"};
      all.insert(all.end(), more.begin(), more.end());
      return nlohmann::json::parse(run_program("rocking", all).out);
    };
    const auto least = threshold({"--least"}), whole = threshold({}), by_gsl = threshold({"--engine", "gsl"});
    CHECK(least.at("windows").is_null());
    CHECK(least.at("minimum").at("code") == whole.at("minimum").at("code"));
    for (const auto& other : {whole, by_gsl})
      CHECK(std::abs(other.at("minimum").at("amplitude").get<double>() /
                         least.at("minimum").at("amplitude").get<double>() -
                     1) < 1e-10);
  }
}

TEST_CASE("two runs give the same bytes") {
  const std::vector<std::string> arguments{"threshold", "--omega", "1.3", "--model", "nonlinear", "--json"};
  CHECK(run_program("rocking", arguments).out == run_program("rocking", arguments).out);
}

TEST_CASE("plots are drawn by extension") {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> commands{
      {"response", "--omega", "2", "--amplitude", "1.6"},
      {"spectrum", "--from", "1", "--to", "3", "--points", "5"},
      {"map", "--omega", "1:3:4", "--amplitude", "1:5:4"}};
  for (const auto& command : commands)
    for (const auto& [name, begin] :
         {std::pair("p.svg", "<?xml"), std::pair("p.png", "\x89PNG"), std::pair("p.pdf", "%PDF")}) {
      const std::string file = folder.path / (command[0] + name);
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(), {"--plot", file});
      const Result result = run_program("rocking", arguments);
      REQUIRE_MESSAGE(result.exit_code == 0, result.err);
      CHECK(read_file(file).starts_with(begin));
    }
  check_refused({"response", "--omega", "2", "--amplitude", "1.6", "--plot", folder.path / "p.gif"}, "p.gif");
}

// gnuplot names each curve in its SVG and draws a cell as a polygon.
TEST_CASE("a plot has the curves of a response and of a spectrum, and the cells of a map in their greys") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "p.svg";
  const auto drawing = [&](const std::string& command) {
    const Result result = run_program(
        "/bin/sh", {"-c", "'" REDERIVE_PROGRAMS "/rocking' " + command + " --plot " + quoted(file)});
    REQUIRE_MESSAGE(result.exit_code == 0, result.err);
    return read_file(file);
  };
  const auto times = [](const std::string& text, const std::string& piece) {
    int found = 0;
    for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
    return found;
  };
  const std::string response = drawing("response --omega 2 --amplitude 1.6");
  CHECK(times(response, "id=\"gnuplot_plot_1") == 3);  // theta, its rate, and one over the other
  CHECK(times(response, " L") > 1000);
  const std::string spectrum = drawing("spectrum --from 1 --to 3 --points 5");
  CHECK(times(spectrum, "id=\"gnuplot_plot_") == 4);
  // Of each curve five points, and a line in the key.
  for (const char* curve : {"_1a\"", "_2a\"", "_3a\"", "_4a\""}) {
    const auto at = spectrum.find("id=\"gnuplot_plot" + std::string(curve));
    const auto path = spectrum.find(" d='", at);
    CHECK(times(spectrum.substr(path, spectrum.find("'/>", path) - path), " L") == 5);
  }
  const std::string map = drawing("map --omega 1:3:4 --amplitude 1:5:4");
  std::string cells = map.substr(map.find("crispEdges"));
  cells = cells.substr(0, cells.find("</g>"));
  CHECK(times(cells, "<polygon fill = 'rgb( 48,  48,  48)'") == 10);  // -1
  CHECK(times(cells, "<polygon fill = 'rgb(140, 140, 140)'") == 2);   // +2
  CHECK(times(cells, "<polygon fill = 'rgb(255, 255, 255)'") == 4);   // safe
  CHECK(run_program("rocking", {"map", "--omega", "1:3:4", "--amplitude", "1:5:4"}).out ==
        " -1         10 points  overturns to theta < 0 without impact\n +0          4 points  safe\n"
        " +2          2 points  overturns to theta > 0 after one impact\n");
}

TEST_CASE("a record is followed from its file") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "record.txt";
  std::ofstream(file) << "0 0\n0.5 0.6\n1.0 -0.6\n1.5 0\n";
  const auto document = json_of({"response", "--record", file, "--json", "--model", "nonlinear"});
  CHECK(document["events"][0]["kind"] == "start");
  CHECK(document["required_friction"].get<double>() > std::tan(0.25));
  check_refused({"response", "--record", "/no/such/file"}, "/no/such/file");
  std::ofstream(file)
      << "PEER\nA station\nACCELERATION TIME HISTORY IN UNITS OF G\n 3  0.5  NPTS, DT\n0.0 0.6 -0.6\n";
  CHECK(json_of({"response", "--record", file, "--json"})["events"][0]["kind"] == "start");
  for (const auto& [option, value] : {std::pair("--step", "0.5"), {"--unit", "g"}})
    check_refused({"response", "--record", file, option, value},
                  std::string(option) + " must be left out: the header of");
  check_refused({"response", "--omega", "2", "--amplitude", "2", "--unit", "m/s2"}, "--unit");
}

TEST_CASE("bad input ends with exit code 2 and names what was wrong") {
  check_refused({"threshold"}, "--omega");
  check_refused({"threshold", "--omega", "nan"}, "--omega");
  check_refused({"threshold", "--omega", "-1"}, "--omega");
  check_refused({"threshold", "--omega", "1e999"}, "--omega");
  check_refused({"threshold", "--omega", "2", "--alpha", "2"}, "alpha");
  check_refused({"threshold", "--omega", "2", "--alpha", "1.4"}, "restitution");
  check_refused({"threshold", "--omega", "2", "--restitution", "1.1"}, "restitution");
  check_refused({"threshold", "--omega", "2", "--model", "cubic"}, "--model");
  check_refused({"threshold", "--omega", "2", "--digits", "61"}, "--digits");
  check_refused({"threshold", "--omega", "2", "--digits", "2.5"}, "--digits");
  check_refused({"threshold", "--omega", "2", "--max-amplitude", "inf"}, "--max-amplitude");
  check_refused({"threshold", "--omega", "2", "--theta0", "x"}, "--theta0");
  check_refused({"threshold", "--omega", "2", "--model", "nonlinear", "--theta0", "1.6"}, "theta0");
  check_refused({"threshold", "--omega", "2", "--theta0", "1e308"}, "initial conditions");
  check_refused({"threshold", "--omega", "2", "--thetadot0", "-1e300", "--model", "nonlinear"}, "initial");
  check_refused({"response", "--omega", "2"}, "--amplitude");
  check_refused({"response", "--omega", "2", "--amplitude", "-1"}, "--amplitude");
  check_refused({"response", "--omega", "2", "--amplitude", "0.5", "--theta0", "0.01"}, "amplitude");
  check_refused({"spectrum", "--from", "3", "--to", "2", "--points", "4"}, "--from");
  check_refused({"spectrum", "--from", "2", "--to", "3", "--points", "1.5"}, "points");
  check_refused({"map", "--omega", "1:2", "--amplitude", "1:2:3"}, "--omega");
  check_refused({"map", "--omega", "1:2:2", "--amplitude", "1:2:3", "--engine", "euler"}, "euler");
  check_refused({"figure", "7"}, "figure");
  check_refused({"nothing"}, "nothing");
}

TEST_CASE("an initial condition too small to matter is none") {
  for (const std::string model : {"linear", "nonlinear"}) {
    std::vector<std::string> arguments{"threshold", "--omega", "2", "--model", model, "--json"};
    const auto rest = json_of(arguments);
    arguments.insert(arguments.end(), {"--theta0", "1e-300", "--thetadot0", "-1e-300"});
    CHECK(json_of(arguments) == rest);
  }
}

TEST_CASE("a negative number may follow an option") {
  const auto document =
      json_of({"threshold", "--omega", "3", "--theta0", "-0.01", "--thetadot0", "-0.1", "--json"});
  CHECK(document["closed_forms"][0]["equations"][0] == "104");
}

TEST_CASE("every command has help and the program a version") {
  for (const char* command : {"threshold", "response", "spectrum", "map", "fragility", "figure"})
    CHECK(run_program("rocking", {command, "--help"}).exit_code == 0);
  CHECK(run_program("rocking", {"--version"}).out.starts_with("Rederive"));
}
