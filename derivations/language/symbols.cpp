#include <algorithm>
#include <derivations/language/symbols.hpp>
#include <regex>
#include <stdexcept>

namespace rederive {

Range read_range(std::string_view text) {
  static const std::regex form(R"( *([(\[]) *([^,]*[^, ]) *, *([^,]*[^, ]) *([)\]]) *)");
  std::cmatch part;
  if (!std::regex_match(text.begin(), text.end(), part, form))
    throw std::invalid_argument("a range must be written (lower, upper), not '" + std::string(text) + "'");
  return {part[2], part[3], part[1] == "[", part[4] == "]"};
}

std::string in_brackets(const Range& range) {
  return (range.lower_closed ? "[" : "(") + range.lower + ", " + range.upper +
         (range.upper_closed ? "]" : ")");
}

bool is_nonnegative_end(std::string_view end) {
  static const std::regex form("([^-A-Za-z]|pi|sqrt|exp)*");
  return std::regex_match(end.begin(), end.end(), form);
}

const Symbol& Symbols::declare(Symbol symbol) {
  static const std::regex name_form("(?![Pp][Ii]$|inf$)[A-Za-z_][A-Za-z_0-9]*");
  if (!std::regex_match(symbol.name, name_form))
    throw std::invalid_argument("a name must be of letters, digits and '_', and not pi or inf, unlike '" +
                                symbol.name + "'");
  const Range ends = read_range(symbol.range);
  if (!GiNaC::is_a<GiNaC::symbol>(symbol.ginac)) {
    // GiNaC simplifies sqrt(x^2) to x if it knows that x is not negative.
    symbol.ginac = is_nonnegative_end(ends.lower)
                       ? SymbolExpression(GiNaC::possymbol(symbol.name, symbol.latex))
                       : SymbolExpression(GiNaC::realsymbol(symbol.name, symbol.latex));
  }
  if (!table_.contains(symbol.name)) order_.push_back(symbol.name);
  std::string name = symbol.name;
  return table_.insert_or_assign(std::move(name), std::move(symbol)).first->second;
}

void Symbols::narrow(std::string_view name, std::string range) {
  (void)(*this)[name];
  (void)read_range(range);
  table_.find(name)->second.range = std::move(range);
}

const Symbol* Symbols::find(std::string_view name) const {
  const auto found = table_.find(name);
  return found == table_.end() ? nullptr : &found->second;
}

const Symbol* Symbols::find(const GiNaC::ex& symbol) const {
  if (!GiNaC::is_a<GiNaC::symbol>(symbol)) return nullptr;
  const Symbol* found = find(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
  return found != nullptr && found->ginac.is_equal(symbol) ? found : nullptr;
}

const SymbolExpression& Symbols::operator[](std::string_view name) const {
  if (const Symbol* found = find(name)) return found->ginac;
  throw std::out_of_range("no symbol '" + std::string(name) + "' is declared");
}

std::size_t Symbols::rank(std::string_view name) const {
  return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), name) - order_.begin());
}

}  // namespace rederive
