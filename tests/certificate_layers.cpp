// False statements, and certificates for them that take off what must not be taken off; true ones beside them
// show that the form is right.
#include <doctest/doctest.h>

#include <tests/certificate_by_hand.hpp>

using namespace by_hand;

TEST_CASE("functions that do not increase all over the domain, factors that may vanish") {
  const auto of = [](const std::string& f, const std::string& range, bool falls) {
    const Json steps = Json::array({{{"function", "exp"}, {"of", "$i*x"}, {"name", "$z"}},
                                    {{"function", "exp"}, {"of", "$i*y"}, {"name", "$w"}}});
    Json link = linked("y-x", "y-x"), divisors = Json::array();
    if (falls) link = linked("x-y", "x-y");
    link["left"]["links"][0]["layers"] =
        Json::array({{{"function", f}, {"falls", falls}, {"left", "x"}, {"right", "y"}}});
    if (f == "tan") divisors = {"cos(x)", "cos(y)"};
    if (f == "cot") divisors = {"sin(x)", "sin(y)"};
    return verdict({f + "(x)", "<", f + "(y)"}, {"x", falls ? ">" : "<", "y"}, {{"x", range}, {"y", range}},
                   steps, link, Json::array(), divisors);
  };
  CHECK(of("sin", "(-pi/2, pi/2)", false) == "accepted");
  CHECK(of("sin", "(0, pi)", false) == "sin does not increase");
  CHECK(of("sin", "(-2, pi/2)", false) == "sin does not increase");
  CHECK(of("cos", "(0, pi)", true) == "accepted");
  CHECK(of("cos", "(-1, 1)", true) == "cos does not fall");
  CHECK(of("cos", "(0, (3373259426*2^32+560513589)/2^62)", true) ==
        "cos does not fall");  // pi as it is rounded, which is a little more
  CHECK(of("cos", "(0, pi)", false) == "cos does not increase");
  CHECK(of("tan", "(-pi/2, pi/2)", false) == "accepted");
  CHECK(of("tan", "(0, pi)", false) == "tan does not increase");
  CHECK(of("cot", "(0, pi)", true) == "accepted");
  CHECK(of("cot", "(-1, 1)", true) == "cot does not fall");
  CHECK(of("cot", "(0, pi)", false) == "cot does not increase");
}

TEST_CASE("factors of a layer that may vanish, or are of any sign") {
  const auto by = [](const std::string& factor, const Json& right, const std::string& residual) {
    Json link = linked(residual, residual);
    link["left"]["links"][0]["layers"] = Json::array(
        {{{"function", "*"}, {"falls", true}, {"left", "x"}, {"right", "1"}, {"factor", {{factor, 1}}}}});
    return verdict({"x*y", "<", "y"}, right, {{"x", real}, {"y", "(-inf, 0)"}, {"z", real}}, Json::array(),
                   link);
  };
  CHECK(by("y", {"x", ">", "1"}, "x-1") == "accepted");
  CHECK(by("y", {"x", "<", "1"}, "1-x") == "the left side is another one");
  CHECK(by("y+1", {"x", ">", "1"}, "x-1") == "a factor may vanish: y+1");
  CHECK(by("2*y", {"x", ">", "1"}, "x-1") == "another layer");
}

TEST_CASE("a factor of a layer that is not 0 because the statement divides by it") {
  const Json ranges{{"x", real}, {"y", real}}, none = Json::array();
  Json link = linked("y-1", "y-1");
  const auto by = [&](const char* factor, int n) {
    link["left"]["links"][0]["layers"] = Json::array(
        {{{"function", "*"}, {"falls", false}, {"left", "y"}, {"right", "1"}, {"factor", {{factor, n}}}}});
  };
  by("x", -1);
  CHECK(verdict({"y/x", "=", "1/x"}, {"y", "=", "1"}, ranges, none, link, none, {"x"}) == "accepted");
  CHECK(verdict({"y/x", ">", "1/x"}, {"y", ">", "1"}, ranges, none, link, none, {"x"}) ==
        "a layer of unknown sign");
  by("x", 1);  // x = 0 solves the left one, whatever y is
  CHECK(verdict({"y*x", "=", "x"}, {"y", "=", "1"}, ranges, none, link) == "a factor may vanish: x");
}

TEST_CASE("angles that end where a function turns, and a little beyond") {
  const Json steps = Json::array({{{"function", "exp"}, {"of", "$i*x"}, {"name", "$z"}},
                                  {{"function", "exp"}, {"of", "$i*y"}, {"name", "$w"}},
                                  {{"function", "exp"},
                                   {"of", "$i*(x-pi/2)"},
                                   {"is", "-$i*$z"},
                                   {"from", {{"$i*x", 1}, {"$i*pi/2", -1}}}},
                                  {{"function", "exp"},
                                   {"of", "$i*(y-pi/2)"},
                                   {"is", "-$i*$w"},
                                   {"from", {{"$i*y", 1}, {"$i*pi/2", -1}}}}});
  Json link = linked("y-x", "y-x");
  link["left"]["links"][0]["layers"] =
      Json::array({{{"function", "sin"}, {"falls", false}, {"left", "x-pi/2"}, {"right", "y-pi/2"}}});
  const auto of = [&](const std::string& end) {
    return verdict({"sin(x-pi/2)", "<", "sin(y-pi/2)"}, {"x", "<", "y"},
                   {{"x", "(0, " + end + ")"}, {"y", "(0, " + end + "]"}}, steps, link);
  };
  for (const char* end : {"pi", "3", "2*pi/2", "pi-1/10^6"}) CHECK(of(end) == "accepted");
  for (const char* beyond : {"pi+1/10^30", "pi*(1+1/10^30)", "(pi^2+1/10^30)/pi",
                             "31415926535897932385/10^19", "14488038916154245685/2^62", "22/7"})
    CHECK(of(beyond) == "sin does not increase");
}

TEST_CASE("the cosine of |x|, where x goes beyond pi") {
  const Json steps{{{"function", "^1/2"}, {"of", "x^2"}, {"name", "$a"}},
                   {{"function", "^1/2"}, {"of", "y^2"}, {"name", "$b"}},
                   {{"function", "exp"}, {"of", "$i*fabs(x)"}, {"name", "$z"}},
                   {{"function", "exp"}, {"of", "$i*fabs(y)"}, {"name", "$w"}}};
  Json link = linked("$a-$b", "$a-$b");
  link["left"]["links"][0]["layers"] =
      Json::array({{{"function", "cos"}, {"falls", true}, {"left", "fabs(x)"}, {"right", "fabs(y)"}}});
  const auto of = [&](const char* range) {
    return verdict({"cos(fabs(x))", "<", "cos(fabs(y))"}, {"fabs(x)", ">", "fabs(y)"},
                   {{"x", range}, {"y", range}}, steps, link);
  };
  CHECK(of("(-pi, pi)") == "accepted");
  for (const char* beyond : {"(-pi, 4)", "(-4, pi)", "(-pi-1/10^30, pi)", "(-pi, pi+1/10^30)", "(-inf, pi)"})
    CHECK(of(beyond) == "cos does not fall");
}

TEST_CASE("x/sqrt(1+x^2) increases, 1/sqrt(1+x^2) turns at 0") {
  const Json steps{{{"function", "^1/2"}, {"of", "1+x^2"}, {"name", "$a"}},
                   {{"function", "^1/2"}, {"of", "1+y^2"}, {"name", "$b"}}};
  const auto of = [&](const std::string& f, const std::string& above, bool falls, const char* range) {
    Json link = falls ? linked("x-y", "x-y") : linked("y-x", "y-x");
    link["left"]["links"][0]["layers"] =
        Json::array({{{"function", f + "(atan)"}, {"falls", falls}, {"left", "x"}, {"right", "y"}}});
    return verdict({(above == "1" ? "1" : "x") + std::string("/sqrt(1+x^2)"), "<",
                    (above == "1" ? "1" : "y") + std::string("/sqrt(1+y^2)")},
                   {"x", falls ? ">" : "<", "y"}, {{"x", range}, {"y", range}}, steps, link, Json::array(),
                   {"sqrt(1+x^2)", "sqrt(1+y^2)"});
  };
  CHECK(of("sin", "x", false, real) == "accepted");
  CHECK(of("sin", "1", false, real) == "another layer");
  CHECK(of("cos", "1", true, "[0, inf)") == "accepted");
  CHECK(of("cos", "1", false, "[0, inf)") == "cos(atan) does not increase");
  CHECK(of("cos", "1", true, real) == "cos(atan) does not fall");
}

TEST_CASE("inequalities whose factor is 0 only where both are equations, and where it is 0 elsewhere") {
  const Json ranges{{"x", real}, {"y", real}}, none = Json::array();
  const std::string sum = "(x+y/2)^2+3/4*y^2";
  Json cubes = linked("x^3-y^3", "x-y", "1", {{sum, 1}});
  CHECK(verdict({"x^3", ">", "y^3"}, {"x", ">", "y"}, ranges, none, cubes) == "a factor may vanish: " + sum);
  cubes["more"] = {{sum, "3/4*(x+y)^2"}};
  CHECK(verdict({"x^3", ">", "y^3"}, {"x", ">", "y"}, ranges, none, cubes) == "accepted");
  CHECK(verdict({"x^3", ">=", "y^3"}, {"x", ">=", "y"}, ranges, none, cubes) == "accepted");
  Json odd = linked("x^3", "x", "1", {{"x", 2}});
  CHECK(verdict({"x^3", ">", "0"}, {"x", ">", "0"}, ranges, none, odd) == "accepted");
  for (const char* op : {">", ">="}) {
    Json other = linked("y^2*x", "x", "1", {{"y", 2}});
    CHECK(verdict({"y^2*x", op, "0"}, {"x", op, "0"}, ranges, none, other) == "a factor may vanish: y");
    other["more"] = {{"y", "y-x^2/4"}};
    CHECK(verdict({"y^2*x", op, "0"}, {"x", op, "0"}, ranges, none, other) == "a factor may vanish: y");
  }
}

TEST_CASE("logarithms of constants as factors") {
  const Json ranges{{"x", real}};
  const auto by = [&](const std::string& number, const Json& right, const std::string& residual) {
    const std::string f = "log(" + number + ")";
    const Json steps = Json::array({{{"function", "log"}, {"of", number}, {"name", "$f"}}});
    return verdict({f + "*x", ">", "0"}, right, ranges, steps, linked("$f*x", residual, "1", {{f, 1}}));
  };
  CHECK(by("2", {"x", ">", "0"}, "x") == "accepted");
  CHECK(by("1/2", {"x", ">", "0"}, "x") == "a factor turns the inequality round");
  CHECK(by("1+1/10^25", {"x", ">", "0"}, "x") == "accepted");
  CHECK(by("1+1/10^130", {"x", ">", "0"}, "x") == "a factor may vanish: log(1+1/10^130)");
}
