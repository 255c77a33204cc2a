// The table of symbols: how each is written, its unit, its range and its meaning.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::language {

/// A GiNaC symbol whose copies keep what GiNaC knows about it (real, positive). Copying a GiNaC::symbol would
/// turn a possymbol into a nameless complex symbol; here that does not compile.
class SymbolExpression : public GiNaC::ex {
 public:
  SymbolExpression() = default;
  explicit SymbolExpression(const GiNaC::symbol& symbol) : GiNaC::ex(symbol) {}
  operator const GiNaC::symbol&() const { return GiNaC::ex_to<GiNaC::symbol>(*this); }  // for ex::diff
  operator GiNaC::symbol() const = delete;
};

/// A symbol with a given value: J_o = 4/3*m*R^2. The value is substituted before anything is decided.
struct Given {
  GiNaC::ex name;
  GiNaC::ex value;
};

/// The range of a symbol that may be any real number.
inline constexpr const char* all_numbers = "(-inf, inf)";

/// A symbol with what is declared about it; in a derivation it is an expression. A range is an open interval
/// in our syntax: "(0, inf)", "(0, pi/2)", "(-inf, inf)"; a closed end is written with a bracket: "(0, 1]".
struct Symbol : SymbolExpression {
  /// Makes a GiNaC symbol: a possymbol where the lower end of the range is seen not to be negative.
  Symbol(std::string name, std::string latex, std::string unicode, std::string unit, std::string range,
         std::string meaning, std::string introduced);
  std::string name;        ///< ASCII, as typed: "theta", "omega_p", "u_gddot"
  std::string latex;       ///< "\\ddot u_g"
  std::string unicode;     ///< "ü_g"
  std::string unit;        ///< SI base units: "kg*m^2/s^2"; "1" for angles and ratios
  std::string range;       ///< see above
  std::string meaning;     ///< one line
  std::string introduced;  ///< where the paper introduces it: "Fig. 1", "(21)"
};

/// The ends of a range, each an expression in our syntax, "inf" or "-inf".
struct Range {
  std::string lower, upper;
  bool lower_closed = false, upper_closed = false;
};
/// Returns the range of a text such as "(0, pi/2]". Throws std::invalid_argument for other texts.
Range read_range(std::string_view text);

/// A set of declared symbols. Copies share the GiNaC symbols, except those that are declared again.
class Symbols {
 public:
  /// Declares a symbol, or declares it anew (a user's assumption replaces the range).
  /// Throws std::invalid_argument if the name or the range cannot be read.
  const Symbol& declare(Symbol symbol);
  /// Replaces the range; the GiNaC symbol stays the same. Throws std::out_of_range for an unknown name.
  void narrow(std::string_view name, const Range& range);
  const Symbol* find(std::string_view name) const;    ///< nullptr if it is not declared
  const Symbol* find(const GiNaC::ex& symbol) const;  ///< by its GiNaC symbol
  /// Returns the GiNaC symbol of a name. Throws std::out_of_range, with the name, if it is not declared.
  const SymbolExpression& operator[](std::string_view name) const;
  const std::vector<std::string>& names() const { return order_; }  ///< in the order of declaration
  const std::map<std::string, Symbol, std::less<>>& table() const { return *table_; }  ///< by name
  std::size_t rank(std::string_view name) const;  ///< place in the printing order: π, then as declared

 private:
  std::vector<std::string> order_;
  using Table = std::map<std::string, Symbol, std::less<>>;
  Table& own_table() {  // for a change: copies of this set keep the table as it was
    if (table_.use_count() > 1) table_ = std::make_shared<Table>(*table_);
    return *table_;
  }
  std::shared_ptr<Table> table_ = std::make_shared<Table>();
};

}  // namespace rederive::language
