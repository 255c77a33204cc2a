#include <algorithm>
#include <derivations/algebra/dimension.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/symbols.hpp>
#include <sstream>
#include <stdexcept>

namespace rederive {

namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

[[noreturn]] void refuse(const std::string& what, const std::string& name) {
  throw std::invalid_argument("symbol '" + name + "': " + what);
}

bool is_name(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && letter(name[0]) && name != "pi" && name != "inf" &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
}

}  // namespace

Range read_range(std::string_view given) {
  const std::string text = trimmed(given);
  const auto comma = text.find(',');
  const bool framed = text.size() >= 5 && (text.front() == '(' || text.front() == '[') &&
                      (text.back() == ')' || text.back() == ']');
  if (!framed || comma == std::string::npos || text.find(',', comma + 1) != std::string::npos) {
    throw std::invalid_argument("a range is written (lower, upper), not '" + text + "'");
  }
  Range range{trimmed(text.substr(1, comma - 1)), trimmed(text.substr(comma + 1, text.size() - comma - 2)),
              text.front() == '[', text.back() == ']'};
  if (range.lower.empty() || range.upper.empty()) {
    throw std::invalid_argument("a range has two ends, unlike '" + text + "'");
  }
  return range;
}

const Symbol& Symbols::declare(std::string name, std::string latex, std::string unicode, std::string unit,
                               std::string range, std::string meaning, std::string introduced) {
  return declare({std::move(name), std::move(latex), std::move(unicode), std::move(unit), std::move(range),
                  std::move(meaning), std::move(introduced), SymbolExpression()});
}

const Symbol& Symbols::declare(Symbol symbol) {
  if (!is_name(symbol.name))
    refuse("a name is letters, digits and '_', and neither 'pi' nor 'inf'", symbol.name);
  Range ends;
  try {
    ends = read_range(symbol.range);
    (void)parse_unit(symbol.unit);
  } catch (const std::invalid_argument& error) {
    refuse(error.what(), symbol.name);
  }
  if (!GiNaC::is_a<GiNaC::symbol>(symbol.ginac)) {
    // GiNaC simplifies sqrt(x^2) to x where it knows that x is not negative.
    const bool positive = ends.lower != "-inf" && compare(parse_range(symbol.range).low.value, 0) >= 0;
    symbol.ginac = positive ? SymbolExpression(GiNaC::possymbol(symbol.name, symbol.latex))
                            : SymbolExpression(GiNaC::realsymbol(symbol.name, symbol.latex));
  }
  findings_.reset();
  if (!table_.contains(symbol.name)) order_.push_back(symbol.name);
  std::string name = symbol.name;
  return table_.insert_or_assign(std::move(name), std::move(symbol)).first->second;
}

Findings& Symbols::findings() const {
  constexpr std::size_t most = 200;
  thread_local std::map<std::string, std::shared_ptr<Findings>> all;
  if (findings_) return *findings_;
  std::ostringstream said;
  for (const auto& [name, symbol] : table_) said << name << symbol.range << ';';
  for (const auto& [symbol, words] : otherwise_) said << symbol << '=' << words << ';';
  for (const GiNaC::ex& e : never_zero_) said << e << ';';
  if (all.size() == most) all.clear();
  std::shared_ptr<Findings>& found = all[said.str()];
  if (!found) found = std::make_shared<Findings>();
  findings_ = found;
  return *findings_;
}

void Symbols::narrow(std::string_view name, std::string range) {
  const auto found = table_.find(name);
  if (found == table_.end()) throw std::out_of_range("no symbol '" + std::string(name) + "' is declared");
  (void)read_range(range);
  found->second.range = std::move(range);
  findings_.reset();
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

std::vector<std::string> Symbols::names() const { return order_; }

std::size_t Symbols::rank(std::string_view name) const {
  return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), name) - order_.begin());
}

}  // namespace rederive
