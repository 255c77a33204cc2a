#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/language/text.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/calculus.hpp>
#include <derivations/paper/latex.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/printed.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/reader/generous.hpp>
#include <functional>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace program;
using namespace decide;
using namespace mechanics;

using GiNaC::ex;

namespace {

[[noreturn]] void refuse_form(const std::string& message) { throw std::invalid_argument(message); }

/// Whether a character belongs to a name: letters, also Greek ones with dots, digits and indices.
bool is_of_name(char32_t code) {
  return (code < 0x80 && (std::isalnum(static_cast<int>(code)) != 0 || code == '_')) ||
         (code >= 0xC0 && code < 0x2000 && code != 0xD7 && code != 0xF7) || subscript_digit(code) >= 0;
}

/// A text, and a place in it.
struct Scanner {
  std::string_view text;
  std::size_t at = 0;

  CodePoint next() const { return first_character(text.substr(std::min(at, text.size()))); }
  void skip_blanks() {
    while (next().bytes > 0 && is_space(next().code)) at += next().bytes;
  }
  bool take(std::string_view mark) {
    skip_blanks();
    if (!text.substr(at).starts_with(mark)) return false;
    at += mark.size();
    return true;
  }
  std::string name() {
    skip_blanks();
    const std::size_t start = at;
    while (next().bytes > 0 && is_of_name(next().code)) at += next().bytes;
    return std::string(text.substr(start, at - start));
  }
  /// Reads "^2", "²" or nothing: 1; 0 for another exponent.
  int order() {
    if (const int digit = superscript_digit(next().code); digit > 0) return at += next().bytes, digit;
    if (!take("^")) return 1;
    const std::string digits = name();
    return digits.size() == 1 && digits[0] >= '1' && digits[0] <= '9' ? digits[0] - '0' : 0;
  }
  /// Reads up to the bracket that closes the one at the place, and returns what is inside.
  std::string inside() {
    const std::size_t start = at;
    for (int depth = 0; at < text.size(); ++at) {
      depth += std::string_view("([{").find(text[at]) != std::string_view::npos   ? 1
               : std::string_view(")]}").find(text[at]) != std::string_view::npos ? -1
                                                                                  : 0;
      if (depth == 0) return std::string(text.substr(start + 1, at++ - start - 1));
    }
    refuse_form("this parenthesis is never closed: " + std::string(text.substr(start)));
  }
  /// Reads the limit of an integral or the bound of a sum: a group, a name or number with its sign, digits.
  std::string limit() {
    skip_blanks();
    if (at < text.size() && (text[at] == '{' || text[at] == '(')) return inside();
    std::string sign = take("-") || take("−") ? "-" : "";
    std::string digits;
    for (; superscript_digit(next().code) >= 0; at += next().bytes)
      digits += std::to_string(superscript_digit(next().code));
    return sign + (digits.empty() ? name() : digits);
  }
};

/// Splits a text at the marks that are outside all brackets; `found` receives the marks.
std::vector<std::string> split_at(std::string_view text, const std::vector<std::string>& marks,
                                  std::vector<std::string>* found = nullptr) {
  std::vector<std::string> parts{""};
  for (std::size_t at = 0, depth = 0; at < text.size();) {
    const auto mark = std::ranges::find_if(
        marks, [&](const std::string& it) { return depth == 0 && text.substr(at).starts_with(it); });
    if (mark != marks.end()) {
      parts.emplace_back();
      if (found != nullptr) found->push_back(*mark);
      at += mark->size();
      continue;
    }
    if (std::string_view("([{").find(text[at]) != std::string_view::npos) ++depth;
    if (std::string_view(")]}").find(text[at]) != std::string_view::npos && depth > 0) --depth;
    parts.back() += text[at++];
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

/// Works out what the grammar of language lacks, from the inside to the outside.
class WorkingOut {
 public:
  WorkingOut(const Paper& paper, Symbols symbols) : paper_(paper), symbols_(std::move(symbols)) {}

  std::string plain(std::string_view text) const {
    Scanner scan{text};
    std::string result;
    int bars = 0;
    while (scan.at < text.size()) {
      const std::size_t start = scan.at;
      if (const auto value = special(scan)) {
        result += "(" + *value + ")";
        continue;
      }
      scan.at = start;
      if (text[start] == '|') {
        const bool opens = !ends_operand(result) || bars == 0;
        bars += opens ? 1 : -1;
        result += opens ? "fabs(" : ")";
        ++scan.at;
        continue;
      }
      const bool is_name = is_of_name(scan.next().code);
      if (is_name)
        (void)scan.name();
      else
        scan.at += std::max<std::size_t>(1, scan.next().bytes);
      result += text.substr(start, scan.at - start);
    }
    if (bars != 0) refuse_form("a bar of |…| has no partner: write fabs(…)");
    return result;
  }

 private:
  static bool ends_operand(const std::string& text) {
    const auto last = text.find_last_not_of(' ');
    if (last == std::string::npos) return false;
    std::size_t start = last;
    while (start > 0 && (text[start] & 0xC0) == 0x80) --start;
    const char32_t code = first_character(std::string_view(text).substr(start)).code;
    return is_of_name(code) || code == ')' || superscript_digit(code) >= 0;
  }

  /// Returns the name of a declared symbol, however it is typed; "" for other texts.
  std::string declared(const std::string& typed) const {
    try {
      const Tree tree = parse(typed, symbols_);
      return is_symbol(tree) ? tree->text : "";
    } catch (const SyntaxError&) {
      return "";
    }
  }
  Tree tree_of(std::string_view text) const { return parse(plain(text), symbols_); }
  ex value_of(std::string_view text) const { return lower(tree_of(text), symbols_); }
  std::string text_of(const ex& value) const { return print(value, Notation::plain, symbols_); }

  /// The value of what begins here and is not in the grammar of language; nothing if that is in it.
  std::optional<std::string> special(Scanner& scan) const {
    if (scan.take("∂")) return derivative(scan, true);
    if (scan.take("∫")) return integral(scan);
    if (scan.take("∑")) return series(scan);
    if (!is_of_name(scan.next().code)) return std::nullopt;
    const std::string name = scan.name();
    if (name == "Σ_" || name == "Σ") return scan.at -= name.size() - std::string("Σ").size(), series(scan);
    const bool may_begin_it = name.starts_with("d") || name == "int" || name == "sum";
    if (!may_begin_it || (name != "d" && !declared(name).empty())) return std::nullopt;
    if (name.starts_with("d")) {
      scan.at -= name.size() - 1;
      return derivative(scan, false);
    }
    const bool is_called = scan.at < scan.text.size() && scan.text[scan.at] == '(';
    if (!is_called || (name != "int" && name != "sum")) return std::nullopt;
    const std::vector<std::string> parts = split_at(scan.inside(), {","});
    if (parts.size() != 4) refuse_form(name + " has four parts, such as " + name + "(k, 1, 3, k*x)");
    return name == "int" ? integral(parts) : series(parts);
  }

  /// Reads a derivative behind its first d or ∂; nothing if it is none.
  std::optional<std::string> derivative(Scanner& scan, bool is_partial) const {
    const std::string d = is_partial ? "∂" : "d";
    const int order = scan.order();
    std::string inside;
    scan.skip_blanks();
    const bool is_group = scan.at < scan.text.size() && scan.text[scan.at] == '(';
    if (is_group)
      inside = scan.inside();
    else
      inside = scan.name();
    if (order == 0 || !scan.take("/") || !scan.take(d)) {
      if (is_partial) refuse_form("write a partial derivative as ∂/∂x(…)");
      return std::nullopt;
    }
    const std::string variable = scan.name();
    if (variable.empty() || (!is_partial && !declared("d" + variable).empty())) return std::nullopt;
    if (scan.order() != order) refuse_form("the orders of a derivative must be the same above and below");
    if (inside.empty()) {
      scan.skip_blanks();
      if (scan.at >= scan.text.size() || scan.text[scan.at] != '(')
        refuse_form(fmt::format("what is derived must be in parentheses: {}/{}{}(…)", d, d, variable));
      inside = scan.inside();
    }
    return derived(inside, variable, order, is_partial);
  }

  std::string derived(const std::string& inside, const std::string& variable, int order,
                      bool is_partial) const {
    const Tree tree = tree_of(inside);
    const std::string name = declared(variable);
    const bool is_time = !is_partial && (variable == "t" || name == "t");
    if (name.empty() && !is_time) refuse_form("the derivative by '" + variable + "', which is not a symbol");
    ex value = lower(tree, symbols_);
    const bool is_bare = is_symbol(tree) && tree->text != name;
    const auto has_rate = [&](const auto& pair) { return pair.first.is_equal(value); };
    if (is_bare && (!is_time || std::ranges::none_of(rates_in(symbols_), has_rate)))
      refuse_form(fmt::format("how {} depends on {} is not declared: write what it is in the parentheses{}",
                              tree->text, variable, is_time ? ", or declare its rate with `rates`" : ""));
    for (int k = 0; k < order; ++k)
      value = is_time ? total_derivative(value, symbols_) : value.diff(symbols_[name]);
    return text_of(value);
  }

  /// The same with a name that is declared here, if it is not a symbol.
  std::pair<WorkingOut, std::string> with(const std::string& typed) const {
    std::string name = declared(typed);
    Symbols symbols = symbols_;
    if (name.empty()) {
      name = "bound_" + std::to_string(symbols.names().size());
      symbols.declare({name, typed, typed, "1", all_numbers, "", ""});
    }
    return {WorkingOut(paper_, std::move(symbols)), name};
  }

  std::string integral(Scanner& scan) const {
    std::string from, to;
    for (int k = 0; k < 2; ++k) {
      scan.skip_blanks();
      if (subscript_digit(scan.next().code) >= 0)
        for (; subscript_digit(scan.next().code) >= 0; scan.at += scan.next().bytes)
          from += std::to_string(subscript_digit(scan.next().code));
      else if (scan.take("_"))
        from = scan.limit();
      else if (scan.take("^") || superscript_digit(scan.next().code) >= 0)
        to = scan.limit();
    }
    if (from.empty() || to.empty())
      refuse_form("an integral needs finite limits: ∫_a^b f dx, or int(x, a, b, f)");
    const std::size_t start = scan.at;
    for (int depth = 0, nested = 0; scan.at < scan.text.size();) {
      const std::size_t before = scan.at;
      const char c = scan.text[before];
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (scan.text.substr(before).starts_with("∫")) ++nested;
      const std::string name = is_of_name(scan.next().code) ? scan.name() : "";
      if (name.empty()) {
        scan.at += std::max<std::size_t>(1, scan.next().bytes);
      } else if (depth == 0 && name.size() > 1 && name[0] == 'd' && declared(name).empty() && nested-- == 0) {
        std::string body = trimmed(std::string(scan.text.substr(start, before - start)));
        if (body.ends_with("*")) body.pop_back();
        return integral({name.substr(1), from, to, body.empty() ? "1" : body});
      }
    }
    refuse_form("the differential of an integral is missing: ∫_a^b f dx, or int(x, a, b, f)");
  }

  std::string integral(const std::vector<std::string>& parts) const {
    for (const std::string& limit : {parts[1], parts[2]})
      if (limit.find("inf") != std::string::npos || limit.find("∞") != std::string::npos)
        refuse_form(
            "the limits of an integral must be finite: write its value, or the integral up to a symbol");
    const auto [inner, name] = with(parts[0]);
    return text_of(definite_integral(inner.value_of(parts[3]), inner.symbols_[name], value_of(parts[1]),
                                     value_of(parts[2])));
  }

  std::string series(Scanner& scan) const {
    const auto fail = [] { refuse_form("a sum needs whole bounds: Σ_{k=1}^{3} f, or sum(k, 1, 3, f)"); };
    if (!scan.take("_")) fail();
    const std::vector<std::string> index = split_at(scan.limit(), {"="});
    if (index.size() != 2 || !scan.take("^")) fail();
    const std::string to = scan.limit();
    scan.skip_blanks();
    const std::size_t start = scan.at;
    std::size_t end = start;
    for (const std::string& part :
         split_at(scan.text.substr(start), {"+", "-", "−", "=", "<", ">", "≤", "≥", "≈", ",", ")"})) {
      end = start + (scan.text.substr(start).find(part)) + part.size();
      break;
    }
    scan.at = end;
    return series({index[0], index[1], to, std::string(scan.text.substr(start, end - start))});
  }

  std::string series(const std::vector<std::string>& parts) const {
    constexpr int most = 200;
    const auto bound = [&](const std::string& text) {
      const ex value = value_of(text);
      if (!value.info(GiNaC::info_flags::integer) || abs(GiNaC::ex_to<GiNaC::numeric>(value)) > most)
        refuse_form(
            fmt::format("the bound '{}' of a sum must be a whole number up to {}: write the sum in closed "
                        "form, or term by term",
                        text, most));
      return GiNaC::ex_to<GiNaC::numeric>(value).to_int();
    };
    const auto [inner, name] = with(parts[0]);
    if (symbols_.find(name) != nullptr && std::ranges::find(paper_.integers, name) == paper_.integers.end())
      refuse_form(fmt::format(
          "the index {} of a sum is declared, but not as a whole number: give it `integer = true`, "
          "or take another letter",
          name));
    const ex term = inner.value_of(parts[3]), index = inner.symbols_[name];
    ex sum = 0;
    for (int k = bound(parts[1]); k <= bound(parts[2]); ++k)
      sum += term.subs(index == k, GiNaC::subs_options::no_pattern);
    return text_of(sum);
  }

  const Paper& paper_;
  Symbols symbols_;
};

using Grid = std::vector<std::vector<std::string>>;

/// The entries of a vector, in one column, or of a matrix in brackets; nothing of other texts.
std::optional<Grid> entries_of(const std::string& text) {
  if (text.empty() || (text[0] != '(' && text[0] != '[')) return std::nullopt;
  Scanner scan{text};
  const std::string inside = scan.inside();
  if (scan.at < text.size()) {
    if (text.starts_with("["))
      refuse_form("only whole sides are read as matrices: write the entries of the result");
    return std::nullopt;
  }
  const std::vector<std::string> items = split_at(inside, {","});
  if (text[0] == '(' && items.size() == 1) return std::nullopt;
  Grid grid;
  for (const std::string& item : items) {
    const bool is_row = item.starts_with("[") && item.ends_with("]");
    grid.push_back(is_row ? split_at(item.substr(1, item.size() - 2), {","}) : std::vector{item});
  }
  constexpr std::size_t most = 3;
  for (const auto& row : grid)
    if (row.size() != grid[0].size() || row.size() > most || grid.size() > most)
      refuse_form(
          "vectors and matrices have up to 3 entries in a row, and as many in each row: [[a, b], [c, d]]");
  return grid;
}

/// The declared entries of a vector or a matrix: F_x and F_y, or F_1 and F_2; M_11 … M_22.
Grid named_entries(const std::string& name, const Grid& like, const Symbols& symbols) {
  for (const std::string letters : {"123", "xyz"}) {
    Grid grid;
    bool is_declared = true;
    for (std::size_t row = 0; row < like.size(); ++row) {
      grid.emplace_back();
      for (std::size_t column = 0; column < like[0].size(); ++column) {
        grid.back().push_back(name + "_" + letters[row] +
                              (like[0].size() > 1 ? std::string(1, letters[column]) : ""));
        is_declared = is_declared && symbols.find(grid.back().back()) != nullptr;
      }
    }
    if (is_declared) return grid;
  }
  refuse_form(fmt::format(
      "the other side has entries, but '{}' has none: write them, or declare {}_1, {}_2 … ({}_11 … of a "
      "matrix)",
      name, name, name, name));
}

/// The statements in a text, each with the name of its part: "1,2", "+"; one without a name if it is alone.
std::vector<RowPart> parts_of(const std::string& text, const Symbols& symbols) {
  if (text.find("±") != std::string::npos || text.find("∓") != std::string::npos) {
    std::vector<RowPart> parts;
    for (const auto& [plus, minus] : {std::pair("+", "-"), {"-", "+"}}) {
      std::string one = text;
      for (const auto& [mark, sign] : {std::pair("±", plus), {"∓", minus}})
        for (std::size_t at = 0; (at = one.find(mark, at)) != std::string::npos;)
          one.replace(at, std::string_view(mark).size(), sign);
      for (RowPart part : parts_of(one, symbols)) {
        part.name += (part.name.empty() ? "" : ",") + std::string(plus);
        parts.push_back(part);
      }
    }
    return parts;
  }
  std::vector<std::string> signs;
  const std::vector<std::string> sides =
      split_at(text, {"<=", ">=", "==", "=<", "=>", "<>", "≤", "≥", "=", "<", ">"}, &signs);
  std::vector<std::optional<Grid>> grids;
  const Grid* like = nullptr;
  for (const std::string& side : sides) grids.push_back(entries_of(side));
  for (const auto& grid : grids)
    if (grid) like = &*grid;
  if (like == nullptr) return {{"", text}};
  if (signs.empty() || std::ranges::any_of(signs, [](const std::string& sign) { return sign != "="; }))
    refuse_form("vectors and matrices are compared by '=': write other relations entry by entry");
  std::vector<RowPart> parts;
  for (std::size_t row = 0; row < like->size(); ++row)
    for (std::size_t column = 0; column < (*like)[0].size(); ++column) {
      RowPart part{std::to_string(row + 1) + ((*like)[0].size() > 1 ? "," + std::to_string(column + 1) : ""),
                   ""};
      for (std::size_t k = 0; k < sides.size(); ++k) {
        const Grid grid = grids[k] ? *grids[k] : named_entries(sides[k], *like, symbols);
        if (grid.size() != like->size() || grid[0].size() != (*like)[0].size())
          refuse_form("the two sides have different numbers of entries");
        part.printed += (k == 0 ? "" : " = ") + grid[row][column];
      }
      parts.push_back(part);
    }
  return parts;
}

/// Reads the text of the field; sets the parts of the row.
void read_field(const Paper& paper, Row& row) {
  std::string text = row.claim();
  if (text.empty() && !row.latex.empty()) text = row.read_as = from_latex(row.latex, paper.symbols);
  for (const char* mark : {"≈", "≃"})
    for (std::size_t at = 0; (at = text.find(mark)) != std::string::npos; row.is_approximate = true)
      text.replace(at, std::string_view(mark).size(), "=");
  if (row.is_approximate && row.order == 0)
    refuse_form(
        "'≈' is an approximation to an order: give the row `order` and `small`, such as order = 1, small = "
        "\"theta\"");
  row.parts = parts_of(text, paper.symbols);
  for (RowPart& part : row.parts) {
    const std::string plain = WorkingOut(paper, paper.symbols).plain(part.printed);
    if (plain != part.printed) part.printed = print(parse_statement(plain, paper.symbols));
    (void)parse_statement(part.printed, paper.symbols);
  }
  std::string& claim = row.kind == RowKind::result ? row.statement : row.printed;
  if (row.parts[0].printed != claim) row.typed = row.latex.empty() || !claim.empty() ? claim : row.read_as;
  claim = row.parts[0].printed;
  if (row.parts.size() == 1) row.parts.clear();
}

}  // namespace

std::string worked_out(const std::string& text, const Paper& paper) {
  return WorkingOut(paper, paper.symbols).plain(text);
}

void read_printed(const Paper& paper, Row& row) {
  const bool is_latex = row.claim().empty();
  const std::string field = is_latex ? "latex" : row.kind == RowKind::result ? "statement" : "printed";
  const auto fail = [&](const std::string& name, const std::string& what) {
    row.parts.clear();
    if (row.fault.empty())
      row.fault = fmt::format("{}: row {}: {}: {}", row.place_of(name), row.id, name, what);
  };
  try {
    read_field(paper, row);
  } catch (const SyntaxError& error) {
    const std::string& text = is_latex ? row.latex : row.claim();
    const std::string rest = text.substr(std::min(error.position, text.size()));
    fail(field, error.what() + reader::advice(error, text, paper.symbols) +
                    (rest.empty() ? std::string(", at the end") : ", at '" + printable_line(rest) + "'"));
  } catch (const std::exception& error) {
    fail(field, error.what());
  }
  try {
    (void)symbols_in(paper, row.domain);
  } catch (const std::exception& error) {
    fail("domain", error.what());
  }
  for (const std::string& text : row.assume) try {
      if (names_of(read_assumption(text, paper.symbols)).empty())
        fail("assume", "'" + text + "' has no symbol");
    } catch (const std::exception& error) {
      fail("assume", error.what());
    }
}

std::vector<Row> rows_in(const Paper& paper, const std::filesystem::path& file) {
  std::vector<Row> rows = read_rows(file);
  for (Row& row : rows) read_printed(paper, row);
  return rows;
}

}  // namespace rederive::paper
