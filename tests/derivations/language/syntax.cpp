// Texts that are read, with their values, and texts that are refused with the place and what was meant.
#include <doctest/doctest.h>

#include <derivations/paper/prove.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::test;
using Text = std::string;

namespace {

/// Returns the error in which reading and lowering end, if any.
std::optional<SyntaxError> error_in(const Text& text, const Limits& limits = {}) {
  try {
    for (const Tree& side : parse_statement(text, paper_symbols(), limits).sides) lower(side);
    return std::nullopt;
  } catch (const SyntaxError& error) {
    return error;
  }
}

/// Returns "note@position message"; "" if there is no error.
Text error_of(const Text& text, const Limits& limits = {}) {
  const auto error = error_in(text, limits);
  return error ? word_of(error->mistake) + "@" + std::to_string(error->position) + " " + error->what() : "";
}

Text repeated(const Text& text, std::size_t times) {
  Text result;
  while (times-- > 0) result += text;
  return result;
}

}  // namespace

TEST_CASE("values: what binds to what, exact numbers, and functions that are quotients of others") {
  each_case("values", [](Text text, Text value) { CHECK(lower(parse(text)) == lower(parse(value))); });
  each_case("real", [](Text text) { CHECK_NOTHROW(parse(print(lower(parse(text))))); });
  CHECK(error_of("exp(10^30) + sin(10^30) + log(10^30)") == "");  // large is not undefined
}

TEST_CASE("the tree keeps the form as written") {
  const Tree factored = parse("2*(x + y)");
  CHECK(factored->kind == Node::Kind::product);
  CHECK(factored->children[1]->kind == Node::Kind::sum);
  CHECK(parse("x/x")->kind == Node::Kind::product);
  CHECK(parse("0.50")->text == "0.50");
  CHECK(parse("-m*g*R")->kind == Node::Kind::negative);
  CHECK(parse("a_p + x")->children[1]->position == 6);
  CHECK(parse("2*Pi - ψ")->children[0]->children[1]->text == "pi");
}

TEST_CASE("Unicode reads as ASCII does") {
  each_case("unicode", [](Text text, Text ascii) { CHECK(is_same(parse(text), parse(ascii))); });
  CHECK(error_of("½") != "");
  CHECK(print(parse_relation("α_p ≥ g·tan(α)")) == "a_p >= g*tan(alpha)");
}

TEST_CASE("relations and chains") {
  const Relation chain = parse_relation("K = x + y <= 3");
  CHECK(chain.sides.size() == 3);
  CHECK(chain.operators == std::vector<Text>{"=", "<="});
  CHECK(parse_statement("x").operators.empty());
  CHECK_THROWS_AS(parse_relation("x + y"), SyntaxError);
  CHECK_THROWS_AS(parse("x = y"), SyntaxError);
}

TEST_CASE("what cannot be read is refused with its place and what was meant") {
  each_case("refused", [](Text text, Text note, Text position, Text says) {
    const Text error = error_of(text);
    CHECK_MESSAGE(error.starts_with(note + "@" + position + " "), error);
    CHECK_MESSAGE(error.find(says) != Text::npos, error);
  });
  Symbols mine = paper_symbols();
  CHECK_THROWS_WITH(mine.declare({"Pi", "P", "P", "1", all_numbers, "", ""}), doctest::Contains("'Pi'"));
}

TEST_CASE("bounds come before anything expensive, and are the caller's") {
  const std::pair<Text, const char*> long_texts[] = {
      {Text(5000, '('), "too_deep@200 "},        {Text(9999, '-') + "x", "too_deep@"},
      {Text(10'001, 'x'), "too_long@10000 "},    {Text(10'000'000, 'x'), "too_long@"},
      {repeated("9^", 3000) + "9", "too_deep@"}, {"(9^64)^64" + repeated("+1/(7^64)^63", 700), "too_large@"}};
  for (const auto& row : long_texts) CHECK(error_of(row.first).starts_with(row.second));
  const Limits wide{.depth = 1'000'000, .digits = 100, .exponent = 1000}, tight{.characters = 5};
  CHECK_NOTHROW(parse("x^1000 + 1e99", paper_symbols(), wide));
  CHECK(error_of(Text(9'000, '('), wide).starts_with("too_deep@"));  // the stack has its own bound
  CHECK(error_of("x+y+x", tight) == "");
  CHECK(error_of("θ̇+θ̇+θ̇", tight).starts_with("too_long@"));
}

TEST_CASE("bytes that are not text are pointed at") {
  for (const Text& text : {Text("x+\0y", 4), Text("x+\xff"), Text("x+\xc3"), Text("x+\xed\xa0\x80"),
                           Text("x+\xc0\xaf")})  // half of a surrogate pair, and '/' in two bytes
    CHECK(error_of(text).starts_with("character@2 "));
  for (const char* text : {"x + \u200b", "x + é"})  // a space without width
    CHECK(error_of(text).starts_with("character@4 "));
}

TEST_CASE("errors show the line with a caret under the character") {
  const auto explained = [](const Text& text) {
    return explain(error_in(text).value(), text, paper_symbols());
  };
  each_case("explained", [&](Text text, Text shown) { CHECK(explained(text) == shown); });
  CHECK(explained(Text(5000, ' ') + "2x").size() < 400);
}

TEST_CASE("no text of any kind does anything but parse or point: 20,000 random texts") {
  Choices random(20'260'711);
  Cells pieces = cases("pieces")[0];
  pieces.push_back("\xff");
  int parsed = 0;
  for (int i = 0; i < 20'000; ++i) {
    Text text;
    for (auto n = random.below(12); n > 0; --n) text += random.pick(pieces);
    CAPTURE(text);
    const auto error = error_in(text);
    parsed += error ? 0 : 1;
    if (!error) continue;
    REQUIRE(error->position <= text.size());
    REQUIRE_FALSE(explain(*error, text).empty());
  }
  CHECK(parsed > 100);
}
