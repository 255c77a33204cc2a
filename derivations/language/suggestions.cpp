#include <derivations/language/functions.hpp>
#include <derivations/language/spelling.hpp>
#include <derivations/language/suggestions.hpp>

namespace rederive {

namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_text = 40;  // that is repeated in a message

/// How a stretch of tokens should be written, and the token behind it.
struct Meant {
  std::string text;
  std::size_t next;
};

/// The text of some tokens, if it is short enough to be repeated.
std::string written(const Formula& f, std::size_t first, std::size_t last) {
  const std::size_t start = f.tokens[first].position, size = f.tokens[last].end - start;
  return size <= longest_text ? std::string(f.text.substr(start, size)) : "…";
}

std::string quoted(const Formula& f, std::size_t at) { return "'" + written(f, at, at) + "'"; }

std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

Meant factors(const Formula& f, std::size_t at);

/// A parenthesis up to where it is closed.
Meant group(const Formula& f, std::size_t opening) {
  std::size_t last = opening;
  for (int open = 1; open > 0 && f.tokens[last + 1].kind != Kind::end;) {
    ++last;
    open += f.tokens[last].is("(") ? 1 : f.tokens[last].is(")") ? -1 : 0;
  }
  const std::string text = written(f, opening, last);
  return {text == "…" ? "(…)" : text, last + 1};
}

/// sin(x), sin^2(x), sin x, sin 2x: the parentheses around the argument, the exponent behind them.
Meant call(const Formula& f, std::size_t function) {
  std::size_t next = function + 1;
  std::string power;
  if (f.tokens[next].kind == Kind::superscript) power = "^" + f.tokens[next++].text;
  if (f.tokens[next].is("^") && f.tokens[next + 1].kind == Kind::number) {
    power = "^" + f.tokens[next + 1].text;
    next += 2;
  }
  Meant argument{"(x)", next};
  if (f.tokens[next].is("(")) {
    argument = group(f, next);
  } else if (is_function(f.tokens[next]) || f.tokens[next].is("sqrt")) {
    argument.text = "(…)";  // sin cos x
  } else if (starts_operand(f.tokens[next])) {
    argument = factors(f, next);
    argument.text = "(" + argument.text + ")";
  }
  return {f.tokens[function].text + argument.text + power, argument.next};
}

/// What begins at a token: a number, a name, a call or a parenthesis, and its exponent.
Meant operand(const Formula& f, std::size_t at) {
  const Token& token = f.tokens[at];
  Meant meant{written(f, at, at), at + 1};
  const bool is_typed = token.kind == Kind::name && meant.text == token.text;
  if (is_function(token)) {
    meant = call(f, at);
  } else if (token.is("(")) {
    meant = group(f, at);
  } else if (token.is("sqrt") && starts_operand(f.tokens[at + 1]) && !f.tokens[at + 1].is("sqrt")) {
    meant = operand(f, at + 1), meant.text = "√" + meant.text;
  } else if (is_typed && f.symbols.find(token.text) == nullptr) {
    const std::string product = split_into_symbols(token.text, f.symbols);
    if (!product.empty()) meant.text = product;
  }
  if (f.tokens[meant.next].kind == Kind::superscript)
    meant.text += written(f, meant.next, meant.next), ++meant.next;
  if (!f.tokens[meant.next].is("^")) return meant;
  const std::size_t exponent = meant.next + (f.tokens[meant.next + 1].is("-") ? 2 : 1);
  if (f.tokens[exponent].kind == Kind::number || f.tokens[exponent].kind == Kind::name)
    return {meant.text + written(f, meant.next, exponent), exponent + 1};
  return meant;
}

/// The argument of a function without parentheses: 2x in sin 2x cos y, 2*x in sin 2*x.
Meant factors(const Formula& f, std::size_t at) {
  Meant all = operand(f, at);
  while (all.text.size() < longest_text) {
    const bool star = f.tokens[at].kind == Kind::number && f.tokens[all.next].is("*");
    const std::size_t next = all.next + (star ? 1 : 0);
    if (f.tokens[next].kind != Kind::name || is_function(f.tokens[next])) break;
    const Meant more = operand(f, next);
    all = {all.text + "*" + more.text, more.next};
  }
  return all;
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
  const std::size_t position = f.tokens[at].position;
  if (f.tokens[at].text == "and" || f.tokens[at].text == "or")
    return {"syntax", position, "one statement at a time: '" + f.tokens[at].text + "' is not read here"};
  auto [tail, next] = operand(f, first);
  for (next = at; starts_operand(f.tokens[next]) && tail.size() < longest_text;) {
    const Meant more = operand(f, next);
    tail += "*" + more.text;
    next = more.next;
  }
  std::string head = first > product ? written(f, product, first - 1) : "";
  if (head == "…") head = "";
  const auto is_number = [&](std::size_t k) { return f.tokens[k].kind == Kind::number; };
  const bool fraction = first >= 2 && is_number(first) && is_number(first - 2) &&
                        (first == 2 || !f.tokens[first - 3].is("^"));  // 3/2 x is 3/2*x; a/2g may be either
  const std::string other = head.ends_with('/') && !fraction ? head + "(" + tail + ") or " : "";
  return {"implicit_multiplication", position, "a product needs its '*': write " + other + head + tail};
}

SyntaxError called_symbol(const Formula& f, std::size_t name) {
  const std::string product = written(f, name, name) + "*" + group(f, name + 1).text;
  return {"implicit_multiplication", f.tokens[name + 1].position,
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
  const std::string meant = "write " + call(f, function).text;
  if (next.kind == Kind::superscript || next.is("^")) return {"syntax", position, meant};
  if (starts_operand(next))
    return {"implicit_multiplication", position, "a function needs parentheses: " + meant};
  return {"syntax", position, "a function needs its argument: " + meant};
}

SyntaxError unknown_name(const Formula& f, std::size_t at) {
  const auto& [kind, name, position, end] = f.tokens[at];
  const std::string shown = quoted(f, at);
  if (name == "inf" || name == "infinity") return {"unknown_symbol", position, "infinity is no number"};
  if (name == "nan" || name == "NaN") return {"unknown_symbol", position, shown + " is no number"};
  if (f.tokens[at + 1].is("(") || (starts_operand(f.tokens[at + 1]) && !foreign_function(name).empty()))
    return {"unknown_function", position,
            "there is no function " + shown + did_you_mean(nearest_function(name))};
  if (const std::string call = glued_call(name, f.symbols); !call.empty())
    return {"implicit_multiplication", position, "a function needs parentheses: write " + call};
  const bool is_typed =
      written(f, at, at) == name;  // of x̄, "xbar" is our spelling: no product of five letters
  const std::string near = nearest_symbol(name, f.symbols),
                    product = is_typed ? split_into_symbols(name, f.symbols) : "";
  const bool is_short = name.size() <= 3;  // "mgR" is a product; "thta" is a slip of the pen
  if (product.empty() || !(near.empty() || is_short))
    return {"unknown_symbol", position, "there is no symbol " + shown + did_you_mean(near)};
  if (!is_short && product.size() == 2 * name.size() - 1)  // "real": r*e*a*l
    return {"unknown_symbol", position,
            "there is no symbol " + shown + "; as a product, it would be " + product};
  return {"implicit_multiplication", position, "a product needs its '*': write " + product};
}

SyntaxError missing_operand(const Formula& f, std::size_t at) {
  const Token& here = f.tokens[at];
  const auto error = [&](const std::string& message) {
    return SyntaxError("syntax", here.position, message);
  };
  if (here.kind == Kind::superscript) return error("there is nothing here that this exponent raises");
  if (at == 0) return error("an operand is missing before " + quoted(f, at));
  if (f.tokens[at - 1].is("(") && here.is(")")) return error("there is nothing in these parentheses");
  const bool end = here.kind == Kind::end;
  return error((end ? "the formula ends where an operand is missing" : "an operand is missing") +
               (" after " + quoted(f, at - 1)));
}

SyntaxError stray_comma(const Formula& f, std::size_t at) {
  const auto is_number = [&](std::size_t k) { return f.tokens[k].kind == Kind::number; };
  if (at == 0 || !is_number(at - 1) || !is_number(at + 1))
    return {"syntax", f.tokens[at].position, "a comma can only stand between the arguments of a function"};
  return {"syntax", f.tokens[at].position,
          "a decimal number is written with a point: " + f.tokens[at - 1].text + "." + f.tokens[at + 1].text};
}

}  // namespace rederive
