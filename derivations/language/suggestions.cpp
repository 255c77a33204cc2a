#include <algorithm>
#include <cctype>
#include <derivations/language/functions.hpp>
#include <derivations/language/suggestions.hpp>

namespace rederive {

namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_text = 40;  // that is looked at, and repeated in a message

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Insertions, deletions, replacements and exchanges of neighbours that make one word of the other
/// (Damerau–Levenshtein, each letter moved once).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      least = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least = std::min(least, d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// The first of the nearest; a mere difference of case is the nearest of all.
std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > longest_text) return {};
  std::string best;
  std::size_t smallest = 1 + (name.size() + 1) / 3;  // a slip in every third letter; none in a single one
  for (const std::string& candidate : known) {
    const bool same = lower_case(name) == lower_case(candidate);
    const std::size_t distance = same ? 0 : edit_distance(name, candidate);
    if (distance < smallest) smallest = distance, best = candidate;
  }
  return best;
}

/// "asin" for "arcsin", "log" for "ln"; empty if it is no function's name elsewhere.
std::string foreign_function(std::string_view name) {
  const std::string word = " " + lower_case(name) + " ";
  if (word == " log10 ") return "log(x)/log(10)";
  if (word == " log2 ") return "log(x)/log(2)";
  if (word == " power ") return "pow";
  for (const Function& function : functions())
    if ((" " + std::string(function.abroad) + " ").find(word) != std::string::npos)
      return std::string(function.name);
  return {};
}

std::string nearest_function(std::string_view name) {
  if (const std::string function = foreign_function(name); !function.empty()) return function;
  std::vector<std::string> known;
  for (const Function& function : functions()) known.emplace_back(function.name);
  known.insert(known.end(), {"abs", "pow"});
  return nearest(name, known);
}

/// "m*g*R" for "mgR": an unknown name that falls into known ones; empty if it does not.
std::string split_into_symbols(std::string_view name, const Symbols& symbols) {
  if (name.size() > longest_text) return {};
  std::vector<std::string> best(name.size() + 1);  // of the first letters, the product of the fewest names
  for (std::size_t end = 1; end <= name.size(); ++end) {
    for (std::size_t start = 0; start < end; ++start) {
      const std::string part(name.substr(start, end - start));
      if ((start > 0 && best[start].empty()) || (part != "pi" && symbols.find(part) == nullptr)) continue;
      const std::string product = start == 0 ? part : best[start] + "*" + part;
      if (best[end].empty() || product.size() < best[end].size()) best[end] = product;
    }
  }
  return best.back();
}

/// The text of some tokens, if it is short enough to be repeated.
std::string written(const Formula& f, std::size_t first, std::size_t last) {
  const std::size_t start = f.tokens[first].position, size = f.tokens[last].end - start;
  return size <= longest_text ? std::string(f.text.substr(start, size)) : "…";
}

std::string quoted(const Formula& f, std::size_t at) { return "'" + written(f, at, at) + "'"; }

bool is_number(const Formula& f, std::size_t at) { return f.tokens[at].kind == Kind::number; }

std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

/// "m*g*R" for mgR. Of x̄, "xbar" is our spelling, and no product of five letters.
std::string as_product(const Formula& f, std::size_t at) {
  const Token& token = f.tokens[at];
  const bool is_typed = token.kind == Kind::name && written(f, at, at) == token.text;
  return is_typed ? split_into_symbols(token.text, f.symbols) : "";
}

// How a stretch of tokens should be written; `at` moves from its first token to the one behind it.

std::string factors(const Formula& f, std::size_t& at);

/// A parenthesis up to where it is closed.
std::string group(const Formula& f, std::size_t& at) {
  const std::size_t opening = at;
  int open = 0;
  do open += f.tokens[at].is("(") ? 1 : f.tokens[at].is(")") ? -1 : 0;
  while (f.tokens[++at].kind != Kind::end && open > 0);
  const std::string text = written(f, opening, at - 1);
  return text == "…" ? "(…)" : text;
}

/// sin(x), sin^2(x), sin x, sin 2x: the parentheses around the argument, the exponent behind them.
std::string call(const Formula& f, std::size_t& at) {
  const std::string name = f.tokens[at++].text;
  std::string power, argument = "(x)";
  if (f.tokens[at].kind == Kind::superscript) power = "^" + f.tokens[at++].text;
  if (f.tokens[at].is("^") && is_number(f, at + 1)) power = "^" + f.tokens[++at].text, ++at;
  if (f.tokens[at].is("("))
    argument = group(f, at);
  else if (is_function(f.tokens[at]) || f.tokens[at].is("sqrt"))
    argument = "(…)";  // sin cos x
  else if (starts_operand(f.tokens[at]))
    argument = "(" + factors(f, at) + ")";
  return name + argument + power;
}

/// A number, a name, a call or a parenthesis, and its exponent.
std::string operand(const Formula& f, std::size_t& at) {
  std::string text;
  if (is_function(f.tokens[at])) {
    text = call(f, at);
  } else if (f.tokens[at].is("(")) {
    text = group(f, at);
  } else if (f.tokens[at].is("sqrt") && starts_operand(f.tokens[at + 1]) && !f.tokens[at + 1].is("sqrt")) {
    text = "√" + operand(f, ++at);
  } else {
    text = as_product(f, at);
    if (text.empty()) text = written(f, at, at);
    ++at;
  }
  if (f.tokens[at].kind == Kind::superscript) text += written(f, at, at), ++at;
  if (!f.tokens[at].is("^")) return text;
  const std::size_t exponent = at + (f.tokens[at + 1].is("-") ? 2 : 1);
  if (f.tokens[exponent].kind != Kind::number && f.tokens[exponent].kind != Kind::name) return text;
  text += written(f, at, exponent);
  at = exponent + 1;
  return text;
}

/// The argument of a function without parentheses: 2x in sin 2x cos y, 2*x in sin 2*x.
std::string factors(const Formula& f, std::size_t& at) {
  const bool starts_with_number = is_number(f, at);
  std::string text = operand(f, at);
  while (text.size() < longest_text) {
    std::size_t next = at + (starts_with_number && f.tokens[at].is("*") ? 1 : 0);
    if (f.tokens[next].kind != Kind::name || is_function(f.tokens[next])) break;
    text += "*" + operand(f, next);
    at = next;
  }
  return text;
}

/// "sin(2*x)" for sin2x, "sqrt(2)" for sqrt2: a function, and a number or a product that stick to it.
std::string glued_call(const std::string& name, const Symbols& symbols) {
  for (std::size_t length = name.size() < longest_text ? name.size() - 1 : 0; length > 1; --length) {
    const std::string function = name.substr(0, length), rest = name.substr(length);
    if (function != "pow" && find_function(function) == nullptr) continue;
    const std::string number = rest.substr(0, rest.find_first_not_of("0123456789"));
    if (number == rest) return function + "(" + number + ")";
    const std::string product = split_into_symbols(rest.substr(number.size()), symbols);
    if (!product.empty()) return function + "(" + number + (number.empty() ? "" : "*") + product + ")";
  }
  return {};
}

}  // namespace

bool starts_operand(const Token& token) {
  return token.kind == Kind::number || token.kind == Kind::name || token.is("(") || token.is("sqrt");
}

bool is_function(const Token& token) {
  return token.kind == Kind::name && (token.text == "pow" || find_function(token.text) != nullptr);
}

SyntaxError juxtaposition(const Formula& f, std::size_t product, std::size_t first, std::size_t at) {
  const auto& [kind, text, position, end] = f.tokens[at];
  if (text == "and" || text == "or")
    return {"syntax", position, "one statement at a time: '" + text + "' is not read here"};
  std::string head = first > product ? written(f, product, first - 1) : "";
  if (head == "…") head = "";
  const bool fraction = first >= 2 && is_number(f, first) && is_number(f, first - 2) &&
                        (first == 2 || !f.tokens[first - 3].is("^"));  // 3/2 x is 3/2*x; a/2g may be either
  std::string tail = operand(f, first);
  while (starts_operand(f.tokens[at]) && tail.size() < longest_text) tail += "*" + operand(f, at);
  const std::string other = head.ends_with('/') && !fraction ? head + "(" + tail + ") or " : "";
  return {"implicit_multiplication", position, "a product needs its '*': write " + other + head + tail};
}

SyntaxError called_symbol(const Formula& f, std::size_t name) {
  std::size_t opening = name + 1;
  const std::size_t position = f.tokens[opening].position;
  const std::string product = written(f, name, name) + "*" + group(f, opening);
  return {"implicit_multiplication", position,
          quoted(f, name) + " is no function: write " + product + " for a product"};
}

SyntaxError ambiguous_inverse(const Token& function, const Token& at) {
  return {"syntax", at.position,
          "this may mean 1/" + function.text + "(x) or a" + function.text + "(x): write which"};
}

SyntaxError bare_function(const Formula& f, std::size_t function) {
  const Token& next = f.tokens[function + 1];
  if (next.is("^") && f.tokens[function + 2].is("-")) return ambiguous_inverse(f.tokens[function], next);
  const std::size_t position = f.tokens[function].position;
  const std::string meant = "write " + call(f, function);
  if (next.kind == Kind::superscript || next.is("^")) return {"syntax", position, meant};
  if (starts_operand(next))
    return {"implicit_multiplication", position, "a function needs parentheses: " + meant};
  return {"syntax", position, "a function needs its argument: " + meant};
}

SyntaxError unknown_name(const Formula& f, std::size_t at) {
  const auto& [kind, name, position, end] = f.tokens[at];
  const Token& next = f.tokens[at + 1];
  const std::string shown = quoted(f, at), no_symbol = "there is no symbol " + shown;
  if (name == "inf" || name == "infinity") return {"unknown_symbol", position, "infinity is no number"};
  if (name == "nan" || name == "NaN") return {"unknown_symbol", position, shown + " is no number"};
  if (next.is("(") || (starts_operand(next) && !foreign_function(name).empty()))
    return {"unknown_function", position,
            "there is no function " + shown + did_you_mean(nearest_function(name))};
  if (const std::string call = glued_call(name, f.symbols); !call.empty())
    return {"implicit_multiplication", position, "a function needs parentheses: write " + call};
  std::vector<std::string> known = f.symbols.names();
  known.emplace_back("pi");
  const std::string near = nearest(name, known), product = as_product(f, at);
  const bool is_short = name.size() <= 3;  // "mgR" is a product; "thta" is a slip of the pen
  if (product.empty() || !(near.empty() || is_short))
    return {"unknown_symbol", position, no_symbol + did_you_mean(near)};
  if (!is_short && product.size() == 2 * name.size() - 1)  // "real": r*e*a*l
    return {"unknown_symbol", position, no_symbol + "; as a product, it would be " + product};
  return {"implicit_multiplication", position, "a product needs its '*': write " + product};
}

SyntaxError missing_operand(const Formula& f, std::size_t at) {
  const auto& [kind, text, position, end] = f.tokens[at];
  if (kind == Kind::superscript)
    return {"syntax", position, "there is nothing here that this exponent raises"};
  if (at == 0) return {"syntax", position, "an operand is missing before " + quoted(f, at)};
  const bool is_empty = f.tokens[at - 1].is("(") && f.tokens[at].is(")");
  if (is_empty) return {"syntax", position, "there is nothing in these parentheses"};
  const std::string where = kind == Kind::end ? "the formula ends where " : "";
  return {"syntax", position, where + "an operand is missing after " + quoted(f, at - 1)};
}

SyntaxError stray_comma(const Formula& f, std::size_t at) {
  const std::size_t position = f.tokens[at].position;
  if (at == 0 || !is_number(f, at - 1) || !is_number(f, at + 1))
    return {"syntax", position, "a comma can only stand between the arguments of a function"};
  const std::string decimal = f.tokens[at - 1].text + "." + f.tokens[at + 1].text;
  return {"syntax", position, "a decimal number is written with a point: " + decimal};
}

}  // namespace rederive
