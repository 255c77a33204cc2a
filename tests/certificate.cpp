// Certificates: written for what is proved, accepted by a checker that shares no code, rejected when spoiled.
#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <random>
#include <tests/certificate_branches.hpp>
#include <tests/run_program.hpp>

using namespace rederive;
using Json = nlohmann::json;

namespace {

std::optional<Json> certificate_of(const ProveRequest& request) {
  const Context context = make_context(request);
  const auto found =
      certificate(parse_statement(request.left, context.symbols),
                  parse_statement(request.right, context.symbols), context.symbols, context.given);
  return found ? std::optional(Json::parse(found->dump())) : std::nullopt;
}

/// Proved by increasing functions on both sides, or because both relations always or never hold: no identity.
bool has_no_factor(const ProveRequest& request) { return decide(request).factor.empty(); }

std::string verdict(const Json& certificate) {
  try {
    certificate_checker::check(certificate);
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// Changes the first digit, sign or function name after a random place of a text; empty if there is none.
std::string slip(const std::string& text, std::mt19937& random) {
  static const std::vector<std::pair<std::string, std::string>> slips{
      {"+", "-"},     {"-", "+"},     {"2", "3"}, {"3", "5"}, {"1", "2"}, {"4", "7"},
      {"sin", "cos"}, {"cos", "sin"}, {"x", "y"}, {"y", "x"}, {"*", "+"}, {"alpha", "theta"}};
  for (int tries = 0; tries < 50; ++tries) {
    const auto& [from, to] = slips[random() % slips.size()];
    const auto place = text.find(from, random() % text.size());
    if (place == std::string::npos || (from == "+" && place == 0)) continue;
    return std::string(text).replace(place, from.size(), to);
  }
  return {};
}

}  // namespace

TEST_CASE("proved statements of the table have certificates, and the checker accepts them") {
  int proved = 0, branching = 0;
  for (const TableRow& row : read_table(std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml")) {
    if (row.expected != "proved" && row.expected != "proved_under") continue;
    INFO(row.request.left << "  |  " << row.request.right);
    // e^|x| is not made of e^x by roots and polynomials
    if (row.request.left == "acosh(cosh(x))") continue;
    const auto c = certificate_of(row.request);
    if (!c && has_no_factor(row.request)) continue;
    REQUIRE(c);
    ++proved;
    CHECK(verdict(*c) == "accepted");
    branching += verdict(*c) == "accepted" && certificate_checker::check(*c) > 0 ? 1 : 0;
  }
  std::cout << proved << " certificates, " << branching << " with branches that were looked at\n";
  CHECK(proved > 500);
}

TEST_CASE("spoiled certificates are rejected") {
  const std::vector<ProveRequest> requests{
      {"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, 0},
      {"m*R*thetaddot + m*g*sin(theta) = 0", "thetaddot = -g/R*sin(theta)", {}, {}, 0},
      {"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", {}, {}, 0},
      {"cosh(x)^2-sinh(x)^2", "1", {}, {}, 0},
      {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", {}, {}, 0},
      {"b^2+h^2", "R^2", {"b = R*sin(alpha)", "h = R*cos(alpha)"}, {}, 0},
      {"sqrt(1+sin(2*alpha))", "sin(alpha)+cos(alpha)", {}, {}, 0},
      {"sin(pi/5)^2", "(5-sqrt(5))/8", {}, {}, 0},
      {"2*atan(x)", "atan(2*x/(1-x^2))", {"-1<x<1"}, {}, 0},
      {"log(x*y)", "log(x)+log(y)", {"x>0", "y>0"}, {}, 0},
      {"sqrt(x^2*y)", "x*sqrt(y)", {"x>0", "y>0"}, {}, 0},
      {"a_p > g*tan(alpha)", "a_p*cos(alpha) > g*sin(alpha)", {}, {}, 0}};
  std::mt19937 random(7);
  int spoiled = 0;
  while (spoiled < 480) {
    const Json whole = *certificate_of(requests[static_cast<std::size_t>(spoiled) % requests.size()]);
    REQUIRE(verdict(whole) == "accepted");
    std::vector<Json::json_pointer> places;  // all of which a change makes false
    const Json flat = whole.flatten();
    for (const auto& [path, item] : flat.items()) {
      const bool idle = path == "/format" || path.find("/ranges/") != std::string::npos ||
                        path.ends_with("/cofactor") || path.ends_with("/degree") || path.ends_with("/over");
      if (!idle) places.emplace_back(path);
    }
    Json broken = whole;
    Json& item = broken[places[random() % places.size()]];
    if (item.is_string()) {
      const std::string text = slip(item.get<std::string>(), random);
      if (text.empty()) continue;
      item = text;
    } else if (item.is_number()) {
      item = item.get<int>() + 1;
    } else {
      continue;
    }
    ++spoiled;
    INFO(Json::diff(whole, broken).dump());
    CHECK(verdict(broken) != "accepted");
  }
}

TEST_CASE("a wrong branch, a factor that vanishes and an inequality turned round are seen") {
  Json root = *certificate_of({"sqrt(x^2)", "x", {"x > 0"}, {}, 0});
  root["ranges"]["x"] = root["pieces"][0]["ranges"]["x"] = "(-inf, inf)";
  CHECK(verdict(root) == "another branch of ^");
  root["pieces"][0]["ranges"]["x"] = "(0, inf)";
  CHECK(verdict(root) == "the pieces do not make up the whole");
  Json cofactor = *certificate_of({"sqrt(1+sin(2*alpha))", "sin(alpha)+cos(alpha)", {}, {}, 0});
  cofactor["ranges"]["alpha"] = cofactor["pieces"][0]["ranges"]["alpha"] = "(-pi, pi)";
  CHECK(verdict(cofactor) == "the cofactor vanishes, not what remains");
  Json strict = *certificate_of({"x < y", "2*x < 2*y", {}, {}, 0});
  CHECK(verdict(strict) == "accepted");
  strict["right"][1] = "<=";
  CHECK(verdict(strict) == "only one allows equality");
  Json turned = *certificate_of({"m*a < m*b", "a < b", {}, {}, 0});
  turned["ranges"]["m"] = turned["pieces"][0]["ranges"]["m"] = "(-inf, 0)";
  CHECK(verdict(turned) == "a factor turns the inequality round");
}

TEST_CASE("a certificate says that a false statement is proved: the checker disagrees") {
  Json c = *certificate_of({"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, 0});
  c["right"][0] = "2*sin(x)";
  CHECK(verdict(c) == "the right side is another one");
  Json& link = c["pieces"][0]["links"][0];
  link["right"] = link["left"];
  CHECK(verdict(c) == "the right side is another one");
}

TEST_CASE("the ledger is certified row by row") {
  TemporaryFolder folder;
  const Result r = run_program("ledger", {"certify", (folder.path / "certificates").string()});
  INFO(r.out << r.err);
  CHECK(r.exit_code == 0);
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path / "certificates")) {
    INFO(file.path().string());
    CHECK(verdict(Json::parse(read_file(file.path()))) == "accepted");
    ++count;
  }
  CHECK(count >= 150);
}

TEST_CASE("prove writes the certificate of what it proves, and of nothing else") {
  TemporaryFolder folder;
  const std::string file = (folder.path / "c.json").string();
  CHECK(run_program("ledger", {"prove", "sin(2*x)", "2*sin(x)*cos(x)", "--certificate", file}).exit_code ==
        0);
  CHECK(verdict(Json::parse(read_file(file))) == "accepted");
  const std::string other = (folder.path / "d.json").string();
  CHECK(run_program("ledger", {"prove", "sin(2*x)", "2*sin(x)", "--certificate", other}).exit_code == 1);
  CHECK_FALSE(std::filesystem::exists(other));
}
