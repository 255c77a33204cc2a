#include <cmath>
#include <derivations/rocking_block/paper.hpp>
#include <lessons/rocking_block/claims_bench.hpp>
#include <lessons/rocking_block/claims_ratios.hpp>
#include <numerics/search/edges.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace decide;
using namespace paper;
using namespace page;
using namespace ledger;

using namespace numerics;

namespace {

constexpr double largest = 20, factor = 1.02;

std::string key_of(const PulseCase& asked) {
  return fmt::format("{}/{}/{}/{}/{}/{}/{}", asked.block.alpha, asked.block.restitution,
                     static_cast<int>(asked.model), static_cast<int>(asked.pulse), asked.omega_ratio,
                     static_cast<double>(asked.initial.angle), static_cast<double>(asked.initial.velocity));
}

template <class Kept, class Make>
const Kept& kept(std::map<std::string, Kept>& store, const std::string& key, Make make) {
  const auto found = store.find(key);
  return found != store.end() ? found->second : store.emplace(key, make()).first->second;
}

ResponseOptions with_history() {
  ResponseOptions options;
  options.history = true;
  return options;
}

}  // namespace

const Entry& Bench::row(const std::string& id) {
  return kept(entries_, id, [&] { return judged(paper(), id); });
}

bool Bench::is_right(const std::string& id) {
  const Verdict verdict = verdict_of(id);
  return verdict == Verdict::proved || verdict == Verdict::proved_under || verdict == Verdict::approximation;
}

std::string Bench::say(const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) {
    const std::string& right = row(id).correction;
    add(text, fmt::format("({}) {}", id, to_string(verdict_of(id))));
    if (!right.empty())
      text +=
          ": right is " + print(parse_statement(right, paper().symbols), Notation::unicode, paper().symbols);
  }
  return text;
}

const std::vector<Window>& Bench::windows(const PulseCase& asked) {
  return kept(windows_, key_of(asked), [&] { return overturning_windows(asked); });
}

Window Bench::least(const PulseCase& asked) {
  const auto window = least_window(windows(asked));
  if (!window) throw std::runtime_error("no amplitude up to 12 alpha*g overturns the block");
  return *window;
}

/// Bisects from the first (or last) amplitude of a grid that has the code, for the amplitudes with one code
/// are connected. Under the cosine pulse the sides are exchanged.
double Bench::edge(const PulseCase& asked, int code_under_sine, bool upper) {
  const int code = asked.pulse == Pulse::sine ? code_under_sine : -code_under_sine;
  return kept(edges_, fmt::format("{}/{}/{}", key_of(asked), code, upper), [&] {
    double inside = 0, outside = 0;
    for (double a = static_cast<double>(start_level(asked.block, asked.model)) * (1 + 1e-9); a < largest;
         a *= factor) {
      const bool has = outcome_at(asked, a).code == code;
      if (has ? upper || inside == 0 : upper == (inside > 0)) (has ? inside : outside) = a;
      if ((upper ? outside : inside) > 0) break;
    }
    if (inside == 0 || outside == 0) return upper ? 0 : inside;
    return edge_of_code(asked, code, inside, outside).inside;
  });
}

double Bench::handover_of(const PulseCase& asked) {
  return kept(ratios_, "handover " + key_of(asked),
              [&] { return handover(asked).value_or(SpecialPoint{}).omega_ratio; });
}

double Bench::end_of(const PulseCase& asked) {
  return kept(ratios_, "end " + key_of(asked),
              [&] { return end_of_mode_2(asked).value_or(SpecialPoint{}).omega_ratio; });
}

Block paper_block(std::optional<double> restitution) { return make_block(0.25, 2.14, restitution); }

PulseCase pulse_case(double omega_ratio, Model model, std::optional<double> restitution) {
  return {paper_block(restitution), model, Pulse::sine, omega_ratio, {}};
}

PulseCase cosine_case(double omega_ratio) {
  return {paper_block(), Model::linear, Pulse::cosine, omega_ratio, {}};
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
  auto roots = closed_forms(asked);
  std::erase_if(roots, [&](const ClosedForm& root) { return root.form != form; });
  return roots;
}

ClosedForm root_of(Form form, const PulseCase& asked) { return roots_of(form, asked).at(0); }

double in_tangent(const PulseCase& asked, double amplitude) {
  return amplitude * asked.block.alpha / std::tan(asked.block.alpha);
}

int impacts_of(const Window& window) { return std::abs(window.code) - 1; }

GroundMotion ground_of(const PulseCase& asked, double amplitude) {
  return pulse_motion(asked.pulse, asked.omega_ratio, amplitude, start_level(asked.block, asked.model));
}

Response motion_at(const PulseCase& asked, double amplitude) {
  return respond(asked.block, asked.model, ground_of(asked, amplitude), asked.initial, with_history());
}

std::vector<Sample> samples_at(const PulseCase& asked, double amplitude) {
  const GroundMotion ground = ground_of(asked, amplitude);
  return sampled(ground, motion_at(asked, amplitude), ground.back().to, 400);
}

double first_time(const Response& motion, EventKind kind) {
  for (const Event& event : motion.events)
    if (event.kind == kind) return static_cast<double>(event.time);
  return 0;
}

std::string fixed(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", value, digits);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero && text[0] == '-' ? text.substr(1) : text;  // no "-0.0000"
}

void add(std::string& list, const std::string& item, const char* separator) {
  list += (list.empty() ? "" : separator) + item;
}

}  // namespace rederive::rocking_block
