#include <derivations/algebra/advice.hpp>
#include <derivations/algebra/functions.hpp>

namespace rederive {

namespace {

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
  constexpr std::size_t longest = 40;
  const std::size_t start = tokens_[first].position, size = tokens_[last].end - start;
  return size <= longest ? std::string(text_.substr(start, size)) : "…";
}

/// The operand at a token as it is written: a number, a name with its parentheses, a parenthesis.
std::string Advice::operand(std::size_t at) const {
  std::size_t last = at;
  if (arity(tokens_[at].text) > 0 && tokens_[at + 1].is("(")) ++last;
  const bool bracket = tokens_[last].is("(");
  for (int open = bracket ? 1 : 0; open > 0 && tokens_[last + 1].kind != Token::Kind::end;) {
    ++last;
    open += tokens_[last].is("(") ? 1 : tokens_[last].is(")") ? -1 : 0;
  }
  const std::string text = written(at, last);
  return bracket && text == "…" ? "(…)" : text;
}

SyntaxError Advice::juxtaposition(std::size_t first, std::size_t at) const {
  return error("implicit_multiplication",
               "a product needs its '*': write " + written(first, at - 1) + "*" + operand(at), at);
}

SyntaxError Advice::called_symbol(std::size_t name) const {
  const std::string symbol = written(name, name);
  return error(
      "implicit_multiplication",
      "'" + symbol + "' is no function: write " + symbol + "*" + operand(name + 1) + " for a product",
      name + 1);
}

SyntaxError Advice::bare_function(std::size_t function) const {
  const std::string& name = tokens_[function].text;
  std::size_t next = function + 1;
  std::string power;
  if (tokens_[next].kind == Token::Kind::superscript) power = "^" + tokens_[next++].text;
  if (tokens_[next].is("^") && tokens_[next + 1].kind == Token::Kind::number) {
    power = "^" + tokens_[next + 1].text;
    next += 2;
  }
  const bool applied = starts_operand(tokens_[next]);
  const std::string argument = applied ? operand(next) : "x";
  const std::string meant = "write " + name + (argument[0] == '(' ? argument : "(" + argument + ")") + power;
  if (!power.empty()) return error("syntax", meant, function);
  if (applied) return error("implicit_multiplication", "a function needs parentheses: " + meant, function);
  return error("syntax", "a function needs its argument: " + meant, function);
}

SyntaxError Advice::unknown_name(std::size_t at) const {
  const std::string& name = tokens_[at].text;
  const std::string shown = "'" + written(at, at) + "'";
  if (tokens_[at + 1].is("(")) {
    return error("unknown_function", "there is no function " + shown + did_you_mean(nearest_function(name)),
                 at);
  }
  const std::string near = nearest_symbol(name, symbols_), product = split_into_symbols(name, symbols_);
  constexpr std::size_t short_name = 3;  // "mgR" is a product; "thta" is a slip of the pen
  if (!product.empty() && (near.empty() || name.size() <= short_name)) {
    return error("implicit_multiplication", "a product needs its '*': write " + product, at);
  }
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
