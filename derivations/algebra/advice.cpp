#include <derivations/algebra/advice.hpp>
#include <derivations/algebra/functions.hpp>

namespace rederive {

namespace {

constexpr std::size_t longest_text = 40;  // that is repeated in a message

std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

}  // namespace

bool starts_operand(const Token& token) {
  return token.kind == Token::Kind::number || token.kind == Token::Kind::name || token.is("(") ||
         token.is("sqrt");
}

SyntaxError Advice::error(const char* note, const std::string& message, std::size_t at) const {
  return {note, tokens_[at].position, message};
}

/// The text of some tokens, if it is short enough to be repeated.
std::string Advice::written(std::size_t first, std::size_t last) const {
  const std::size_t start = tokens_[first].position, size = tokens_[last].end - start;
  return size <= longest_text ? std::string(text_.substr(start, size)) : "…";
}

bool Advice::is_function(std::size_t at) const {
  return tokens_[at].kind == Token::Kind::name && arity(tokens_[at].text) > 0;
}

/// A parenthesis up to where it is closed.
Advice::Meant Advice::group(std::size_t opening) const {
  std::size_t last = opening;
  for (int open = 1; open > 0 && tokens_[last + 1].kind != Token::Kind::end;) {
    ++last;
    open += tokens_[last].is("(") ? 1 : tokens_[last].is(")") ? -1 : 0;
  }
  const std::string text = written(opening, last);
  return {text == "…" ? "(…)" : text, last + 1};
}

/// sin(x), sin^2(x), sin x, sin 2x: the parentheses around the argument, the exponent behind them.
Advice::Meant Advice::call(std::size_t function) const {
  const std::string& name = tokens_[function].text;
  std::size_t next = function + 1;
  std::string power;
  if (tokens_[next].kind == Token::Kind::superscript) power = "^" + tokens_[next++].text;
  if (tokens_[next].is("^") && tokens_[next + 1].kind == Token::Kind::number) {
    power = "^" + tokens_[next + 1].text;
    next += 2;
  }
  Meant argument{"(x)", next};
  if (tokens_[next].is("(")) {
    argument = group(next);
  } else if (is_function(next) || tokens_[next].is("sqrt")) {
    argument.text = "(…)";  // sin cos x
  } else if (starts_operand(tokens_[next])) {
    argument = factors(next);
    argument.text = "(" + argument.text + ")";
  }
  return {name + argument.text + power, argument.next};
}

/// What begins at a token: a number, a name, a call or a parenthesis, and its exponent.
Advice::Meant Advice::operand(std::size_t at) const {
  const Token& token = tokens_[at];
  Meant meant{written(at, at), at + 1};
  if (is_function(at))
    meant = call(at);
  else if (token.is("("))
    meant = group(at);
  else if (token.is("sqrt") && starts_operand(tokens_[at + 1]) && !tokens_[at + 1].is("sqrt"))
    meant = operand(at + 1), meant.text = "√" + meant.text;
  else if (token.kind == Token::Kind::name && token.text != "pi" && symbols_.find(token.text) == nullptr &&
           meant.text == token.text)
    if (const std::string product = split_into_symbols(token.text, symbols_); !product.empty())
      meant.text = product;
  if (tokens_[meant.next].kind == Token::Kind::superscript)
    meant.text += written(meant.next, meant.next), ++meant.next;
  if (tokens_[meant.next].is("^")) {
    const std::size_t exponent = meant.next + (tokens_[meant.next + 1].is("-") ? 2 : 1);
    if (tokens_[exponent].kind == Token::Kind::number || tokens_[exponent].kind == Token::Kind::name) {
      meant.text += written(meant.next, exponent);
      meant.next = exponent + 1;
    }
  }
  return meant;
}

/// The argument of a function without parentheses: 2x in sin 2x cos y, 2*x in sin 2*x.
Advice::Meant Advice::factors(std::size_t at) const {
  Meant all = operand(at);
  const auto is_symbol = [&](std::size_t k) {
    return tokens_[k].kind == Token::Kind::name && !is_function(k);
  };
  const bool number = tokens_[at].kind == Token::Kind::number;
  while (all.text.size() < longest_text) {
    const bool star = number && tokens_[all.next].is("*");
    if (!is_symbol(all.next + (star ? 1 : 0))) break;
    const Meant more = operand(all.next + (star ? 1 : 0));
    all = {all.text + "*" + more.text, more.next};
  }
  return all;
}

SyntaxError Advice::juxtaposition(std::size_t product, std::size_t first, std::size_t at) const {
  if (tokens_[at].text == "and" || tokens_[at].text == "or")
    return error("syntax", "one statement at a time: '" + tokens_[at].text + "' is not read here", at);
  std::string tail = operand(first).text;
  std::size_t next = at;
  while (starts_operand(tokens_[next]) && tail.size() < longest_text) {
    const Meant more = operand(next);
    tail += "*" + more.text;
    next = more.next;
  }
  std::string head = first > product ? written(product, first - 1) : "";
  if (head == "…") head = "";
  std::string message = "a product needs its '*': write " + head + tail;
  const auto is_number = [&](std::size_t k) { return tokens_[k].kind == Token::Kind::number; };
  const bool fraction = first >= 2 && is_number(first) && is_number(first - 2) &&
                        (first == 2 || !tokens_[first - 3].is("^"));  // 3/2 x is 3/2*x; a/2g may be either
  if (head.ends_with('/') && !fraction)
    message = "a product needs its '*': write " + head + "(" + tail + ") or " + head + tail;
  return error("implicit_multiplication", message, at);
}

SyntaxError Advice::called_symbol(std::size_t name) const {
  const std::string symbol = written(name, name);
  return error(
      "implicit_multiplication",
      "'" + symbol + "' is no function: write " + symbol + "*" + group(name + 1).text + " for a product",
      name + 1);
}

SyntaxError Advice::bare_function(std::size_t function) const {
  const std::string& name = tokens_[function].text;
  const Token& next = tokens_[function + 1];
  if (next.is("^") && tokens_[function + 2].is("-"))
    return error("syntax", "this may mean 1/" + name + "(x) or a" + name + "(x): write which", function + 1);
  const std::string meant = "write " + call(function).text;
  if (next.kind == Token::Kind::superscript || next.is("^")) return error("syntax", meant, function);
  if (starts_operand(next))
    return error("implicit_multiplication", "a function needs parentheses: " + meant, function);
  return error("syntax", "a function needs its argument: " + meant, function);
}

/// "sin(2*x)" for sin2x, "sqrt(2)" for sqrt2: a function, and a number or a product that stick to it.
std::string Advice::glued_call(const std::string& name) const {
  for (std::size_t length = name.size() - 1; length > 1; --length) {
    if (arity(name.substr(0, length)) == 0) continue;
    const std::size_t letters = name.find_first_not_of("0123456789", length);
    const std::string number = name.substr(length, letters == std::string::npos ? letters : letters - length);
    std::string product =
        letters == std::string::npos ? "" : split_into_symbols(name.substr(letters), symbols_);
    if (letters != std::string::npos && product.empty()) continue;
    if (!number.empty() && !product.empty()) product = "*" + product;
    return name.substr(0, length) + "(" + number + product + ")";
  }
  return {};
}

SyntaxError Advice::unknown_name(std::size_t at) const {
  const std::string& name = tokens_[at].text;
  const std::string shown = "'" + written(at, at) + "'";
  if (name == "inf" || name == "infinity") return error("unknown_symbol", "infinity is no number", at);
  if (name == "nan" || name == "NaN") return error("unknown_symbol", shown + " is no number", at);
  if (const std::string function = nearest_function(name);
      tokens_[at + 1].is("(") || (is_foreign_function(name) && starts_operand(tokens_[at + 1])))
    return error("unknown_function", "there is no function " + shown + did_you_mean(function), at);
  if (const std::string call = name.size() < longest_text ? glued_call(name) : ""; !call.empty())
    return error("implicit_multiplication", "a function needs parentheses: write " + call, at);
  const bool is_typed = written(at, at) == name;  // of x̄, "xbar" is our spelling: no product of five letters
  const std::string near = nearest_symbol(name, symbols_),
                    product = is_typed ? split_into_symbols(name, symbols_) : "";
  constexpr std::size_t short_name = 3;  // "mgR" is a product; "thta" is a slip of the pen
  const bool is_spelt = name.size() > short_name && product.size() == 2 * name.size() - 1;  // "real": r*e*a*l
  if (is_spelt && near.empty())
    return error("unknown_symbol", "there is no symbol " + shown + "; as a product, it would be " + product,
                 at);
  if (!product.empty() && (near.empty() || name.size() <= short_name))
    return error("implicit_multiplication", "a product needs its '*': write " + product, at);
  return error("unknown_symbol", "there is no symbol " + shown + did_you_mean(near), at);
}

SyntaxError Advice::missing_operand(std::size_t at) const {
  const Token& here = tokens_[at];
  if (here.kind == Token::Kind::superscript) {
    return error("syntax", "there is nothing here that this exponent raises", at);
  }
  if (at == 0) return error("syntax", "an operand is missing before '" + written(at, at) + "'", at);
  if (tokens_[at - 1].is("(") && here.is(")"))
    return error("syntax", "there is nothing in these parentheses", at);
  const std::string after = " after '" + written(at - 1, at - 1) + "'";
  const bool end = here.kind == Token::Kind::end;
  return error("syntax",
               (end ? "the formula ends where an operand is missing" : "an operand is missing") + after, at);
}

SyntaxError Advice::stray_comma(std::size_t at) const {
  const bool between_numbers =
      at > 0 && tokens_[at - 1].kind == Token::Kind::number && tokens_[at + 1].kind == Token::Kind::number;
  if (!between_numbers)
    return error("syntax", "a comma can only stand between the arguments of a function", at);
  return error(
      "syntax",
      "a decimal number is written with a point: " + tokens_[at - 1].text + "." + tokens_[at + 1].text, at);
}

}  // namespace rederive
