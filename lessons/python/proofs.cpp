// Binds the ledger, the prover and the emission to Python; all arguments and results are text. Each takes the
// folder of a paper, or "" for the built-in one. The messages for users of Python are in
// lessons/python/rederive.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <derivations/paper/derivation_file.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/paper/json.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <lessons/ledger/report.hpp>
#include <mutex>
#include <nlohmann/json.hpp>

namespace py = pybind11;

namespace rederive::python {
using namespace language;
using namespace numbers;
using namespace program;
using namespace emit;
using namespace paper;
namespace {

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

/// Where a paper is: its folder, or "" for the built-in one, and files that replace its own where they are
/// not
/// "": equations.toml and derivations.json.
struct Source {
  std::filesystem::path folder, equations, derivations;

  Paper read() const {
    Paper paper = folder.empty() ? rocking_block::paper() : read_paper(folder);
    if (!equations.empty()) paper.rows = {}, paper.equations = equations;
    if (!derivations.empty()) paper.derivations = read_derivations(derivations, paper.symbols);
    return paper;
  }
};

/// Judges all rows of a paper and returns `report(paper, entries)`. Ctrl-C ends it.
template <class Report>
auto judged(const Source& source, Report report) {
  bool is_interrupted = false;
  const auto work = [&] {
    const Paper paper = source.read();
    std::vector<Entry> entries;
    for (const Row& row : rows_of(paper)) {
      if (is_interrupted) break;
      try {
        entries.push_back(judge(paper, row));
      } catch (const SyntaxError& error) {
        throw BadInput("row " + row.id + ": " + explain(error, row.printed, paper.symbols));
      } catch (const std::invalid_argument& error) {
        throw BadInput("row " + row.id + ": " + error.what());
      }
      const py::gil_scoped_acquire locked;
      is_interrupted = PyErr_CheckSignals() != 0;
    }
    return report(paper, entries);
  };
  auto result = alone(algebra(), work);
  if (is_interrupted) throw py::error_already_set();
  return result;
}

/// Returns a statement as LaTeX; "" if there is none, and for a row whose text cannot be read.
std::string latex(const std::string& statement, const Symbols& symbols) {
  try {
    return statement.empty() ? "" : print(parse_statement(statement, symbols), Notation::latex, symbols);
  } catch (const SyntaxError&) {
    return "";
  }
}

/// What Python is told of a row: its JSON, what is printed (or stated) and what is derived as LaTeX.
using Told = std::tuple<std::string, std::string, std::string>;

std::vector<Told> ledger(const Source& source) {
  return judged(source, [](const Paper& paper, const std::vector<Entry>& entries) {
    std::vector<Told> told;
    for (const Entry& entry : entries)
      told.emplace_back(to_json(entry).dump(), latex(entry.row.claim(), paper.symbols),
                        latex(entry.derived, paper.symbols));
    return told;
  });
}

std::string errata(const Source& source, const std::string& format) {
  return judged(source, [&](const Paper& paper, const std::vector<Entry>& entries) {
    return ledger::errata(entries, format, paper);
  });
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
std::string prove(const Source& source, const py::object& left_side, const py::object& right_side,
                  const py::object& assumptions, const py::object& small_symbols,
                  const py::object& series_order) {
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
    return decide_bounded(source.read(), {trimmed(left), trimmed(right), assume, small, order}, stop).dump();
  });
  if (is_interrupted) throw py::error_already_set();
  return found;
}

std::string emit_text(const Source& source, const py::object& language, const py::object& functions) {
  const std::string target = text_of("emit(): target", language);
  const auto names = texts_of("emit(): functions", functions);
  const auto found = targets().find(target);
  if (found == targets().end()) {
    std::string known;
    for (const auto& [name, its] : targets()) known += (known.empty() ? "" : ", ") + name;
    throw BadInput("there is no target '" + target + "'; the target must be one of " + known);
  }
  return alone(algebra(), [&] {
    return emit::emit(chosen_from(source.read().emission(), names, found->second), found->second);
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
  using namespace rederive::python;
  const py::arg source("source");
  py::class_<Source>(module, "Source")
      .def(py::init<std::filesystem::path, std::filesystem::path, std::filesystem::path>(),
           py::arg("folder") = "", py::arg("equations") = "", py::arg("derivations") = "");
  module.def("ledger", rederive::python::ledger, source);
  module.def("errata", rederive::python::errata, source, py::arg("format"));
  module.def("prove", rederive::python::prove, source, py::arg("left"), py::arg("right"), py::arg("assume"),
             py::arg("small"), py::arg("order"));
  module.def("emit", emit_text, source, py::arg("target"), py::arg("names"));
  module.def("has_current_derivations", rederive::paper::has_current_derivations, py::arg("folder"));
}
