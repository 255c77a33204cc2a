#include <algorithm>
#include <derivations/algebra/completion.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// What the symbols are: exactly, but for the one of which bounds are known.
GiNaC::exmap exact_values(const Witness& witness, const Symbols& symbols) {
  GiNaC::exmap values;
  for (const auto& [name, text] : witness.at)
    if (!witness.between.contains(name))
      values[symbols[name]] = witness.exactly.contains(name)
                                  ? lower(parse(witness.exactly.at(name), symbols), symbols)
                                  : ex(GiNaC::numeric(text.c_str()));
  return values;
}

Point digits(const Witness& witness) {
  Point point;
  for (const auto& [name, text] : witness.at) point[name] = cln::cl_RA(text.c_str());
  return point;
}

/// To 45 decimal places.
std::optional<cln::cl_RA> digits_of(const ex& value, const Witness& witness, const Symbols& symbols) {
  const auto number = evaluate(to_tree(value, symbols), digits(witness), 60);
  if (!number) return std::nullopt;
  return cln::round1(*number * power_of_ten(45)) / cln::cl_RA(power_of_ten(45));
}

}  // namespace

void put(Witness& witness, const std::string& name, const ex& value, const Symbols& symbols) {
  try {
    ex exactly = value;  // what stands for a symbol may mention the one of which bounds are known
    for (int round = 0; round < 2; ++round)
      exactly = exactly.subs(exact_values(witness, symbols), GiNaC::subs_options::no_pattern);
    if (exactly.info(GiNaC::info_flags::rational)) {
      witness.at[name] = rational_text(cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(exactly).to_cl_N()));
      return;
    }
    const auto digits = digits_of(exactly, witness, symbols);
    if (!digits) return;
    witness.exactly[name] = print(exactly, Notation::plain, symbols);
    witness.at[name] = rational_text(*digits);
  } catch (const std::exception&) {  // a pole, or what our syntax cannot write
  }
}

namespace {

/// Any values for the names that are missing; such that the trees have values, if they are easily found.
void fill(Witness& witness, const std::set<std::string>& names, const std::vector<Tree>& trees,
          const Symbols& symbols) {
  const Points points(names, symbols);
  Point chosen;
  for (int k = 0; k < 8; ++k) {
    Point point = digits(witness);
    for (const auto& [name, value] : points.at(k)) point.try_emplace(name, value);
    if (k == 0) chosen = point;
    if (!std::all_of(trees.begin(), trees.end(), [&](const Tree& t) { return value_of(t, point); })) continue;
    chosen = point;
    break;
  }
  for (const std::string& name : names) witness.at.try_emplace(name, rational_text(chosen.at(name)));
}

void put_given(Witness& witness, const Given& g, const std::vector<Given>& given, const Symbols& symbols) {
  const Symbol* symbol = symbols.find(g.name);
  if (symbol == nullptr || witness.at.contains(symbol->name)) return;
  const ex value = put_in(g.value, given);
  const Tree tree = to_tree(value, symbols);
  std::set<std::string> names;
  collect_names(tree, names);
  fill(witness, names, {tree}, symbols);
  put(witness, symbol->name, value, symbols);
}

}  // namespace

void complete(Witness& witness, const std::vector<Tree>& sides, const std::vector<Given>& given,
              const Symbols& symbols) {
  for (const Given& g : given) put_given(witness, g, given, symbols);
  std::set<std::string> names;
  for (const Tree& side : sides) collect_names(side, names);
  std::erase_if(names, [&](const std::string& name) { return witness.at.contains(name); });
  fill(witness, names, sides, symbols);
}

std::vector<std::string> in_words(const Witness& witness) {
  std::vector<std::string> words;
  for (const auto& [name, number] : witness.at) {
    const auto exactly = witness.exactly.find(name);
    const auto bounds = witness.between.find(name);
    words.push_back(bounds != witness.between.end()
                        ? name + " between " + decimal_text(bounds->second.low) + " and " +
                              decimal_text(bounds->second.high) + " where " + witness.solves
                        : name + " = " + (exactly != witness.exactly.end() ? exactly->second : number));
  }
  return words;
}

}  // namespace rederive
