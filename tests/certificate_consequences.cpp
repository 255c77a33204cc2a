// Links that follow from those of the other statement: certificates made up by hand, true ones and false
// ones, each of which leans on one thing that the checker must not take on trust.
#include <doctest/doctest.h>

#include <tests/certificate_by_hand.hpp>

using namespace by_hand;

namespace {

Json term(const std::string& factor, const Json& links) { return {{"factor", factor}, {"links", links}}; }

/// times·residual = terms + more; or -residual^2 for the residual.
Json follows(const char* side, std::size_t link, const Json& terms, const std::string& more = "0",
             const std::string& times = "1", bool squared = false) {
  return {{side, {{"link", link}}},
          {"follows", {{"times", times}, {"squared", squared}, {"terms", terms}, {"more", more}}}};
}

std::string verdict_of(const Json& left, const Json& right, const Json& links,
                       const std::string& range = real) {
  const Json ranges{{"x", range}, {"y", real}, {"z", real}};
  return verdict_of_links(left, right, ranges, Json::array(), links);
}

/// One link of either side: the left one follows by hand, the right one by these terms.
std::string verdict_on_right(const Json& left, const Json& right, const Json& of_left, const Json& of_right,
                             const std::string& range = real) {
  return verdict_of(left, right, Json::array({of_left, of_right}), range);
}

}  // namespace

TEST_CASE("equations in another order follow from each other") {
  const Json left{"x", "=", "y", "=", "1"}, right{"y", "=", "x", "=", "1"};
  const Json same = follows("left", 0, Json::array({term("-1", {0})}));  // x-y = -(y-x)
  const Json one = follows("left", 1, Json::array({term("1", {1}), term("-1", {0})}));
  const Json back = follows("right", 0, Json::array({term("-1", {0})}));
  const Json other = follows("right", 1, Json::array({term("1", {1}), term("-1", {0})}));
  CHECK(verdict_of(left, right, Json::array({same, one, back, other})) == "accepted");
  CHECK(verdict_of(left, right, Json::array({same, one, back})) == "a link is left out");
  const Json wrong = follows("right", 1, Json::array({term("1", {1}), term("1", {0})}));
  CHECK(verdict_of(left, right, Json::array({same, one, back, wrong})) == "it does not follow");
  const Json beyond = follows("right", 1, Json::array({term("1", {2})}));
  CHECK(verdict_of(left, right, Json::array({same, one, back, beyond})) != "accepted");
}

TEST_CASE("a factor that has no value where the link holds says nothing") {
  const Json left{"y", "=", "0"}, right{"x", "=", "0"};  // y = (y/x)*x
  const Json back = follows("right", 0, Json::array({term("x/y", {0})}));
  CHECK(verdict_on_right(left, right, follows("left", 0, Json::array({term("y/x", {0})})), back) ==
        "it divides");
  for (const char* factor : {"y*x^(-1)", "y*x^(-1/2)^2", "y*log(x)/log(x)", "y*x^y*x^(-y)"})
    CHECK(verdict_on_right(left, right, follows("left", 0, Json::array({term(factor, {0})})), back) ==
          "it may have no value");
  const Json times = follows("left", 0, Json::array({term("y", {0})}), "0", "x");  // x*y = y*x
  CHECK(verdict_on_right(left, right, times, back) == "a factor may vanish, or equality is left open");
}

TEST_CASE("a square that is not positive is 0") {
  const Json left{"x^2", "<=", "0"}, right{"x", "=", "0"};
  const Json there = follows("right", 0, Json::array({term("1", {0})}), "0", "1", true);
  const Json back = follows("left", 0, Json::array({term("-x", {0})}));
  CHECK(verdict_on_right(left, right, back, there) == "accepted");
  CHECK(verdict_on_right({"x^2", "<", "0"}, right, back, there) ==
        "a factor may vanish, or equality is left open");
  const Json more = follows("right", 0, Json::array({term("1", {0})}), "-y^2", "1", true);  // x^2 <= y^2
  CHECK(verdict_on_right({"x^2-y^2", "<=", "0"}, right, more, back) == "more may be negative");
  const Json turned = follows("right", 0, Json::array({term("-1", {0})}), "0", "1", true);  // x^2 >= 0
  CHECK(verdict_on_right({"x^2", ">=", "0"}, right, follows("left", 0, Json::array({term("x", {0})})),
                         turned) == "a term may be negative");
}

TEST_CASE("an inequality needs terms of the right sign") {
  const Json left{"x", "<", "y", "=", "2"}, right{"x", "<", "2", "=", "y"};
  const Json first = follows("left", 0, Json::array({term("1", {0}), term("-1", {1})}));
  const Json second = follows("left", 1, Json::array({term("-1", {1})}));
  const Json back = follows("right", 0, Json::array({term("1", {0}), term("-1", {1})}));
  const Json last = follows("right", 1, Json::array({term("-1", {1})}));
  CHECK(verdict_of(left, right, Json::array({first, second, back, last})) == "accepted");
  const Json weak{"x", "<=", "2", "=", "y"};
  CHECK(verdict_of(left, weak, Json::array({first, second, back, last})) ==
        "a factor may vanish, or equality is left open");
  const Json x_less{"x", "<", "0"}, y_less{"y", "<", "0"};  // -y = (-x)·1 + (x-y)
  CHECK(verdict_on_right(x_less, y_less, back, follows("right", 0, Json::array({term("1", {0})}), "x-y")) !=
        "accepted");
}

TEST_CASE("a factor that vanishes only where nothing is asked") {
  const Json left{"(x-1)^2*(x-2)", ">", "0"}, right{"x", ">", "2"};
  const Json there = follows("right", 0, Json::array({term("1", {0})}), "0", "(x-1)^2");
  const Json back =
      follows("left", 0, Json::array({term("1", {0}), term("2", {0, 0}), term("1", {0, 0, 0})}));
  CHECK(verdict_on_right(left, right, back, there) == "accepted");
  const Json weak_left{"(x-1)^2*(x-2)", ">=", "0"}, weak_right{"x", ">=", "2"};  // x = 1
  CHECK(verdict_on_right(weak_left, weak_right, back, there) ==
        "a factor may vanish, or equality is left open");
  const Json no_sign = follows("right", 0, Json::array({term("1", {0})}), "0", "x-1");
  CHECK(verdict_on_right({"(x-1)*(x-2)", ">", "0"}, right, back, no_sign) != "accepted");
}
