// Certificates over less than the declared ranges, and of names that are replaced by others.
#include <doctest/doctest.h>

#include <tests/certificate_by_hand.hpp>

using namespace by_hand;

namespace {

Json settled(const char* where, int link, const std::string& form, bool holds) {
  return {{where, {{"link", link}, {"form", form}}}, {"holds", holds}};
}

/// What the checker says of two statements about x in a range.
std::string verdict_over(const std::string& range, const std::string& declared, const Json& left,
                         const Json& right, const Json& given, const Json& steps, const Json& links) {
  Json c{{"format", "rederive certificate 11"},
         {"left", left},
         {"right", right},
         {"given", given},
         {"divisors", Json::array()},
         {"never zero", Json::array()},
         {"parts of divisors", Json::object()},
         {"slopes", Json::object()},
         {"ranges", {{"x", range}}},
         {"declared", declared.empty() ? Json::object() : Json{{"x", declared}}},
         {"cut", Json::array()},
         {"pieces", {{{"steps", steps}, {"links", links}}}}};
  if (given.contains("y")) c["ranges"]["y"] = "(0, 1)";
  try {
    certificate_checker::check(c);
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("outside of the ranges of a certificate neither statement may hold") {
  const Json always{"0", "<", "1"}, none = Json::object(), steps = Json::array();
  const Json links = Json::array({settled("left", 0, "x", true), settled("right", 0, "1", true)});
  CHECK(verdict_over("(0, inf)", "", {"0", "<", "x"}, always, none, steps, links) == "accepted");
  CHECK(verdict_over("(0, inf)", "(-inf, inf)", {"0", "<", "x"}, always, none, steps, links) ==
        "it holds outside of the ranges: x");
  CHECK(verdict_over("(0, 1]", "(-inf, inf)", {"0", "<", "x"}, always, none, steps, links) ==
        "it holds outside of the ranges: x");
  const Json log = Json::array({{{"function", "log"}, {"of", "x"}, {"name", "$f"}}});
  const Json same{{"left", {{"links", {{{"link", 0}}}}, {"residual", "$f"}}},
                  {"right", {{"links", {{{"link", 0}}}}, {"residual", "$f"}}},
                  {"factor", none},
                  {"cofactor", "1"}};
  const Json logarithm{"log(x)", ">", "0"};
  CHECK(verdict_over("(0, inf)", "(-inf, inf)", logarithm, logarithm, none, log, Json::array({same})) ==
        "accepted");
  CHECK(verdict_over("(1, inf)", "(-inf, inf)", logarithm, logarithm, none, log, Json::array({same})) ==
        "accepted");
  CHECK(verdict_over("(2, inf)", "(-inf, inf)", logarithm, logarithm, none, log, Json::array({same})) ==
        "it holds outside of the ranges: x");
}

TEST_CASE("a name that is replaced keeps its range") {
  const Json always{"0", "<", "1"}, given{{"y", "2*x"}}, steps = Json::array({{{"given", "y"}}});
  const auto of = [&](const std::string& form) {
    return verdict_over("(-inf, inf)", "", {form, ">", "0"}, always, given, steps,
                        {settled("left", 0, form, true), settled("right", 0, "1", true)});
  };
  CHECK(of("y") == "accepted");
  CHECK(of("1-y") == "accepted");
  CHECK(of("1/2-y") == "the form leaves it open");
  CHECK(of("x") == "the form leaves it open");
  const Json root{{"function", "^1/2"}, {"of", "x^2"}, {"is", "x"}};  // where x is not negative
  const Json same{{"left", {{"links", {{{"link", 0}}}}, {"residual", "x"}}},
                  {"right", {{"links", {{{"link", 0}}}}, {"residual", "x"}}},
                  {"factor", Json::object()},
                  {"cofactor", "1"}};
  CHECK(verdict_over("(-inf, inf)", "", {"sqrt(x^2)"}, {"x"}, given, Json::array({steps[0], root}),
                     Json::array({same})) == "accepted");
  CHECK(verdict_over("(-inf, inf)", "", {"sqrt(x^2)"}, {"x"}, Json::object(), Json::array({root}),
                     Json::array({same})) == "another branch of ^1/2");
}
