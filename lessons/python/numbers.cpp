// Binds the numerics for Python, with NumPy arrays. The package is in lessons/python/rederive.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <lessons/python/calls.hpp>
#include <limits>
#include <numerics/search/grid.hpp>
#include <numerics/search/story.hpp>

namespace rederive::python {
namespace {

using namespace numerics;

Model model_of(const std::string& name) {
  if (name == "linear") return Model::linear;
  if (name == "nonlinear") return Model::nonlinear;
  throw std::invalid_argument("model '" + name + "' must be linear or nonlinear");
}

Pulse pulse_of(const std::string& name) {
  if (name == "sine") return Pulse::sine;
  if (name == "cosine") return Pulse::cosine;
  throw std::invalid_argument("pulse '" + name + "' must be sine or cosine");
}

/// What Python calls a Pulse.
struct Shape {
  double omega;
  std::string kind;
};

Shape make_shape(double omega, const std::string& kind) {
  pulse_of(kind);
  return {between("omega", omega, 0.01, 1000), kind};
}

py::tuple values_of(const Block& block) { return py::make_tuple(block.alpha, block.p, block.restitution); }
py::tuple values_of(const Shape& shape) { return py::make_tuple(shape.omega, shape.kind); }

PulseCase case_of(const Block& block, const Shape& shape, const std::string& model, double theta0,
                  double thetadot0) {
  PulseCase asked;
  asked.block = block, asked.model = model_of(model);
  asked.pulse = pulse_of(shape.kind), asked.omega_ratio = shape.omega;
  constexpr double all = std::numeric_limits<double>::max();
  asked.initial = initial_state(asked.block, asked.model, between("theta0", theta0, -all, all),
                                between("thetadot0", thetadot0, -all, all));
  return asked;
}

std::vector<Window> found_windows(const PulseCase& asked, double largest, bool least) {
  WindowSearch search;
  search.largest = between("largest", largest, 1e-9, 1e6), search.least = least;
  return attended(1, {}, py::none(), [&](const Work& work) {
    search.threads = work.threads, search.stop = work.stop;
    return overturning_windows(asked, search);
  });
}

py::object threshold(const Shape& pulse, const Block& block, const std::string& model, double theta0,
                     double thetadot0, double largest) {
  const auto found = found_windows(case_of(block, pulse, model, theta0, thetadot0), largest, true);
  if (found.empty()) return py::none();
  return py::module_::import("rederive").attr("Threshold")(found[0].from, found[0].code);
}

py::object windows(const Shape& pulse, const Block& block, const std::string& model, double theta0,
                   double thetadot0, double largest) {
  std::vector<std::tuple<double, double, int>> rows;
  for (const Window& window : found_windows(case_of(block, pulse, model, theta0, thetadot0), largest, false))
    rows.emplace_back(window.from, or_nan(window.to), window.code);
  return table(rows, {{"from", "f8"}, {"to", "f8"}, {"code", "i4"}});
}

py::object spectrum_table(const Numbers& omegas, const Block& block, const std::string& kind,
                          const std::string& model, double theta0, double thetadot0, double largest,
                          std::optional<int> threads, const py::object& progress) {
  const PulseCase asked = case_of(block, make_shape(1, kind), model, theta0, thetadot0);
  const std::vector<double> ratios = numbers_of("omegas", omegas, 0.01, 1000);
  WindowSearch search;
  search.largest = between("largest", largest, 1e-9, 1e6);
  const auto points = attended(static_cast<int>(ratios.size()), threads, progress, [&](const Work& work) {
    search.stop = work.stop;
    return spectrum(asked, ratios, search, work);
  });
  std::vector<std::tuple<double, double, int, double, double, double>> rows;
  for (const SpectrumPoint& at : points)
    rows.emplace_back(at.omega_ratio, or_nan(at.minimum), at.code, or_nan(at.mode1), or_nan(at.mode2_lower),
                      or_nan(at.mode2_upper));
  return table(rows, {{"omega_ratio", "f8"},
                      {"minimum", "f8"},
                      {"code", "i4"},
                      {"mode1", "f8"},
                      {"mode2_lower", "f8"},
                      {"mode2_upper", "f8"}});
}

py::array_t<int> map_codes(const Numbers& omegas, const Numbers& amplitudes, const Block& block,
                           const std::string& kind, const std::string& model, double theta0, double thetadot0,
                           std::optional<int> threads, const py::object& progress) {
  const PulseCase asked = case_of(block, make_shape(1, kind), model, theta0, thetadot0);
  const std::vector<double> ratios = numbers_of("omegas", omegas, 0.01, 1000),
                            levels = numbers_of("amplitudes", amplitudes, 0, 1e6);
  if (ratios.size() * levels.size() > 50'000'000)
    throw std::invalid_argument("omegas and amplitudes give more than 50 million points: ask for fewer");
  py::array_t<int> codes({ratios.size(), levels.size()});
  if (codes.size() == 0) return codes;
  const OutcomeMap map = attended(static_cast<int>(ratios.size()), threads, progress,
                                  [&](const Work& work) { return outcome_map(asked, ratios, levels, work); });
  int* to = codes.mutable_data();
  for (const auto& column : map.codes) to = std::copy(column.begin(), column.end(), to);
  return codes;
}

/// What Python calls a Response.
struct Told {
  Story story;
  double alpha;
  std::vector<Sample> history;

  std::string_view outcome() const { return outcome_name(story.outcome.code); }
  std::optional<double> time() const {
    if (!story.overturn_time) return std::nullopt;
    return static_cast<double>(*story.overturn_time);
  }
  /// A column of the history, times `unit`.
  py::array_t<double> column(Real Sample::*what, double unit = 1) const {
    py::array_t<double> values(static_cast<py::ssize_t>(history.size()));
    std::ranges::transform(history, values.mutable_data(),
                           [&](const Sample& at) { return static_cast<double>(at.*what * unit); });
    return values;
  }
  py::object events() const {
    std::vector<std::tuple<double, std::string, double, double, double>> rows;
    for (const Event& event : story.response.events)
      rows.emplace_back(event.time, name_of(event.kind), event.angle, event.velocity_before,
                        event.velocity_after);
    return table(rows, {{"time", "f8"},
                        {"kind", "U9"},
                        {"theta_over_alpha", "f8"},
                        {"velocity_before", "f8"},
                        {"velocity_after", "f8"}});
  }
};

Told response(const Shape& pulse, double amplitude, const Block& block, const std::string& model,
              double theta0, double thetadot0, std::optional<double> until, int samples) {
  const PulseCase asked = case_of(block, pulse, model, theta0, thetadot0);
  between("amplitude", amplitude, 0, 1e6);
  const double end = until ? between("until", *until, 0, 1e5) : -1;
  between("samples", samples, 2, 1e7);
  return attended(1, {}, py::none(), [&](const Work&) {
    const GroundMotion motion = pulse_or_none(asked, amplitude);
    Story story = tell(block, asked.model, motion, asked.initial, static_cast<Real>(end));
    auto history = sampled(motion, story.response, story.until, samples);
    return Told{std::move(story), block.alpha, std::move(history)};
  });
}

/// Equal, hashed and pickled by its values, which cannot change.
template <class Value, class Make>
py::class_<Value> value_type(py::module_& module, const char* name, const char* documentation, Make make) {
  py::class_<Value> type(module, name, documentation);
  type.attr("__module__") = "rederive";
  type.def("__eq__", [](const Value& a, const py::object& b) {
    return py::isinstance<Value>(b) && values_of(a).equal(values_of(b.cast<const Value&>()));
  });
  type.def("__hash__", [](const Value& value) { return py::hash(values_of(value)); });
  type.def(py::pickle([](const Value& value) { return values_of(value); }, make));
  return type;
}

// This function is long because it has the documentation that Python shows.
void add_values(py::module_& module) {
  value_type<Block>(module, "Block", R"(A free-standing rectangular block. It cannot be changed.

Parameters
----------
alpha : float
    Stockiness atan(b/h) of the half width b and the half height h, in rad, 1e-12 <= alpha < pi/2.
p : float
    Frequency parameter sqrt(3g/(4R)) in 1/s, above 0.
restitution : float or None
    Ratio e of the angular velocities after and before an impact, eq (34), 0 < e <= 1. None uses
    eq (46b), 1 - 3/2 sin(alpha)^2.

Raises
------
ValueError
    If a value is out of range.

>>> Block(alpha=0.25)
Block(alpha=0.25, p=2.14, restitution=0.9081869214...)
)",
                    [](const py::tuple& values) {
                      return make_block(values[0].cast<double>(), values[1].cast<double>(),
                                        values[2].cast<double>());
                    })
      .def(py::init(&make_block), py::arg("alpha") = 0.25, py::arg("p") = 2.14,
           py::arg("restitution") = py::none())
      .def_static("from_size", &block_from_size, py::arg("half_width"), py::arg("half_height"),
                  py::arg("restitution") = py::none(), py::arg("gravity") = standard_gravity,
                  "Returns a block from b and h in metres and gravity in m/s^2.")
      .def_readonly("alpha", &Block::alpha, "atan(b/h), rad")
      .def_readonly("p", &Block::p, "sqrt(3g/4R), 1/s")
      .def_readonly("restitution", &Block::restitution,
                    "ratio of the angular velocities after and before an impact")
      .def("__repr__", [](const Block& block) {
        return fmt::format("Block(alpha={}, p={}, restitution={})", block.alpha, block.p, block.restitution);
      });
  value_type<Shape>(
      module, "Pulse",
      R"(A pulse of ground acceleration, eq (52), which begins when rocking can start. It cannot be changed.

Parameters
----------
omega : float
    Frequency omega_p/p, without unit, 0.01 to 1000.
kind : {"sine", "cosine"}
    Form of the pulse.

Raises
------
ValueError
    If a value is out of range.

>>> Pulse(3)
Pulse(omega=3, kind='sine')
)",
      [](const py::tuple& values) {
        return make_shape(values[0].cast<double>(), values[1].cast<std::string>());
      })
      .def(py::init(&make_shape), py::arg("omega"), py::arg("kind") = "sine")
      .def_readonly("omega", &Shape::omega, "omega_p/p")
      .def_readonly("kind", &Shape::kind, "sine or cosine")
      .def("__repr__", [](const Shape& pulse) {
        return fmt::format("Pulse(omega={}, kind='{}')", pulse.omega, pulse.kind);
      });
  py::class_<Told> told(module, "Response",
                        R"(The result of `response`. Times are p*t and velocities thetadot/(alpha*p).

Attributes
----------
outcome : str
    "safe" or "overturned".
code : int
    side*(impacts + 1) if the block overturns, 0 if it is safe.
time : float or None
    Time at which the block overturns.
impacts : int
    Number of impacts until the block overturns, or of all impacts.
events : structured array
    Fields time, kind (start, impact, rest, restart, pulse_end, overturn), theta_over_alpha,
    velocity_before, velocity_after.
tau, theta_over_alpha, thetadot_over_alpha_p, ground_over_g : arrays of shape (samples,)
    The history.)");
  told.attr("__module__") = "rederive";
  told.def_property_readonly("outcome", &Told::outcome)
      .def_property_readonly("code", [](const Told& it) { return it.story.outcome.code; })
      .def_property_readonly("impacts", [](const Told& it) { return impacts_of(it.story); })
      .def_property_readonly("time", &Told::time)
      .def_property_readonly("events", &Told::events)
      .def_property_readonly("tau", [](const Told& it) { return it.column(&Sample::time); })
      .def_property_readonly("theta_over_alpha", [](const Told& it) { return it.column(&Sample::angle); })
      .def_property_readonly("thetadot_over_alpha_p",
                             [](const Told& it) { return it.column(&Sample::velocity); })
      .def_property_readonly("ground_over_g",
                             [](const Told& it) { return it.column(&Sample::ground, it.alpha); });
}

// This function is long because it has the documentation that Python shows.
void add_functions(py::module_& module) {
  const py::arg pulse("pulse"), omegas("omegas"), amplitudes("amplitudes"), amplitude("amplitude");
  const auto block = py::arg("block") = make_block(0.25, 2.14), kind = py::arg("kind") = "sine",
             model = py::arg("model") = "linear", theta0 = py::arg("theta0") = 0.0,
             thetadot0 = py::arg("thetadot0") = 0.0, largest = py::arg("largest") = 12.0,
             threads = py::arg("threads") = py::none(), progress = py::arg("progress") = py::none();
  const py::kw_only only;
  module.def("threshold", threshold, pulse, block, only, model, theta0, thetadot0, largest,
             R"(Finds the least amplitude that overturns the block, and how it overturns.

Parameters
----------
pulse : Pulse
block : Block
model : {"linear", "nonlinear"}
    Equations of motion: eq (56) or eq (21).
theta0, thetadot0 : float
    Angle in rad and angular velocity in rad/s at the start.
largest : float
    Largest amplitude a_p/(alpha*g) of the search, 1e-9 to 1e6.

Returns
-------
Threshold or None
    The amplitude a_p/(alpha*g) and the code; None if no amplitude up to `largest` overturns the block.
    The relative error is at most 1e-12 (linear) or 1e-10 (nonlinear). Below the amplitude, windows
    narrower than 1e-9 may be missing.

Raises
------
ValueError
    If a value is out of range.

>>> threshold(Pulse(3))  # eqs (86) and (88)
Threshold(amplitude=1.40009981815..., code=2)
)");
  module.def("windows", windows, pulse, block, only, model, theta0, thetadot0, largest,
             R"(Finds every window of amplitudes that overturns the block.

The parameters and errors are those of `threshold`.

Returns
-------
structured array of shape (windows,)
    Fields from, to, code. `to` is NaN if a window reaches `largest`. Windows narrower than 1e-5 may
    be missing.

>>> windows(Pulse(3))["code"]
array([ 2, -1], dtype=int32)
)");
  module.def("response", response, pulse, amplitude, block, only, model, theta0, thetadot0,
             py::arg("until") = py::none(), py::arg("samples") = 2001,
             R"(Computes the outcome, the events and the history under one pulse.

The other parameters and the errors are those of `threshold`.

Parameters
----------
amplitude : float
    Amplitude a_p/(alpha*g) of the pulse, 0 to 1e6.
until : float or None
    End of the history, p*t, at most 1e5. None ends it shortly after the last event.
samples : int
    Number of samples of the history, at least 2.

Returns
-------
Response

>>> response(Pulse(3), 1.41).outcome
'overturned'
)");
  module.def("spectrum", spectrum_table, omegas, block, only, kind, model, theta0, thetadot0, largest,
             threads, progress,
             R"(Finds the thresholds of overturning at each frequency. Ctrl-C ends the computation.

The other parameters and the errors are those of `threshold`.

Parameters
----------
omegas : array_like of shape (n,)
    Frequencies omega_p/p, 0.01 to 1000.
kind : {"sine", "cosine"}
    Form of the pulse.
threads : int or None
    Number of threads, 1 to 1024. None uses all processors.
progress : callable or None
    progress(done, total) is called now and then, in the calling thread.

Returns
-------
structured array of shape (n,)
    Fields omega_ratio, minimum (the least amplitude that overturns), code, mode1 (the least amplitude
    without impact), mode2_lower and mode2_upper (the least and the largest amplitude after one impact).
    A field is NaN if there is no such amplitude up to `largest`.

>>> spectrum([3])["mode1"]  # eq (71)
array([3.63114987])
)");
  module.def("map", map_codes, omegas, amplitudes, block, only, kind, model, theta0, thetadot0, threads,
             progress,
             R"(Computes the outcome over a grid of frequencies and amplitudes. Ctrl-C ends the computation.

The other parameters and the errors are those of `spectrum`. `progress` counts frequencies; with tqdm:
`with tqdm(total=n) as bar: map(..., progress=lambda done, total: bar.update(done - bar.n))`.

Parameters
----------
omegas : array_like of shape (n,)
    Frequencies omega_p/p, 0.01 to 1000.
amplitudes : array_like of shape (m,)
    Amplitudes a_p/(alpha*g), 0 to 1e6. n*m is at most 50 million.

Returns
-------
integer array of shape (n, m)
    The code at each point: side*(impacts + 1) if the block overturns, 0 if it is safe.

>>> map([1, 3], [1.2, 1.41, 4])
array([[ 2,  2, -1],
       [ 0,  2, -1]], dtype=int32)
)");
}

}  // namespace
}  // namespace rederive::python

PYBIND11_MODULE(_numbers, module) {
  module.attr("version") = REDERIVE_VERSION;
  rederive::python::add_values(module);
  rederive::python::add_functions(module);
}
