// Writes recurrences as a class of C++ or JavaScript.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/emit/emit.hpp>
#include <derivations/emit/operations.hpp>
#include <set>
#include <stdexcept>

namespace rederive::emit {
using namespace language;

namespace {

constexpr const char* cpp_prologue = R"(
/// Coefficient k of the product of two series, by Cauchy's formula; the newest terms last, so that the others
/// need not wait for them.
template <class T>
[[gnu::always_inline]] inline T product(const T* a, const T* b, int k) {
  if (k == 0) return a[0] * b[0];
  if (k == 1) return a[1] * b[0] + a[0] * b[1];
  T sum = a[1] * b[k - 1];
#pragma GCC unroll 32
  for (int j = 2; j < k; ++j) sum = sum + a[j] * b[k - j];
  return sum + a[k] * b[0] + a[0] * b[k];
}

/// Coefficient k of the series c = a/b, so that c b = a, from those before it.
template <class T>
T quotient(T a_k, const T* b, const T* c, int k) {
  for (int j = 1; j <= k; ++j) a_k = a_k - b[j] * c[k - j];
  return a_k / b[0];
}

/// Returns x^(1/n). Overload it for number types that know a faster root.
template <class T>
T root(T x, int n) {
  using std::pow;
  return pow(x, T(1) / T(n));
}

/// The value of a series a time h after its start, by Horner's rule: even and odd powers apart, which is half as
/// long to wait for.
template <class T, std::size_t size>
[[gnu::always_inline]] inline T value_at(const T (&series)[size], T h) {
  const T square = h * h;
  T even = series[(size - 1) / 2 * 2], odd = series[size / 2 * 2 - 1];
#pragma GCC unroll 32
  for (std::size_t k = (size - 1) / 2 * 2; k > 0; k -= 2) even = even * square + series[k - 2];
#pragma GCC unroll 32
  for (std::size_t k = size / 2 * 2 - 1; k > 1; k -= 2) odd = odd * square + series[k - 2];
  return even + h * odd;
}
)";

constexpr const char* cpp_class = R"(
{documentation}template <class T, int order>
struct {name} {{
{declared}
  /// Coefficients 0: where the motion starts.
  void start({arguments}) {{
{start}  }}

  /// Coefficients 1 to order, from coefficients 0.
  void expand() {{
{before}#pragma GCC unroll 32
    for (int k = 0; k < order; ++k) {{
{lines}    }}
  }}

  /// The largest of the coefficients k.
  T largest(int k) const {{
    using std::fabs;
    using std::max;
    T value = T(0);
{largest}    return value;
  }}

  /// The step over which neither of the last two terms exceeds the tolerance.
  T step_size(T tolerance) const {{
    using std::min;
    return min(root(tolerance / largest(order - 1), order - 1), root(tolerance / largest(order), order));
  }}

  /// Coefficients 0 a time h later; functions go along with the state.
  void advance(T h) {{
{advance}  }}
}};
)";

constexpr const char* javascript_prologue = R"(
/// Coefficient k of the product of two series, by Cauchy's formula.
function product(a, b, k) {
  let sum = a[0] * b[k];
  for (let j = 1; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

/// Coefficient k of the series c = a/b, so that c b = a, from those before it.
function quotient(a_k, b, c, k) {
  for (let j = 1; j <= k; ++j) a_k -= b[j] * c[k - j];
  return a_k / b[0];
}

/// The value of a series a time h after its start, by Horner's rule.
export function value_at(series, h) {
  let value = 0;
  for (let k = series.length - 1; k >= 0; --k) value = value * h + series[k];
  return value;
}
)";

constexpr const char* javascript_class = R"(
{documentation}export class {name} {{
  constructor(order) {{
    this.order = order;
{declared}  }}

  /// Coefficients 0: where the motion starts.
  start({arguments}) {{
{start}  }}

  /// Coefficients 1 to order, from coefficients 0.
  expand() {{
    const {{ order, {parameters}, {series} }} = this;
{before}    for (let k = 0; k < order; ++k) {{
{lines}    }}
  }}

  /// The largest of the coefficients k.
  largest(k) {{
    const {{ {series} }} = this;
    let value = 0;
{largest}    return value;
  }}

  /// The step over which neither of the last two terms exceeds the tolerance.
  step_size(tolerance) {{
    const length = (k) => Math.pow(tolerance / this.largest(k), 1 / k);
    return Math.min(length(this.order - 1), length(this.order));
  }}

  /// Coefficients 0 a time h later; functions go along with the state.
  advance(h) {{
    const {{ {series} }} = this;
{advance}  }}
}}
)";

using Names = std::vector<std::string>;

/// Returns a copy of a line for each name, which replaces {0}.
std::string each(const Names& names, const std::string& line) {
  std::string text;
  for (const std::string& name : names) text += fmt::format(fmt::runtime(line), name);
  return text;
}

/// Returns coefficient k + 1 of a motion from coefficient k of its rate. The factors that do not depend on
/// the rate come first.
Tree integrated(const Tree& rate) {
  Tree share = leaf("share"), rest = rate;
  if (rate->kind == Node::Kind::negative)
    share = make_tree(Node::Kind::negative, "", {share}), rest = rate->children[0];
  std::vector<Tree> factors = {share};
  if (rest->kind == Node::Kind::product)
    factors.insert(factors.end(), rest->children.begin(), rest->children.end());
  else
    factors.push_back(rest);
  std::vector<bool> divides(factors.size(), false);
  if (rest->kind == Node::Kind::product)
    std::copy(rest->inverse.begin(), rest->inverse.end(), divides.begin() + 1);
  return make_tree(Node::Kind::product, "", factors, divides);
}

std::vector<std::string> documentation(const TaylorStepper& stepper, const RationalSystem& system,
                                       const Names& arguments, const Symbols& symbols) {
  const auto plain = [&](const auto& what) { return print(what, Notation::plain, system.symbols); };
  Names lines = {stepper.brief + ": Taylor coefficients of the motion.", "  Rates of change:"};
  for (const auto& [symbol, rate] : system.rates)
    lines.push_back("    " + name_of(symbol) + "' = " + plain(rate));
  for (const auto& f : system.functions)
    lines.push_back("    where " + f.name + " = " + f.function + "(" + plain(f.argument) + ")");
  for (const std::string& name : arguments) lines.push_back("  " + line_about(*symbols.find(name)));
  std::string printed = stepper.equation;
  for (const auto& [state, rate] : stepper.rates) printed += "\n" + print(rate, Notation::plain, symbols);
  lines.push_back("Equation (" + stepper.equation + "); hash " + hash_of(printed) + ".");
  return lines;
}

/// Returns the class of a stepper. Longer than 60 lines, because each part of the template is one short
/// statement.
std::string text_of(const TaylorStepper& stepper, const Symbols& symbols, Target target) {
  const bool cpp = target == Target::cpp;
  const Dialect& language = dialect(target);
  const RationalSystem system = rational_system(stepper, symbols);
  const Recurrences derived = recurrences(system);
  Names parameters, series;
  for (const SymbolExpression& symbol : stepper.parameters) parameters.push_back(name_of(symbol));
  for (const auto& [symbol, rate] : system.rates) series.push_back(name_of(symbol));
  const Names state(series.begin(), series.end() - static_cast<std::ptrdiff_t>(system.functions.size()));
  Names arguments = parameters;
  arguments.insert(arguments.end(), state.begin(), state.end());
  std::set<std::string> functions;
  const auto infix = [&](const Tree& tree) {
    const Operations operations({tree});
    for (const Operation& operation : operations.all())
      if (operation.kind == Operation::Kind::call) functions.insert(operation.text);
    return Infix(operations, language, false).text(operations.results()[0]);
  };
  const auto declared_functions = [&] {
    const Names names(functions.begin(), functions.end());
    functions.clear();
    return cpp ? each(names, "    using std::{0};\n") : "";
  };
  const auto constant = [&](const std::string& name, const std::string& value) {
    return (cpp ? "const T " : "const ") + name + " = " + value + ";";
  };
  const std::string self = cpp ? "this->" : "this.";
  std::string start =
      each(parameters, "    " + self + "{0} = {0};\n") + each(state, "    " + self + "{0}[0] = {0};\n");
  for (const auto& f : system.functions) {
    Tree argument = f.argument;
    for (const auto& inner : system.functions)
      argument = put_in(argument, leaf(inner.name), leaf(self + inner.name + "[0]"));
    start += "    " + self + f.name + "[0] = " + infix(make_tree(Node::Kind::call, f.function, {argument})) +
             ";\n";
  }
  start = declared_functions() + start;
  Names lines, kept;
  std::string before;
  for (const auto& [name, value, is_kept] : derived.constants)
    before += "    " + constant(name, infix(value)) + "\n";
  for (const auto& [name, value, is_kept] : derived.lines) {
    lines.push_back(is_kept ? name + "[k] = " + infix(value) + ";" : constant(name, infix(value)));
    if (is_kept) kept.push_back(name);
  }
  lines.push_back(constant("share", cpp ? "T(1) / T(k + 1)" : "1 / (k + 1)"));
  for (const auto& [name, rate] : derived.rates)
    lines.push_back(name + "[k + 1] = " + infix(integrated(rate)) + ";");
  before = declared_functions() + before +
           each(kept, cpp ? "    T {0}[order];\n" : "    const {0} = new Float64Array(order);\n");
  std::string body;
  for (const std::string& line : lines) body += wrapped("      " + line, "          ") + "\n";
  if (derived.uses_first)
    body = "      " + constant("first", cpp ? "T(k == 0 ? 1 : 0)" : "k === 0 ? 1 : 0") + "\n" + body;
  const Names about = documentation(stepper, system, arguments, symbols);
  const auto list = [](const Names& names, const std::string& each_of_them) {
    return each(names, ", " + each_of_them).substr(names.empty() ? 0 : 2);
  };
  const std::string declared = "  T " + list(parameters, "{0}") + ";\n" +
                               wrapped("  T " + list(series, "{0}[order + 1]") + ";", "      ", ", ") + "\n",
                    absolute = language.call("fabs", "{0}[k]");
  return fmt::format(
      fmt::runtime(cpp ? cpp_class : javascript_class), fmt::arg("name", stepper.name),
      fmt::arg("documentation", cpp ? each(about, "/// {0}\n") : "/**\n" + each(about, " * {0}\n") + " */\n"),
      fmt::arg("declared", cpp ? declared : each(series, "    this.{0} = new Float64Array(order + 1);\n")),
      fmt::arg("arguments", list(arguments, cpp ? "T {0}" : "{0}")), fmt::arg("start", start),
      fmt::arg("parameters", list(parameters, "{0}")), fmt::arg("series", list(series, "{0}")),
      fmt::arg("before", before), fmt::arg("lines", body),
      fmt::arg("largest", each(series, "    value = " + language.call("max", "value, " + absolute) + ";\n")),
      fmt::arg("advance", each(series, "    {0}[0] = value_at({0}, h);\n")));
}

}  // namespace

std::string taylor_text(const std::vector<TaylorStepper>& steppers, const Symbols& symbols, Target target) {
  if (steppers.empty()) return "";
  if (target != Target::cpp && target != Target::javascript)
    throw std::invalid_argument("Taylor steppers can only be written in C++ and JavaScript");
  std::string text = target == Target::cpp ? cpp_prologue : javascript_prologue;
  for (const TaylorStepper& stepper : steppers) text += text_of(stepper, symbols, target);
  return text;
}

}  // namespace rederive::emit
