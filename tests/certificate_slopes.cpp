// Certificates whose signs are seen from slopes, and those in pieces: what the checker takes, and what not.
#include <doctest/doctest.h>

#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/prove_command.hpp>
#include <tests/certificate_by_hand.hpp>

using namespace rederive;
using Json = nlohmann::json;

namespace {

const std::string open_form = "the form leaves it open";

std::string verdict_of(const Json& certificate) {
  try {
    certificate_checker::check(certificate);
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// Of "form op 0 always holds" for x in a range, with what is said of the slope of the form.
std::string sloped(const std::string& form, const std::string& range, const Json& why,
                   const std::string& op = ">", const Json& divisors = Json::array(),
                   Json ranges = Json::object()) {
  const auto link = [](const char* where, const std::string& f) -> Json {
    return {{where, {{"link", 0}, {"form", f}}}, {"holds", true}};
  };
  Json c = Json::parse(certificate(parse_statement("x^2+1 > 0", paper_symbols()), parse_statement("0 < 1"),
                                   make_context({"x", "x", {}, {}, {}}).symbols, {})
                           .dump());
  c["left"] = {form, op, "0"}, c["right"] = {"0", "<", "1"};
  ranges["x"] = range;
  c["ranges"] = ranges, c["slopes"] = {{form, why}}, c["divisors"] = divisors;
  c["pieces"] = {{{"steps", Json::array()}, {"links", {link("left", form), link("right", "1")}}}};
  return verdict_of(c);
}
Json from(const std::string& how, int sign, const std::string& slope, const std::string& bend = "") {
  Json why{{"in", "x"}, {"sign", sign}, {"how", how}, {"slope", slope}};
  if (!bend.empty()) why["bend"] = bend;
  return why;
}

Json certificate_of(const std::string& left, const std::string& right,
                    const std::vector<std::string>& assumptions = {}) {
  return Json::parse(decide({left, right, assumptions, {}, {}}).certificate.dump());
}

}  // namespace

TEST_CASE("what is not negative at an end and grows from there is positive") {
  const std::string f = "x^2-x";
  CHECK(sloped(f, "(1, inf)", from("low", 1, "2*x-1")) == "accepted");
  CHECK(sloped(f, "[1, inf)", from("low", 1, "2*x-1")) == open_form);  // it is 0 at 1
  CHECK(sloped(f, "[1, inf)", from("low", 1, "2*x-1"), ">=") == "accepted");
  CHECK(sloped(f, "(-inf, 0)", from("high", 1, "2*x-1")) == "accepted");
  CHECK(sloped(f, "(-inf, 1)", from("high", 1, "2*x-1")) == "a slope of unknown sign: 2*x-1");
  CHECK(sloped(f, "(1, inf)", from("low", 1, "2*x")) == "another slope of x^2-x");
  CHECK(sloped(f, "(1, inf)", from("low", -1, "2*x-1")) == "a slope of unknown sign: 2*x-1");
  CHECK(sloped(f, "(1, inf)", from("low", 2, "2*x-1")) == "no sign");
  CHECK(sloped(f, "(1, inf)", from("high", 1, "2*x-1")) == "a slope of unknown sign: 2*x-1");
  CHECK(sloped("1-x", "(0, inf)", from("high", -1, "-1")) == "a slope of unknown sign: -1");
  CHECK(sloped("1-x", "(0, inf)", from("high", 1, "-1")) == "it may have no value at an end: 1-x");
  CHECK(sloped(f, "(1/2, inf)", from("low", 1, "2*x-1")) == "of another sign at an end: x^2-x");
  CHECK(sloped(f, "(0, inf)", from("low", 1, "2*x-1")) == "a slope of unknown sign: 2*x-1");
  CHECK(sloped("x-x", "(0, inf)", from("low", 1, "0")) == "no slope: 0");
  CHECK(sloped(f, "(1, inf)", from("soon", 1, "2*x-1")) == "no such reason: soon");
  Json of_another = from("low", 1, "2*x-1");
  of_another["in"] = "y";
  CHECK(sloped(f, "(1, inf)", of_another) == "no slope in y");
}

TEST_CASE("so is what bends down between two ends where it is not negative") {
  CHECK(sloped("x-x^2", "(0, 1)", from("ends", 1, "1-2*x", "-2")) == "accepted");
  CHECK(sloped("x-x^2", "(0, 1]", from("ends", 1, "1-2*x", "-2")) == open_form);
  CHECK(sloped("x-x^2", "(0, 2)", from("ends", 1, "1-2*x", "-2")) == "of another sign at an end: x-x^2");
  CHECK(sloped("x-x^2", "(0, 1)", from("ends", 1, "1-2*x", "2")) == "another slope of 1-2*x");
  CHECK(sloped("x^2-x", "(0, 1)", from("ends", 1, "2*x-1", "2")) == "a slope of unknown sign: 2");
  CHECK(sloped("x-x^2", "(0, inf)", from("ends", 1, "1-2*x", "-2")) ==
        "it may have no value at an end: x-x^2");
}

TEST_CASE("and what is positive inside, and at the ends of its range") {
  const std::string f = "x+(1-x)^2";
  CHECK(sloped(f, "[0, 1]", from("inside", 1, f)) == "accepted");
  CHECK(sloped(f, "[0, 1]", from("inside", -1, f)) == "of another sign inside: " + f);
  const std::string g = "x*(1-x)";
  CHECK(sloped(g, "[0, 1]", from("inside", 1, g)) == open_form);  // 0 at the ends
  CHECK(sloped(g, "(0, 1)", from("inside", 1, g)) == "accepted");
  CHECK(sloped("x-x^2", "(0, 1)", from("inside", 1, "x-x^2")) == "of another sign inside: x-x^2");
  CHECK(sloped("x-x^2", "(0, 1)", from("inside", 1, g)) == "accepted");
  CHECK(sloped("x-x^2", "[0, 1]", from("inside", 1, g)) == open_form);
  CHECK(sloped("x-x^2", "[0, 1]", from("inside", 1, g), ">=") == "accepted");
  CHECK(sloped("x-x^2", "[0, 1)", from("inside", 1, "x^2*(1/x-1)"), ">=") == "accepted");
  CHECK(sloped("x-x^2", "[0, 2)", from("inside", 1, "x^2*(1/x-1)"), ">=") == "of another sign inside: x-x^2");
  CHECK(sloped("x-x^2", "(0, 1)", from("inside", 1, "x")) == "another: x");
}

TEST_CASE("of several names a slope is positive whatever the others are") {
  const auto with_y = [](const std::string& form, const std::string& slope, const std::string& of_y,
                         const std::string& at_low = "") {
    Json why = from("low", 1, slope);
    if (!at_low.empty()) why["at low"] = at_low;
    return sloped(form, "(0, inf)", why, ">", Json::array(), {{"y", of_y}});
  };
  CHECK(with_y("y^2*x", "y^2", "(0, inf)") == "accepted");
  CHECK(with_y("y^2*x", "y^2", "(-inf, inf)") == "a slope that may be 0 for some values of others: y^2");
  CHECK(with_y("x*y+y-1/2*y", "y", "(0, inf)") == "of another sign at an end: x*y+y-1/2*y");
  CHECK(with_y("x*y+y-1/2*y", "y", "(0, inf)", "1/2*y") == "accepted");
  CHECK(with_y("x*y+y-1/2*y", "y", "(0, inf)", "1/3*y") == "another value at an end: x*y+y-1/2*y");
  CHECK(with_y("x*y+y-2*y", "y", "(0, inf)", "-y") == "of another sign at an end: x*y+y-2*y");
}

TEST_CASE("what is taken times a slope is positive") {
  const auto times = [](const std::string& form, int sign, const std::string& by, const std::string& slope) {
    Json why = from("low", sign, slope);
    why["by"] = by;
    return sloped(form, "(0, inf)", why, ">", {"1+x"});
  };
  CHECK(times("x/(1+x)", 1, "(1+x)^2", "1") == "accepted");
  CHECK(times("x/(1+x)", 1, "(1+x)^2", "2") == "another slope of x/(1+x)");
  CHECK(times("-x/(1+x)", 1, "-(1+x)^2", "1") == "it may turn the slope round: -(1+x)^2");
  CHECK(times("x/(1+x)", 1, "(1-x)^2", "(1-x)^2/(1+x)^2") == "it may turn the slope round: (1-x)^2");
}

TEST_CASE("a function that grows is a layer") {
  const auto layered = [](const std::string& f_of_y, const Json& ranges, const Json& why,
                          const std::string& function = "x^3+x", bool falls = false) {
    const auto side = [](const Json& layers) -> Json {
      return {{"links", Json::array({{{"link", 0}, {"layers", layers}}})}, {"residual", "x-y"}};
    };
    const Json layer{{"function", "of"}, {"falls", falls}, {"left", "x"}, {"right", "y"}, {"of", function}};
    const Json link{{"left", side(Json::array({layer}))},
                    {"right", side(Json::array())},
                    {"factor", Json::object()},
                    {"cofactor", "1"}};
    const std::string op = falls ? "<" : ">";
    Json c = by_hand::certificate({function, op, f_of_y}, {"x", ">", "y"}, ranges, Json::array({link}));
    c["slopes"] = {{function, why}};
    if (function == "-1/x") c["divisors"] = {"x", "y"};
    return verdict_of(c);
  };
  const Json real{{"x", "(-inf, inf)"}, {"y", "(-inf, inf)"}}, grows = from("grows", 1, "3*x^2+1");
  CHECK(layered("y^3+y", real, grows) == "accepted");
  CHECK(layered("y^3+y+1", real, grows) == "another layer");
  CHECK(layered("y^3", {{"x", "(-inf, inf)"}, {"y", "(-inf, inf)"}}, from("grows", 1, "3*x^2"), "x^3") ==
        "accepted");  // 0 at a single point
  CHECK(layered("y^3+y", {{"x", "(-inf, inf)"}, {"y", "(0, inf)"}}, grows) == "accepted");
  CHECK(layered("y^3+y", {{"x", "(0, inf)"}, {"y", "(-inf, inf)"}}, grows) == "not in the range of x: y");
  CHECK(layered("y^3+y", {{"x", "(0, inf)"}, {"y", "[0, inf)"}}, grows) == "not in the range of x: y");
  CHECK(layered("y^3+y", real, from("grows", 1, "3*x^2+2")) == "another slope of x^3+x");
  CHECK(layered("y^3+y", real, from("low", 1, "3*x^2+1")) == "no growth: x^3+x");
  CHECK(layered("y^3-y", real, from("grows", 1, "3*x^2-1"), "x^3-x") == "a slope of unknown sign: 3*x^2-1");
  CHECK(layered("y^3+y", real, grows, "x^3+x", true) == "no such growth");
  CHECK(layered("-y", real, from("grows", -1, "-1"), "-x", true) == "accepted");
  CHECK(layered("-y", real, from("grows", -1, "-1"), "-x") == "no such growth");
  CHECK(layered("1", real, from("grows", 1, "0"), "1") == "no slope: 0");
  const auto of_three = [&](const char* of_z) {
    const Json three{{"x", "(0, 1)"}, {"y", "(0, 1)"}, {"z", of_z}};
    return layered("y*z^2", three, from("grows", 1, "z^2"), "x*z^2");
  };
  CHECK(of_three("(0, inf)") == "accepted");
  CHECK(of_three("(-inf, inf)") == "a slope that may be 0 for some values of others: z^2");
  Json other = grows;
  other["in"] = "y";
  CHECK(layered("y^3+y", real, other) == "another slope of x^3+x");
  CHECK(sloped("x", "(0, inf)", from("grows", 1, "1")) == "accepted");  // by its range alone
  CHECK(sloped("x-1", "(0, inf)", from("grows", 1, "1")) == open_form);
  CHECK(sloped("x^3+8", "(-2, 1)", from("grows", 1, "1")) == "accepted");  // an odd power grows
  CHECK(sloped("x^3+8", "(-3, 1)", from("grows", 1, "1")) == open_form);
  const Json pole{{"x", "(-1, 1)"}, {"y", "(-1, 1)"}};
  CHECK(layered("-1/y", pole, from("grows", 1, "1/x^2"), "-1/x") == "it may have no value: -1/x");
}

TEST_CASE("an even function is a layer, up to the sign of a name") {
  const auto layered = [](const std::string& f, const std::string& of_y, const std::string& slope,
                          const Json& ranges, bool falls = false) {
    const auto side = [](const Json& layers) -> Json {
      return {{"links", Json::array({{{"link", 0}, {"layers", layers}}})}, {"residual", "x^2-y^2"}};
    };
    const Json layer{{"function", "even of"}, {"falls", falls}, {"left", "x"}, {"right", "y"}, {"of", f}};
    const Json link{{"left", side(Json::array({layer}))},
                    {"right", side(Json::array())},
                    {"factor", Json::object()},
                    {"cofactor", "1"}};
    Json c =
        by_hand::certificate({f, falls ? "<" : ">", of_y}, {"x^2", ">", "y^2"}, ranges, Json::array({link}));
    c["slopes"] = {{f, from("grows", falls ? -1 : 1, slope)}};
    if (f == "-1/x^2") c["divisors"] = {"x^2", "y^2"};
    return verdict_of(c);
  };
  const Json ranges{{"x", "(0, inf)"}, {"y", "(-inf, inf)"}};
  CHECK(layered("x^4+x^2", "y^4+y^2", "4*x^3+2*x", ranges) == "accepted");
  CHECK(layered("-x^2", "-y^2", "-2*x", ranges, true) == "accepted");
  CHECK(layered("-x^2", "-y^2", "-2*x", ranges) == "a slope of unknown sign: -2*x");
  CHECK(layered("x^3+x", "y^3+y", "3*x^2+1", ranges) == "not even: x^3+x");
  CHECK(layered("x^4+x^2", "y^4+2*y^2", "4*x^3+2*x", ranges) == "another layer");
  CHECK(layered("x^4+x^2", "y^4+y^2", "4*x^3+2*x", {{"x", "(0, 1)"}, {"y", "(-1, 1)"}}) == "accepted");
  CHECK(layered("x^4+x^2", "y^4+y^2", "4*x^3+2*x", {{"x", "(0, 1)"}, {"y", "[-1, 1)"}}) ==
        "not in the range of x: y");
  CHECK(layered("x^4+x^2", "y^4+y^2", "4*x^3+2*x", {{"x", "(0, 1)"}, {"y", "(-2, 1)"}}) ==
        "not in the range of x: y");
  CHECK(layered("x^3+x", "y^3+y", "3*x^2+1", {{"x", "(-inf, inf)"}, {"y", "(-inf, inf)"}}) ==
        "of either sign: x");
  CHECK(layered("-1/x^2", "-1/y^2", "2/x^3", ranges) == "a divisor is 0");  // it has no value at 0
}

TEST_CASE("a slope says nothing across a pole or a kink") {
  const Json divisor{"x"};
  CHECK(sloped("x-1/x", "(-1/2, inf)", from("low", 1, "1+1/x^2"), ">", divisor) ==
        "it may have no value: x-1/x");
  CHECK(sloped("x-1/x", "(1, inf)", from("low", 1, "1+1/x^2"), ">", divisor) == "accepted");
  CHECK(sloped("x-1/x", "(0, inf)", from("low", 1, "1+1/x^2"), ">", divisor) ==
        "it may have no value at an end: x-1/x");
}

TEST_CASE("a certificate in pieces covers the range, and every point between") {
  const Json c = certificate_of("exp(x) >= 1+x", "0 < 1");
  REQUIRE(c.at("cells").size() == 2);
  CHECK(verdict_of(c) == "accepted");
  Json spoiled = c;
  spoiled["cells"].erase(0);
  CHECK(verdict_of(spoiled) == "a gap before (0, inf)");
  spoiled = c, spoiled["cells"].erase(1);
  CHECK(verdict_of(spoiled) == "the cells end at 0");
  spoiled = c, spoiled["left"] = spoiled["right"];
  CHECK(verdict_of(spoiled) == "another statement in (-inf, 0)");
  spoiled = c, spoiled["cells"][0]["range"] = "(-inf, 1)", spoiled["cells"][1]["range"] = "(1, inf)";
  CHECK(verdict_of(spoiled) == "another statement in (-inf, 1)");
  spoiled = c, spoiled["cells"][1].erase("certificate");
  CHECK(verdict_of(spoiled) == "it holds in (0, inf)");
  spoiled = c, spoiled["range"] = "[-1, inf)";
  CHECK(verdict_of(spoiled) == "a gap before (-inf, 0)");
  Json strict = c;  // on either side the same, but not at 0
  for (Json* s : {&strict, &strict["cells"][0]["certificate"], &strict["cells"][1]["certificate"]})
    (*s)["left"][1] = ">";
  CHECK(verdict_of(strict) == "they differ at 0");
  Json excluded = certificate_of("exp(x) > 1+x", "0 < 1", {"x != 0"});
  CHECK(verdict_of(excluded) == "accepted");
  for (Json* s : {&excluded, &excluded["cells"][0]["certificate"], &excluded["cells"][1]["certificate"]})
    (*s)["never zero"] = {"x-1"};
  CHECK(verdict_of(excluded) == "they differ at 0");
}

TEST_CASE("so does one of expressions, where they may be equal on either side alone") {
  const Json c = certificate_of("acos(sin(psi))", "fabs(pi/2-psi)");
  CHECK(verdict_of(c) == "accepted");
  const Json root = certificate_of("sqrt(x-1)+sqrt(x) = 1", "x = 1");
  CHECK(verdict_of(root) == "accepted");
  Json other = root;
  other["right"] = {"x", "=", "2"};
  CHECK(verdict_of(other) != "accepted");
}

TEST_CASE("what is compared with a relation of numbers is so wherever it has a value") {
  const Json log = certificate_of("log(x) <= x - 1", "0 < 1"), sine = certificate_of("sin(x)/x < 1", "0 < 1");
  CHECK(verdict_of(log) == "accepted");
  CHECK(verdict_of(sine) == "accepted");
  Json part = certificate_of("sqrt(x) >= 1", "0 < 1", {"x > 1"});
  CHECK(verdict_of(part) == "accepted");
  part["declared"] = {{"x", "(0, inf)"}};
  CHECK(verdict_of(part) == "it holds outside of the ranges: x");
  part["left"] = {"sqrt(x-1)", ">=", "0"}, part["declared"] = {{"x", "(-inf, inf)"}};
  CHECK(verdict_of(part) != "it holds outside of the ranges: x");  // without a value below 1
  Json nowhere = log;
  nowhere["in"] = "x", nowhere["range"] = "(-inf, 0)", nowhere["cells"] = {{{"range", "(-inf, 0)"}}};
  CHECK(verdict_of(nowhere) == "it is compared nowhere");
  nowhere["left"] = {"x", ">", "0"};
  CHECK(verdict_of(nowhere) == "it holds in (-inf, 0)");
  nowhere["left"] = log["left"], nowhere["right"] = {"x", "<", "1"};
  CHECK(verdict_of(nowhere) == "it holds in (-inf, 0)");
}

TEST_CASE("a factor that grows is 0 at one place, which is in the range") {
  Json good = certificate_of("sin(x)*y = 0", "x*y = 0", {"-1 < x < 1"});
  CHECK(verdict_of(good) == "accepted");
  const auto spoiled = [&](const auto& spoil) {
    Json c = good;
    spoil(c);
    return verdict_of(c);
  };
  const auto zero_of = [](Json& c) -> Json& { return c["pieces"][0]["links"][0]["zeros"]["sin(x)"]; };
  const std::string refusal = "no growth in x from 0: sin(x)";
  CHECK(spoiled([&](Json& c) { zero_of(c)["x"]["at"] = "x"; }) == refusal);
  CHECK(spoiled([&](Json& c) { zero_of(c)["x"]["at"] = "1/2"; }) == "nothing is said of exp");
  CHECK(spoiled([&](Json& c) { zero_of(c) = {{"y", {{"at", "0"}}}}; }) == "no growth in y from 0: sin(x)");
  CHECK(spoiled([&](Json& c) { c["slopes"] = Json::object(); }) == refusal);
  CHECK(spoiled([&](Json& c) { c["slopes"]["sin(x)"]["slope"] = "1"; }) == "another slope of sin(x)");
  CHECK(spoiled([&](Json& c) { c["slopes"]["sin(x)"]["how"] = "low"; }) ==
        "of another sign at an end: sin(x)");
  CHECK(spoiled([&](Json& c) { c["ranges"]["x"] = "(-4, 4)"; }) == "a slope of unknown sign: cos(x)");
  // it falls there, and is 0 at pi, not at 0
  CHECK(spoiled([&](Json& c) { c["ranges"]["x"] = "(2, 4)", c["slopes"]["sin(x)"]["sign"] = -1; }) ==
        refusal);
  // what is listed as a divisor, but is none
  CHECK(spoiled([&](Json& c) {
          c["right"] = {"(x-1)*y", "=", "0"}, c["divisors"] = {"x"};
          c["pieces"][0]["links"][0]["right"]["residual"] = "(x-1)*y";
          c["pieces"][0]["links"][0]["factor"] = {{"sin(x)", 1}, {"x-1", -1}};
        }) == "a factor may vanish: sin(x)");
  // the other side has no zero there
  Json other = certificate_of("sinh(x)*y = 0", "x*y = 0");
  CHECK(verdict_of(other) == "accepted");
  other["right"] = {"(x+1)*y", "=", "0"};
  CHECK(verdict_of(other) != "accepted");
}

TEST_CASE("bars are 0 where what is between them is") {
  Json c = certificate_of("fabs(x)*y = 0", "x*y = 0");
  CHECK(verdict_of(c) == "accepted");
  Json& place = c["pieces"][0]["links"][0]["zeros"]["fabs(x)"]["x"];
  place["at"] = "1";
  CHECK(verdict_of(c) == "another power of x");
  place["at"] = "0", place["share"] = "2";
  CHECK(verdict_of(c) == "another power of x");
  place["share"] = "1/2", place["more"] = "1/2*x^2";
  CHECK(verdict_of(c) == "accepted");
  place["more"] = "x-1/2*x^2";
  CHECK(verdict_of(c) == "more may be negative");
}
