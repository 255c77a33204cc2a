#include <algorithm>
#include <derivations/language/symbols.hpp>
#include <regex>
#include <stdexcept>

namespace rederive::language {

Range read_range(std::string_view text) {
  static const std::regex form(R"( *([(\[]) *([^,]*[^, ]) *, *([^,]*[^, ]) *([)\]]) *)");
  std::cmatch part;
  if (!std::regex_match(text.begin(), text.end(), part, form))
    throw std::invalid_argument("a range must be written (lower, upper), not '" + std::string(text) + "'");
  return {part[2], part[3], part[1] == "[", part[4] == "]"};
}

Symbol::Symbol(std::string its_name, std::string its_latex, std::string its_unicode, std::string its_unit,
               std::string its_range, std::string its_meaning, std::string its_introduced)
    : name(std::move(its_name)),
      latex(std::move(its_latex)),
      unicode(std::move(its_unicode)),
      unit(std::move(its_unit)),
      range(std::move(its_range)),
      meaning(std::move(its_meaning)),
      introduced(std::move(its_introduced)) {
  static const std::regex positive(R"(.([^-A-Za-z,]|pi|sqrt|exp)*,.*)");  // nothing is subtracted
  // GiNaC simplifies sqrt(x^2) to x where it knows that x is not negative.
  SymbolExpression::operator=(std::regex_match(range, positive)
                                  ? SymbolExpression(GiNaC::possymbol(name, latex))
                                  : SymbolExpression(GiNaC::realsymbol(name, latex)));
}

const Symbol& Symbols::declare(Symbol symbol) {
  static const std::regex name_form("(?![Pp][Ii]$|inf$)[A-Za-z_][A-Za-z_0-9]*");
  if (!std::regex_match(symbol.name, name_form))
    throw std::invalid_argument("a name must be of letters, digits and '_', and not pi or inf, unlike '" +
                                symbol.name + "'");
  (void)read_range(symbol.range);
  if (!table_->contains(symbol.name)) order_.push_back(symbol.name);
  return own_table().insert_or_assign(std::string(symbol.name), std::move(symbol)).first->second;
}

void Symbols::narrow(std::string_view name, const Range& range) {
  (void)(*this)[name];
  own_table().find(name)->second.range =
      (range.lower_closed ? "[" : "(") + range.lower + ", " + range.upper + (range.upper_closed ? "]" : ")");
}

const Symbol* Symbols::find(std::string_view name) const {
  const auto found = table_->find(name);
  return found == table_->end() ? nullptr : &found->second;
}

const Symbol* Symbols::find(const GiNaC::ex& symbol) const {
  if (!GiNaC::is_a<GiNaC::symbol>(symbol)) return nullptr;
  const Symbol* found = find(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
  return found != nullptr && found->is_equal(symbol) ? found : nullptr;
}

const SymbolExpression& Symbols::operator[](std::string_view name) const {
  if (const Symbol* found = find(name)) return *found;
  throw std::out_of_range("no symbol '" + std::string(name) + "' is declared");
}

std::size_t Symbols::rank(std::string_view name) const {
  if (name == "pi") return 0;
  return 1 + static_cast<std::size_t>(std::find(order_.begin(), order_.end(), name) - order_.begin());
}

}  // namespace rederive::language
