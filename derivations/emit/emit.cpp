// Writes functions as source text: the part that is common to all targets.
#include <algorithm>
#include <derivations/emit/emit.hpp>
#include <derivations/emit/operations.hpp>
#include <derivations/language/print.hpp>
#include <derivations/mechanics/dimension.hpp>
#include <derivations/program/program.hpp>
#include <set>
#include <stdexcept>

namespace rederive::emit {
using namespace language;
using namespace mechanics;
using namespace program;

namespace {

using Kind = Operation::Kind;

std::vector<Tree> trees_of(const EmittedFunction& function, const Symbols& symbols, bool with_derivatives) {
  std::vector<Tree> trees = {to_tree(function.value, symbols)};
  for (const SymbolExpression& symbol : function.derivatives) {
    if (with_derivatives) trees.push_back(to_tree(function.value.diff(symbol), symbols));
  }
  return trees;
}

std::vector<std::string> argument_names(const EmittedFunction& function) {
  std::vector<std::string> names;
  for (const SymbolExpression& argument : function.arguments) {
    names.push_back(name_of(argument));
  }
  return names;
}

Body body_of(const EmittedFunction& function, const Symbols& symbols, bool with_derivatives,
             const Dialect& dialect, bool sharing) {
  const Operations operations(trees_of(function, symbols, with_derivatives));
  const Infix infix(operations, dialect, sharing);
  Body body;
  body.shared = infix.shared();
  std::set<std::string> used, functions;
  for (const Operation& operation : operations.all()) {
    if (operation.kind == Kind::call) functions.insert(operation.text);
    if (operation.kind == Kind::symbol) used.insert(operation.text);
  }
  body.functions_used.assign(functions.begin(), functions.end());
  for (const std::string& name : argument_names(function)) {
    if (!used.contains(name)) body.unused.push_back(name);
  }
  const auto& results = operations.results();
  body.results.emplace_back("value", infix.text(results[0]));
  for (std::size_t i = 1; i < results.size(); ++i) {
    body.results.emplace_back("d_" + name_of(function.derivatives[i - 1]), infix.text(results[i]));
  }
  return body;
}

/// Throws std::invalid_argument if a symbol in the value is not an argument.
void check_arguments(const EmittedFunction& function, const Symbols& symbols) {
  for (auto part = function.value.preorder_begin(); part != function.value.preorder_end(); ++part) {
    if (!GiNaC::is_a<GiNaC::symbol>(*part)) continue;
    const bool given =
        std::any_of(function.arguments.begin(), function.arguments.end(),
                    [&](const SymbolExpression& argument) { return argument.is_equal(*part); });
    if (!given) {
      throw std::invalid_argument(function.name + " depends on " + print(*part, Notation::plain, symbols) +
                                  ", which is not among its arguments");
    }
  }
}

std::string plain_unit(const Dimension& dimension) {
  std::string above, below;
  for (std::size_t i = 0; i < dimension.size(); ++i) {
    const GiNaC::numeric power = GiNaC::abs(dimension[i]);
    if (power.is_zero()) continue;
    std::string& side = dimension[i].is_negative() ? below : above;
    std::string factor = base_units[i];
    if (power != 1) factor += "^" + print(power, Notation::plain, {});
    side += (side.empty() ? "" : dimension[i].is_negative() ? "/" : "*") + factor;
  }
  return (above.empty() ? "1" : above) + (below.empty() ? "" : "/" + below);
}

std::vector<std::string> documentation(const EmittedFunction& function, const Symbols& symbols,
                                       bool with_derivatives) {
  const Provenance facts = provenance(function, symbols);
  const Operations operations(trees_of(function, symbols, with_derivatives));
  std::vector<std::string> lines = {function.brief + (with_derivatives ? ", with derivatives" : "") + "."};
  for (const std::string& name : argument_names(function)) {
    lines.push_back("  " + line_about(*symbols.find(name)));
  }
  lines.push_back("  returns: " + facts.unit);
  lines.push_back("Equation (" + function.equation + "); " + std::to_string(operations.count_unshared()) +
                  " operations, " + std::to_string(operations.count()) +
                  " with shared subexpressions; hash " + facts.hash + ".");
  return lines;
}

constexpr auto origin = "Written by emit from the derivations: not to be edited.";

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += (c == '_' || c == '^' ? "\\" : "") + std::string(1, c);
  return result;
}

std::string latex(const Emission& emission) {
  std::string text =
      "% " + std::string(origin) + "\n\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n";
  for (const EmittedFunction& function : emission.functions) {
    text += "\n\\paragraph{" + latex_escaped(function.name) + ", equation (" + function.equation + ")} ";
    text += "% hash " + provenance(function, emission.symbols).hash + "\n\\[\n  ";
    text += print(function.value, Notation::latex, emission.symbols) + "\n\\]\n";
  }
  return text + "\n\\end{document}\n";
}

}  // namespace

std::string hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  static constexpr const char* digits = "0123456789abcdef";
  std::string result;
  for (int shift = 60; shift >= 0; shift -= 4) result += digits[hash >> shift & 15];
  return result;
}

std::string line_about(const Symbol& symbol) {
  return symbol.name + ": " + symbol.meaning + "; " + symbol.unit + ", " + symbol.range;
}

Provenance provenance(const EmittedFunction& function, const Symbols& symbols) {
  check_arguments(function, symbols);
  const Tree tree = to_tree(function.value, symbols);
  const DimensionReport report = dimension(tree, symbols);
  if (!report.consistent) throw std::invalid_argument(function.name + ": " + report.explanation);
  const Operations operations(trees_of(function, symbols, true));
  return {plain_unit(report.dimension.value_or(Dimension{})), operations.count_unshared(), operations.count(),
          hash_of(function.equation + "\n" + print(tree))};
}

std::string emit(const Emission& emission, Target target, bool sharing) {
  const auto& [symbols, functions, steppers, units] = emission;
  for (const EmittedFunction& function : functions) provenance(function, symbols);  // refuses what is unsound
  if (target == Target::latex) return latex(emission);
  const Dialect& language = dialect(target);
  std::string text = language.comment({origin, units}) + language.prologue();
  for (const EmittedFunction& function : functions) {
    const std::vector<std::string> arguments = argument_names(function);
    const auto write = [&, &symbols = symbols](const std::string& name, bool with_derivatives) {
      text += "\n" + language.function(name, arguments, documentation(function, symbols, with_derivatives),
                                       body_of(function, symbols, with_derivatives, language, sharing));
    };
    write(function.name, false);
    if (!function.derivatives.empty()) write(function.name + "_with_derivatives", true);
  }
  return text + taylor_text(steppers, symbols, target) + language.epilogue();
}

const std::map<std::string, Target>& targets() {
  static const std::map<std::string, Target> all = [] {
    std::map<std::string, Target> found;
    for (const TargetLanguage& language : target_languages()) found[language.name] = language.target;
    return found;
  }();
  return all;
}

Emission chosen_from(Emission all, const std::vector<std::string>& names, Target target) {
  const std::set<std::string> named(names.begin(), names.end());
  const bool has_steppers = target == Target::cpp || target == Target::javascript;
  std::set<std::string> unknown = named;
  for (const EmittedFunction& function : all.functions) unknown.erase(function.name);
  for (const TaylorStepper& stepper : all.steppers)
    if (unknown.erase(stepper.name) != 0 && !has_steppers)
      throw BadInput("'" + stepper.name +
                     "' is a Taylor stepper: it can only be written in cpp and javascript");
  if (!unknown.empty())
    throw BadInput("there is no function '" + printable_line(*unknown.begin()) +
                   "'; emit --list shows all functions");
  const auto is_left_out = [&](const auto& f) { return !named.empty() && !named.contains(f.name); };
  std::erase_if(all.functions, is_left_out);
  std::erase_if(all.steppers, [&](const auto& f) { return !has_steppers || is_left_out(f); });
  return all;
}

}  // namespace rederive::emit
