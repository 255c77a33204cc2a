#include <algorithm>
#include <cctype>
#include <derivations/algebra/functions.hpp>
#include <map>

namespace rederive {

namespace {

constexpr std::string_view of_one_argument[] = {
    "sin",  "cos",  "tan",  "cot",   "sec",   "csc",   "asin", "acos", "atan", "sinh", "cosh", "tanh",
    "coth", "sech", "csch", "asinh", "acosh", "atanh", "exp",  "log",  "sqrt", "fabs", "abs"};

/// What people write elsewhere, and what it is called here.
const std::map<std::string_view, std::string>& foreign_names() {
  static const std::map<std::string_view, std::string> names = {{"ln", "log"},
                                                                {"arcsin", "asin"},
                                                                {"arccos", "acos"},
                                                                {"arctan", "atan"},
                                                                {"tg", "tan"},
                                                                {"ctg", "cot"},
                                                                {"cosec", "csc"},
                                                                {"arcsinh", "asinh"},
                                                                {"arccosh", "acosh"},
                                                                {"arctanh", "atanh"},
                                                                {"arsinh", "asinh"},
                                                                {"arcosh", "acosh"},
                                                                {"artanh", "atanh"},
                                                                {"sh", "sinh"},
                                                                {"ch", "cosh"},
                                                                {"th", "tanh"},
                                                                {"root", "sqrt"},
                                                                {"power", "pow"},
                                                                {"log10", "log(x)/log(10)"},
                                                                {"log2", "log(x)/log(2)"},
                                                                {"atan2", "atan"}};
  return names;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Insertions, deletions, replacements and exchanges of neighbours that make one word of the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

/// The first of the nearest; a mere difference of case is the nearest of all.
std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 40;
  if (name.size() > longest) return {};
  std::string best;
  std::size_t smallest = 1 + (name.size() + 1) / 3;  // a slip in every third letter; none in a single one
  for (const std::string& candidate : known) {
    const std::size_t distance =
        lower_case(name) == lower_case(candidate) ? 0 : edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

int arity(std::string_view function) {
  if (function == "pow") return 2;
  const auto* end = std::end(of_one_argument);
  return std::find(std::begin(of_one_argument), end, function) == end ? 0 : 1;
}

std::string canonical_function(std::string_view function) {
  return std::string(function == "abs" ? "fabs" : function);
}

std::string nearest_symbol(std::string_view name, const Symbols& symbols) {
  std::vector<std::string> known = symbols.names();
  known.emplace_back("pi");
  return nearest(name, known);
}

std::string nearest_function(std::string_view name) {
  const auto foreign = foreign_names().find(lower_case(name));
  if (foreign != foreign_names().end()) return foreign->second;
  std::vector<std::string> known(std::begin(of_one_argument), std::end(of_one_argument));
  known.emplace_back("pow");
  return nearest(name, known);
}

bool is_foreign_function(std::string_view name) { return foreign_names().contains(lower_case(name)); }

std::string split_into_symbols(std::string_view name, const Symbols& symbols) {
  constexpr std::size_t longest = 40;
  if (name.size() > longest) return {};
  // best[i]: the first i letters as a product of the fewest names
  std::vector<std::vector<std::string>> best(name.size() + 1);
  for (std::size_t end = 1; end <= name.size(); ++end) {
    for (std::size_t start = 0; start < end; ++start) {
      const std::string_view part = name.substr(start, end - start);
      if ((start > 0 && best[start].empty()) || (part != "pi" && symbols.find(part) == nullptr)) continue;
      if (!best[end].empty() && best[end].size() <= best[start].size() + 1) continue;
      best[end] = best[start];
      best[end].emplace_back(part);
    }
  }
  std::string product;
  for (const std::string& part : best.back()) product += (product.empty() ? "" : "*") + part;
  return product;
}

}  // namespace rederive
