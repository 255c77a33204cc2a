// What the lessons are made of: sentences with mathematics in them, and the formats they are written in.
#include <doctest/doctest.h>

#include <derivations/language/functions.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <regex>
#include <tests/block.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::page;
using namespace rederive::test;

TEST_CASE("paragraphs are parted by blank lines, and white space inside them does not matter") {
  CHECK(paragraphs("  one\n  two \n\n three ") == std::vector<std::string>{"one two", "three"});
  CHECK(paragraphs(" \n\n ").empty());
}

TEST_CASE("a sentence is taken apart at its marks") {
  const auto parts = spans("Put $theta = 0$ into `ledger` *now*.");
  REQUIRE(parts.size() == 7);
  CHECK(parts[1].kind == Span::Kind::math);
  CHECK(parts[1].text == "theta = 0");
  CHECK(parts[3].kind == Span::Kind::code);
  CHECK(parts[5].kind == Span::Kind::emphasis);
  CHECK_THROWS_AS(spans("an open $mark"), std::invalid_argument);
}

TEST_CASE("a sentence may hold links, and any text as a part in which nothing is a mark") {
  const auto parts = spans("See [lesson 1](one.html), for x in [0, 1].");
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].kind == Span::Kind::link);
  CHECK(parts[1].text == "lesson 1");
  CHECK(parts[1].target == "one.html");
  CHECK(parts[2].text == ", for x in [0, 1].");
  const std::string hostile = "$x * `y` [z](http://evil) \\$ \\";
  REQUIRE(spans(literal(hostile)).size() == 1);
  CHECK(spans(literal(hostile))[0].text == hostile);
  REQUIRE(spans("`" + literal(hostile) + "`").size() == 1);
  CHECK(spans("`" + literal(hostile) + "`")[0].text == hostile);
}

TEST_CASE("a page says the same in every format") {
  const std::vector<Passage> passages{
      Heading{"Heading *one*", 1},
      Paragraph{"A sentence about $theta$ with a [link](page.html)."},
      Formula{parse_relation("theta <= alpha"), "71"},
      Findings{"Right or wrong",
               {{.label = "why", .words = "it is *so*"}, {.label = "", .verbatim = "a\n ^"}},
               "said"},
      Table{{"left", "right"}, {{"cell", "$alpha$"}}},
      Commands{{"ledger show 71"}},
      BulletList{{"item one", "item two"}},
      Theorem{"71", "Theorem t.\n", "`t` in `T.v`"},
      Buttons{"Press or ", {{"go", "go on"}}},
      ExerciseForm{
          "its-id", "Its title", "open", {Paragraph{"What is $m$?"}}, {{"a", "mass"}, {"b", "metre"}}}};
  const std::vector<std::string> words{
      "The title",      "About",    "Heading",   "A sentence",     "71",
      "Right or wrong", "why",      "cell",      "ledger show 71", "item two",
      "lemma of Coq",   "Press or", "Its title", "What is",        "metre"};
  for (const Format format :
       {Format::unicode, Format::plain, Format::latex, Format::markdown, Format::notebook, Format::html}) {
    CAPTURE(static_cast<int>(format));
    const std::string page = rendered({"The title", {{"About", "itself"}}}, passages,
                                      {.paper = rederive::rocking_block::paper(), .format = format});
    for (const std::string& part : words) CHECK_MESSAGE(page.find(part) != std::string::npos, part);
  }
}

TEST_CASE("mathematics in a sentence is printed in each notation") {
  CHECK(print_inline("theta < 0", Notation::unicode, paper_symbols()) == "θ < 0");
  CHECK(print_inline("u_gddot", Notation::latex, paper_symbols()) == "\\ddot u_g");
  CHECK_THROWS_AS(print_inline("theta < ", Notation::plain, paper_symbols()), SyntaxError);
}

TEST_CASE("the pieces of a formula, joined, are the formula") {
  const Relation relation = parse_relation("K = 1/2*J_o*thetadot^2 - m*g*R*(sin(alpha) - 1) + m*u_gdot");
  const auto text = [](const Piece& piece) { return print(piece, Notation::plain, paper_symbols()); };
  CHECK(joined(pieces(relation), " ", text) == print(relation));
  CHECK(pieces(relation).size() == 4);
}

TEST_CASE("words without marks get them where a name can be nothing else") {
  CHECK(marked("the dots over u_g are lost", rederive::rocking_block::paper()) ==
        "the dots over $u_g$ are lost");
  CHECK(marked("cos(alpha - theta) is a cosine", rederive::rocking_block::paper()) ==
        "$cos(alpha - theta)$ is a cosine");
  CHECK(marked("a*b `c` and a_word", rederive::rocking_block::paper()) == "a·b 'c' and a_word");
}

TEST_CASE("lines are wrapped by columns, not by bytes") {
  CHECK(columns("θ̈ = 0") == 5);
  const std::string text = wrap("θθθθ θθθθ θθθθ", 9, "", "  ");
  CHECK(text == "θθθθ θθθθ\n  θθθθ\n");
  CHECK(wrap(glued("a b c d") + " e", 5, "", "") == "a b c d\ne\n");
}

TEST_CASE("plain text is ASCII") {
  CHECK(to_ascii("α − θ ≤ π", paper_symbols()) == "alpha - theta <= pi");
  CHECK(to_ascii("θ̈ and ü_g, θ̇₊", paper_symbols()) == "thetaddot and u_gddot, thetadot_plus");
  CHECK_THROWS_AS(to_ascii("漢", paper_symbols()), std::invalid_argument);
}

namespace {

std::string mathml_of(const std::string& text) {
  return mathml(parse_statement(text, paper_symbols()), paper_symbols());
}

/// The tags of a text that are not closed in order, or closed without being open.
std::vector<std::string> unbalanced(const std::string& text) {
  static const std::regex tag("<(/?)([a-z]+)[^<>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator at(text.begin(), text.end(), tag), end; at != end; ++at) {
    if ((*at)[3].length() > 0 || (*at)[2] == "wbr") continue;
    if ((*at)[1].length() == 0)
      open.push_back((*at)[2]);
    else if (!open.empty() && open.back() == (*at)[2])
      open.pop_back();
    else
      return {"/" + (*at)[2].str()};
  }
  return open;
}

}  // namespace

TEST_CASE("a tree becomes MathML with the same structure") {
  CHECK(mathml_of("1/2*m") ==
        "<math><mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac><mi>m</mi></math>");
  CHECK(mathml_of("omega_p^2") ==
        "<math><msubsup><mi>ω</mi><mrow><mi>p</mi></mrow><mrow><mn>2</mn></mrow></msubsup></math>");
  CHECK(mathml_of("m < 2").find("<mo>&lt;</mo>") != std::string::npos);
  CHECK(mathml_of("1e-3*m") ==
        "<math><mn>1</mn><mo>·</mo><msup><mn>10</mn><mrow><mo form=\"prefix\">−</mo><mn>3</mn></mrow></msup>"
        "<mi>m</mi></math>");
  CHECK(mathml_of("m*2^3") ==
        "<math><mi>m</mi><mo>·</mo><msup><mn>2</mn><mrow><mn>3</mn></mrow></msup></math>");
  CHECK(mathml_of("sin(m)^2").starts_with("<math><msup><mi>sin</mi>"));
  CHECK(mathml_of("atan(m)").starts_with("<math><mi>arctan</mi>"));
  CHECK(mathml_of("asinh(m)").starts_with("<math><mi>arsinh</mi>"));
  CHECK(mathml_of("(m/2)^2").find("stretchy=\"true\"") != std::string::npos);
  CHECK(mathml_of("(m + 2)^2").find("stretchy=\"false\"") != std::string::npos);
}

TEST_CASE("a symbol becomes MathML as it is written in Unicode") {
  const std::string theta = "<mover accent=\"true\"><mi>θ</mi><mo stretchy=\"false\">¨</mo></mover>";
  CHECK(mathml_of("thetaddot") == "<math>" + theta + "</math>");
  CHECK(mathml_of("thetaddot_ex") ==
        "<math><msub>" + theta + "<mrow><mi mathvariant=\"normal\">ex</mi></mrow></msub></math>");
  CHECK(mathml_of("theta_to") ==
        "<math><msub><mi>θ</mi><mrow><msub><mi>t</mi><mrow><mi>o</mi></mrow></msub>"
        "</mrow></msub></math>");
  CHECK(mathml_of("dK_dtheta") ==
        "<math><mfrac><mrow><mi>∂</mi><mi>K</mi></mrow><mrow><mi>∂</mi><mi>θ</mi>"
        "</mrow></mfrac></math>");
  CHECK(mathml_of("t_star") == "<math><msup><mi>t</mi><mrow><mo>*</mo></mrow></msup></math>");
}

TEST_CASE("every function, every symbol and every printed row has MathML, of which all elements are closed") {
  std::vector<std::string> texts = paper_symbols().names();
  for (const Function& function : functions()) {
    const std::string call = std::string(function.name) + "(theta)";
    for (const std::string& text : {call, call + "^2", "2^" + call, "1e-3*" + call + "/m"})
      texts.push_back(text);
  }
  for (const auto& row : read_rows(equations_file()))
    if (!row.printed.empty()) texts.push_back(row.printed);
  CHECK(texts.size() > 300);
  for (const std::string& text : texts) {
    CAPTURE(text);
    CHECK(mathml_of(text).size() > 20);
    CHECK(unbalanced(mathml_of(text)) == std::vector<std::string>());
    CHECK(unbalanced(formula_html(parse_statement(text, paper_symbols()), paper_symbols())) ==
          std::vector<std::string>());
    CHECK_NOTHROW(to_ascii(print_inline(text, Notation::unicode, paper_symbols()), paper_symbols()));
  }
}

TEST_CASE("special cases are put into derived and printed equations alike") {
  const Page page(rederive::rocking_block::paper());
  CHECK(print(page.derived_with("13", {{"theta", "0"}})) == "y_c = 0");
  CHECK(page.number_of(page.derived("46b").right, {{"alpha", "pi/2"}}) == doctest::Approx(-0.5));
  CHECK_THROWS_AS(page.number_of(page.derived("46b").right), std::invalid_argument);
  CHECK_THROWS_AS(page.derived("999"), std::out_of_range);
  CHECK_THROWS_AS(judged(page.paper(), "999"), std::out_of_range);
}

TEST_CASE("a step that is on the page already is left out only on the way to the same formula") {
  using rederive::mechanics::Derivation;
  const auto& symbols = rederive::rocking_block::paper().symbols;
  const GiNaC::ex alpha = symbols["alpha"], g = symbols["g"];
  const auto from = [&](const GiNaC::ex& result) {
    Derivation derivation;
    derivation.left = alpha;
    derivation.right = result;
    derivation.steps = {{"Resolve the forces", 0, 0}, {"Hence", alpha, result}};
    return derivation;
  };
  Page page(rederive::rocking_block::paper());
  std::vector<std::size_t> counts;
  for (const GiNaC::ex& result : {g, GiNaC::ex(2 * g), g}) {
    page.argue(from(result));
    counts.push_back(page.blocks().size());
  }
  const auto words = [&](std::size_t at) { return std::get<Paragraph>(page.blocks().at(at)).text; };
  REQUIRE(counts == std::vector<std::size_t>{2, 4, 6});
  CHECK(words(0) == "Resolve the forces. Hence");
  CHECK(words(2) == words(0));
  CHECK(words(4) == "Hence");
}
