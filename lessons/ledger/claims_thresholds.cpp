#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_ratios.hpp>
#include <lessons/ledger/claims_thresholds.hpp>
#include <lessons/ledger/claims_workbench.hpp>

namespace rederive {

namespace {

constexpr double largest = 20, factor = 1.02;

std::string key_of(const PulseCase& asked) {
  return fmt::format("{}/{}/{}/{}/{}/{}/{}", asked.block.alpha, asked.block.restitution,
                     static_cast<int>(asked.model), static_cast<int>(asked.pulse), asked.omega_ratio,
                     static_cast<double>(asked.initial.angle), static_cast<double>(asked.initial.velocity));
}

template <class Value, class Make>
const Value& kept(std::map<std::string, Value>& store, const std::string& key, Make make) {
  const auto found = store.find(key);
  return found != store.end() ? found->second : store.emplace(key, make()).first->second;
}

std::optional<double> ratio_of(const std::optional<SpecialPoint>& point) {
  return point ? std::optional(point->omega_ratio) : std::nullopt;
}

}  // namespace

std::shared_ptr<Thresholds> make_thresholds() { return std::make_shared<Thresholds>(); }

const std::vector<Window>& Thresholds::windows(const PulseCase& asked) {
  return kept(windows_, key_of(asked), [&] { return overturning_windows(asked); });
}

/// The region of one code is connected: from the first (or last) amplitude of a row of them that has it,
/// bisect.
std::optional<double> Thresholds::edge(const PulseCase& asked, int code, bool upper) {
  return kept(edges_, fmt::format("{}/{}/{}", key_of(asked), code, upper), [&]() -> std::optional<double> {
    const double least = static_cast<double>(start_level(asked.block, asked.model)) * (1 + 1e-9);
    std::optional<double> inside, outside;
    for (double a = least; a < largest; a *= factor) {
      const bool has = outcome_at(asked, a).code == code;
      if (has && !inside) inside = a;
      if (has && upper) inside = a;
      if (!has && !inside && !upper) outside = a;
      if (!has && inside && upper) outside = a;
      if (upper ? outside.has_value() : inside.has_value()) break;
    }
    if (!inside) return std::nullopt;
    if (!outside) return upper ? std::nullopt : inside;
    return edge_of_code(asked, code, *inside, *outside).inside;
  });
}

std::optional<double> Thresholds::mode_1(const PulseCase& asked) {
  return edge(asked, asked.pulse == Pulse::sine ? -1 : 1, false);
}
std::optional<double> Thresholds::mode_2(const PulseCase& asked) {
  return edge(asked, asked.pulse == Pulse::sine ? 2 : -2, false);
}
std::optional<double> Thresholds::mode_2_upper(const PulseCase& asked) {
  return edge(asked, asked.pulse == Pulse::sine ? 2 : -2, true);
}

Window Thresholds::least(const PulseCase& asked) {
  const auto window = least_window(windows(asked));
  if (!window) throw std::runtime_error("nothing overturns up to 12 alpha*g");
  return *window;
}

std::optional<double> Thresholds::handover_of(const PulseCase& asked) {
  return kept(ratios_, "handover " + key_of(asked), [&] { return ratio_of(handover(asked)); });
}

std::optional<double> Thresholds::end_of(const PulseCase& asked) {
  return kept(ratios_, "end " + key_of(asked), [&] { return ratio_of(end_of_mode_2(asked)); });
}

Block paper_block(std::optional<double> restitution) { return make_block(0.25, 2.14, restitution); }

PulseCase pulse_case(double omega_ratio, Model model, std::optional<double> restitution, Pulse pulse) {
  return {paper_block(restitution), model, pulse, omega_ratio, {}};
}

PulseCase with_initial(PulseCase asked, double theta_0, double thetadot_0) {
  asked.initial = initial_state(asked.block, asked.model, theta_0, thetadot_0);
  return asked;
}

PulseCase with_alpha(PulseCase asked, double alpha, std::optional<double> restitution) {
  asked.block = make_block(alpha, asked.block.p, restitution);
  return asked;
}

std::vector<ClosedForm> roots_of(Form form, const PulseCase& asked) {
  std::vector<ClosedForm> roots;
  for (const ClosedForm& root : closed_forms(asked))
    if (root.form == form) roots.push_back(root);
  return roots;
}

double in_tangent(const PulseCase& asked, double amplitude) {
  return amplitude * asked.block.alpha / std::tan(asked.block.alpha);
}

}  // namespace rederive
