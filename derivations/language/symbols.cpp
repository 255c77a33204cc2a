#include <algorithm>
#include <cctype>
#include <derivations/language/symbols.hpp>
#include <derivations/language/unit.hpp>
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

/// Letters, digits and '_'; no look-alike of pi, which is the constant.
bool is_name(const std::string& name) {
  const bool is_pi = name.size() == 2 && std::tolower(name[0]) == 'p' && std::tolower(name[1]) == 'i';
  const auto is_in_names = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '_'); };
  return !name.empty() && !is_pi && name != "inf" && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::all_of(name.begin(), name.end(), is_in_names);
}

/// Whether the end of a range is not negative, as its form shows: nothing is subtracted, and what functions
/// there are have no negative values.
bool is_plainly_nonnegative(std::string end) {
  for (const std::string_view harmless : {"pi", "sqrt", "exp"})
    for (std::size_t at; (at = end.find(harmless)) != std::string::npos;) end.erase(at, harmless.size());
  return std::none_of(end.begin(), end.end(),
                      [](unsigned char c) { return c == '-' || std::isalpha(c) != 0; });
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
  if (!is_name(name)) refuse("a name is letters, digits and '_', and neither 'pi' nor 'inf'", name);
  Range ends;
  try {
    ends = read_range(range);
    (void)parse_unit(unit);
  } catch (const std::invalid_argument& error) {
    refuse(error.what(), name);
  }
  // GiNaC simplifies sqrt(x^2) to x where it knows that x is not negative.
  const SymbolExpression symbol = is_plainly_nonnegative(ends.lower)
                                      ? SymbolExpression(GiNaC::possymbol(name, latex))
                                      : SymbolExpression(GiNaC::realsymbol(name, latex));
  findings_.reset();
  if (!table_.contains(name)) order_.push_back(name);
  return table_[name] = {name, latex, unicode, unit, range, meaning, introduced, symbol};
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

// What the prover of derivations/algebra keeps here; it goes with it.
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

}  // namespace rederive
