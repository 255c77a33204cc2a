#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <derivations/language/functions.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/command_line.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/papers/solve.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <numerics/pictures/plot.hpp>

namespace rederive::papers {
using namespace language;
using namespace emit;
using namespace program;
using namespace paper;
using namespace page;

namespace {

using Json = nlohmann::ordered_json;
using State = std::vector<double>;
/// The value of a right side at a time and a state.
using Rate = std::function<double(double time, const State& state)>;

/// Turns trees into functions of the time and the state. The parameters have values.
class Compiler {
 public:
  Compiler(std::vector<std::string> state, std::string time, std::map<std::string, double> parameters)
      : state_(std::move(state)), time_(std::move(time)), parameters_(std::move(parameters)) {}

  Rate compiled(const Tree& tree) const {
    switch (tree->kind) {
      case Node::Kind::number:
        return [value = std::stod(tree->text)](double, const State&) { return value; };
      case Node::Kind::symbol:
        return symbol(tree->text);
      case Node::Kind::negative:
        return [part = compiled(tree->children[0])](double t, const State& x) { return -part(t, x); };
      case Node::Kind::power:
        return [base = compiled(tree->children[0]), exponent = compiled(tree->children[1])](
                   double t, const State& x) { return std::pow(base(t, x), exponent(t, x)); };
      case Node::Kind::call:
        return call(tree);
      default:
        return chain(tree);
    }
  }

 private:
  Rate symbol(const std::string& name) const {
    if (name == time_) return [](double t, const State&) { return t; };
    if (name == "pi") return [](double, const State&) { return M_PI; };
    const auto place = std::ranges::find(state_, name);
    if (place != state_.end())
      return [k = static_cast<std::size_t>(place - state_.begin())](double, const State& x) { return x[k]; };
    return [value = parameters_.at(name)](double, const State&) { return value; };
  }

  Rate call(const Tree& tree) const {
    using OfDouble = double (*)(double);
    static const std::map<std::string, OfDouble> all{
        {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},     {"asin", std::asin},
        {"acos", std::acos}, {"atan", std::atan},   {"sinh", std::sinh},   {"cosh", std::cosh},
        {"tanh", std::tanh}, {"asinh", std::asinh}, {"acosh", std::acosh}, {"atanh", std::atanh},
        {"exp", std::exp},   {"log", std::log},     {"sqrt", std::sqrt},   {"fabs", std::fabs}};
    const Rate argument = compiled(tree->children[0]);
    if (const auto known = all.find(tree->text); known != all.end())
      return [f = known->second, argument](double t, const State& x) { return f(argument(t, x)); };
    // the others are defined in terms of these: cot, sec …
    const Function& function = function_named(tree->text);
    Symbols u;
    u.declare({"u", "u", "u", "1", all_numbers, "", ""});
    return compiled(put_in(parse(function.simpler, u), "u", tree->children[0]));
  }

  Rate chain(const Tree& tree) const {
    std::vector<Rate> parts;
    for (const Tree& child : tree->children) parts.push_back(compiled(child));
    if (tree->kind == Node::Kind::sum)
      return [parts, inverse = tree->inverse](double t, const State& x) {
        double sum = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) sum += inverse[k] ? -parts[k](t, x) : parts[k](t, x);
        return sum;
      };
    return [parts, inverse = tree->inverse](double t, const State& x) {
      double product = 1;
      for (std::size_t k = 0; k < parts.size(); ++k)
        product = inverse[k] ? product / parts[k](t, x) : product * parts[k](t, x);
      return product;
    };
  }

  std::vector<std::string> state_;
  std::string time_;
  std::map<std::string, double> parameters_;
};

/// A motion to compute: d(state)/dt = rates, from `start` at time 0.
struct Problem {
  std::vector<std::string> names;
  std::vector<Rate> rates;
  State start;
  std::vector<std::pair<std::string, Rate>> events;  ///< texts, and functions whose zeros are looked for
};

struct Event {
  double time;
  std::string what;
  State state;
};
struct Motion {
  std::vector<std::pair<double, State>> points;
  std::vector<Event> events;
};

int right_sides(double time, const double state[], double rates[], void* problem) {
  const auto& all = *static_cast<const Problem*>(problem);
  const State at(state, state + all.names.size());
  for (std::size_t k = 0; k < all.rates.size(); ++k) {
    rates[k] = all.rates[k](time, at);
    if (!std::isfinite(rates[k])) return GSL_EDOM;
  }
  return GSL_SUCCESS;
}

/// Integrates by GSL's Runge-Kutta method of order 8 (Prince and Dormand 1981) with an error per step below
/// `tolerance`, relative and absolute.
class Integrator {
 public:
  Integrator(const Problem& problem, double tolerance)
      : problem_(problem),
        system_{right_sides, nullptr, problem.names.size(), const_cast<Problem*>(&problem)},
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, problem.names.size())),
        control_(gsl_odeiv2_control_y_new(tolerance, tolerance)),
        evolve_(gsl_odeiv2_evolve_alloc(problem.names.size())) {}
  Integrator(const Integrator&) = delete;
  ~Integrator() {
    gsl_odeiv2_evolve_free(evolve_);
    gsl_odeiv2_control_free(control_);
    gsl_odeiv2_step_free(step_);
  }

  /// Returns the motion at `points` + 1 equally spaced times.
  Motion motion(double until, int points) {
    Motion motion;
    State state = problem_.start;
    double time = 0, step = until / points / 8;
    motion.points.emplace_back(time, state);
    for (int k = 1; k <= points; ++k) {
      const double end = until * k / points;
      while (time < end) {
        const double before = time;
        const State from = state;
        advance(time, end, step, state);
        for (const auto& [what, value] : problem_.events)
          find(what, value, before, from, time, state, motion);
      }
      motion.points.emplace_back(time, state);
    }
    std::ranges::stable_sort(motion.events, {}, &Event::time);
    return motion;
  }

 private:
  void advance(double& time, double end, double& step, State& state) {
    constexpr int most_steps = 2'000'000;
    if (++steps_ > most_steps)
      throw BadInput(
          fmt::format("the integration needs more than {} steps; choose a shorter --until", most_steps));
    gsl_error_handler_t* const handler = gsl_set_error_handler_off();
    const int status =
        gsl_odeiv2_evolve_apply(evolve_, control_, step_, &system_, &time, end, &step, state.data());
    gsl_set_error_handler(handler);
    if (status != GSL_SUCCESS || step < 1e-14 * std::max(1.0, std::fabs(time)))
      throw BadInput(fmt::format("the equation has no value beyond the time {:.6g}: {}", time, at(state)));
  }

  std::string at(const State& state) const {
    std::string text;
    for (std::size_t k = 0; k < state.size(); ++k)
      text += fmt::format("{}{} = {:.6g}", k == 0 ? "" : ", ", problem_.names[k], state[k]);
    return text;
  }

  /// Adds the event if the value changes its sign in this step: the length of the step is bisected.
  void find(const std::string& what, const Rate& value, double before, const State& from, double after,
            const State& to, Motion& motion) {
    const double first = value(before, from), last = value(after, to);
    if (first == 0 || (first < 0) == (last < 0)) return;  // a zero at the start belongs to the step before
    double low = 0, high = after - before;
    State state = to;
    constexpr int bits = 52;
    for (int k = 0; k < bits; ++k) {
      const double middle = (low + high) / 2;
      state = from;
      State error(state.size());
      gsl_odeiv2_step_reset(step_);
      gsl_odeiv2_step_apply(step_, before, middle, state.data(), error.data(), nullptr, nullptr, &system_);
      ((value(before + middle, state) < 0) == (first < 0) ? low : high) = middle;
    }
    gsl_odeiv2_step_reset(step_);
    motion.events.push_back({before + high, what, state});
  }

  const Problem& problem_;
  gsl_odeiv2_system system_;
  gsl_odeiv2_step* step_;
  gsl_odeiv2_control* control_;
  gsl_odeiv2_evolve* evolve_;
  int steps_ = 0;
};

struct SolveOptions {
  std::string row, stepper, csv, plot;
  std::vector<std::string> values, events;
  double until = 0;
  int points = 400;
  bool json = false;
};

const TaylorStepper& chosen(const Emission& emission, const SolveOptions& options) {
  if (emission.steppers.empty())
    throw BadInput("functions.toml has no [[stepper]]; it says which row is an equation of motion");
  std::string known;
  for (const TaylorStepper& stepper : emission.steppers) {
    if (!options.row.empty() && stepper.equation != options.row) continue;
    if (!options.stepper.empty() && stepper.name != options.stepper) continue;
    return stepper;
  }
  for (const TaylorStepper& stepper : emission.steppers)
    known += fmt::format("{}{} (row {})", known.empty() ? "" : ", ", stepper.name, stepper.equation);
  throw BadInput("there is no such stepper in functions.toml; there are " + known);
}

/// Reads "theta=0.5" and the like. Expressions without symbols are allowed: pi/6.
std::map<std::string, double> values_in(const std::vector<std::string>& texts, const Paper& paper) {
  std::map<std::string, double> values;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    if (sign == text.npos) throw BadInput("'" + printable_line(text) + "' must be a value such as theta=0.5");
    const std::string name = trimmed(text.substr(0, sign)), value = trimmed(text.substr(sign + 1));
    values[name] = reading(value, paper.symbols, [&] {
      return Page(paper).number_of(lower(parse(value, paper.symbols), paper.symbols));
    });
  }
  return values;
}

Problem problem_of(const TaylorStepper& stepper, const SolveOptions& options, const Paper& paper,
                   const std::vector<std::string>& events) {
  std::map<std::string, double> values = values_in(options.values, paper);
  Problem problem;
  for (const auto& [part, rate] : stepper.rates) problem.names.push_back(name_of(part));
  std::map<std::string, double> parameters;
  const auto take = [&](const std::string& name) {
    const auto found = values.find(name);
    if (found == values.end()) throw BadInput("the value of " + name + " is missing: --set " + name + "=…");
    const double value = found->second;
    values.erase(found);
    return value;
  };
  for (const std::string& name : problem.names) problem.start.push_back(take(name));
  for (const SymbolExpression& parameter : stepper.parameters)
    parameters[name_of(parameter)] = take(name_of(parameter));
  if (!values.empty())
    throw BadInput("'" + printable_line(values.begin()->first) +
                   "' is neither in the state nor a parameter of " + stepper.name);
  const Compiler compiler(problem.names, name_of(stepper.time), parameters);
  for (const auto& [part, rate] : stepper.rates)
    problem.rates.push_back(compiler.compiled(to_tree(rate, paper.symbols)));
  for (const std::string& text : events)
    problem.events.emplace_back(
        text, reading(text, paper.symbols, [&] {
          const Relation relation = parse_relation(text, paper.symbols);
          return compiler.compiled(make_tree(Node::Kind::sum, "", relation.sides, {false, true}));
        }));
  return problem;
}

std::string csv_of(const Motion& motion, const Problem& problem) {
  std::string text = "t";
  for (const std::string& name : problem.names) text += "," + name;
  text += "\n";
  for (const auto& [time, state] : motion.points) {
    text += fmt::format("{}", time);
    for (const double value : state) text += fmt::format(",{}", value);
    text += "\n";
  }
  return text;
}

void draw_motion(const Motion& motion, const Problem& problem, const Paper& paper, const std::string& file) {
  numerics::Plot plot{.caption = paper.title, .panels = {}};
  for (std::size_t k = 0; k < problem.names.size(); ++k) {
    numerics::Panel panel{.title = "",
                          .x_label = "t",
                          .y_label = paper.symbols.find(problem.names[k])->unicode,
                          .curves = {{.title = "", .points = {}}}};
    for (const auto& [time, state] : motion.points) panel.curves[0].points.emplace_back(time, state[k]);
    plot.panels.push_back(panel);
  }
  numerics::draw(plot, file);
}

int solve(const SolveOptions& options, const PaperFolder& folder) {
  const Paper& paper = folder.paper();
  const Emission emission = paper.emission();
  const TaylorStepper& stepper = chosen(emission, options);
  const std::vector<std::string> events =
      options.events.empty() ? events_of_stepper(paper, stepper.name) : options.events;
  const Problem problem = problem_of(stepper, options, paper, events);
  if (!options.plot.empty()) numerics::check_plot_name(options.plot);
  constexpr double tolerance = 1e-12, looser = 1e-9;
  const Motion motion = Integrator(problem, tolerance).motion(options.until, options.points);
  const Motion check = Integrator(problem, looser).motion(options.until, options.points);
  double difference = 0;
  for (std::size_t k = 0; k < problem.names.size(); ++k)
    difference =
        std::max(difference, std::fabs(motion.points.back().second[k] - check.points.back().second[k]));
  if (!options.csv.empty()) write_whole(options.csv, csv_of(motion, problem));
  if (!options.plot.empty()) draw_motion(motion, problem, paper, options.plot);
  Json json{{"stepper", stepper.name}, {"row", stepper.equation}, {"until", options.until}};
  std::string text =
      fmt::format("{}: row ({}) until t = {}\n", stepper.name, stepper.equation, options.until);
  json["events"] = Json::array();
  const auto add = [&](const std::string& what, double time, const State& state) {
    Json entry{{"time", time}, {"what", what}, {"state", Json::object()}};
    text += fmt::format("  t = {:<14.10g} {:<20}", time, what);
    for (std::size_t k = 0; k < state.size(); ++k) {
      entry["state"][problem.names[k]] = state[k];
      text += fmt::format(" {} = {:.10g}", problem.names[k], state[k]);
    }
    text += "\n";
    return entry;
  };
  for (const Event& event : motion.events) json["events"].push_back(add(event.what, event.time, event.state));
  json["end"] = add("end", motion.points.back().first, motion.points.back().second);
  json["difference"] = difference;
  text += fmt::format("  With the tolerance {} instead of {}, the end differs by {:.2g}.\n", looser,
                      tolerance, difference);
  const std::string said = options.json ? json.dump(2) + "\n" : text;
  std::fputs(said.c_str(), stdout);
  return as_expected;
}

}  // namespace

int run_solve(const std::function<const PaperFolder&()>& folder, int argc, char** argv) {
  CLI::App app{"Integrates an equation of motion of the paper, a [[stepper]] of functions.toml."};
  SolveOptions options;
  app.add_option("--row", options.row,
                 "Integrate the right side of this row. Default: of the first stepper.");
  app.add_option("--stepper", options.stepper, "Integrate this stepper, by its name.");
  app.add_option(
         "--set", options.values,
         "Set the start of a part of the state, or a parameter: theta=0.5. May be given several times.")
      ->allow_extra_args(false)
      ->option_text("NAME=VALUE");
  app.add_option("--until", options.until, "Integrate from the time 0 to this time.")
      ->required()
      ->check(CLI::PositiveNumber);
  app.add_option(
         "--event", options.events,
         "Report when this equation holds: \"theta = 0\". May be given several times. Default: the events\n"
         "of the stepper.")
      ->allow_extra_args(false);
  app.add_option("--points", options.points, "Write this many times, from 1 to 1000000. Default: 400.")
      ->check(whole_number)
      ->check(CLI::Range(1, 1000000));
  app.add_option("--csv", options.csv, "Write the history to this file as CSV.")->check(file_name);
  app.add_option("--plot", options.plot, "Draw the history to this file: .svg, .png or .pdf.")
      ->check(file_name);
  app.add_flag("--json", options.json, "Write one JSON document to standard output.");
  app.footer(
      "Examples:\n  $ rederive rod solve --row 2 --set theta=0.5 --set thetadot=0 --set g=9.81 --set L=1 "
      "--until 5\n\n");
  return run_command(app, argc, argv, [&] {
    try {
      return solve(options, folder());
    } catch (const std::invalid_argument& error) {
      throw BadInput(error.what());
    }
  });
}

}  // namespace rederive::papers
