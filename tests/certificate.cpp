// Certificates: written for what is proved, accepted by a checker that shares no code, rejected when spoiled.
#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <lessons/ledger/prove_table.hpp>
#include <random>
#include <tests/certificate_relations.hpp>
#include <tests/certificate_replay.hpp>
#include <tests/run_program.hpp>

using namespace rederive;
using Json = nlohmann::json;

namespace {

/// Of what is proved; null of all else.
Json certificate_of(const ProveRequest& request) { return Json::parse(decide(request).certificate.dump()); }

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

/// A name that nothing else mentions may be any other one.
bool is_unused(const Json& certificate, const std::string& name) {
  const std::string text = certificate.dump();
  return text.find(name) == text.rfind(name);
}

}  // namespace

TEST_CASE("nothing is proved that has no certificate, or one that is not accepted") {
  const auto decided = decide({"tanh(x) >= 1/2", "tanh(x)^3-3/2*tanh(x)^2+3/4*tanh(x)-1/8 >= 0", {}, {}, {}});
  CHECK(decided.proof.verdict == Verdict::undecided);
  CHECK(decided.proof.reason.find("it seems to hold") == 0);
  CHECK(decided.certificate.is_null());
}

TEST_CASE("of several solutions of what is assumed each has a certificate of its own") {
  const Json whole = certificate_of({"1-x^2", "y^2", {"x^2+y^2 = 1"}, {}, {}});
  CHECK(verdict(whole) == "accepted");
  REQUIRE(whole["cases"].size() == 2);
  CHECK(whole["cases"][0]["given"]["x"] == "sqrt(1 - y^2)");
  CHECK(whole["cases"][1]["given"]["x"] == "-sqrt(1 - y^2)");
  const auto rejects = [&](const auto& spoil) {
    Json broken = whole;
    spoil(broken);
    CHECK(verdict(broken) != "accepted");
  };
  rejects([](Json& c) { c["right"][0] = "y^2 + 1"; });
  rejects([](Json& c) { c["cases"][1]["right"][0] = "-(-y^2)"; });  // the same, but another statement
  rejects([](Json& c) { c["cases"][1]["given"]["x"] = "-sqrt(2 - y^2)"; });
  rejects([](Json& c) { c["cases"].erase(1); });
  rejects([](Json& c) { c["cases"][1] = c; });
}

TEST_CASE("spoiled certificates are rejected") {
  const std::vector<ProveRequest> requests{
      {"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, {}},
      {"m*R*thetaddot + m*g*sin(theta) = 0", "thetaddot = -g/R*sin(theta)", {}, {}, {}},
      {"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", {}, {}, {}},
      {"cosh(x)^2-sinh(x)^2", "1", {}, {}, {}},
      {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", {}, {}, {}},
      {"b^2+h^2", "R^2", {"b = R*sin(alpha)", "h = R*cos(alpha)"}, {}, {}},
      {"sqrt(1+sin(2*alpha))", "sin(alpha)+cos(alpha)", {}, {}, {}},
      {"sin(pi/5)^2", "(5-sqrt(5))/8", {}, {}, {}},
      {"2*atan(x)", "atan(2*x/(1-x^2))", {"-1<x<1"}, {}, {}},
      {"log(x*y)", "log(x)+log(y)", {"x>0", "y>0"}, {}, {}},
      {"sqrt(x^2*y)", "x*sqrt(y)", {"x>0", "y>0"}, {}, {}},
      {"a_p > g*tan(alpha)", "a_p*cos(alpha) > g*sin(alpha)", {}, {}, {}},
      {"log(x) < log(y)", "x < y", {}, {}, {}},
      {"x^2+y^2 >= 2*x*y", "1 > 0", {}, {}, {}},
      {"0 < x < 1", "x^2 < x", {}, {}, {}},
      {"b < 1", "0 < b < 1", {}, {}, {}}};
  std::mt19937 random(7);
  int spoiled = 0, identities = 0;
  while (spoiled < 480) {
    const Json whole = certificate_of(requests[static_cast<std::size_t>(spoiled) % requests.size()]);
    REQUIRE(verdict(whole) == "accepted");
    std::vector<Json::json_pointer> places;  // all of which a change makes false
    const Json flat = whole.flatten();
    for (const auto& [path, item] : flat.items()) {
      const bool idle = path == "/format" || path.find("/ranges/") != std::string::npos ||
                        path.ends_with("/cofactor") || (path.ends_with("/name") && is_unused(whole, item));
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
    const bool is_side_condition = !broken.contains("pieces") || broken["ranges"] != whole["ranges"] ||
                                   broken["divisors"] != whole["divisors"];
    if (!is_identity(whole) || is_side_condition) continue;
    ++identities;
    CHECK(replay(broken) != "accepted");
  }
  CHECK(identities >= 100);
}

TEST_CASE("a wrong branch, a factor that vanishes and an inequality turned round are seen") {
  Json root = certificate_of({"sqrt(x^2)", "x", {"x > 0"}, {}, {}});
  root["ranges"]["x"] = "(-inf, inf)";
  CHECK(verdict(root) == "another branch of ^1/2");
  Json size = certificate_of({"acosh(cosh(x))", "fabs(x)", {}, {}, {}});
  CHECK(verdict(size) == "accepted");
  size["pieces"][0] = size["pieces"][1];  // as if x were positive on both sides of 0
  CHECK(verdict(size) == "another branch of ^1/2");
  size["cut"] = Json::array();
  CHECK(verdict(size) == "another branch of ^1/2");
  Json cofactor = certificate_of({"sqrt(1+sin(2*alpha))", "sin(alpha)+cos(alpha)", {}, {}, {}});
  cofactor["ranges"]["alpha"] = "(-pi, pi)";
  CHECK(verdict(cofactor) == "a divisor is 0");
  Json strict = certificate_of({"x < y", "2*x < 2*y", {}, {}, {}});
  CHECK(verdict(strict) == "accepted");
  strict["right"][1] = "<=";
  CHECK(verdict(strict) == "only one allows equality");
}

TEST_CASE("a factor that may be 0 or negative is not taken on trust") {
  Json turned = certificate_of({"m*a < m*b", "a < b", {}, {}, {}});
  for (const char* range : {"(-inf, 0)", "(-inf, inf)", "[0, inf)"}) {
    turned["ranges"]["m"] = range;
    CHECK(verdict(turned) != "accepted");
  }
  Json equation = certificate_of({"m*a = m*b", "a = b", {}, {}, {}});
  CHECK(verdict(equation) == "accepted");
  equation["ranges"]["m"] = "(-inf, inf)";  // m = 0 solves the left one, whatever a and b are
  CHECK(verdict(equation) == "a factor may vanish: m");
  Json cosine = certificate_of({"cos(theta)*x > 0", "x > 0", {}, {}, {}});
  cosine["ranges"]["theta"] = "(-pi/2, pi/2]";
  CHECK(verdict(cosine) == "a factor may vanish: cos(theta)");
  Json divided = certificate_of({"a/x = b/x", "a = b", {}, {}, {}});
  CHECK(verdict(divided) == "accepted");
  divided["divisors"] = Json::array();
  CHECK(verdict(divided) == "a divisor is not listed");
  Json sum = certificate_of({"x*(x^2+y^2) = 0", "x = 0", {}, {}, {}});
  CHECK(verdict(sum) == "accepted");
  sum["pieces"][0]["links"][0].erase("more");
  CHECK(verdict(sum) == "a factor may vanish: x^2 + y^2");
}

TEST_CASE("only increasing functions are taken off both sides of a relation") {
  const auto layers = [](const ProveRequest& request) -> std::pair<Json, Json> {
    const Json c = certificate_of(request);
    REQUIRE(verdict(c) == "accepted");
    return {c, c["pieces"][0]["links"][0]["left"]["links"][0]["layers"][0]};
  };
  const auto spoiled = [](Json c, const Json& layer) {
    c["pieces"][0]["links"][0]["left"]["links"][0]["layers"][0] = layer;
    return verdict(c);
  };
  auto [less, exponential] = layers({"exp(x) < exp(y)", "x < y", {}, {}, {}});
  exponential["function"] = "sinh";
  CHECK(spoiled(less, exponential) == "another layer");
  std::swap(less["left"][0], less["left"][2]);
  CHECK(verdict(less) != "accepted");
  auto [more, arc] = layers({"acos(x) < acos(y)", "x > y", {}, {}, {}});
  more["right"][1] = "<";  // as if acos increased
  CHECK(verdict(more) == "the right side is another one");
  Json& falls = more["pieces"][0]["links"][0];
  more["left"] = {"cos(x)", "<", "cos(y)"}, falls["left"]["links"][0]["layers"][0]["function"] = "cos";
  CHECK(verdict(more) != "accepted");
  const Json cosines = certificate_of({"cos(x)-cos(y) < 0", "cos(x) < cos(y)", {}, {}, {}});
  Json passed_off = cosines;  // knows cos(x) and cos(y)
  passed_off["left"] = {"cos(x)", "<", "cos(y)"}, passed_off["right"] = {"x", "<", "y"};
  passed_off["pieces"][0]["links"][0]["left"]["links"][0]["layers"] = {
      {{"function", "cos"}, {"falls", true}, {"left", "x"}, {"right", "y"}}};
  CHECK(verdict(passed_off) == "cos does not fall");
  auto [size, bars] = layers({"fabs(x) < 1", "x^2 < 1", {}, {}, {}});
  size["right"] = {"x", "<", "1"};  // of both signs: |x| < 1 is not x < 1
  CHECK(verdict(size) == "the right side is another one");
  auto [sixth, power] = layers({"x^6 < y^6", "x^2 < y^2", {}, {}, {}});
  sixth["right"] = {"x", "<", "y"}, sixth["pieces"][0]["links"][0]["right"]["residual"] = "y - x";
  CHECK(verdict(sixth) == "something remains");
  power["function"] = "^3";
  CHECK(spoiled(sixth, power) == "another layer");
}

TEST_CASE("ranges show that a factor is never 0") {
  const std::vector<ProveRequest> requests{{"(1-x)*y > 0", "y > 0", {"0<x<1"}, {}, {}},
                                           {"(1-x^2)*a > 0", "a > 0", {"-1<x<1"}, {}, {}},
                                           {"(x-2)*a = 0", "a = 0", {"x>3"}, {}, {}},
                                           {"sin(2*alpha)*x > 0", "x > 0", {}, {}, {}},
                                           {"(1-sin(alpha))*x > 0", "x > 0", {}, {}, {}},
                                           {"cos(alpha-theta)*x = 0", "x = 0", {"0<theta<pi/2"}, {}, {}},
                                           {"cosh(x) >= 1", "1 > 0", {}, {}, {}}};
  for (const ProveRequest& request : requests) {
    INFO(request.left);
    Json c = certificate_of(request);
    CHECK(verdict(c) == "accepted");
    for (const auto& [name, range] : c["ranges"].items())  // and any range does not
      if (request.left[0] != 'c' || name == "theta") {
        Json wide = c;
        for (Json& other : wide["ranges"]) other = "(-inf, inf)";
        CHECK(verdict(wide) != "accepted");
      }
  }
}

TEST_CASE("what always holds, or never, has a form that says so") {
  Json c = certificate_of({"x^2+y^2 >= 2*x*y", "1 > 0", {}, {}, {}});
  CHECK(verdict(c) == "accepted");
  Json& link = c["pieces"][0]["links"][0];
  const std::string form = link["left"]["form"];
  c["left"][1] = ">";  // x = y
  CHECK(verdict(c) == "the form leaves it open");
  c["left"][1] = ">=", link["left"]["form"] = "x^2 + y^2 - 2*x*y";
  CHECK(verdict(c) == "the form leaves it open");
  link["left"]["form"] = "x^2 + y^2";
  CHECK(verdict(c) == "the form is another one");
  link["left"]["form"] = form, link["holds"] = false;
  CHECK(verdict(c) == "the form leaves it open");
  Json closed = certificate_of({"m >= 0", "m > 0", {}, {}, {}});
  closed["ranges"]["m"] = "[0, inf)";
  CHECK(verdict(closed) == "the form leaves it open");
}

TEST_CASE("a certificate says that a false statement is proved: the checker disagrees") {
  Json c = certificate_of({"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, {}});
  c["right"][0] = "2*sin(x)";
  CHECK(verdict(c) == "the right side is another one");
  Json& link = c["pieces"][0]["links"][0];
  link["right"]["residual"] = link["left"]["residual"];
  CHECK(verdict(c) == "the right side is another one");
}

TEST_CASE("nothing in a certificate keeps the checker from looking where the statement has a value") {
  Json c = certificate_of({"sqrt(x^2)", "x", {"x > 0"}, {}, {}});
  CHECK(verdict(c) == "accepted");
  c["ranges"]["x"] = "(-inf, inf)";
  Json& steps = c["pieces"][0]["steps"];
  const Json honest = steps;
  const auto with = [&](const Json& step) {
    steps = honest;
    steps.insert(steps.begin(), step);
    return verdict(c);
  };
  // log(x) has no value for x < 0, 1/(x+|x|) neither
  CHECK(with({{"function", "log"}, {"of", "x"}, {"name", "$f"}}) != "accepted");
  CHECK(with({{"function", "^1/2"}, {"of", "x"}, {"name", "$r"}}) != "accepted");
  // x is no name of a generator
  c["ranges"].erase("x");
  CHECK(with({{"function", "log"}, {"of", "2"}, {"name", "x"}}) == "a statement may have that name: x");
  Json far = certificate_of({"sqrt((x-5)^2)", "x-5", {"x > 5"}, {}, {}});
  CHECK(verdict(far) == "accepted");
  far["ranges"]["x"] = "(-inf, inf)";
  CHECK(verdict(far) == "another branch of ^1/2");
  c["ranges"]["x"] = "(-inf, 0)";
  steps = honest;
  for (const char* noise :
       {"x + 10^40*(x - x)", "x + (2^60 - 2^30*2^30)*x", "x*(x + sqrt(x^2))/(x + sqrt(x^2))"})
    for (Json& step : steps)
      if (step.contains("is")) {
        INFO(noise);
        step["is"] = noise;
        CHECK(verdict(c) != "accepted");
      }
}

TEST_CASE("a statement is read whole") {
  Json c = certificate_of({"x = y", "2*x = 2*y", {}, {}, {}});
  CHECK(verdict(c) == "accepted");
  Json chain = c, op = c, power = c, generator = c;
  chain["right"].push_back("="), chain["right"].push_back("5");
  CHECK(verdict(chain) == "a link is left out");
  op["left"][1] = op["right"][1] = "!=";
  CHECK(verdict(op) == "no relation: !=");
  power["left"] = {"x^4294967297", "=", "y"};
  CHECK(verdict(power) != "accepted");
  generator["left"] = {"$i*x", "=", "$i*y"};
  CHECK(verdict(generator) == "a statement has no generators");
}

TEST_CASE("the ledger is certified row by row") {
  TemporaryFolder folder;
  const Result r = run_program("ledger", {"certify", (folder.path / "certificates").string()});
  INFO(r.out << r.err);
  CHECK(r.exit_code == 0);
  int count = 0, identities = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path / "certificates")) {
    INFO(file.path().string());
    const Json row = Json::parse(read_file(file.path()));
    CHECK(verdict(row) == "accepted");
    ++count;
    if (!is_identity(row)) continue;
    ++identities;
    CHECK(replay(row) == "accepted");
  }
  CHECK(count >= 150);
  CHECK(identities >= count - 1);  // as the README says
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
