// Lines of a paper that are not equations of numbers: derivatives, integrals, sums, signs, vectors, LaTeX.
#include <doctest/doctest.h>

#include <derivations/paper/latex.hpp>
#include <derivations/paper/printed.hpp>
#include <tests/cases.hpp>
#include <tests/derivations/paper/own_paper.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::decide;
using namespace rederive::paper;
using Json = nlohmann::json;

namespace {

/// The paper of these tests: x, y, k, t … are its symbols, q has rates, and n is a whole number.
const Paper& paper() {
  static const Paper made = [] {
    Paper result{.title = "A paper"};
    const auto declare = [&](const std::string& name, const std::string& latex, const std::string& unicode,
                             const std::string& range) {
      result.declare({{name, latex, unicode, "1", range, "a symbol", "(1)"}});
    };
    for (const char* name : {"x", "y", "z", "t", "K", "d", "V", "b"}) declare(name, name, name, all_numbers);
    for (const char* name : {"a", "c", "m", "L"}) declare(name, name, name, "(0, inf)");
    declare("omega", "\\omega", "ω", "(0, inf)"), declare("theta", "\\theta", "θ", all_numbers);
    declare("thetadot", "\\dot\\theta", "θ̇", all_numbers);
    declare("thetaddot", "\\ddot{\\theta}", "θ̈", all_numbers);
    declare("u_g", "u_g", "u_g", all_numbers), declare("u_gddot", "\\ddot{u_g}", "ü_g", all_numbers);
    declare("u_gdot", "\\dot u_{g}", "u̇_g", all_numbers), declare("theta_0", "\\theta_0", "θ₀", "(0, a)");
    for (const char* name : {"F_x", "F_y", "M_11", "M_12", "M_21", "M_22"})
      declare(name, name, name, all_numbers);
    declare("n", "n", "n", "(-inf, inf)"), declare("j", "j", "j", "[1, inf)");
    result.integers = {"n", "j"};
    return result;
  }();
  return made;
}

std::string why_not(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// Returns the rows of a file, as the paper reads them.
std::vector<Row> rows(const std::string& toml) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "equations.toml") << toml;
  return rows_in(paper(), folder.path / "equations.toml");
}

std::string toml_row(const std::string& keys) {
  return "[[equation]]\nid = \"1\"\nkind = \"equation\"\nexpected = \"proved\"\n" + keys + "\n";
}

/// Judges a row by relations that are derived for its parts: "+: x = a; -: x = -a", or for the row.
Entry judged_by(const std::string& keys, const std::string& derivations) {
  Paper own = paper();
  own.derivations = {};
  std::istringstream texts(derivations);
  for (std::string text; std::getline(texts >> std::ws, text, ';');) {
    const auto colon = text.find(": ");
    const std::string part = colon == std::string::npos ? "" : "[" + text.substr(0, colon) + "]";
    own.derivations.add("1" + part, [text, colon] {
      const Relation relation =
          parse_relation(colon == std::string::npos ? text : text.substr(colon + 2), paper().symbols);
      return derived(lower(relation.sides[0], paper().symbols), lower(relation.sides[1], paper().symbols),
                     {});
    });
  }
  return judge(own, rows(toml_row(keys))[0]);
}

}  // namespace

TEST_CASE("derivatives, integrals, sums and bars are worked out") {
  each_case("worked_out", [](const std::string& text, const std::string& value) {
    const Relation left{{parse(worked_out(text, paper()), paper().symbols)}, {}},
        right{{parse(value, paper().symbols)}, {}};
    const Proof proof = decide(left, right, paper().symbols);
    CHECK_MESSAGE(proof.verdict == Verdict::proved, print(left.sides[0]));
  });
}

TEST_CASE("what is not worked out is refused, with what to write instead") {
  each_case("refused", [](const std::string& text, const std::string& why) {
    const std::string said = why_not([&] { (void)worked_out(text, paper()); });
    CHECK_MESSAGE(contains(said, why), said);
  });
}

TEST_CASE("a row says one statement, or each sign and each entry is one") {
  each_case("judged", [](const Cells& row) {
    const Entry entry = judged_by(row[0], row[1]);
    CHECK_MESSAGE(to_string(entry.proof.verdict) == row[2], entry.proof.reason);
    if (row.size() > 3) CHECK_MESSAGE(contains(entry.proof.reason, row[3]), entry.proof.reason);
  });
}

TEST_CASE("LaTeX is read as printed, and its two readings are refused") {
  each_case("latex", [](const std::string& latex, const std::string& read) {
    CHECK(from_latex(latex, paper().symbols) == read);
  });
  each_case("no_latex", [](const std::string& latex, const std::string& why) {
    const std::string said = why_not([&] { (void)from_latex(latex, paper().symbols); });
    CHECK_MESSAGE(contains(said, why), said);
  });
}
