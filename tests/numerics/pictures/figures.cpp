// The paper's figures, computed: every one draws, its curves are numbers, and they say what the simulation
// says.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>
#include <tests/run_program.hpp>

namespace {

using Curve = std::map<double, double>;

struct Drawn {
  std::map<std::string, Curve> curves;  ///< of the first panel, those over time by their time
  std::set<std::string> titles;         ///< of the curves of all panels, after the panel's
  std::string drawing;
};

/// rocking figure N, from its data and its drawing.
Drawn figure(int number) {
  const TemporaryFolder folder;
  const auto data = folder.path / "data.csv", drawing = folder.path / "drawing.svg";
  const Result r =
      run_program("rocking", {"figure", std::to_string(number), "--data", data, "--out", drawing});
  REQUIRE_MESSAGE(r.exit_code == 0, r.err);
  Drawn drawn{{}, {}, read_file(drawing)};
  std::istringstream lines(read_file(data));
  std::string line, first_panel;
  std::getline(lines, line);
  CHECK(line == "panel,curve,x,y");
  while (std::getline(lines, line)) {
    const auto y = line.rfind(','), x = line.rfind(',', y - 1), curve = line.find("\",\"");
    REQUIRE((y != line.npos && x != line.npos && curve < x));
    const double at = std::stod(line.substr(x + 1)), value = std::stod(line.substr(y + 1));
    CHECK((std::isfinite(at) && std::isfinite(value)));
    const std::string panel = line.substr(0, curve);
    if (drawn.curves.empty()) first_panel = panel;
    drawn.titles.insert(line.substr(0, x));
    if (panel == first_panel) drawn.curves[line.substr(curve + 3, x - curve - 4)][at] = value;
  }
  return drawn;
}

}  // namespace

TEST_CASE("every figure draws, and block after block is safe or overturns as its curve is called") {
  int safe = 0, overturning = 0;
  for (int number = 8; number <= 16; ++number) {
    CAPTURE(number);
    const Drawn drawn = figure(number);
    CHECK(drawn.drawing.find("<svg") != std::string::npos);
    CHECK(drawn.drawing.find("</svg>") != std::string::npos);
    CHECK(drawn.curves.size() >= 2);
    const std::string plot = "id=\"gnuplot_plot_";  // so gnuplot begins each curve
    std::size_t plots = 0;
    for (auto at = drawn.drawing.find(plot); at != std::string::npos; at = drawn.drawing.find(plot, at + 1))
      ++plots;
    CHECK(plots == drawn.titles.size());
    for (const auto& [its_name, curve] : drawn.curves) {
      const auto& name = its_name;
      CAPTURE(name);
      const double last = std::abs(curve.rbegin()->second);  // theta/alpha
      if (name.ends_with(": safe")) CHECK(last < 1), ++safe;
      if (name.ends_with(": overturns")) CHECK(last > 3), ++overturning;
    }
  }
  CHECK(safe == 7);
  CHECK(overturning == 7);
}

TEST_CASE("without gnuplot a figure is refused, and says what to install") {
  const TemporaryFolder folder;
  const std::string rocking = REDERIVE_PROGRAMS "/rocking", file = folder.path / "drawing.svg";
  const Result r = run_program("/usr/bin/env", {"PATH=/nowhere", rocking, "figure", "8", "--out", file});
  CHECK(r.exit_code == 2);
  CHECK(r.err.find("gnuplot-nox") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("the least amplitude of figure 10 is that of the first condition, or of one for more impacts") {
  const Drawn drawn = figure(10);
  int equal = 0;
  for (const auto& point : drawn.curves.at("simulated least amplitude")) {
    const double omega = point.first, simulated = point.second;
    CAPTURE(omega);
    double least = 1e300;
    for (const auto& [name, curve] : drawn.curves)
      if (name.starts_with('(') && name.find("not admissible") == std::string::npos)
        if (const auto near = curve.lower_bound(omega - 1e-9);
            near != curve.end() && near->first < omega + 1e-9)
          least = std::min(least, near->second);
    CHECK(simulated < least * (1 + 1e-9));
    if (omega < 1.5) continue;  // there a block overturns after more impacts at a smaller one
    CHECK(simulated == doctest::Approx(least).epsilon(1e-9));
    ++equal;
  }
  CHECK(equal == 12);
}

TEST_CASE("under the cosine pulse of figure 14 condition (103) is the simulated threshold from 3 on") {
  const Drawn drawn = figure(14);
  const Curve& condition = drawn.curves.at("(103) cosine, 0.01 rad, 0.1 rad/s");
  int equal = 0;
  for (const auto& point : drawn.curves.at("simulated, cosine, 0.01 rad, 0.1 rad/s")) {
    const double omega = point.first, simulated = point.second;
    CAPTURE(omega);
    if (omega < 3) continue;
    const auto near = condition.lower_bound(omega - 1e-9);
    REQUIRE(near != condition.end());
    CHECK(simulated == doctest::Approx(near->second).epsilon(1e-9));
    ++equal;
  }
  CHECK(equal == 15);
}
