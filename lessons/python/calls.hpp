// What all calls from Python share: they check numbers, and they let Python watch and end a long computation.
#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <numerics/motion/parallel.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rederive::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the value. Throws std::invalid_argument, with `name`, unless low <= value <= high.
inline double between(const char* name, double value, double low, double high) {
  if (!std::isfinite(value))
    throw std::invalid_argument(fmt::format("{} {} is not a finite number", name, value));
  if (!(value >= low && value <= high))
    throw std::invalid_argument(fmt::format("{} {} must lie between {} and {}", name, value, low, high));
  return value;
}

/// Returns the values of an array. Throws std::invalid_argument, with `name`, unless it has one dimension and
/// all values are between the bounds.
inline std::vector<double> numbers_of(const char* name, const Numbers& array, double low, double high) {
  if (array.ndim() != 1)
    throw std::invalid_argument(
        fmt::format("{} must be a list or an array of one dimension; this one has {}", name, array.ndim()));
  std::vector<double> values(array.data(), array.data() + array.size());
  for (const double value : values) between(name, value, low, high);
  return values;
}

/// Returns compute(work), computed on other threads without Python's lock. This thread tells `progress` how
/// many of `count` parts are done, and watches for Ctrl-C, after which no further part is begun.
template <class Compute>
auto attended(int count, std::optional<int> threads, const py::object& progress, Compute compute) {
  std::atomic<bool> stop{false};
  std::atomic<int> done{0};
  numerics::Work work;
  work.count = count, work.stop = &stop, work.progress = [&](int n) { done = n; };
  const int machine = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  work.threads = static_cast<int>(between("threads", threads.value_or(machine), 1, 1024));
  auto result = std::async(std::launch::async, [&] { return compute(work); });
  std::exception_ptr raised;
  for (bool over = false; !over;) {
    {
      const py::gil_scoped_release release;
      over = result.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
    }
    if (raised) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (const int now = done.exchange(0); now > 0 && !progress.is_none()) progress(now, count);
    } catch (...) {
      raised = std::current_exception(), stop = true;
    }
  }
  if (raised) std::rethrow_exception(raised);
  return result.get();
}

/// Returns the value, or NaN if there is none.
inline double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Returns a structured array of NumPy with the named columns: name and type.
template <class Row>
py::object table(const std::vector<Row>& rows,
                 const std::vector<std::pair<std::string, std::string>>& columns) {
  return py::module_::import("numpy").attr("array")(rows, columns);
}

}  // namespace rederive::python
