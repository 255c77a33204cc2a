// Certificates: written for what is proved, accepted by a checker that shares no code, rejected when spoiled.
#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <random>
#include <tests/certificate_checker.hpp>
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
  int proved = 0, certified = 0, trusting = 0;
  for (const TableRow& row : read_table(std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml")) {
    if (row.expected != "proved" && row.expected != "proved_under") continue;
    ++proved;
    const auto c = certificate_of(row.request);
    if (!c) continue;
    INFO(row.request.left << "  |  " << row.request.right);
    CHECK(verdict(*c) == "accepted");
    ++certified;
    trusting += verdict(*c) == "accepted" && certificate_checker::check(*c) > 0 ? 1 : 0;
  }
  std::cout << proved << " proved, " << certified << " certificates, " << trusting
            << " with roots or branches taken on trust\n";
  CHECK(certified * 10 >= proved * 8);
}

TEST_CASE("a hundred spoiled certificates are rejected") {
  const std::vector<ProveRequest> requests{
      {"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, 0},
      {"m*R*thetaddot + m*g*sin(theta) = 0", "thetaddot = -g/R*sin(theta)", {}, {}, 0},
      {"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", {}, {}, 0},
      {"cosh(x)^2-sinh(x)^2", "1", {}, {}, 0},
      {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", {}, {}, 0},
      {"b^2+h^2", "R^2", {"b = R*sin(alpha)", "h = R*cos(alpha)"}, {}, 0}};
  std::mt19937 random(7);
  int spoiled = 0;
  while (spoiled < 120) {
    const Json whole = *certificate_of(requests[static_cast<std::size_t>(spoiled) % requests.size()]);
    REQUIRE(verdict(whole) == "accepted");
    std::vector<Json::json_pointer> places;  // every text and number that says something mathematical
    const Json flat = whole.flatten();
    for (const auto& [path, item] : flat.items()) {
      const bool idle = path == "/format" || path.find("/name") != std::string::npos ||
                        path.find("/kind") != std::string::npos || path.find("/facts") == 0;
      if (!idle && !item.is_boolean() && !(item.is_string() && item.get<std::string>().empty()))
        places.emplace_back(path);
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

TEST_CASE("a certificate says that a false statement is proved: the checker disagrees") {
  Json c = *certificate_of({"sin(2*x)", "2*sin(x)*cos(x)", {}, {}, 0});
  c["right"] = "2*sin(x)";
  CHECK(verdict(c) == "the right side is another one");
  c["links"][0]["right"] = c["links"][0]["left"];
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
