// Binds the ledger, the prover and the emission to Python; all arguments and results are text. The messages
// for users of Python are in lessons/python/rederive.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <derivations/paper/json.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <mutex>
#include <nlohmann/json.hpp>

namespace py = pybind11;

namespace rederive::python {
using namespace language;
using namespace numbers;
using namespace program;
using namespace emit;
using namespace paper;
using namespace rocking_block;
namespace {

using rocking_block::paper;

/// Without Python's lock, but one at a time: GiNaC counts references, and remembers, without locks.
template <class Work>
auto alone(std::mutex& mutex, Work work) {
  const py::gil_scoped_release release;
  const std::lock_guard lock(mutex);
  return work();
}

std::mutex& algebra() {
  static std::mutex mutex;
  return mutex;
}

std::string latex(const std::string& statement) {
  return statement.empty()
             ? ""
             : print(parse_statement(statement, paper().symbols), Notation::latex, paper().symbols);
}

/// What Python is told of a row: its JSON, what is printed (or stated) and what is derived as LaTeX.
using Told = std::tuple<std::string, std::string, std::string>;

std::vector<Told> ledger(const std::string& equations) {
  const std::vector<Row> rows = read_rows(equations);
  std::vector<Told> told;
  for (const Row& row : rows) {
    told.push_back(alone(algebra(), [&] {
      const Entry entry = judge(paper(), row);
      return Told{to_json(entry).dump(), latex(row.claim()), latex(entry.derived)};
    }));
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return told;
}

/// The text that a Python object is. Throws py::type_error, which begins with `name`, where it is not text,
/// and UnicodeEncodeError where it has surrogates.
std::string text_of(const std::string& name, const py::handle& object) {
  if (!py::isinstance<py::str>(object))
    throw py::type_error(name + " must be text, not " + Py_TYPE(object.ptr())->tp_name +
                         "; pass str() of a SymPy expression");
  Py_ssize_t size = 0;
  const char* text = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
  if (text == nullptr) throw py::error_already_set();
  return {text, static_cast<std::size_t>(size)};
}

/// One text, or the texts of a list or another iterable.
std::vector<std::string> texts_of(const std::string& name, const py::object& given) {
  std::vector<std::string> texts;
  if (!py::isinstance<py::iterable>(given) || py::isinstance<py::str>(given) ||
      py::isinstance<py::bytes>(given))
    texts.push_back(text_of(name, given));
  else
    for (const py::handle object : given) texts.push_back(text_of(name, object));
  return texts;
}

/// Ctrl-C ends it.
std::string prove(const py::object& left_side, const py::object& right_side, const py::object& assumptions,
                  const py::object& small_symbols, const py::object& series_order) {
  const std::string left = text_of("prove(): left", left_side), right = text_of("prove(): right", right_side);
  const auto assume = texts_of("prove(): assume", assumptions),
             small = texts_of("prove(): small", small_symbols);
  if (!series_order.is_none() && !py::isinstance<py::int_>(series_order))
    throw py::type_error(std::string("prove(): order must be a whole number, not ") +
                         Py_TYPE(series_order.ptr())->tp_name);
  const auto order = series_order.cast<std::optional<int>>();
  bool is_interrupted = false;
  const auto stop = [&] {
    const py::gil_scoped_acquire locked;
    return is_interrupted = PyErr_CheckSignals() != 0;
  };
  std::string found = alone(algebra(), [&] {
    return decide_bounded(paper(), {trimmed(left), trimmed(right), assume, small, order}, stop).dump();
  });
  if (is_interrupted) throw py::error_already_set();
  return found;
}

std::string emit_text(const py::object& language, const py::object& functions) {
  const std::string target = text_of("emit(): target", language);
  const auto names = texts_of("emit(): functions", functions);
  const auto found = targets().find(target);
  if (found == targets().end()) {
    std::string known;
    for (const auto& [name, its] : targets()) known += (known.empty() ? "" : ", ") + name;
    throw BadInput("there is no target '" + target + "'; the target must be one of " + known);
  }
  return alone(algebra(), [&] {
    return emit::emit(chosen_from(paper().emission(), names, found->second), found->second);
  });
}

}  // namespace
}  // namespace rederive::python

PYBIND11_MODULE(_proofs, module) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const rederive::program::BadInput& error) {
      PyErr_SetString(PyExc_ValueError, rederive::program::printable(error.what()).c_str());
    }
  });
  module.def("ledger", rederive::python::ledger, py::arg("equations"));
  module.def("prove", rederive::python::prove, py::arg("left"), py::arg("right"), py::arg("assume"),
             py::arg("small"), py::arg("order"));
  module.def("emit", rederive::python::emit_text, py::arg("target"), py::arg("names"));
}
