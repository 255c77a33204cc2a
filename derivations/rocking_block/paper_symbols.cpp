#include <derivations/rocking_block/paper_symbols.hpp>
#include <set>

namespace rederive {

namespace {

// Filled before main(), where GiNaC can make symbols but cannot evaluate yet: the ranges are read later.
std::vector<Symbol>& declarations() {
  static std::vector<Symbol> all;
  return all;
}

bool has_symbols(const Tree& tree) {
  return (tree->kind == Node::Kind::symbol && tree->text != "pi") ||
         std::ranges::any_of(tree->children, has_symbols);
}

/// A number as an end of a range that is not beyond `end`, an end of the range of another symbol: the end of
/// that one, or infinity.
std::string number_beyond(const Tree& end, bool is_upper, const Symbols& symbols) {
  const std::string infinity = is_upper ? "inf" : "-inf";
  if (end->kind != Node::Kind::symbol) return infinity;
  const Range other = read_range(symbols.find(end->text)->range);
  const std::string& number = is_upper ? other.upper : other.lower;
  return number.ends_with("inf") || has_symbols(parse(number, symbols)) ? infinity : number;
}

/// Makes numbers of the ends of a symbol's range, and conditions of those that are none.
void settle_range(const std::string& name, Symbols& symbols, std::vector<Relation>& conditions) {
  Range range = read_range(symbols.find(name)->range);
  for (const bool is_upper : {false, true}) {
    std::string& end = is_upper ? range.upper : range.lower;
    if (end == "inf" || end == "-inf") continue;
    const Tree tree = parse(end, symbols);
    if (!has_symbols(tree)) continue;
    const bool is_closed = is_upper ? range.upper_closed : range.lower_closed;
    const std::string sign = is_upper ? "<" : ">";
    conditions.push_back({{make_tree(Node::Kind::symbol, name), tree}, {is_closed ? sign + "=" : sign}});
    end = number_beyond(tree, is_upper, symbols);
  }
  symbols.narrow(name, in_brackets(range));
}

/// Refuses a second symbol that is written as another one is, or as another one is called.
void check_spelling(const Symbol& symbol, const Symbols& symbols) {
  for (const auto& [name, other] : symbols.table()) {
    if (name == symbol.name || (symbol.unicode != other.unicode && symbol.unicode != name)) continue;
    throw std::invalid_argument("the symbols " + name + " and " + symbol.name + " are both written '" +
                                symbol.unicode + "'; each needs a spelling of its own in Unicode");
  }
}

struct Declared {
  Symbols symbols;
  std::vector<Relation> conditions;
};

const Declared& declared_symbols() {
  static const Declared all = [] {
    Declared result;
    const auto about = [](const Symbol& symbol, const auto& check) {
      try {
        check();
      } catch (const std::exception& error) {
        throw std::invalid_argument("the symbol " + symbol.name + ": " + error.what());
      }
    };
    for (const Symbol& symbol : declarations()) about(symbol, [&] { result.symbols.declare(symbol); });
    for (const std::string& name : result.symbols.names()) {
      const Symbol symbol = *result.symbols.find(name);
      about(symbol, [&] { (void)parse_unit(symbol.unit); });
      about(symbol, [&] { settle_range(name, result.symbols, result.conditions); });
    }
    for (const std::string& name : result.symbols.names())
      check_spelling(*result.symbols.find(name), result.symbols);
    return result;
  }();
  return all;
}

}  // namespace

SymbolExpression paper::declared(const char* name, const char* latex, const char* unicode, const char* unit,
                                 const char* range, const char* meaning, const char* introduced) {
  const std::string_view ends = range;
  const bool is_positive = ends.size() > 1 && is_nonnegative_end(ends.substr(1, ends.find(',') - 1));
  const SymbolExpression symbol = is_positive ? SymbolExpression(GiNaC::possymbol(name, latex))
                                              : SymbolExpression(GiNaC::realsymbol(name, latex));
  declarations().push_back({name, latex, unicode, unit, range, meaning, introduced, symbol});
  return symbol;
}

std::size_t paper::number_of_declarations() { return declarations().size(); }

bool is_of_another_paper(std::string_view name) {
  return std::any_of(declarations().begin() + static_cast<std::ptrdiff_t>(paper::declarations_of_the_block),
                     declarations().end(), [&](const Symbol& symbol) { return symbol.name == name; });
}

const Symbols& paper_symbols() { return declared_symbols().symbols; }

const std::vector<Relation>& declared_conditions() { return declared_symbols().conditions; }

}  // namespace rederive
