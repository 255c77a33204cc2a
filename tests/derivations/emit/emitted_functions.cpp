#include <cln/float.h>
#include <cln/real.h>
#include <doctest/doctest.h>

#include <cmath>
#include <derivations/emit/emit.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <emitted/rocking_block.hpp>
#include <random>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

#include "running_error.hpp"

using namespace rederive;
using namespace rederive::rocking_block;

namespace {

constexpr unsigned seed = 4'711;
constexpr int points_each = 20;

// ---- points: rational numbers with few binary digits, exact as double, inside the declared ranges

double end_of(const std::string& end, double instead) {
  if (end.ends_with("inf")) return instead;
  return std::stod(digits_at(parse(end), {}, 17).value());
}

std::vector<double> random_point(const EmittedFunction& function, std::mt19937& random) {
  std::vector<double> point;
  for (const SymbolExpression& argument : function.arguments) {
    const Range range = read_range(emission_symbols().find(name_of(argument))->range);
    const double upper = end_of(range.upper, 4), lower = end_of(range.lower, -4);
    const double part = 0.05 + 0.9 * static_cast<double>(random() % 1000) / 1000;
    point.push_back(std::round((lower + part * (upper - lower)) * 256) / 256);
  }
  return point;
}

Point exact_point(const EmittedFunction& function, const std::vector<double>& values) {
  Point point;
  for (std::size_t i = 0; i < values.size(); ++i) {
    point.emplace(name_of(function.arguments[i]), cln::rational(cln::cl_DF(values[i])));
  }
  return point;
}

/// |computed - exact| over the condition estimate.
double error_in_units(const EmittedFunction& function, const GiNaC::ex& value,
                      const std::vector<double>& point, double computed) {
  const Tree tree = to_tree(value, emission_symbols());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < point.size(); ++i) values[name_of(function.arguments[i])] = point[i];
  const Value exact = value_at(tree, exact_point(function, point), 200);
  REQUIRE_MESSAGE(exact.is == Value::Is::certain, function.name);
  const double difference =
      cln::double_approx(cln::rational(cln::cl_DF(computed)) - cln::cl_RA(exact.ball()));
  return std::fabs(difference) / (running_error(*tree, values).error + 0x1p-1060);
}

// ---- what each language computes: a program that prints every function at every point

struct Language {
  Target target;
  std::string program, file, begin, end;
  std::string print_before, print_after;  // around a number
  std::vector<std::string> compile;       // arguments of the program; empty: it interprets the file
};

std::vector<Language> languages() {
  const std::vector<std::string> strict = {"-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1"};
  Language cpp{Target::cpp,
               "g++",
               "emitted.hpp",
               "#include <cstdio>\n#include \"emitted.hpp\"\n"
               "using namespace rederive::emitted;\nint main() {\n",
               "}\n",
               "std::printf(\"%.17g\\n\", ",
               ");",
               strict};
  Language c{Target::c,
             "gcc",
             "emitted.h",
             "#include <stdio.h>\n#include \"emitted.h\"\nint main(void) {\n",
             "return 0;\n}\n",
             "printf(\"%.17g\\n\", ",
             ");",
             strict};
  cpp.compile.push_back("-std=c++20");
  c.compile.push_back("-std=c11");
  return {cpp,
          c,
          {Target::python, "python3", "emitted.py", "from emitted import *\n", "", "print(repr(", "))", {}},
          {Target::javascript,
           "node",
           "emitted.mjs",
           "import * as emitted from \"./emitted.mjs\";\n",
           "",
           "console.log(String(emitted.",
           "));",
           {}}};
}

bool there_is(const std::string& program) {
  return run_program("/usr/bin/env", {"sh", "-c", "command -v " + program}).exit_code == 0;
}

std::string call_of(const std::string& name, const std::vector<double>& point) {
  std::string text = name + "(";
  for (std::size_t i = 0; i < point.size(); ++i) {
    char number[64];
    std::snprintf(number, sizeof number, "%s%.8f", i == 0 ? "" : ", ", point[i]);
    text += number;
  }
  return text + ")";
}

using Points = std::vector<std::vector<std::vector<double>>>;  // function, point, argument

Points random_points(const std::vector<EmittedFunction>& functions) {
  std::mt19937 random(seed);
  Points points;
  for (const EmittedFunction& function : functions) {
    auto& some = points.emplace_back();
    for (int i = 0; i < points_each; ++i) some.push_back(random_point(function, random));
  }
  return points;
}

/// A line for each value and each derivative, in the order of functions and points.
std::string driver(const Language& language, const std::vector<EmittedFunction>& functions,
                   const Points& points) {
  std::string text = language.begin;
  const auto line = [&](const std::string& call) {
    text += language.print_before + call + language.print_after + "\n";
  };
  for (std::size_t f = 0; f < functions.size(); ++f) {
    for (const auto& point : points[f]) {
      line(call_of(functions[f].name, point));
      for (const SymbolExpression& symbol : functions[f].derivatives) {
        line(call_of(functions[f].name + "_with_derivatives", point) + ".d_" + name_of(symbol));
      }
    }
  }
  return text + language.end;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Runs a command in a folder; its output, after a check that it succeeds in silence.
std::string in_folder(const std::filesystem::path& folder, const std::string& command) {
  const Result result =
      run_program("/usr/bin/env", {"sh", "-c", "cd '" + folder.string() + "' && " + command});
  CHECK_MESSAGE(result.exit_code == 0, result.err.substr(0, 2000));
  CHECK(result.err == "");
  return result.out;
}

std::vector<double> computed_by(const Language& language, const std::vector<EmittedFunction>& functions,
                                const Points& points, bool sharing) {
  const TemporaryFolder folder;
  write(folder.path / language.file, emit(functions, language.target, sharing));
  const bool compiled = !language.compile.empty();
  const std::string suffix = language.file.substr(language.file.find('.'));
  const std::string main = compiled ? (suffix == ".h" ? "main.c" : "main.cpp") : "main" + suffix;
  write(folder.path / main, driver(language, functions, points));
  if (compiled) {
    std::string flags;
    for (const std::string& flag : language.compile) flags += " " + flag;
    // Alone first: the text must not lean on what a user includes before it.
    write(folder.path / ("alone" + main.substr(4)), "#include \"" + language.file + "\"\n");
    in_folder(folder.path, language.program + flags + " -c alone" + main.substr(4));
    in_folder(folder.path, language.program + flags + " " + main + " -o program -lm");
  }
  std::istringstream lines(in_folder(folder.path, compiled ? "./program" : language.program + " " + main));
  std::vector<double> numbers;
  for (std::string number; lines >> number;) numbers.push_back(std::stod(number));
  return numbers;
}

/// Compares all that a language computes with 50 digits; the largest error in units of the condition
/// estimate.
double worst_error(const Language& language, bool sharing) {
  const std::vector<EmittedFunction> functions = emitted_functions();
  const Points points = random_points(functions);
  const std::vector<double> numbers = computed_by(language, functions, points, sharing);
  std::size_t next = 0;
  double worst = 0;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const EmittedFunction& function = functions[f];
    std::vector<GiNaC::ex> values = {function.value};
    for (const SymbolExpression& symbol : function.derivatives) values.push_back(function.value.diff(symbol));
    for (const auto& point : points[f]) {
      for (const GiNaC::ex& value : values) {
        REQUIRE(next < numbers.size());
        const double error = error_in_units(function, value, point, numbers[next++]);
        CHECK_MESSAGE(error < 1, function.name);
        worst = std::max(worst, error);
      }
    }
  }
  CHECK(next == numbers.size());
  return worst;
}

}  // namespace

TEST_CASE("every language computes what was derived, to the digits that its rounding allows") {
  MESSAGE("seed " << seed);
  for (const Language& language : languages()) {
    CAPTURE(language.program);
    if (!there_is(language.program)) {
      skip("there is no " + language.program);
      continue;
    }
    for (const bool sharing : {true, false}) {
      const double worst = worst_error(language, sharing);
      MESSAGE(language.program << std::string(sharing ? ", shared" : ", not shared") << ": worst error "
                               << worst << " of the condition estimate");
    }
  }
}

TEST_CASE("derivatives pass the Taylor test: the remainder is of second order") {
  using namespace rederive::emitted;
  const auto order = [](const auto& f, double x) {  // f gives value and derivative
    const auto [value, slope] = f(x);
    const auto remainder = [&, v = value, s = slope](double h) {
      return std::fabs(f(x + h).first - v - h * s);
    };
    return std::log2(remainder(0x1p-8) / remainder(0x1p-9));
  };
  const auto pair = [](auto result, auto member) { return std::pair{result.value, result.*member}; };
  std::mt19937 random(seed);
  for (int i = 0; i < 10; ++i) {
    const double w = 0.5 + static_cast<double>(random() % 1000) / 250,
                 x = 0.3 + static_cast<double>(random() % 1000) / 1500;
    CAPTURE(w);
    CAPTURE(x);
    using Negative = angular_acceleration_negative_with_derivatives_result<double>;
    using Threshold = overturning_without_impact_negative_with_derivatives_result<double>;
    using Impact = impact_during_pulse_with_derivatives_result<double>;
    using Critical = overturning_impact_after_pulse_with_derivatives_result<double>;
    using Response = linear_response_positive_with_derivatives_result<double>;
    CHECK(order(
              [&](double v) {
                return pair(angular_acceleration_negative_with_derivatives(0.25, w, v, 0.3),
                            &Negative::d_theta);
              },
              x) == doctest::Approx(2).epsilon(0.1));
    CHECK(order(
              [&](double v) {
                return pair(overturning_without_impact_negative_with_derivatives(w, v), &Threshold::d_psi);
              },
              x) == doctest::Approx(2).epsilon(0.1));
    CHECK(
        order(
            [&](double v) { return pair(impact_during_pulse_with_derivatives(w, 0.4, v), &Impact::d_tau_i); },
            x) == doctest::Approx(2).epsilon(0.1));
    CHECK(order(
              [&](double v) {
                return pair(overturning_impact_after_pulse_with_derivatives(w, v, 2.0, 0.9),
                            &Critical::d_psi);
              },
              x) == doctest::Approx(2).epsilon(0.1));
    CHECK(order(
              [&](double v) {
                return pair(linear_response_positive_with_derivatives(0.25, 2.0, w, 0.5, 0.4, 0.01, -0.2, v),
                            &Response::d_t);
              },
              x) == doctest::Approx(2).epsilon(0.1));
  }
}
