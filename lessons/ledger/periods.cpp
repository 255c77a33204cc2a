#include <algorithm>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/periods.hpp>
#include <regex>

namespace rederive {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr int longest = 4;
const std::set<std::string> circular{"sin", "cos", "tan", "cot", "sec", "csc"};

/// The number of turns after which a text is the same again: a common one of what it was, and of this text.
/// Nothing where there is none.
std::optional<numeric> period(const Tree& tree, const std::string& name, const numeric& before,
                              const Symbols& symbols) {
  if (tree->kind == Node::Kind::symbol) return tree->text == name ? std::nullopt : std::optional(before);
  if (tree->kind == Node::Kind::call && circular.contains(tree->text)) {
    const ex slope =
        lower(tree->children[0], symbols).expand().diff(GiNaC::ex_to<GiNaC::symbol>(symbols[name]));
    if (!slope.info(GiNaC::info_flags::rational)) return std::nullopt;
    return GiNaC::lcm(before, GiNaC::ex_to<numeric>(slope).denom());
  }
  std::optional<numeric> result = before;
  for (const Tree& child : tree->children)
    if (result) result = period(child, name, *result, symbols);
  return result;
}

bool is_mentioned(const std::string& name, const std::vector<std::string>& texts) {
  const std::regex word("(^|[^A-Za-z0-9_])" + name + "($|[^A-Za-z0-9_])");
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return std::regex_search(text, word); });
}

}  // namespace

void keep_to_one_period(const ProveRequest& request, Context& context) {
  Symbols& symbols = context.symbols;
  std::set<std::string> names;
  for (const Tree& side : context.assumed) collect_names(side, names);
  std::erase_if(names, [&](const std::string& name) {
    const Symbol* symbol = symbols.find(name);
    return symbol == nullptr || symbol->range != all_numbers || is_mentioned(name, request.small);
  });
  if (names.empty()) return;
  std::vector<Tree> trees = context.assumed;
  for (const std::string& text : {request.left, request.right})
    for (const Tree& side : read(text, symbols).sides) trees.push_back(side);
  std::vector<std::string> differences;
  for (const std::string& text : request.assumptions)
    if (text.find("!=") != std::string::npos) differences.push_back(text);
  for (const std::string& name : names) {
    std::optional<numeric> turns = 1;
    for (const Tree& tree : trees)
      if (turns) turns = period(tree, name, *turns, symbols);
    if (!turns || *turns > longest || is_mentioned(name, differences)) continue;
    const std::string end = *turns == 1 ? "pi" : std::to_string(turns->to_int()) + "*pi";
    const Symbol old = *symbols.find(name);
    symbols.declare(name, old.latex, old.unicode, old.unit, "(-" + end + ", " + end + "]", old.meaning,
                    old.introduced);
    if (*turns == 1) context.periodic.insert(name);
  }
}

std::vector<std::string> same_turns(const Sides& sides, const Context& context) {
  const Symbols& symbols = context.symbols;
  for (const auto& [a, b] : {std::pair{sides.left, sides.right}, {sides.right, sides.left}}) {
    const std::string function = name_of(a);
    const bool is_known = function == "sin" || function == "cos" || function == "tan";
    if (!is_known || function != name_of(b) || !GiNaC::is_a<GiNaC::symbol>(a.op(0))) continue;
    const ex x = a.op(0), y = b.op(0);
    const std::string name = symbols.find(x)->name;
    if (y.has(x) || !context.periodic.contains(name)) continue;
    const ex other = function == "sin" ? GiNaC::Pi - y : function == "cos" ? -y : GiNaC::Pi + y;
    return {name + " = " + print(y, Notation::plain, symbols),
            name + " = " + print(other.expand(), Notation::plain, symbols)};
  }
  return {};
}

}  // namespace rederive
