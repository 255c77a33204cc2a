// Functions as source text: what is common to all targets.
#include <algorithm>
#include <derivations/emit/emit.hpp>
#include <derivations/emit/operations.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

using Kind = Operation::Kind;

/// Writes operations as infix expressions, with parentheses where precedence needs them.
class Infix {
 public:
  Infix(const Operations& operations, const Dialect& dialect, bool sharing)
      : all_(operations.all()), dialect_(dialect), names_(all_.size()) {
    const std::vector<std::size_t> uses = operations.uses();
    for (std::size_t i = 0; sharing && i < all_.size(); ++i) {
      if (uses[i] < 2 || all_[i].constant || all_[i].is_leaf()) continue;
      std::string expression = text(i, 0);
      names_[i] = "common_" + std::to_string(shared_.size() + 1);
      shared_.emplace_back(names_[i], std::move(expression));
    }
  }

  const std::vector<std::pair<std::string, std::string>>& shared() const { return shared_; }
  std::string text(std::size_t index) const { return text(index, 0); }

 private:
  /// `place`: 0 anywhere, 1 after a minus, 2 left of * and /, 3 right of them or after a unary minus.
  std::string text(std::size_t index, int place) const {
    if (!names_[index].empty()) return names_[index];
    const Operation& operation = all_[index];
    const auto operand = [&](std::size_t i, int at) { return text(operation.operands[i], at); };
    const auto framed = [&](const std::string& inside, bool frame) {
      return frame ? "(" + inside + ")" : inside;
    };
    switch (operation.kind) {
      case Kind::number:
        return dialect_.number(operation.text);
      case Kind::symbol:
        return operation.text == "pi" ? dialect_.pi() : operation.text;
      case Kind::add:
        return framed(operand(0, 0) + " + " + operand(1, 1), place > 0);
      case Kind::subtract:
        return framed(operand(0, 0) + " - " + operand(1, 1), place > 0);
      case Kind::multiply:
        return framed(operand(0, 2) + " * " + operand(1, 3), place > 2);
      case Kind::divide:
        return framed(operand(0, 2) + " / " + operand(1, 3), place > 2);
      case Kind::negate:
        return framed("-" + operand(0, 2), place > 0);
      case Kind::call:
        break;
    }
    std::string arguments = operand(0, 0);
    for (std::size_t i = 1; i < operation.operands.size(); ++i) arguments += ", " + operand(i, 0);
    return dialect_.call(operation.text, arguments);
  }

  const std::vector<Operation>& all_;
  const Dialect& dialect_;
  std::vector<std::string> names_;
  std::vector<std::pair<std::string, std::string>> shared_;
};

std::vector<Tree> trees_of(const EmittedFunction& function, bool with_derivatives) {
  std::vector<Tree> trees = {to_tree(function.value, emission_symbols())};
  for (const SymbolExpression& symbol : function.derivatives) {
    if (with_derivatives) trees.push_back(to_tree(function.value.diff(symbol), emission_symbols()));
  }
  return trees;
}

std::vector<std::string> argument_names(const EmittedFunction& function) {
  std::vector<std::string> names;
  for (const SymbolExpression& argument : function.arguments) {
    names.push_back(GiNaC::ex_to<GiNaC::symbol>(argument).get_name());
  }
  return names;
}

Body body_of(const EmittedFunction& function, bool with_derivatives, const Dialect& dialect, bool sharing) {
  const Operations operations(trees_of(function, with_derivatives));
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
    const auto& symbol = GiNaC::ex_to<GiNaC::symbol>(function.derivatives[i - 1]);
    body.results.emplace_back("d_" + symbol.get_name(), infix.text(results[i]));
  }
  return body;
}

/// Every symbol in the value is an argument.
void check_arguments(const EmittedFunction& function) {
  for (auto part = function.value.preorder_begin(); part != function.value.preorder_end(); ++part) {
    if (!GiNaC::is_a<GiNaC::symbol>(*part)) continue;
    const bool given =
        std::any_of(function.arguments.begin(), function.arguments.end(),
                    [&](const SymbolExpression& argument) { return argument.is_equal(*part); });
    if (!given) {
      throw std::invalid_argument(function.name + " depends on " +
                                  print(*part, Notation::plain, emission_symbols()) +
                                  ", which is no argument of it");
    }
  }
}

std::string plain_unit(const Dimension& dimension) {
  std::string above, below;
  const char* units[] = {"kg", "m", "s"};
  for (std::size_t i = 0; i < dimension.size(); ++i) {
    const GiNaC::numeric power = GiNaC::abs(dimension[i]);
    if (power.is_zero()) continue;
    std::string& side = dimension[i].is_negative() ? below : above;
    std::string factor = units[i];
    if (power != 1) factor += "^" + print(GiNaC::ex(power));
    side += (side.empty() ? "" : dimension[i].is_negative() ? "/" : "*") + factor;
  }
  return (above.empty() ? "1" : above) + (below.empty() ? "" : "/" + below);
}

std::string fnv_1a(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  static constexpr const char* digits = "0123456789abcdef";
  std::string result;
  for (int shift = 60; shift >= 0; shift -= 4) result += digits[hash >> shift & 15];
  return result;
}

std::vector<std::string> documentation(const EmittedFunction& function, bool with_derivatives) {
  const Provenance facts = provenance(function);
  const Operations operations(trees_of(function, with_derivatives));
  std::vector<std::string> lines = {function.brief + (with_derivatives ? ", with derivatives" : "") + "."};
  for (const std::string& name : argument_names(function)) {
    const Symbol& symbol = *emission_symbols().find(name);
    lines.push_back("  " + name + ": " + symbol.meaning + "; " + symbol.unit + ", " + symbol.range);
  }
  lines.push_back("  returns: " + facts.unit);
  lines.push_back("Equation (" + function.equation + "); " + std::to_string(operations.count_unshared()) +
                  " operations, " + std::to_string(operations.count()) +
                  " with shared subexpressions; hash " + facts.hash + ".");
  return lines;
}

const std::vector<std::string>& header() {
  static const std::vector<std::string> lines = {
      "Written by emit from the derivations: not to be edited.",
      "Units are SI; with p = 1 and g = 1 all is dimensionless, and t is p*t."};
  return lines;
}

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += (c == '_' || c == '^' ? "\\" : "") + std::string(1, c);
  return result;
}

std::string latex(const std::vector<EmittedFunction>& functions) {
  std::string text =
      "% " + header()[0] + "\n\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n";
  for (const EmittedFunction& function : functions) {
    text += "\n\\paragraph{" + latex_escaped(function.name) + ", equation (" + function.equation + ")} ";
    text += "% hash " + provenance(function).hash + "\n\\[\n  ";
    text += print(function.value, Notation::latex, emission_symbols()) + "\n\\]\n";
  }
  return text + "\n\\end{document}\n";
}

}  // namespace

Provenance provenance(const EmittedFunction& function) {
  check_arguments(function);
  const Tree tree = to_tree(function.value, emission_symbols());
  const DimensionReport report = dimension(tree, emission_symbols());
  if (!report.consistent) throw std::invalid_argument(function.name + ": " + report.explanation);
  const Operations operations(trees_of(function, true));
  return {plain_unit(report.dimension.value_or(Dimension{0, 0, 0})), operations.count_unshared(),
          operations.count(),
          fnv_1a(function.equation + "\n" + print(tree, Notation::plain, emission_symbols()))};
}

std::string emit(const std::vector<EmittedFunction>& functions, Target target, bool sharing) {
  for (const EmittedFunction& function : functions) provenance(function);  // refuses what is unsound
  if (target == Target::latex) return latex(functions);
  const Dialect& language = dialect(target);
  std::string text = language.comment(header()) + language.prologue();
  for (const EmittedFunction& function : functions) {
    const std::vector<std::string> arguments = argument_names(function);
    text += "\n" + language.function(function.name, arguments, documentation(function, false),
                                     body_of(function, false, language, sharing));
    if (function.derivatives.empty()) continue;
    text +=
        "\n" + language.function(function.name + "_with_derivatives", arguments,
                                 documentation(function, true), body_of(function, true, language, sharing));
  }
  return text + language.epilogue();
}

}  // namespace rederive
