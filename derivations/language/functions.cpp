#include <algorithm>
#include <derivations/language/functions.hpp>
#include <stdexcept>
#include <string>

namespace rederive::language {
namespace {
using GiNaC::ex;
using enum Function::Kind;
using enum Function::Parity;

template <class Serial>
ex value(const ex& u) {
  return GiNaC::function(Serial::serial, u);
}

/// Returns |x|, and x itself for a root: GiNaC turns |sqrt(u)| into sqrt(|u|) and forgets that u >= 0.
ex absolute(const ex& x) {
  const bool is_root = GiNaC::is_a<GiNaC::power>(x) && x.op(1).info(GiNaC::info_flags::rational) &&
                       !x.op(1).info(GiNaC::info_flags::integer);
  return is_root ? x : GiNaC::abs(x);
}

// clang-format off
constexpr Function table[] = {
    {.name = "sin", .of = value<GiNaC::sin_SERIAL>, .latex = "\\sin", .kind = circular, .parity = odd,
     .derivative = "cos(u)", .piece = "[-pi/2, pi/2]", .values = "[-1, 1]", .inverse = "asin",
     .half_turn = -1},
    {.name = "cos", .of = value<GiNaC::cos_SERIAL>, .latex = "\\cos", .kind = circular, .parity = even,
     .derivative = "-sin(u)", .piece = "[0, pi]", .values = "[1, -1]", .inverse = "acos", .half_turn = -1},
    {.name = "tan", .of = value<GiNaC::tan_SERIAL>, .latex = "\\tan", .aliases = "tg", .kind = circular,
     .parity = odd, .needs = {"cos(u)"}, .simpler = "sin(u)/cos(u)", .derivative = "1+tan(u)^2",
     .piece = "(-pi/2, pi/2)", .values = "(-inf, inf)", .inverse = "atan", .half_turn = +1},
    {.name = "cot", .of = [](const ex& u) -> ex { return cos(u) / sin(u); }, .latex = "\\cot",
     .aliases = "ctg", .kind = circular, .parity = odd, .needs = {"sin(u)"}, .simpler = "cos(u)/sin(u)",
     .derivative = "-1-cot(u)^2", .piece = "(0, pi)", .values = "(inf, -inf)", .half_turn = +1},
    {.name = "sec", .of = [](const ex& u) -> ex { return 1 / cos(u); }, .latex = "\\sec", .kind = circular,
     .parity = even, .needs = {"cos(u)"}, .simpler = "1/cos(u)", .reciprocal = "cos",
     .derivative = "sec(u)*tan(u)", .half_turn = -1},
    {.name = "csc", .of = [](const ex& u) -> ex { return 1 / sin(u); }, .latex = "\\csc", .aliases = "cosec",
     .kind = circular, .parity = odd, .needs = {"sin(u)"}, .simpler = "1/sin(u)", .reciprocal = "sin",
     .derivative = "-csc(u)*cot(u)", .half_turn = -1},
    {.name = "asin", .of = value<GiNaC::asin_SERIAL>, .latex = "\\arcsin", .aliases = "arcsin",
     .kind = inverse, .parity = odd, .domain = {-1, 1}, .needs = {"1-u^2 >= 0"},
     .derivative = "1/sqrt(1-u^2)", .values = "[-pi/2, pi/2]", .inverse = "sin"},
    {.name = "acos", .of = value<GiNaC::acos_SERIAL>, .latex = "\\arccos", .aliases = "arccos",
     .kind = inverse, .domain = {-1, 1}, .needs = {"1-u^2 >= 0"}, .simpler = "pi/2-asin(u)",
     .derivative = "-1/sqrt(1-u^2)", .values = "[pi, 0]", .inverse = "cos"},
    {.name = "atan", .of = value<GiNaC::atan_SERIAL>, .latex = "\\arctan", .aliases = "arctan atan2",
     .kind = inverse, .parity = odd, .derivative = "1/(1+u^2)", .values = "(-pi/2, pi/2)", .inverse = "tan"},
    {.name = "sinh", .of = value<GiNaC::sinh_SERIAL>, .latex = "\\sinh", .aliases = "sh", .kind = exponential,
     .parity = odd, .simpler = "(exp(u)-exp(-u))/2", .derivative = "cosh(u)", .values = "(-inf, inf)",
     .inverse = "asinh"},
    {.name = "cosh", .of = value<GiNaC::cosh_SERIAL>, .latex = "\\cosh", .aliases = "ch", .kind = exponential,
     .parity = even, .simpler = "(exp(u)+exp(-u))/2", .derivative = "sinh(u)", .piece = "[0, inf)",
     .values = "[1, inf)"},
    {.name = "tanh", .of = value<GiNaC::tanh_SERIAL>, .latex = "\\tanh", .aliases = "th", .kind = exponential,
     .parity = odd, .simpler = "(exp(u)-exp(-u))/(exp(u)+exp(-u))", .derivative = "1-tanh(u)^2",
     .values = "(-1, 1)", .inverse = "atanh"},
    {.name = "coth", .of = [](const ex& u) -> ex { return cosh(u) / sinh(u); }, .latex = "\\coth",
     .kind = exponential, .parity = odd, .needs = {"u"}, .simpler = "(exp(u)+exp(-u))/(exp(u)-exp(-u))",
     .reciprocal = "tanh", .derivative = "1-coth(u)^2"},
    {.name = "sech", .of = [](const ex& u) -> ex { return 1 / cosh(u); }, .latex = "\\operatorname{sech}",
     .kind = exponential, .parity = even, .simpler = "2/(exp(u)+exp(-u))", .reciprocal = "cosh",
     .derivative = "-sech(u)*tanh(u)"},
    {.name = "csch", .of = [](const ex& u) -> ex { return 1 / sinh(u); }, .latex = "\\operatorname{csch}",
     .kind = exponential, .parity = odd, .needs = {"u"}, .simpler = "2/(exp(u)-exp(-u))",
     .reciprocal = "sinh", .derivative = "-csch(u)*coth(u)"},
    {.name = "asinh", .of = value<GiNaC::asinh_SERIAL>, .latex = "\\operatorname{arsinh}",
     .aliases = "arcsinh arsinh", .coq = "arcsinh", .kind = inverse, .parity = odd,
     .simpler = "log(u+sqrt(u^2+1))", .derivative = "1/sqrt(1+u^2)", .values = "(-inf, inf)",
     .inverse = "sinh"},
    {.name = "acosh", .of = value<GiNaC::acosh_SERIAL>, .latex = "\\operatorname{arcosh}",
     .aliases = "arccosh arcosh", .has_coq = false, .kind = inverse, .domain = {1}, .needs = {"u-1 >= 0"},
     .simpler = "log(u+sqrt(u^2-1))", .derivative = "1/sqrt(u^2-1)", .values = "[0, inf)", .inverse = "cosh"},
    {.name = "atanh", .of = value<GiNaC::atanh_SERIAL>, .latex = "\\operatorname{artanh}",
     .aliases = "arctanh artanh", .has_coq = false, .kind = inverse, .parity = odd, .domain = {-1, 1, true},
     .needs = {"1-u > 0", "1+u > 0"}, .simpler = "log((1+u)/(1-u))/2", .derivative = "1/(1-u^2)",
     .values = "(-inf, inf)", .inverse = "tanh"},
    {.name = "exp", .of = value<GiNaC::exp_SERIAL>, .latex_frame = "\\mathrm{e}^{#}", .kind = exponential,
     .derivative = "exp(u)", .values = "(0, inf)", .inverse = "log"},
    {.name = "log", .of = value<GiNaC::log_SERIAL>, .latex = "\\ln", .aliases = "ln", .coq = "ln",
     .kind = inverse, .domain = {0, HUGE_VAL, true}, .needs = {"u > 0"}, .derivative = "1/u",
     .values = "(-inf, inf)", .inverse = "exp"},
    {.name = "sqrt", .of = [](const ex& u) -> ex { return sqrt(u); }, .latex_frame = "\\sqrt{#}", .unicode = "√",
     .aliases = "root", .domain = {0}, .needs = {"u >= 0"}, .derivative = "1/(2*sqrt(u))",
     .values = "[0, inf)"},
    {.name = "fabs", .of = absolute, .latex_frame = "\\left|#\\right|", .unicode = "abs", .javascript = "abs",
     .coq = "Rabs", .parity = even, .derivative = "u/fabs(u)", .piece = "[0, inf)", .values = "[0, inf)"},
};
// clang-format on

}  // namespace

std::span<const Function> functions() { return table; }

const Function* find_function(std::string_view name) {
  if (name == "abs" || name == "Abs") name = "fabs";
  const Function* found = std::ranges::find(table, name, &Function::name);
  return found == std::end(table) ? nullptr : found;
}

const Function& function_named(std::string_view name) {
  if (const Function* found = find_function(name)) return *found;
  throw std::out_of_range("there is no function '" + std::string(name) + "'");
}

bool is_function(std::string_view name) { return name == "pow" || find_function(name) != nullptr; }

}  // namespace rederive::language
