// The functions of the language, the ledger and the kernel for the built-in paper, so that tests about it
// read well.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/mutate.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <emitted/rocking_block_symbols.hpp>
#include <nlohmann/json.hpp>

namespace rederive::test {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace emit;
using namespace paper;
using namespace kernel;

inline const Symbols& paper_symbols() { return rocking_block::paper().symbols; }
inline Tree parse(std::string_view text) { return language::parse(text, paper_symbols()); }
inline Relation parse_relation(std::string_view text) {
  return language::parse_relation(text, paper_symbols());
}
inline Relation parse_statement(std::string_view text) {
  return language::parse_statement(text, paper_symbols());
}
inline GiNaC::ex lower(const Tree& tree) { return language::lower(tree, paper_symbols()); }
inline Tree to_tree(const GiNaC::ex& expression) { return language::to_tree(expression, paper_symbols()); }
inline std::string print(const GiNaC::ex& expression, Notation notation = Notation::plain) {
  return language::print(expression, notation, paper_symbols());
}
inline std::string print(const Tree& tree, Notation notation) {
  return language::print(tree, notation, paper_symbols());
}
inline std::string print(const Relation& relation, Notation notation) {
  return language::print(relation, notation, paper_symbols());
}
inline DimensionReport dimension(const Tree& tree) { return mechanics::dimension(tree, paper_symbols()); }
inline DimensionReport dimension(const Relation& relation) {
  return mechanics::dimension(relation, paper_symbols());
}

inline std::filesystem::path equations_file() { return paper::equations_file(rocking_block::paper()); }
inline Symbols symbols_in(const std::string& domain) {
  return paper::symbols_in(rocking_block::paper(), domain);
}
inline Entry judge(const Row& row) { return paper::judge(rocking_block::paper(), row); }
inline Derivation derivation_of(const std::string& id) {
  return paper::derivation_of(rocking_block::paper(), id).value();
}
inline std::optional<Derivation> checked_derivation(const std::string& id) {
  return paper::checked_derivation(rocking_block::paper(), {}, id);
}
inline Relation derived_relation(const Derivation& derivation) {
  return paper::derived_relation(derivation, paper_symbols());
}
inline std::vector<Mutant> mutants(const Relation& printed) {
  return paper::mutants(printed, rocking_block::paper());
}
inline Mutation mutate(const Row& row, unsigned seed, int most = 24) {
  return paper::mutate(rocking_block::paper(), row, seed, most);
}
inline Symbols declared_symbols(const ProveRequest& request) {
  return paper::declared_symbols(rocking_block::paper(), request);
}
inline Problem problem_of(const ProveRequest& request) {
  return paper::problem_of(rocking_block::paper(), request);
}
inline Proof decide(const ProveRequest& request) { return paper::decide(rocking_block::paper(), request); }
inline nlohmann::ordered_json decide_bounded(const ProveRequest& request,
                                             const std::function<bool()>& stop = {}) {
  return paper::decide_bounded(rocking_block::paper(), request, stop);
}
inline Provenance provenance(const EmittedFunction& function) {
  return emit::provenance(function, rocking_block::emission_symbols());
}
inline RationalSystem rational_system(const TaylorStepper& stepper) {
  return emit::rational_system(stepper, rocking_block::emission_symbols());
}
inline std::string emit(const std::vector<EmittedFunction>& functions, Target target, bool sharing = true,
                        const std::vector<TaylorStepper>& steppers = {}) {
  return emit::emit({rocking_block::emission_symbols(), functions, steppers}, target, sharing);
}
inline std::optional<Lemma> lemma_of(const Entry& entry) {
  return kernel::lemma_of(rocking_block::paper(), entry);
}
/// The theorems of Coq about the paper.
inline const Theorems& theorems() {
  static const Theorems all = theorems_of(rocking_block::paper());
  return all;
}
inline std::string theorem_file(const std::string& file) {
  return kernel::theorem_file(rocking_block::paper(), file);
}
inline void write_scripts(const std::filesystem::path& folder, const std::vector<Lemma>& lemmas,
                          const std::map<std::string, std::string>& more = {}) {
  kernel::write_scripts(rocking_block::paper(), folder, lemmas, more);
}

}  // namespace rederive::test
