// The functions that formulas may use. Whatever reads, writes or reasons about them takes it from these rows.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace rederive::language {

/// A function f of one argument u, and what is known about it. A text that is empty says that there is none.
struct Function {
  enum class Kind { circular, exponential, inverse, other };
  enum class Parity { none, odd, even };
  /// The ends of the interval on which f has values, except at its poles.
  struct Domain {
    double least = -HUGE_VAL, most = HUGE_VAL;
    bool is_open = false;  ///< whether these ends are outside

    /// Returns whether x is certainly outside; `sign_beyond(end)` is the sign of x - end, or nothing.
    template <class SignBeyond>
    bool excludes(const SignBeyond& sign_beyond) const {
      const auto lies_beyond = [&](double end, int side) {
        const std::optional<int> sign = std::isinf(end) ? std::nullopt : sign_beyond(static_cast<long>(end));
        return sign && (*sign == side || (*sign == 0 && is_open));
      };
      return lies_beyond(least, -1) || lies_beyond(most, 1);
    }
  };
  std::string_view name;              ///< in our syntax, in C, C++ and Python, and in GiNaC (but abs)
  GiNaC::ex (*of)(const GiNaC::ex&);  ///< returns f(u); throws GiNaC's error at a pole
  std::string_view latex = {};        ///< the command
  std::string_view latex_frame = {};  ///< what LaTeX writes instead of a command, with # for the argument
  std::string_view unicode = {};      ///< if it is not the name
  std::string_view aliases = {};      ///< its names elsewhere, in lower case: "arctan atan2"
  std::string_view javascript = {};   ///< in Math, if it is not the name
  std::string_view coq = {};          ///< in the library or in the prelude, if it is not the name
  bool has_coq = true;                ///< whether either has it
  Kind kind = Kind::other;  ///< exponential: made of e^u; inverse: of these and of circular functions
  Parity parity = Parity::none;
  Domain domain = {};
  /// The domain as conditions on u: relations, and expressions that must not be 0.
  std::array<std::string_view, 2> needs = {};
  std::string_view simpler = {};     ///< f(u) in the functions with which identities are decided
  std::string_view reciprocal = {};  ///< the function 1/f, if f is defined by that
  std::string_view derivative = {};  ///< in u
  std::string_view piece = {};       ///< where f is monotone, if that is not the whole domain
  std::string_view values = {};      ///< f at the ends of the piece, in this order: its range
  std::string_view inverse = {};     ///< of a circular f on its piece, or of f where that is the whole domain
  int half_turn = 0;                 ///< f(u + pi)/f(u) of a circular f, else 0
};

/// Returns all functions, in the order in which messages suggest them.
std::span<const Function> functions();
/// Returns the function of this name, or nullptr; "abs" is "fabs". It does not know pow, which is a^b.
const Function* find_function(std::string_view name);
/// Returns the function of this name. Throws std::out_of_range if there is none.
const Function& function_named(std::string_view name);
/// Returns whether this is the name of a function, or pow.
bool is_function(std::string_view name);

}  // namespace rederive::language
