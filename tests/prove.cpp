// The table of statements, row by row, and what `ledger prove` says to a user.
#include <doctest/doctest.h>

#include <ctime>
#include <derivations/algebra/witness.hpp>
#include <derivations/emit/command_line.hpp>
#include <iostream>
#include <lessons/ledger/prove_table.hpp>
#include <nlohmann/json.hpp>
#include <tests/certificate_replay.hpp>
#include <tests/run_program.hpp>

using namespace rederive;

namespace {

const std::string table_file = std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml";

nlohmann::json prove_json(std::vector<std::string> arguments, int exit_code) {
  arguments.insert(arguments.begin(), "prove");
  arguments.push_back("--json");
  const Result r = run_program("ledger", arguments);
  INFO(r.out << r.err);
  CHECK(r.exit_code == exit_code);
  return nlohmann::json::parse(r.out);
}

std::pair<std::string, nlohmann::json> verdict_and_certificate(const ProveRequest& request) {
  try {
    const auto [proof, certificate] = decide(request);
    return {to_string(proof.verdict), nlohmann::json::parse(certificate.dump())};
  } catch (const BadInput&) {
    return {"refused", nullptr};
  }
}

/// Of processor time: on a shared machine the wall clock also counts what others do.
double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

TEST_CASE("every row of the table has the verdict that it should have, and a certificate if it is proved") {
  const auto rows = read_table(table_file);
  CHECK(rows.size() >= 400);
  int proved = 0, identities = 0;
  for (const TableRow& row : rows) {
    INFO(row.group << ": " << row.request.left << "  |  " << row.request.right << "  (" << row.why << ")");
    CHECK_FALSE(row.why.empty());
    const double start = seconds_now();
    const auto [verdict, certificate] = verdict_and_certificate(row.request);
    CHECK(seconds_now() - start < 2);
    CHECK(verdict == row.expected);
    CHECK(certificate.is_object() == row.expected.starts_with("proved"));
    if (!certificate.is_object()) continue;
    ++proved;
    if (!is_identity(certificate)) continue;
    ++identities;
    CHECK(replay(certificate) == "accepted");
  }
  std::cout << proved << " certificates, " << identities << " of them identities\n";
  CHECK(proved > 1000);
  CHECK(identities > 400);
}

TEST_CASE("a verdict does not depend on the order that the computer algebra gives the symbols") {
  std::vector<GiNaC::realsymbol> others;  // each of them moves the order of those that come after it
  for (int k = 0; k < 8; ++k) {
    for (const TableRow& row : read_table(table_file)) {
      if (row.group != "Lost solutions") continue;
      INFO(row.request.left << "  |  " << row.request.right << "  with " << others.size()
                            << " other symbols");
      CHECK(verdict_and_certificate(row.request).first == row.expected);
    }
    others.emplace_back("other_" + std::to_string(k));
  }
}

namespace {

bool is_in_ranges(const Witness& witness, const Symbols& symbols) {
  return std::all_of(witness.at.begin(), witness.at.end(), [&](const auto& name_and_value) {
    const Symbol* symbol = symbols.find(name_and_value.first);
    return symbol != nullptr && is_inside(symbol->range, cln::cl_RA(name_and_value.second.c_str()));
  });
}

}  // namespace

TEST_CASE("every refuted row has a witness inside the declared ranges, of which both sides are shown") {
  for (const TableRow& row : read_table(table_file)) {
    if (row.expected != "refuted") continue;
    INFO(row.request.left << "  |  " << row.request.right);
    const Proof proof = decide(row.request).proof;
    REQUIRE(proof.witness);
    const bool relation =
        row.request.left.find_first_of("=<>") != std::string::npos;  // there both may be 0: x < y, x <= y
    CHECK((relation || proof.witness->printed != proof.witness->derived));
    const std::vector<Case> cases = cases_of(row.request);
    CHECK(std::any_of(cases.begin(), cases.end(),
                      [&](const Case& one) { return is_in_ranges(*proof.witness, one.context.symbols); }));
  }
}

TEST_CASE("a proof says what it rests on") {
  const auto j = prove_json({"sqrt(g^2)", "g"}, 0);
  CHECK(j["verdict"] == "proved");
  CHECK(j["side_conditions"] == nlohmann::json{"g > 0"});
  CHECK(prove_json({"x/x", "1"}, 0)["side_conditions"] == nlohmann::json{"x != 0"});
  CHECK(prove_json({"sqrt(x)^2", "x"}, 0)["side_conditions"] == nlohmann::json{"x >= 0"});
  CHECK(prove_json({"m*a = m*b", "a = b"}, 0)["factor"] == "m");
  CHECK(prove_json({"log(x) <= x - 1", "0 < 1"}, 0)["side_conditions"] == nlohmann::json{"x > 0"});
}

TEST_CASE("side conditions say nothing twice, nor what is assumed") {
  const auto conditions = [](const std::vector<std::string>& arguments) {
    return prove_json(arguments, 0)["side_conditions"];
  };
  CHECK(conditions({"sqrt(x)*log(x)", "log(x)*x^(1/2)"}) == nlohmann::json{"x > 0"});
  CHECK(conditions({"log(x)/sqrt(x)", "2*log(sqrt(x))/sqrt(x)"}) == nlohmann::json{"x > 0"});
  CHECK(conditions({"sqrt(1-x^2)/(1-x^2)", "1/sqrt(1-x^2)"}) == nlohmann::json{"1 - x^2 > 0"});
  CHECK(conditions({"x/(y+z/p^2)", "x*p^2/(y*p^2+z)"}) == nlohmann::json{"p^2*y + z != 0"});
  CHECK(conditions({"tan(x) < tan(y)", "0 < 1", "--assume", "0 < x < y < pi/2"}) ==
        nlohmann::json{"x > 0", "y < pi/2", "x < y"});  // no cosine is 0 there
}

TEST_CASE(
    "what is assumed not to be 0 is a side condition of a proof that rests on it, and of no other one") {
  const auto conditions = [](const std::string& left, const std::string& right) {
    return prove_json({left, right, "--assume", "x != 0", "--assume", "x != y"}, 0)["side_conditions"];
  };
  CHECK(conditions("x^2 > 0", "0 < 1") == nlohmann::json{"x != 0"});
  CHECK(conditions("(x - y)*z = 0", "z = 0") == nlohmann::json{"x - y != 0"});
  CHECK(conditions("x^2 + y^2 >= 2*x*y", "0 < 1") == nlohmann::json::array());
  CHECK(conditions("1/x^2 > 0", "0 < 1") == nlohmann::json{"x != 0"});  // once
}

TEST_CASE("of many ranges those are named that a proof rests on, however long it takes to find out") {
  const Proof proof =
      decide({"J_o*thetaddot + m*R*a_p*sin(omega_p*t+psi)*cos(alpha-theta) + m*g*R*sin(alpha-theta) = 0",
              "thetaddot = -p^2*(sin(alpha-theta) + a_p*sin(omega_p*t+psi)/g*cos(alpha-theta))",
              {"J_o = 4/3*m*R^2", "p = sqrt(3*g/(4*R))"},
              {},
              {}})
          .proof;
  CHECK(proof.verdict == Verdict::proved_under);
  CHECK(proof.side_conditions == std::vector<std::string>{"g > 0", "m > 0"});  // as p has a value, R > 0 then
}

TEST_CASE("a refutation can be checked by hand") {
  const auto j = prove_json({"sqrt(x^2)", "x"}, 1);
  CHECK(j["verdict"] == "refuted");
  REQUIRE(j["witness"]["at"].contains("x"));
  CHECK(j["witness"]["at"]["x"].get<std::string>().starts_with("-"));
  CHECK(j["witness"]["derived"] == "-" + j["witness"]["printed"].get<std::string>());
}

TEST_CASE("what cannot be decided is said to be undecided, with the reason and what would help") {
  const auto j = prove_json({"log(x*y)", "log(x)+log(y)"}, 3);
  CHECK(j["verdict"] == "undecided");
  CHECK(j["reason"].get<std::string>().find("sign of x, y") != std::string::npos);
  CHECK(prove_json({"log(x*y)", "log(x)+log(y)", "--assume", "x > 0", "--assume", "y > 0"}, 0)["verdict"] ==
        "proved");
}

TEST_CASE("given equations and approximations have verdicts of their own") {
  CHECK(prove_json({"b^2+h^2", "R^2", "--assume", "b = R*sin(alpha)", "--assume", "h = R*cos(alpha)"},
                   0)["verdict"] == "proved_under");
  CHECK(prove_json({"sin(theta)", "theta", "--small", "theta", "--order", "1"}, 0)["verdict"] ==
        "approximation");
  const auto conditions = [](const std::string& left, const std::string& right) {
    return prove_json({left, right, "--assume", "y >= 0", "--small", "x", "--order", "1"},
                      0)["side_conditions"];
  };
  CHECK(conditions("fabs(y-x)", "y-x") == nlohmann::json{"y != 0", "y >= 0"});  // at 0 it has a corner
  CHECK(conditions("sqrt((y+1)^2+x)", "y+1+x/(2*y+2)") == nlohmann::json{"y >= 0"});
  CHECK(conditions("(y-x)^2", "y^2-2*x*y").empty());
}

TEST_CASE("a series asks that the lowest terms below a bar, in a root or a logarithm are not 0") {
  using Texts = std::vector<std::string>;
  const auto conditions = [](const char* order, const char* left, const char* right, Texts assumptions = {},
                             const char* small = "x") {
    Texts arguments{left, right, "--small", small, "--order", order};
    for (const std::string& assumption : assumptions)
      arguments.push_back("--assume"), arguments.push_back(assumption);
    const nlohmann::json answer = prove_json(arguments, 0);
    CHECK(answer["verdict"] == "approximation");
    return answer["side_conditions"];
  };
  CHECK(conditions("0", "x/(a+x)", "0") == Texts{"a != 0"});  // at a = 0 it is 1
  CHECK(conditions("1", "a^2/(a+x)", "a-x") == Texts{"a != 0"});
  CHECK(conditions("0", "b/(K+b)", "0", {"K >= 0"}, "b") == Texts{"K != 0"});  // K + b > 0 for all K
  CHECK(conditions("0", "x/(a+x) = y", "y = 0") == Texts{"a != 0"});
  CHECK(conditions("0", "K/(K+b) < y", "1 < y", {"K >= 0"}, "b") == Texts{"K != 0"});
  CHECK(conditions("0", "x/(sin(a)^2*cos(b)+x)", "0") == Texts{"cos(b) != 0", "sin(a) != 0"});
  CHECK(conditions("0", "x*tan(a+x)", "0") == Texts{"cos(a) != 0"});
  CHECK(conditions("0", "x/log(a+x)", "0") == Texts{"a > 0", "log(a) != 0"});
  CHECK(conditions("0", "asin(a+x)", "asin(a)") == Texts{"1 - a^2 > 0"});
  CHECK(conditions("2", "sqrt(a^2*x^2+x^4)", "fabs(a)*x", {"x > 0"}) == Texts{"a != 0", "x > 0"});
  CHECK(conditions("1", "sqrt(a*x^2+x^4)", "sqrt(a)*x", {"x > 0"}) == Texts{"a > 0", "x > 0"});
  CHECK(conditions("0", "a^x", "1") == Texts{"a > 0"});
  CHECK(conditions("0", "a^x", "1", {"a >= 0"}) == Texts{"a != 0"});
  CHECK(conditions("0", "(x-y)/sin(x-y)", "1", {}, "x,y") == Texts{"x - y != 0"});
  CHECK(conditions("1", "sin(x)+q-q", "x", {"q = 1/(a+x)"}) == Texts{"a != 0"});
}

TEST_CASE("a text that cannot be read ends with 2 and a caret under the character") {
  const Result r = run_program("ledger", {"prove", "2x", "x"});
  CHECK(r.exit_code == 2);
  CHECK(r.out.empty());
  CHECK(r.err.find("^") != std::string::npos);
  CHECK(r.err.find("2*x") != std::string::npos);
  const Result slip = run_program("ledger", {"prove", "alphaa", "alpha"});
  CHECK(slip.exit_code == 2);
  CHECK(slip.err.find("did you mean 'alpha'?") != std::string::npos);
  CHECK(run_program("ledger", {"prove", "x"}).exit_code == 2);
  CHECK(run_program("ledger", {"prove", "x", "y", "--assume", "x > 1", "--assume", "x < 0"}).exit_code == 2);
}

TEST_CASE("a comparison of symbols that a proof rests on is among its side conditions") {
  const auto conditions = [](const std::string& assumption, const std::string& left,
                             const std::string& right) {
    return prove_json({left, right, "--assume", assumption}, 0)["side_conditions"];
  };
  CHECK(conditions("a_p > alpha*g", "fabs(a_p-alpha*g)", "a_p-alpha*g") == nlohmann::json{"a_p > g*alpha"});
  CHECK(conditions("a_p > alpha*g", "a_p+a_p", "2*a_p").empty());
  CHECK(conditions("b/h < 1", "sqrt((h-b)^2)", "h-b") == nlohmann::json{"b/h < 1", "h > 0"});
}

TEST_CASE("what picks one of several solutions is a condition, and so is what leaves out a piece") {
  using Texts = std::vector<std::string>;
  const auto conditions = [](const Texts& assumptions, const std::string& left, const std::string& right) {
    Texts arguments{left, right};
    for (const std::string& assumption : assumptions)
      arguments.push_back("--assume"), arguments.push_back(assumption);
    return prove_json(arguments, 0)["side_conditions"];
  };
  CHECK(conditions({"sin(x) = 0", "1 < x < 10"}, "(x-3*pi)*(x-pi)*(x-2*pi)", "0") ==
        Texts{"x > 1", "x < 10"});
  CHECK(conditions({"x^4-5*x^2+4 = 0", "x >= 1"}, "(x-1)*(x-2)", "0") == Texts{"x >= 1"});
  CHECK(conditions({"y*cos(x) = 0", "y > 0"}, "sin(x)^2", "1") == Texts{"y > 0"});
  CHECK(conditions({"R*sin(x) = 0"}, "sin(x)", "0") == Texts{"R > 0"});
  CHECK(conditions({"sin(2*alpha) = 1/2"}, "(alpha-pi/12)*(alpha-5*pi/12)", "0") ==
        Texts{"alpha > 0", "alpha < pi/2"});
  CHECK(conditions({"x^2 = x", "x != 0"}, "x", "1") == Texts{"x != 0"});
  CHECK(conditions({"sin(x) > 0", "0 < x < 4"}, "x < pi", "0 < 1") == Texts{"sin(x) > 0", "x > 0", "x < 4"});
  CHECK(conditions({"x*y > 0", "x+y > 0"}, "x > 0", "0 < 1") == Texts{"x*y > 0", "x + y > 0"});
  CHECK(conditions({"sin(x) > 0", "y > 0"}, "fabs(sin(x))", "sin(x)") == Texts{"sin(x) > 0"});
  CHECK(conditions({"sin(x) = 0", "y > 0"}, "cos(x)^2", "1") == Texts{});
}

TEST_CASE("a witness has every symbol that the assumptions name") {
  const auto j = prove_json({"y", "0", "--assume", "x*b > h", "--assume", "z > 2"}, 1);
  for (const char* name : {"x", "b", "h", "y", "z"}) CHECK(j["witness"]["at"].contains(name));
}

TEST_CASE("an assumption that cannot be taken says why, or what would decide it") {
  const auto error = [](const std::vector<std::string>& assumptions) {
    std::vector<std::string> arguments{"prove", "1", "1"};
    for (const std::string& assumption : assumptions)
      arguments.push_back("--assume"), arguments.push_back(assumption);
    const Result r = run_program("ledger", arguments);
    CHECK(r.exit_code == 2);
    return r.err;
  };
  const auto has = [](const std::string& text, const char* part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  has(error({"x^2 = 4", "y^2 = x^2", "z^2 = x^2", "q^2 = x^2"}), "assume \"x > 0\" or \"x < 0\"");
  has(error({"sin(x) = x/2"}), "if it holds for one value of x only, say that one");
  has(error({"x < 0", "y = log(x)"}), "contradict each other");
  has(error({"x < 1", "x = y^2+1"}), "contradicts its range (-inf, 1)");
  has(error({"b < h", "b = h"}), "contradict each other");
  has(error({"x < y", "y < z", "z < x"}), "contradict each other");
  has(error({"x <= y", "y <= x"}), "say \"y - x = 0\"");
  has(error({"alpha = 2"}), "contradicts its range (0, pi/2)");
  has(error({"y > sqrt(x^2+z^2-1)"}), "x^2 + z^2 - 1 >= 0");
  has(error({"x*y >= 1"}), "factor of known sign");
}

namespace {

/// What is said of a table with this in it.
Result of_table(const std::string& text, std::vector<std::string> arguments = {}) {
  const TemporaryFolder folder;
  const auto file = folder.path / "table.toml";
  std::ofstream(file) << text;
  arguments.insert(arguments.begin(), {"prove", "--table", file.string()});
  return run_program("ledger", arguments);
}

/// One row, with another field if need be.
std::string row_that_expects(const std::string& verdict, const std::string& other = "") {
  return "[[row]]\ngroup = \"Double angles\"\nleft = \"sin(2*x)\"\nright = \"2*sin(x)*cos(x)\"\nexpected = "
         "\"" +
         verdict + "\"\nwhy = \"the sum of two equal angles\"\n" + other + "\n";
}

}  // namespace

TEST_CASE("the page of what can be decided is written from the table") {
  const Result good = of_table(row_that_expects("proved")), bad = of_table(row_that_expects("refuted"));
  CHECK(good.exit_code == 0);
  CHECK(good.out.find("## Double angles") != std::string::npos);
  CHECK(good.out.find("| `sin(2*x)` | `2*sin(x)*cos(x)` |") != std::string::npos);
  CHECK(good.out.find("**expected") == std::string::npos);
  const Result small =
      of_table(row_that_expects("proved", "assume = [\"y > 0\"]\nsmall = [\"x\"]\norder = 1"));
  CHECK(small.out.find("| `y > 0`, `x` small, order 1 | proved |") != std::string::npos);
  CHECK(bad.exit_code == 1);
  CHECK(bad.out.find("proved (**expected refuted**)") != std::string::npos);
  const auto json = nlohmann::json::parse(of_table(row_that_expects("refuted"), {"--json"}).out);
  CHECK(json["rows"][0]["verdict"] == "proved");
  CHECK(json["rows"][0]["expected"] == "refuted");
  CHECK(json["counts"]["proved"] == 1);
}

TEST_CASE("a row of a table is bounded like any other statement") {
  const Result r = of_table(
      "[[row]]\ngroup = \"g\"\nexpected = \"undecided\"\nleft = \"(a+b+c+d+f+g+h+k+l+m+n+p+q+r+s)^8\"\n"
      "right = \"(s+r+q+p+n+m+l+k+h+g+f+d+c+b+a)^8\"\n",
      {"--json"});
  CHECK(r.exit_code == 0);
  CHECK(r.out.find("it took longer than it may") != std::string::npos);
}

TEST_CASE("a table that cannot be read says where it is wrong, and what would be right") {
  const auto complaint = [](const Result& r) {
    CHECK(r.exit_code == 2);
    CHECK(r.out.empty());
    return r.err;
  };
  const auto has = [](const std::string& text, const char* part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  has(complaint(of_table(row_that_expects("maybe"))), ":1: 'maybe' is no verdict; right is one of");
  has(complaint(of_table(row_that_expects("proved", "asume = [\"x > 0\"]"))), "unknown key 'asume'");
  has(complaint(of_table(row_that_expects("proved", "assume = \"x > 0\""))), "must be a list of strings");
  has(complaint(of_table(row_that_expects("proved", "order = \"2\""))), "'order' must be a whole number");
  has(complaint(of_table(row_that_expects("proved", "order = 99"))), "'order' is 0 to 12");
  has(complaint(of_table(row_that_expects("proved\\u001b[31m"))), "one line of printable characters");
  has(complaint(of_table("[[row]]\nleft = \"x\"\n")), "a row needs 'group'");
  has(complaint(of_table("x = 1\n")), "has no [[row]]");
  has(complaint(of_table("[[row\n")), ".toml:1: ");
  has(complaint(of_table(row_that_expects("proved"), {"--assume", "x > 0"})), "excludes --table");
  std::string deep = "a";
  for (int k = 0; k < 60'000; ++k) deep += ".a";
  has(complaint(of_table(deep + " = 1\n")), "cannot be read: it ran out of memory or stack");
}

TEST_CASE("what is small may be named as in a formula") {
  CHECK(prove_json({"--small", "θ", "--order", "1", "sin(θ)", "θ"}, 0)["verdict"] == "approximation");
  CHECK(prove_json({"--small", "x, y", "--order", "1", "sin(x)+y", "x+y"}, 0)["verdict"] == "approximation");
}
