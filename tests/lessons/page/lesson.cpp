// What the lessons are made of: sentences with mathematics in them, and the formats they are written in.
#include <doctest/doctest.h>

#include <derivations/language/functions.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <tests/block.hpp>

using namespace rederive;

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

TEST_CASE("mathematics in a sentence is printed in each notation") {
  CHECK(print_inline("theta < 0", Notation::unicode, paper_symbols()) == "θ < 0");
  CHECK(print_inline("u_gddot", Notation::latex, paper_symbols()) == "\\ddot u_g");
  CHECK_THROWS_AS(print_inline("theta < ", Notation::plain, paper_symbols()), SyntaxError);
}

TEST_CASE("the pieces of a formula, joined, are the formula") {
  const Relation relation = parse_relation("K = 1/2*J_o*thetadot^2 - m*g*R*(sin(alpha) - 1) + m*u_gdot");
  std::string joined;
  for (const auto& piece : pieces(relation, Notation::plain, paper_symbols()))
    joined += (joined.empty() ? "" : " ") + piece;
  CHECK(joined == print(relation));
  CHECK(pieces(relation, Notation::plain, paper_symbols()).size() == 4);
}

TEST_CASE("words without marks get them where a name can be nothing else") {
  CHECK(marked("the dots over u_g are lost", rocking_block::paper()) == "the dots over $u_g$ are lost");
  CHECK(marked("cos(alpha - theta) is a cosine", rocking_block::paper()) ==
        "$cos(alpha - theta)$ is a cosine");
  CHECK(marked("a*b `c` and a_word", rocking_block::paper()) == "a·b 'c' and a_word");
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

TEST_CASE("LaTeX becomes MathML with the same structure") {
  CHECK(mathml("\\frac{1}{2} m") ==
        "<math><mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac><mi>m</mi></math>");
  CHECK(mathml("\\omega_p^2").find("<msubsup><mi>ω</mi>") != std::string::npos);
  CHECK(mathml("\\ddot\\theta")
            .find("<mover accent=\"true\"><mi>θ</mi><mo stretchy=\"false\">¨</mo></mover>") !=
        std::string::npos);
  CHECK(mathml("a < b").find("&lt;") != std::string::npos);
  for (const auto* wrong : {"\\unknown", "{a", "a}", "\\left( a", "\\frac{1}"})
    CHECK_THROWS_AS(mathml(wrong), std::invalid_argument);
}

TEST_CASE("all that the LaTeX of formulas may contain becomes MathML") {
  for (const char* letter :
       {"alpha", "beta",     "gamma",   "delta",    "epsilon", "varepsilon", "zeta",   "eta",
        "theta", "vartheta", "iota",    "kappa",    "lambda",  "mu",         "nu",     "xi",
        "pi",    "rho",      "sigma",   "varsigma", "tau",     "upsilon",    "phi",    "varphi",
        "chi",   "psi",      "omega",   "Gamma",    "Delta",   "Theta",      "Lambda", "Xi",
        "Pi",    "Sigma",    "Upsilon", "Phi",      "Psi",     "Omega"}) {
    CAPTURE(letter);
    CHECK(mathml(std::string("\\dot\\") + letter + "_{0}").size() > 60);
  }
  for (const Function& function : functions()) {
    CAPTURE(function.name);
    const std::string call = std::string(function.name) + "(x)";
    for (const std::string& text : {call, call + "^2", "2^" + call, "1e-3*" + call + "/y"})
      CHECK_NOTHROW(mathml(print_inline(text, Notation::latex, paper_symbols())));
  }
  for (const char* latex :
       {"\\vec{v}", "\\hat x", "\\tilde\\omega", "\\mathbf{F}_1", "\\mathcal{L}", "x'", "x^{\\prime}",
        "\\overline{AB}", "\\ell", "\\hbar", "J_{\\text{rod}}", "\\sqrt[3]{x}", "\\left\\{x\\right\\}",
        "k_\\infty", "a\\;b\\quad c", "\\dfrac{1}{2}", "Θ_w", "x^\\ast", "v_\\perp"})
    CHECK_NOTHROW(mathml(latex));
  CHECK(mathml("\\sqrt[3]{x}") ==
        "<math><mroot><mrow><mi>x</mi></mrow><mrow><mn>3</mn></mrow></mroot></math>");
}

TEST_CASE("every symbol of the paper has MathML and ASCII") {
  for (const auto& name : paper_symbols().names()) {
    CAPTURE(name);
    CHECK(mathml(paper_symbols().find(name)->latex).size() > 20);
    CHECK_NOTHROW(print_inline(name, Notation::unicode, paper_symbols()));
  }
}

TEST_CASE("every printed row of the ledger has MathML") {
  for (const auto& row : read_rows(equations_file())) {
    if (row.printed.empty()) continue;
    CAPTURE(row.id);
    CHECK_NOTHROW(mathml(print_statement(parse_statement(row.printed), Notation::latex, paper_symbols())));
  }
}

TEST_CASE("special cases are put into derived and printed equations alike") {
  const Page page(rocking_block::paper());
  CHECK(print(page.derived_with("13", {{"theta", "0"}})) == "y_c = 0");
  CHECK(page.number_of(page.derived("46b").right, {{"alpha", "pi/2"}}) == doctest::Approx(-0.5));
  CHECK_THROWS_AS(page.number_of(page.derived("46b").right), std::invalid_argument);
  CHECK_THROWS_AS(page.derived("999"), std::out_of_range);
  CHECK_THROWS_AS(judged(page.paper(), "999"), std::out_of_range);
}
