#include <doctest/doctest.h>

#include <derivations/paper/prove.hpp>
#include <random>
#include <tests/block.hpp>

using namespace rederive;

namespace {

/// "note@position message" of the error that reading and lowering ends in; "" if there is none.
std::string error_of(const std::string& text, const Limits& limits = {}) {
  try {
    for (const Tree& side : parse_statement(text, paper_symbols(), limits).sides) lower(side);
    return "";
  } catch (const SyntaxError& error) {
    return error.note + "@" + std::to_string(error.position) + " " + error.what();
  }
}

struct Refused {
  std::string text, note;
  std::size_t position;
  const char* says;
};

void check_refused(const std::vector<Refused>& table) {
  for (const Refused& row : table) {
    CAPTURE(row.text);
    const std::string error = error_of(row.text);
    CHECK_MESSAGE(error.starts_with(row.note + "@" + std::to_string(row.position) + " "), error);
    CHECK_MESSAGE(error.find(row.says) != std::string::npos, error);
  }
}

GiNaC::ex value(const std::string& text) { return lower(parse(text)); }

}  // namespace

TEST_CASE("binding: powers to the right, a minus after powers, quotients from left to right") {
  CHECK(value("2^3^2") == 512);
  CHECK(value("(2^3)^2") == 64);
  CHECK(value("-3^2") == -9);
  CHECK(value("2^-1") == GiNaC::numeric(1, 2));
  CHECK(value("2**3**2") == 512);
  CHECK(value("-3**2*2**-1") == GiNaC::numeric(-9, 2));
  CHECK(value("12/2/3") == 2);
  CHECK(value("12/2*3") == 18);
  CHECK(value("1-2-3") == -4);
  CHECK(value("-2*3+10") == 4);
  CHECK(value("2*-3") == -6);
  CHECK(value("+3--2") == 5);
}

TEST_CASE("the tree keeps the form as written") {
  const Tree factored = parse("2*(x + y)");
  CHECK(factored->kind == Node::Kind::product);
  CHECK(factored->children[1]->kind == Node::Kind::sum);
  CHECK(parse("x/x")->kind == Node::Kind::product);
  CHECK(parse("0.50")->text == "0.50");
  CHECK(parse("-m*g*R")->kind == Node::Kind::negative);
  CHECK(parse("a_p + x")->children[1]->position == 6);
}

TEST_CASE("Unicode reads as ASCII does") {
  const std::vector<std::pair<const char*, const char*>> same = {
      {"θ̇", "thetadot"},         // a combining dot above
      {"θ̈", "thetaddot"},        // a combining diaeresis
      {"u\u0308_g", "u_gddot"},  // u, diaeresis, _g
      {"ü_g", "u_gddot"},        // precomposed
      {"u_g\u0307", "u_gdot"},   // the dot at the end
      {"ẋ_c + ÿ_c", "x_cdot + y_cddot"},
      {"θ̇₀/p", "thetadot_0/p"},
      {"α_p", "a_p"},  // the paper's letter
      {"Ā₁ − A₁", "Abar_1 - A_1"},
      {"θ̇⁻", "thetadot_minus"},
      {"θ⁻¹", "theta^(-1)"},
      {"m·g×R⋅x∕y÷r", "m*g*R*x/y/r"},
      {"½", ""},
      {"√2", "sqrt(2)"},
      {"√(x+1)²", "sqrt(x+1)^2"},
      {"sin²(α) + cos²(α)", "sin(alpha)^2 + cos(alpha)^2"},
      {"x²³", "x^23"},
      {"µ", "mu"},  // the micro sign
      {"2·π − ψ", "2*pi - psi"},
      {"ϕ + Ω", "phi + Omega"},
      {"x\u00A0+\u2009y", "x + y"},  // other spaces
      {"t* + θ_*", "t_star + theta_star"},
      {"(t*)^2 - t* - x", "t_star^2 - t_star - x"},
      {"t*x + t*(1+x) + t* (2)", "t*x + t*(1+x) + t*(2)"},  // the star is a product's
      {"t*-x", "t*(-x)"},
  };
  for (const auto& [its_unicode, ascii] : same) {
    const auto& unicode = its_unicode;
    CAPTURE(unicode);
    const bool is_refused = *ascii == '\0';
    CHECK((is_refused ? error_of(unicode) != "" : print(parse(unicode)) == print(parse(ascii))));
  }
  CHECK(print(parse_relation("α_p ≥ g·tan(α)")) == "a_p >= g*tan(alpha)");
}

TEST_CASE("relations and chains") {
  const Relation chain = parse_relation("K = x + y <= 3");
  CHECK(chain.sides.size() == 3);
  CHECK(chain.operators == std::vector<std::string>{"=", "<="});
  CHECK(parse_statement("x").operators.empty());
  CHECK_THROWS_AS(parse_relation("x + y"), SyntaxError);
  check_refused({{"(x = y)", "relation", 3, "inside parentheses"}, {"x =", "syntax", 3, "'='"}});
  try {
    parse("x = y");
    FAIL("an equation is no expression");
  } catch (const SyntaxError& error) {
    CHECK(error.note == "relation");
    CHECK(error.position == 2);
  }
}

TEST_CASE("a product without its sign is refused with what was meant") {
  check_refused(
      {{"2x", "implicit_multiplication", 1, "2*x"},
       {"sin x", "implicit_multiplication", 0, "sin(x)"},
       {"x y", "implicit_multiplication", 2, "x*y"},
       {"m(b+h)", "implicit_multiplication", 1, "m*(b + h)"},
       {"(x+1)(x-1)", "implicit_multiplication", 5, "(x + 1)*(x - 1)"},
       {"sin(x)cos(y)", "implicit_multiplication", 6, "sin(x)*cos(y)"},
       {"mgR", "implicit_multiplication", 0, "m*g*R"},
       {"αp/e", "implicit_multiplication", 0, "write alpha*p/e"},
       {"2 sin(x)", "implicit_multiplication", 2, "2*sin(x)"},
       {"2e", "implicit_multiplication", 1, "2*e"},
       {"3 4", "implicit_multiplication", 2, "may be a sum"},
       {"3/2 sin^2(alpha)", "implicit_multiplication", 4, "write 3/2*sin(alpha)^2"},
       {"1 - 3/2 sin²alpha", "implicit_multiplication", 8, "write 1 - 3/2*sin(alpha)^2"},
       {"4/3mR^2", "implicit_multiplication", 3, "write 4/3*m*R^2"},
       {"m g R", "implicit_multiplication", 2, "write m*g*R"},
       {"theta^2/2g", "implicit_multiplication", 9, "write theta^2/(2*g) or theta^2/2*g"},
       {"sin 2x", "implicit_multiplication", 0, "write sin(2*x)"},
       {"sin p t cos(theta)", "implicit_multiplication", 0, "write sin(p*t)"},
       {"sin2x", "implicit_multiplication", 0, "write sin(2*x)"},
       {"cosα", "implicit_multiplication", 0, "write cos(alpha)"},
       {"sqrt2", "implicit_multiplication", 0, "write sqrt(2)"},
       {"x - y/r cos(t)", "implicit_multiplication", 8, "write x - y/(r*cos(t)) or x - y/r*cos(t)"},
       {"m*(x - y/r t)", "implicit_multiplication", 11, "write m*(x - y/(r*t)) or m*(x - y/r*t)"},
       {"2x/3 m y = g t", "implicit_multiplication", 1, "write 2*x/(3*m*y) = g*t or 2*x/3*m*y = g*t"},
       {"x/(2 y) cos(t)", "implicit_multiplication", 5, "write x/((2*y)*cos(t)) or x/(2*y)*cos(t)"},
       {"1 1/3*m", "implicit_multiplication", 2, "may be a sum, as in 1 1/2, or a product"},
       {"pi r", "implicit_multiplication", 3, "pi*r"}});
  const auto said = [](const std::string& text) {
    try {
      (void)parse(text, paper_symbols());
    } catch (const SyntaxError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  for (const char* open :
       {"m*cos theta - x", "sin x^2", "cos alpha/2", "sin alpha (x + y)", "1 - sin alpha + x y"})
    CHECK_MESSAGE(said(open).find("write") == std::string::npos, said(open));  // where does the argument end?
}

TEST_CASE("unknown names come with the nearest known one") {
  check_refused({{"thta", "unknown_symbol", 0, "'theta'"},
                 {"x + omgea_p", "unknown_symbol", 4, "'omega_p'"},
                 {"Theta_0", "unknown_symbol", 0, "'theta_0'"},
                 {"snh(x)", "unknown_function", 0, "'sinh'"},
                 {"ln(x)", "unknown_function", 0, "'log'"},
                 {"arctan(x)", "unknown_function", 0, "'atan'"},
                 {"Sin(x)", "unknown_function", 0, "'sin'"},
                 {"qqqqqq", "unknown_symbol", 0, "'qqqqqq'"}});
}

TEST_CASE("slips of other languages are named") {
  check_refused({{"x == 2", "syntax", 2, "'='"},
                 {"x =< 2", "syntax", 2, "'<='"},
                 {"x ≠ 2", "syntax", 2, "≠"},
                 {"[x + y]*2", "syntax", 0, "'('"},
                 {"0,25", "syntax", 1, "0.25"},
                 {"sin^2(x)", "syntax", 0, "sin(x)^2"},
                 {"sin²x", "syntax", 0, "sin(x)^2"},
                 {"sin⁻¹(x)", "syntax", 3, "asin"},
                 {"tan^-1(x)", "syntax", 3, "atan"},
                 {"arcsin x", "unknown_function", 0, "asin"},
                 {"log10(x)", "unknown_function", 0, "log(x)/log(10)"},
                 {"x > 0 and y > 0", "syntax", 6, "one statement"},
                 {"x < inf", "unknown_symbol", 4, "infinity"},
                 {"\\alpha", "syntax", 0, "LaTeX"},
                 {"1.2.3", "syntax", 0, "decimal point"},
                 {"fabs(x, y)", "arguments", 0, "1 argument, not 2"},
                 {"pow(x)", "arguments", 0, "2 arguments, not 1"},
                 {"sin()", "arguments", 0, "not 0"},
                 {"sin", "syntax", 0, "sin(x)"}});
}

TEST_CASE("what is missing is pointed at") {
  check_refused({{"", "empty", 0, "no formula"},
                 {"   ", "empty", 3, "no formula"},
                 {"x +", "syntax", 3, "after '+'"},
                 {"*x", "syntax", 0, "before '*'"},
                 {"(x + y", "syntax", 0, "never closed"},
                 {"x + y)", "syntax", 5, "closes nothing"},
                 {"()", "syntax", 1, "nothing in these"},
                 {"²", "syntax", 0, "exponent"},
                 {"x^", "syntax", 2, "after '^'"},
                 {"x²^3", "syntax", 3, "parentheses"}});
}

TEST_CASE("pi may be written Pi; other look-alikes of it are refused") {
  CHECK(value("Pi") == GiNaC::Pi);
  CHECK(value("sin(Pi/6)") == GiNaC::numeric(1, 2));
  CHECK(parse("2*Pi - ψ")->children[0]->children[1]->text == "pi");
  check_refused({{"2*PI", "unknown_symbol", 2, "'PI' is not a symbol here: the constant is written pi"},
                 {"pI/2", "unknown_symbol", 0, "written pi"},
                 {"sin(Π/2)", "unknown_symbol", 4, "'Π' is not a symbol here: the constant is written pi"}});
  Symbols mine = paper_symbols();
  CHECK_THROWS_WITH(mine.declare({"Pi", "P", "P", "1", all_numbers, "", ""}), doctest::Contains("'Pi'"));
}

TEST_CASE("undefined values are refused where they arise") {
  check_refused({{"x + 1/0", "undefined", 6, "zero"},
                 {"1/(x - x)", "undefined", 3, "zero"},
                 {"log(0)", "undefined", 0, ""},
                 {"0^(-1)", "undefined", 0, "zero"},
                 {"0^0", "undefined", 0, "0^0"},
                 {"tan(pi/2)", "undefined", 0, ""},
                 {"x*cot(0)", "undefined", 2, ""},
                 {"sqrt(-1)^2", "undefined", 0, "real"},
                 {"(-8)^(1/3)", "undefined", 0, "negative"},
                 {"log(-2)", "undefined", 0, "real"},
                 {"asin(2)*0", "undefined", 0, "real"}});
}

TEST_CASE("large is not undefined") { CHECK(error_of("exp(10^30) + sin(10^30) + log(10^30)") == ""); }

TEST_CASE("bounds come before anything expensive") {
  check_refused({{"1e999999999", "too_large", 0, "40 digits"},
                 {"1e-999999999", "too_large", 0, "40 digits"},
                 {"x^65", "too_large", 2, "64"},
                 {"x^-65", "too_large", 2, "64"},
                 {"x⁹⁹⁹⁹⁹⁹⁹⁹⁹", "too_large", 1, "64"},
                 {"x^(60+60)", "too_large", 3, "64"},
                 {"(x^60)^60", "too_large", 7, "64"},
                 {"((10^64)^64)^64", "too_large", 0, "large"},
                 {"9^9^9", "too_large", 2, "64"}});
  CHECK(error_of(std::string(5000, '(')).starts_with("too_deep@200 "));
  CHECK(error_of(std::string(9999, '-') + "x").starts_with("too_deep@"));
  CHECK(error_of(std::string(10'001, 'x')).starts_with("too_long@10000 "));
  CHECK(error_of(std::string(10'000'000, 'x')).starts_with("too_long@"));
  std::string tower;
  for (int i = 0; i < 3000; ++i) tower += "9^";
  CHECK(error_of(tower + "9").starts_with("too_deep@"));
  std::string bombs = "(9^64)^64";
  while (bombs.size() < 9000) bombs += "+1/(7^64)^63";
  CHECK(error_of(bombs).starts_with("too_large@"));
}

TEST_CASE("bounds are the caller's") {
  Limits wide;
  wide.exponent = 1000;
  wide.digits = 100;
  wide.depth = 1'000'000;
  CHECK_NOTHROW(parse("x^1000 + 1e99", paper_symbols(), wide));
  CHECK(error_of(std::string(9'000, '('), wide).starts_with("too_deep@"));  // the stack has its own bound
  Limits tight;
  tight.characters = 5;
  CHECK(error_of("x+y+x", tight) == "");
  CHECK(error_of("θ̇+θ̇+θ̇", tight).starts_with("too_long@"));
}

TEST_CASE("bytes that are no text are pointed at") {
  CHECK(error_of(std::string("x+\0y", 4)).starts_with("character@2 "));
  CHECK(error_of("x+\xff").starts_with("character@2 "));
  CHECK(error_of("x+\xc3").starts_with("character@2 "));
  CHECK(error_of("x+\xed\xa0\x80").starts_with("character@2 "));  // half of a surrogate pair
  CHECK(error_of("x+\xc0\xaf").starts_with("character@2 "));      // '/' in two bytes
  CHECK(error_of("x + \u200b").starts_with("character@4 "));      // a space of no width
  CHECK(error_of("x + é").starts_with("character@4 "));
}

TEST_CASE("errors show the line with a caret under the character") {
  const auto explained = [](const std::string& text) {
    try {
      parse(text);
      return std::string();
    } catch (const SyntaxError& error) {
      return explain(error, text);
    }
  };
  CHECK(explained("θ̇ + 2x") == "a product needs its '*': write thetadot + 2*x\n  θ̇ + 2x\n       ^");
  CHECK(explained("x +\ny + thta\n- x") ==
        "there is no symbol 'thta': did you mean 'theta'?\n  y + thta\n      ^");
  CHECK(explained(std::string("x\0", 2)) == "there is an invisible control character here\n  x?\n   ^");
  const std::string far = explained(std::string(5000, ' ') + "2x");
  CHECK(far.size() < 400);
}

TEST_CASE("no text of any kind does anything but parse or point") {
  constexpr unsigned seed = 20'260'711;
  MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  const std::vector<std::string> pieces = {"x",   "theta", "θ̇",  "m",    "sin", "(",   ")",      "+",    "-",
                                           "*",   "/",     "^",  "1",    "0",   "0.5", "e9",     "²",    ",",
                                           "=",   " ",     "√",  "pi",   "log", "u_g", "\u0308", "\xff", "⁻",
                                           "tan", "fabs(", "64", "asin", "[",   "≤"};
  int parsed = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (auto n = random() % 12; n > 0; --n) text += pieces[random() % pieces.size()];
    CAPTURE(text);
    try {
      for (const Tree& side : parse_statement(text).sides) lower(side);
      ++parsed;
    } catch (const SyntaxError& error) {
      REQUIRE(error.position <= text.size());
      REQUIRE_FALSE(explain(error, text).empty());
    }
  }
  CHECK(parsed > 100);
}
