#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

namespace {

// Filled before main(), where GiNaC can make symbols but cannot evaluate yet: the ranges are read later.
std::vector<Symbol>& declarations() {
  static std::vector<Symbol> all;
  return all;
}

}  // namespace

SymbolExpression paper::declared(const char* name, const char* latex, const char* unicode, const char* unit,
                                 const char* range, const char* meaning, const char* introduced) {
  const bool negative_too = std::string_view(range).substr(1).starts_with('-');
  const SymbolExpression symbol = negative_too ? SymbolExpression(GiNaC::realsymbol(name, latex))
                                               : SymbolExpression(GiNaC::possymbol(name, latex));
  declarations().push_back({name, latex, unicode, unit, range, meaning, introduced, symbol});
  return symbol;
}

const Symbols& paper_symbols() {
  static const Symbols symbols = [] {
    Symbols table;
    for (const Symbol& symbol : declarations()) table.declare(symbol);
    return table;
  }();
  return symbols;
}

}  // namespace rederive
