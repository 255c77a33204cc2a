// What users met when they brought papers of their own to the ledger.
#include <doctest/doctest.h>

#include <lessons/page/prose.hpp>
#include <tests/cases.hpp>
#include <tests/derivations/paper/own_paper.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::page;
using namespace rederive::ledger;
namespace fs = std::filesystem;
using GiNaC::ex;
using Json = nlohmann::json;

namespace {

Json judged(const PaperOfATest& paper, int exit_code = 0) {
  const Result r = run_paper(paper, {"--json"});
  CHECK_MESSAGE(r.exit_code == exit_code, r.err);
  REQUIRE_MESSAGE(r.out.starts_with("{"), r.err);
  return Json::parse(r.out)["equations"];
}

/// Judges the one row of a paper that derives it in one way.
Json judged(const std::function<void()>& declare, const std::string& toml, Derive derive, int exit_code = 0) {
  return judged({declare, toml, {{"1", derive}}}, exit_code)[0];
}

/// Judges rows x = y that are derived in these ways, and checks that each is an error with its reason.
Json check_errors(const std::function<void()>& declare,
                  const std::vector<std::pair<Derive, std::string>>& ways) {
  PaperOfATest paper{declare, "", {}};
  for (const auto& [derive, reason] : ways) {
    const std::string id = std::to_string(paper.derivations.size() + 1);
    paper.toml += row(id, "x = y");
    paper.derivations.emplace_back(id, derive);
  }
  const Json rows = judged(paper, 1);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    CAPTURE(k);
    CHECK(rows[k]["verdict"] == "error");
    CHECK_MESSAGE(contains(rows[k]["reason"], ways[k].second), rows[k]["reason"]);
    CHECK(contains(rows[k]["reason"], "the derivation of (" + std::to_string(k + 1) + ")"));
  }
  return rows;
}

Derivation x_is(const ex& value, const std::vector<Step>& steps = {}) {
  return derived(symbol("x"), value, steps);
}

Derivation x_is_y() { return x_is(symbol("y")); }

void nothing() {}

/// Declares "NAME", "NAME (0, 1)", or "NAME (0, 1) UNIT".
void declare_as(const std::string& text) {
  const auto range = text.find(' '), unit = text.find_first_of(")]");
  if (range == std::string::npos) return declare(text.c_str());
  declare(text.substr(0, range).c_str(), text.substr(range + 1, unit - range).c_str(),
          unit + 2 < text.size() ? text.substr(unit + 2).c_str() : "1");
}

/// Judges a row of the table: what is printed, what is derived, the verdict, the symbols that are declared,
/// and "domain: …", "assumption: …" or "small: …".
Json judged(const Cells& row) {
  const auto after = [&](const std::string& key) {
    return row.size() > 4 && row[4].starts_with(key) ? row[4].substr(key.size()) : std::string();
  };
  const std::string domain = after("domain: ");
  const auto symbols = [&] {
    std::istringstream names(row.size() > 3 ? row[3] : "");
    for (std::string text; std::getline(names >> std::ws, text, ';');) declare_as(text);
  };
  const auto derive = [=] {
    const Relation relation = parse_relation(row[1], own_paper().symbols);
    Derivation result = derived(lower(relation.sides[0], own_paper().symbols),
                                lower(relation.sides[1], own_paper().symbols), {});
    result.assumption = after("assumption: ");
    result.small = after("small: ");
    result.order = result.small.empty() ? 0 : 1;
    return result;
  };
  const std::string more = domain.empty() ? "" : "domain = \"" + domain + "\"",
                    expected = row[2] == "error" ? "proved" : row[2];
  const Json entry = judged(symbols, ::row("1", row[0], more, expected), derive, row[2] == "error" ? 1 : 0);
  CHECK(entry["verdict"] == row[2]);
  return entry;
}

}  // namespace

TEST_CASE("two symbols that are written alike are refused, both named") {
  for (const char* first : {"L", "ℒ"}) {
    CAPTURE(first);
    const PaperOfATest paper{
        [&] {
          own_paper().declare({{"L", "L", first, "m", "(0, inf)", "length", "(1)"}});
          own_paper().declare({{"L_c", "L", "L", "m", "(0, inf)", "another length", "(1)"}});
        },
        row("1", "x = L"),
        {{"1", [] { return x_is(symbol("L")); }}}};
    const Result r = run_paper(paper, {});
    CHECK(r.exit_code == 2);
    for (const char* part : {"the symbols L", " L_c ", "are both written 'L'"})
      CHECK_MESSAGE(contains(r.err, part), r.err);
  }
  // a name is read as the symbol of that name
  Symbols symbols;
  symbols.declare({"L_c", "L", "L", "m", "(0, inf)", "", ""});
  symbols.declare({"L", "L", "L", "m", "(0, inf)", "", ""});
  CHECK(parse("L", symbols)->text == "L");
}

TEST_CASE("a row is judged by its derivation, with its ranges, its domain and what it assumes") {
  each_case("verdicts", [](const Cells& row) { judged(row); });
  const Json slip = judged(cases("verdicts").back());
  CHECK(contains(slip["reason"], "q_7"));
  CHECK(contains(slip["reason"], "assumption"));
  const Json unread =
      judged([] { declare("theta_0"); }, row("1", "x = y", "domain = \"theta_0 near alpha\""), x_is_y, 1);
  CHECK(unread["verdict"] == "error");
  CHECK(contains(unread["reason"], "paper.toml:8: row 1: domain: "));
  CHECK(contains(unread["reason"], "theta_0 near alpha"));
}

TEST_CASE("a slip in one place is corrected there, several by what is derived") {
  each_case("corrections", [](const Cells& row) {
    const Json entry = judged(Cells{row[0], row[1], "refuted", row[2]});
    CHECK(entry["correction"] == (row.size() > 3 ? Json(row[3]) : entry["derived"]));
  });
}

TEST_CASE("a range or a unit that cannot be read is refused with its symbol") {
  const auto refused = [](const char* range, const char* unit) {
    const Result r =
        run_paper({[&] { declare("q_7", range, unit); }, row("1", "x = y"), {{"1", x_is_y}}}, {});
    CHECK(r.exit_code == 2);
    CHECK(r.out.empty());
    CHECK_MESSAGE(contains(r.err, "the symbol q_7: "), r.err);
  };
  for (const char* range : {"(0, alhpa)", "0, 1", "(0, 1", "(1, 0)", "(0, sqrt(-1))", "(0, 1/0)", "", "("})
    refused(range, "1");
  for (const char* unit : {"furlong", "kg*", "2*m", "m^x", "", "m + s"}) refused("(0, 1)", unit);
}

TEST_CASE("units may have parentheses, negative powers and all base units of the SI") {
  CHECK(parse_unit("s^4/(kg*m^2)") == parse_unit("kg^-1*s^4/m^2"));
  CHECK(parse_unit("kg^-1*s^4") == parse_unit("s^4/kg"));
  CHECK(unit_text(parse_unit("kg*m^2/s^3/A^2")) == "kg·m²/(s³·A²)");
  CHECK(unit_text(parse_unit("mol*cd/K")) == "mol·cd/K");
  CHECK(parse_unit("m^(1/2)") == parse_unit("m/m^0.5"));
  CHECK(judged(cases("units")[0])["dimension"] == "consistent");
}

TEST_CASE("a derivation that cannot be used makes an error of its row alone") {
  static const std::string long_name = "q_" + std::string(258, '1');
  check_errors([] { declare(long_name.c_str()); },
               {{[] { return x_is(GiNaC::symbol("q_8")); },
                 "the right side of its result: the symbol q_8 is not declared"},
                {[]() -> Derivation { throw std::runtime_error("no such integral"); }, "no such integral"},
                {[] { return x_is(1 / (symbol("x") - symbol("x"))); }, "division by zero"},
                {[] { return x_is(ex(0.5) * symbol("y")); },
                 "the right side of its result: the number 0.5 is not rational"},
                {[] {
                   return x_is(symbol("y"), {{"Take", symbol("x"), GiNaC::symbol("q_9")}});
                 },
                 "step 1 (Take): the symbol q_9 is not declared"},
                {[]() -> Derivation { throw 42; }, "(6)"},
                {[] { return x_is(pow(symbol("y"), 1000)); }, "exponents go up to 64"},
                {[] { return derived(symbol("x"), symbol("y"), {}, {}, "=="); }, "'=='"},
                {[] { return x_is(tgamma(symbol("y"))); },
                 "the right side of its result: our syntax has no function 'tgamma'"},
                {[] {
                   return x_is(symbol("y"), {{"Take", symbol("x"), GiNaC::Euler}});
                 },
                 "step 1 (Take): our syntax cannot write Euler"},
                {[] {
                   return x_is(symbol("y"), {{"Take", symbol("x"), symbol("x") == symbol("y")}});
                 },
                 "step 1 (Take): our syntax cannot write x==y"},
                {[] {
                   ex sum;
                   for (int k = 1; k <= 40; ++k) sum += pow(symbol(long_name.c_str()), k);
                   return x_is(sum);
                 },
                 "characters"},
                {[] {
                   Derivation nameless = x_is_y();
                   nameless.order = 2;
                   return nameless;
                 },
                 ""}});
  const PaperOfATest paper{
      nothing,
      row("1", "x = y") + row("2", "x = 2*y", "", "refuted"),
      {{"1", []() -> Derivation { throw std::runtime_error("no such integral"); }}, {"2", x_is_y}}};
  CHECK(judged(paper, 1)[1]["verdict"] == "refuted");
  const Result table = run_paper(paper, {});
  CHECK(table.exit_code == 1);
  CHECK(contains(table.out, "no such integral"));
  for (const Cells& arguments : {Cells{"show", "1"}, {"mutate"}, {"show", "1", "--json"}})
    CHECK(run_paper(paper, arguments).exit_code == 1);
  CHECK(run_paper(paper, {"graph"}).exit_code == 0);
  CHECK(run_paper(paper, {"errata", "--format", "latex"}).exit_code == 0);
}

TEST_CASE("a row that cannot be read is an error with its place, and the others are judged") {
  const PaperOfATest paper{
      nothing, row("1", "x = y +") + row("2", "x = 2*y", "", "refuted"), {{"1", x_is_y}, {"2", x_is_y}}};
  const Json rows = judged(paper, 1);
  CHECK(contains(rows[0]["reason"], "paper.toml:5: row 1: printed: an operand is missing"));
  CHECK(rows[1]["verdict"] == "refuted");
  const Result table = run_paper(paper, {});
  CHECK(table.exit_code == 1);
  CHECK(contains(table.out, "\n2 rows: 1 error, 1 refuted\n"));
  for (const Cells& arguments :
       {Cells{"show", "1"}, {"mutate"}, {"certify", "proofs"}, {"show", "1", "--json"}})
    CHECK_MESSAGE(run_paper(paper, arguments).exit_code == (arguments[0] == "certify" ? 0 : 1),
                  run_paper(paper, arguments).err);
}

TEST_CASE("what a derivation states without a step is counted apart") {
  const auto stated = [] {
    Derivation result = x_is_y();
    result.is_stated = true;
    return result;
  };
  const PaperOfATest paper{nothing,
                           row("1", "x = y") + row("2", "x = y") + row("3", "x = 2*y", "", "refuted"),
                           {{"1", stated}, {"2", x_is_y}, {"3", stated}}};
  const Json rows = judged(paper);
  CHECK(rows[0]["verdict"] == "proved");
  CHECK(rows[0]["stated"] == true);
  CHECK(rows[1]["stated"] == false);
  CHECK(rows[2]["stated"] == false);
  CHECK(contains(run_paper(paper, {}).out, "\n3 rows: 1 proved, 1 refuted, 1 stated\n"));
  CHECK(contains(run_paper(paper, {"show", "1"}).out, "its derivation has no step of its own"));
}

TEST_CASE("what is derived from itself is an error that says so") {
  const auto first = [] { return x_is(symbol("y"), {from("2", "Take")}); };
  const auto second = [] { return x_is(symbol("y"), {from("1", "Take")}); };
  const Json rows =
      judged({nothing, row("1", "x = y") + row("2", "x = y"), {{"1", first}, {"2", second}}}, 1);
  CHECK(contains(rows[0]["reason"], "(1) is derived from itself"));
  CHECK(contains(rows[1]["reason"], "(2) is derived from itself"));
}

TEST_CASE("an id derived twice, and a derivation without row, are refused by name") {
  const Result twice = run_paper({nothing, row("1", "x = y"), {{"1", x_is_y}, {"1", x_is_y}}}, {});
  CHECK(twice.exit_code == 2);
  CHECK_MESSAGE(contains(twice.err, "(1) is derived twice"), twice.err);
  const Result extra = run_paper({nothing, row("1", "x = y"), {{"1", x_is_y}, {"4", x_is_y}}}, {"show", "1"});
  CHECK(extra.exit_code == 2);
  CHECK_MESSAGE(contains(extra.err, "(4)"), extra.err);
  CHECK(contains(extra.err, "paper.toml"));
}

TEST_CASE("prove knows the symbols of the paper and their ranges") {
  const auto prove = [](const std::function<void()>& declare, const std::string& left,
                        const std::string& right) {
    const Result r =
        run_paper({declare, row("1", "x = y"), {{"1", x_is_y}}}, {"prove", left, right, "--json"});
    return Json::parse(r.out)["verdict"].get<std::string>();
  };
  const auto positive = [] {
    declare("r", "(0, 1)"), declare("d", "(-1, 0)"), declare("theta_0", "(0, alpha)");
  };
  CHECK(prove(positive, "sqrt(r^2)", "r") == "proved");
  CHECK(prove(positive, "fabs(d)", "-d") == "proved");
  CHECK(prove(positive, "fabs(alpha - theta_0)", "alpha - theta_0") == "proved");
  CHECK(prove(nothing, "sqrt(r^2)", "r") == "refuted");
  const auto written = [] { own_paper().declare({{"L_c", "L", "L", "m", "(0, inf)", "length", "(1)"}}); };
  CHECK(prove(written, "sqrt(L^2)", "L_c") == "proved");
}

TEST_CASE("the series of what is derived are compared, and an exact match is called exact") {
  each_case("series", [](const Cells& row) {
    CHECK(contains(judged(row)["reason"], "exact") == (row[2] == "proved"));
  });
}

// acosh(1/(1 - alpha/theta_0)) for acosh(1/(1 - theta_0/alpha)): where 0 < theta_0 < alpha the first has no
// value.
TEST_CASE("a printed form without a value wherever the derived one has some is refuted, and so are slips") {
  const auto symbols = [] {
    declare("T_0", "(0, inf)", "s"), declare("L_1", "(0, inf)", "m"), declare("theta_0", "(0, alpha)");
  };
  const auto derive = [] {
    return derived(symbol("T_0"),
                   2 * GiNaC::Pi * sqrt(symbol("L_1") / symbol("g")) *
                       acosh(1 / (1 - symbol("theta_0") / symbol("alpha"))),
                   {});
  };
  const std::string right = "T_0 = 2*pi*sqrt(L_1/g)*acosh(1/(1 - theta_0/alpha))",
                    wrong = "T_0 = 2*pi*sqrt(L_1/g)*acosh(1/(1 - alpha/theta_0))";
  const Json refuted = judged(symbols, row("1", wrong, "", "refuted"), derive);
  CHECK(refuted["verdict"] == "refuted");
  CHECK(refuted["witness"]["printed"] == "no value");
  CHECK(refuted["witness"]["derived"] != "no value");
  CHECK(refuted["correction"] == right);
  CHECK(judged(symbols, row("1", right), derive)["verdict"] == "proved");
  const Result slips = run_paper({symbols, row("1", right), {{"1", derive}}}, {"mutate"});
  // Open: no point with alpha > 1 is found, where one of the slips has a value, too.
  CAPTURE(slips.out);
  CHECK(contains(slips.out, "0 equal    1 survived\n"));
  CHECK(contains(slips.out, "survived: T_0 = 2*pi*sqrt(L_1/g)*acosh(1/(1 - 1/alpha))\n"));
}

TEST_CASE("the equations are found beside the source or the program, wherever it runs") {
  const TemporaryFolder elsewhere;
  const fs::path beside = fs::path(__FILE__).parent_path(), name_of_a_table = "../../prove_table.toml";
  REQUIRE(fs::exists(beside / name_of_a_table));
  const Result r = in_a_child(elsewhere.path, [&] {
    std::string name = "paper";
    char* argv[] = {name.data(), nullptr};
    return run_ledger(Paper{.title = "A paper", .equations = name_of_a_table}, 1, argv);
  });
  CHECK(r.exit_code == 2);  // it is another kind of table
  CHECK_MESSAGE(contains(r.err, (beside / name_of_a_table).string()), r.err);
  const Result missing = in_a_child(elsewhere.path, [] {
    std::string name = "paper";
    char* argv[] = {name.data(), nullptr};
    return run_ledger(Paper{.title = "A paper", .equations = "nowhere.toml"}, 1, argv);
  });
  CHECK(missing.exit_code == 2);
  CHECK(contains(missing.err, "nowhere.toml"));
}

TEST_CASE("a witness says exactly, or with digits, what was put in") {
  const auto symbols = [] { declare("h_1", "(0, inf)"), declare("b_1", "(0, 1)"); };
  const auto derive = [] {
    return derived(symbol("x"), 2 * symbol("h_1"), {}, {{symbol("h_1"), exp(symbol("b_1"))}});
  };
  const Json entry = judged(symbols, row("1", "x = 3*h_1", "", "refuted"), derive);
  const std::string value = entry["witness"]["exactly"]["h_1"];
  CHECK_MESSAGE(value.starts_with("exp("), value);
  for (const std::string words : entry["witness"]["in_words"]) CHECK_MESSAGE(words.size() < 60, words);
  // b_1 lies between bounds: of h_1 there are digits
  const auto implicit = [] {
    const ex b = symbol("b_1");
    return derived(b * exp(b) + symbol("h_1"), 2 + symbol("h_1") - sin(b), {}, {{symbol("h_1"), cosh(b)}});
  };
  const Json other =
      judged(symbols, row("1", "b_1*exp(b_1) + h_1 = 1 + h_1", "", "refuted"), implicit)["witness"];
  REQUIRE(other.contains("between"));
  CHECK(contains(other["at"]["h_1"], "."));
  CHECK(contains(other["in_words"].dump(), "h_1 ≈ 1."));
}

TEST_CASE("only what is between dollars is mathematics in the words of a step") {
  const auto symbols = [] { declare("a", "(0, inf)"), declare("body", "(0, inf)"), declare("is"); };
  const auto derive = [] {
    return x_is(symbol("a"), {in_words("Of a body is taken $a*x^2$, at a price of 5$")});
  };
  const PaperOfATest paper{symbols, row("1", "x = 2*a", "", "refuted"), {{"1", derive}}};
  const TemporaryFolder folder;
  const Result marked_by_us = in_a_child(folder.path, [&] {
    symbols();
    std::fputs(
        (marked("Of a body is taken", own_paper()) + "\n" + marked("is taken $a*x^2$ of a", own_paper()) +
         "\n" + marked("where R is $R$, for 5$", own_paper()) + "\n" +
         marked("at $no formula$ of α = 0", own_paper()) + "\n")
            .c_str(),
        stdout);
    return 0;
  });
  CHECK(marked_by_us.out ==
        "Of a body is taken\nis taken $a*x^2$ of a\nwhere R is 'R', for 5'\n"
        "at no formula of α = 0\n");
  const auto two = [] { return x_is(symbol("a"), {in_words("Of a body is taken $a*x^2$ at once")}); };
  const PaperOfATest other{symbols, row("1", "x = 2*a", "", "refuted"), {{"1", two}}};
  CHECK(contains(run_paper(other, {"show", "1"}).out, "Of a body is taken a·x² at once\n"));
  const std::string latex = run_paper(other, {"errata", "--format", "latex"}).out;
  CHECK_MESSAGE(contains(latex, "Of a body is taken $a x^2$ at once}\n"), latex);
  CHECK(contains(run_paper(paper, {"show", "1"}).out, "Of a body is taken 'a*x^2', at a price of 5'\n"));
}

TEST_CASE("one is not called several") {
  const PaperOfATest paper{nothing, row("1", "x = 2*y", "", "refuted"), {{"1", x_is_y}}};
  CHECK(contains(run_paper(paper, {}).out, "\n1 row: 1 refuted\n"));
  CHECK(contains(run_paper(paper, {"errata"}).out, "\n1 error.\n"));
}