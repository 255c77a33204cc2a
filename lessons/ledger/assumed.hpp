// The parts of make_context (prove_command.hpp): assumptions that are inequalities, and those that are
// equations.
#pragma once

#include <lessons/ledger/prove_command.hpp>
#include <lessons/ledger/reading.hpp>

namespace rederive {

/// A relation and the assumption that it is from.
struct Assumed {
  Relation relation;
  std::string text;
};

/// An assumption that has several solutions: one of these holds. What it says otherwise is for a user who has
/// too many of them.
struct SeveralSolutions : BadInput {
  SeveralSolutions(const std::string& what, std::vector<std::string> solutions, std::string of = "")
      : BadInput(what), each(std::move(solutions)), inequality(std::move(of)) {}
  std::vector<std::string> each;  ///< "x > 0" and "x < 0", or "x = pi/6" and "x = 5*pi/6"
  std::string inequality;         ///< the assumption, if it is one
};

/// An assumption that never holds with the others.
struct Contradiction : BadInput {
  using BadInput::BadInput;
};

/// A symbol alone.
inline bool is_name(const Tree& tree) { return tree->kind == Node::Kind::symbol && tree->text != "pi"; }

/// "a_p > alpha*g"
std::string in_words(const Assumed& link, const Symbols& symbols);

/// Narrows the range of a symbol by "x > 0", "2*x < 3" or "abs(x) < 1". False where the link is no bound of
/// one symbol, or one that a range cannot hold. Throws BadInput where no room is left.
bool narrow(const Assumed& link, Symbols& symbols);

/// Adds what stands for symbols after a link that compares them; nothing where it holds anyway. Throws
/// BadInput where it contradicts what is known, and where it can be solved for no symbol.
void compare_symbols(const Assumed& link, Context& context);

/// Adds what the equations say of symbols. Those that say what a symbol is come first; what the others leave
/// is solved, for no symbol that is small. Throws BadInput, SeveralSolutions and Contradiction among them.
void read_equations(const std::vector<Assumed>& equations, Context& context,
                    const std::vector<std::string>& small);

/// What an assumption divides by is not 0, though the computer algebra may have cancelled it.
void avoid_divisors(const Relation& relation, Symbols& symbols);

/// Refuses an assumption whose sides have values for x >= 0 and the like only, if none of what is kept of it
/// says so: sqrt(x)^2 = y is kept as y = x.
void keep_values(const std::string& text, const std::vector<Tree>& sides, const std::vector<GiNaC::ex>& kept,
                 const Context& context);

/// Whether it has a power such as x^n, of which conditions_of() says more than is needed: x > 0.
bool has_symbol_in_exponent(const Tree& tree, const Symbols& symbols);

/// Nothing in an assumption fails, but for what it divides by; else throws SeveralSolutions with what it
/// needs, to be assumed as well.
void needs_values(const Assumed& link, const Symbols& symbols, const std::vector<Comparison>& comparisons);
/// Throws BadInput: what can be assumed, and why not this.
[[noreturn]] void refuse(const std::string& text, const std::string& why = "");
/// Throws Contradiction.
[[noreturn]] void contradicts(const std::string& text);

}  // namespace rederive
