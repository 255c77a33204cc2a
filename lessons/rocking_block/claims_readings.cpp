#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/rocking_block/claims_readings.hpp>
#include <numbers>

namespace rederive::rocking_block {
using namespace numbers;
using namespace paper;

using namespace numerics;

namespace {

using std::numbers::pi;
constexpr double short_pi = 3.14;

/// A block and a model: what a reading assumes about them, and the case of the numerics.
struct Shape {
  Reading reading;
  PulseCase asked;
};

/// Returns the reading that gives a value for a shape.
Reading with_value(const Shape& shape, double value) {
  Reading reading = shape.reading;
  reading.value = value;
  return reading;
}

/// Returns the blocks and models that the text may mean.
std::vector<Shape> shapes(double omega_ratio, bool with_impact) {
  std::vector<Shape> list;
  for (const Model model : {Model::linear, Model::nonlinear})
    for (const bool ratio : {false, true})
      for (const std::optional<double> e :
           {std::optional<double>{}, std::optional<double>{0.9}, std::optional<double>{1.0}}) {
        if (!with_impact && e) continue;
        if (model == Model::linear && ratio && (e || !with_impact)) continue;  // free of alpha but for e
        const double alpha = ratio ? std::atan(0.25) : 0.25;
        std::string says = fmt::format("{}, alpha = {}", model == Model::linear ? "linear" : "nonlinear",
                                       ratio ? "atan(0.25)" : "0.25");
        if (with_impact) says += e ? fmt::format(", e = {:g}", *e) : std::string(", e of (46)");
        list.push_back({{.says = says, .model = model, .has_own_restitution = with_impact && !e},
                        with_alpha(pulse_case(omega_ratio, model), alpha, e)});
      }
  return list;
}

std::string summary_of(const Match& match) {
  return fmt::format("{}: {:.7g} ({:+.2f} of the last digit)", match.reading.says, match.reading.value,
                     match.off);
}

}  // namespace

std::string words_for(const ShortPi& pi) {
  return fmt::format("2*pi = {}, psi {}", pi.in_turn ? "6.28" : "exact",
                     pi.in_psi ? "with pi = 3.14" : "exact");
}

std::vector<Match> compare_with(const std::string& printed, const std::vector<Reading>& readings) {
  const auto point = printed.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
  const double unit = std::pow(10.0, -digits), value = std::stod(printed);
  std::vector<Match> matches;
  for (const Reading& reading : readings) {
    const double off = (reading.value - value) / unit;
    matches.push_back({reading, off, std::abs(off) <= 0.5});
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return std::abs(a.off) < std::abs(b.off); });
  return matches;
}

std::vector<Reading> between(const std::string& one, const std::string& other,
                             const std::vector<Reading>& readings) {
  const double a = std::stod(one), b = std::stod(other), low = std::min(a, b), high = std::max(a, b);
  std::vector<Reading> inside;
  for (const Reading& reading : readings)
    if (low <= reading.value && reading.value <= high) inside.push_back(reading);
  return inside;
}

std::vector<Reading> fitting(const std::vector<Match>& matches) {
  std::vector<Reading> list;
  for (const Match& match : matches)
    if (match.rounds) list.push_back(match.reading);
  return list;
}

std::string summary(const std::vector<Match>& matches) {
  std::string text;
  for (const Match& match : matches)
    if (match.rounds) text += (text.empty() ? "fits: " : "; ") + summary_of(match);
  if (!text.empty() || matches.empty()) return text;
  return fmt::format("none of {} readings fits; nearest {}", matches.size(), summary_of(matches.front()));
}

std::vector<Reading> threshold_readings(Bench& bench, double omega_ratio, int impacts) {
  std::vector<Reading> list;
  for (const Shape& shape : shapes(omega_ratio, impacts == 1)) {
    const double amplitude = bench.mode(impacts, shape.asked);
    if (amplitude == 0) continue;
    struct Shown {
      const char* words;
      Unit unit;
      double value;
    };
    for (const auto& [words, unit, value] :
         {Shown{"alpha*g", Unit::alpha_g, amplitude},
          Shown{"g*tan(alpha)", Unit::g_tan_alpha, in_tangent(shape.asked, amplitude)},
          Shown{"g", Unit::g, amplitude * shape.asked.block.alpha}})
      for (const bool is_reciprocal : {false, true}) {
        Reading reading = with_value(shape, is_reciprocal ? 1 / value : value);
        reading.says += (is_reciprocal ? ", reciprocal of " : ", in ") + std::string(words);
        reading.unit = unit, reading.is_reciprocal = is_reciprocal;
        list.push_back(std::move(reading));
      }
  }
  return list;
}

std::vector<Reading> period_readings(Bench& bench, double omega_ratio, double printed_amplitude) {
  const double omega = omega_ratio * paper_block().p;
  std::vector<Reading> list;
  const std::vector<Reading> amplitudes{{fmt::format("amplitude {:g}", printed_amplitude), printed_amplitude},
                                        {"the least amplitude", bench.least(pulse_case(omega_ratio)).from}};
  for (const Reading& amplitude : amplitudes) {
    const double psi = std::asin(1 / amplitude.value);
    for (const ShortPi cut : {ShortPi{false, false}, {false, true}, {true, false}, {true, true}})
      list.push_back(
          {.says = fmt::format("T_ex, {}, {}", amplitude.says, words_for(cut)),
           .value = (2 * (cut.in_turn ? short_pi : pi) - psi * (cut.in_psi ? short_pi / pi : 1)) / omega,
           .pi = cut});
  }
  list.push_back({"the period 2*pi/omega_p", 2 * pi / omega});
  return list;
}

std::vector<Reading> handover_readings(Bench& bench) {
  std::vector<Reading> list;
  for (const Shape& shape : shapes(1, true)) {
    if (shape.asked.model != Model::linear || shape.asked.block.restitution == 1) continue;
    if (const double ratio = bench.handover_of(shape.asked); ratio > 0)
      list.push_back(with_value(shape, ratio));
  }
  return list;
}

std::vector<Reading> end_readings(Bench& bench) {
  std::vector<Reading> list;
  for (const Shape& shape : shapes(1, true)) {
    if (shape.asked.block.restitution == 1) continue;  // without loss it never ends
    if (shape.asked.model == Model::nonlinear && shape.asked.block.alpha != 0.25) continue;
    if (const double ratio = bench.end_of(shape.asked); ratio > 0) list.push_back(with_value(shape, ratio));
  }
  return list;
}

}  // namespace rederive::rocking_block
