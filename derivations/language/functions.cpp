#include <algorithm>
#include <derivations/language/functions.hpp>

namespace rederive {

namespace {

using GiNaC::ex;

/// Returns |x|, and x itself for a root: GiNaC turns |sqrt(u)| into sqrt(|u|) and forgets that u >= 0.
ex absolute(const ex& x) {
  const bool is_root = GiNaC::is_a<GiNaC::power>(x) && x.op(1).info(GiNaC::info_flags::rational) &&
                       !x.op(1).info(GiNaC::info_flags::integer);
  return is_root ? x : GiNaC::abs(x);
}

// clang-format off
constexpr Function table[] = {
    {"sin", "\\sin", "", [](const ex& x) -> ex { return sin(x); }},
    {"cos", "\\cos", "", [](const ex& x) -> ex { return cos(x); }},
    {"tan", "\\tan", "tg", [](const ex& x) -> ex { return tan(x); }},
    {"cot", "\\cot", "ctg", [](const ex& x) -> ex { return cos(x) / sin(x); }},
    {"sec", "\\sec", "", [](const ex& x) -> ex { return 1 / cos(x); }},
    {"csc", "\\csc", "cosec", [](const ex& x) -> ex { return 1 / sin(x); }},
    {"asin", "\\arcsin", "arcsin", [](const ex& x) -> ex { return asin(x); }, -1, 1},
    {"acos", "\\arccos", "arccos", [](const ex& x) -> ex { return acos(x); }, -1, 1},
    {"atan", "\\arctan", "arctan atan2", [](const ex& x) -> ex { return atan(x); }},
    {"sinh", "\\sinh", "sh", [](const ex& x) -> ex { return sinh(x); }},
    {"cosh", "\\cosh", "ch", [](const ex& x) -> ex { return cosh(x); }},
    {"tanh", "\\tanh", "th", [](const ex& x) -> ex { return tanh(x); }},
    {"coth", "\\coth", "", [](const ex& x) -> ex { return cosh(x) / sinh(x); }},
    {"sech", "\\operatorname{sech}", "", [](const ex& x) -> ex { return 1 / cosh(x); }},
    {"csch", "\\operatorname{csch}", "", [](const ex& x) -> ex { return 1 / sinh(x); }},
    {"asinh", "\\operatorname{arsinh}", "arcsinh arsinh", [](const ex& x) -> ex { return asinh(x); }},
    {"acosh", "\\operatorname{arcosh}", "arccosh arcosh", [](const ex& x) -> ex { return acosh(x); }, 1},
    {"atanh", "\\operatorname{artanh}", "arctanh artanh", [](const ex& x) -> ex { return atanh(x); }, -1, 1, true},
    {"exp", "", "", [](const ex& x) -> ex { return exp(x); }},
    {"log", "\\ln", "ln", [](const ex& x) -> ex { return log(x); }, 0, HUGE_VAL, true},
    {"sqrt", "", "root", [](const ex& x) -> ex { return sqrt(x); }, 0},
    {"fabs", "", "", absolute},
};
// clang-format on

}  // namespace

std::span<const Function> functions() { return table; }

const Function* find_function(std::string_view name) {
  if (name == "abs" || name == "Abs") name = "fabs";
  const Function* found = std::ranges::find(table, name, &Function::name);
  return found == std::end(table) ? nullptr : found;
}

bool is_function(std::string_view name) { return name == "pow" || find_function(name) != nullptr; }

}  // namespace rederive
