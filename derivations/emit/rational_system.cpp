#include <algorithm>
#include <derivations/emit/emit.hpp>
#include <derivations/emit/taylor.hpp>
#include <derivations/language/functions.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <map>
#include <stdexcept>

namespace rederive::emit {
using namespace language;
using namespace mechanics;

namespace {

using GiNaC::ex;

/// A function whose derivative is sign times another function of the same argument.
struct Member {
  std::string name, derivative;
  int sign;
};

/// Returns the functions to which the derivatives of a function lead, in the order of the table; none if one
/// of these derivatives is not plus or minus a function of the same argument.
std::vector<Member> family_of(const std::string& function) {
  Symbols symbols;
  symbols.declare({"u", "u", "u", "1", all_numbers, "", ""});
  std::vector<Member> family;
  std::string name = function;
  while (std::ranges::find(family, name, &Member::name) == family.end()) {
    Tree derivative = parse(function_named(name).derivative, symbols);
    const bool is_negative = derivative->kind == Node::Kind::negative;
    if (is_negative) derivative = derivative->children[0];
    if (derivative->kind != Node::Kind::call || derivative->children[0]->text != "u") return {};
    family.push_back({name, derivative->text, is_negative ? -1 : 1});
    name = derivative->text;
  }
  std::ranges::sort(family, {}, [](const Member& member) { return find_function(member.name); });
  return family;
}

class Extension {
 public:
  Extension(const TaylorStepper& stepper, const Symbols& symbols) : stepper_(stepper), symbols_(symbols) {
    for (const SymbolExpression& parameter : stepper.parameters) declare(parameter);
    for (const auto& [state, rate] : stepper.rates) declare(state), system_.rates.emplace_back(state, 0);
    const bool timed = std::any_of(stepper.rates.begin(), stepper.rates.end(),
                                   [&](const auto& entry) { return entry.second.has(stepper.time); });
    if (timed) declare(stepper.time), system_.rates.emplace_back(stepper.time, 1);
  }

  RationalSystem result() {
    std::vector<Tree> trees;
    for (const auto& [state, rate] : stepper_.rates) {
      check(state, rate);
      trees.push_back(without_functions(to_tree(rate, symbols_)));
    }
    for (std::size_t i = 0; i < trees.size(); ++i) system_.rates[i].second = lowered(trees[i]);
    for (const RationalSystem::Function& f : system_.functions) {
      const ex inner = time_derivative(lowered(f.argument), system_.rates);
      system_.rates.emplace_back(system_.symbols[f.name], f.sign * system_.symbols[f.derivative] * inner);
    }
    return std::move(system_);
  }

 private:
  void declare(const SymbolExpression& symbol) {
    arguments_.push_back(symbol);
    system_.symbols.declare(*symbols_.find(symbol));
  }

  ex lowered(const Tree& tree) const { return lower(tree, system_.symbols); }

  void check(const SymbolExpression& state, const ex& rate) const {
    if (rate.is_zero()) return;
    std::vector<SymbolExpression> arguments = arguments_;
    arguments.push_back(stepper_.time);
    const std::string name = stepper_.name + ": the rate of " + name_of(state);
    const std::string unit =
        provenance({name, arguments, rate * stepper_.time / state, {}, "", ""}, symbols_).unit;
    if (unit != "1")
      throw std::invalid_argument(
          name + ", multiplied by the time and divided by the state, must be a pure number, but it is in " +
          unit);
  }

  bool moves(const Node& node) const {
    if (node.kind == Node::Kind::symbol)
      return std::any_of(system_.rates.begin(), system_.rates.end(),
                         [&](const auto& entry) { return name_of(entry.first) == node.text; }) ||
             std::any_of(system_.functions.begin(), system_.functions.end(),
                         [&](const auto& f) { return f.name == node.text; });
    return std::any_of(node.children.begin(), node.children.end(),
                       [&](const Tree& child) { return moves(*child); });
  }

  /// Returns the tree with components of the state in place of functions, inner functions first, so that the
  /// argument of each is rational in the components before it.
  Tree without_functions(const Tree& tree) {
    if (tree->children.empty()) return tree;
    std::vector<Tree> children;
    for (const Tree& child : tree->children) children.push_back(without_functions(child));
    const Tree rebuilt = make_tree(tree->kind, tree->text, children, tree->inverse);
    return tree->kind == Node::Kind::call && moves(*rebuilt) ? state_for(tree->text, children[0]) : rebuilt;
  }

  /// Returns the component of the state for a function of an argument; it adds the whole family of the
  /// function.
  Tree state_for(const std::string& function, const Tree& argument) {
    for (const RationalSystem::Function& known : system_.functions)
      if (known.function == function && is_same(known.argument, argument)) return leaf(known.name);
    if (const std::vector<Member> family = family_of(function); !family.empty()) {
      const std::string number = "_" + std::to_string(++count_[family[0].name]);
      for (const auto& [name, derivative, sign] : family) {
        system_.symbols.declare({name + number, name, name, "1", all_numbers, name, "emit"});
        system_.functions.push_back({name + number, name, argument, derivative + number, sign});
      }
      return leaf(function + number);
    }
    throw std::invalid_argument(stepper_.name + ": " + function + "(" +
                                print(argument, Notation::plain, system_.symbols) +
                                ") has no recurrence; only sin, cos, sinh, cosh and exp have one");
  }

  const TaylorStepper& stepper_;
  const Symbols& symbols_;
  RationalSystem system_;
  std::vector<SymbolExpression> arguments_;
  std::map<std::string, int> count_;
};

}  // namespace

RationalSystem rational_system(const TaylorStepper& stepper, const Symbols& symbols) {
  return Extension(stepper, symbols).result();
}

}  // namespace rederive::emit
