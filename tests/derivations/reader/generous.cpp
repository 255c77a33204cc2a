// What students write, with what must be read; what is echoed is read as the same tree.
#include <doctest/doctest.h>

#include <derivations/paper/prove.hpp>
#include <derivations/reader/generous.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::paper;
using namespace rederive::reader;
using namespace rederive::test;
using Text = std::string;

namespace {

/// The symbols of an exercise in which e is not given, or "" for all.
Vocabulary reader_for(const Text& given) {
  return {.symbols = paper_symbols(),
          .given = given.empty() ? std::vector<Text>{} : std::vector<Text>{"x", "t", "p"}};
}
Readings readings_of(const Text& text, const Text& given = "") {
  return generous_readings(text, reader_for(given));
}

bool is_same_tree(const Relation& a, const Relation& b) {
  return a.operators == b.operators && std::ranges::equal(a.sides, b.sides, is_same);
}
bool is_same_value(const Relation& a, const Relation& b) {
  return a.operators == b.operators &&
         std::ranges::equal(a.sides, b.sides, [](const Tree& left, const Tree& right) {
           return lower(left).is_equal(lower(right));
         });
}

/// Checks that what was read is read back as the same tree, from our syntax and from the typeset text.
void check_echo(const Relation& read, const Text& typed) {
  for (const Notation notation : {Notation::plain, Notation::unicode}) {
    const Text echo = print(read, notation);
    const Readings again = readings_of(echo);
    REQUIRE_MESSAGE(again.all.size() == 1, typed, " → ", echo);
    CHECK_MESSAGE(is_same_tree(again.all[0], read), typed, " → ", echo, " → ",
                  print(again.all[0], Notation::plain));
  }
}

/// Returns the note of the error in which reading ends; "" if there is none.
Text note_of(const Text& text) {
  try {
    (void)readings_of(text);
    return "";
  } catch (const SyntaxError& error) {
    CHECK(error.position <= text.size());
    return word_of(error.mistake);
  }
}

/// Texts as students write them: factors side by side, functions without parentheses, all kinds of signs.
class StudentTexts {
 public:
  Text next(std::size_t depth = 1) { return sum(depth); }

 private:
  Text sum(std::size_t depth) {
    Text text = product(depth);
    for (std::size_t more = choices_.below(3); more > 0; --more)
      text += choices_.pick(signs_) + product(depth);
    return text;
  }
  Text product(std::size_t depth) {
    Text text = choices_.one_in(3) ? choices_.pick(numbers_) : "";
    text += factor(depth);
    for (std::size_t more = choices_.below(3); more > 0; --more)
      text += choices_.pick(times_) + factor(depth);
    return text;
  }
  Text factor(std::size_t depth) {
    const std::size_t kind = choices_.below(depth == 0 ? 3 : 9);
    if (kind < 3) return choices_.pick(names_) + choices_.pick(powers_);
    if (kind == 3) return choices_.pick(functions_) + choices_.pick(powers_) + " " + choices_.pick(names_);
    if (kind == 4) return choices_.pick(functions_) + choices_.pick(powers_) + "(" + sum(depth - 1) + ")";
    if (kind == 5) return "\\frac{" + sum(depth - 1) + "}{" + sum(depth - 1) + "}";
    if (kind == 7) return "√(" + sum(depth - 1) + ")";
    if (kind == 6) return "|" + sum(depth - 1) + "|";
    return Text(choices_.pick(brackets_)).replace(1, 1, sum(depth - 1));
  }
  Choices choices_{59};
  const std::vector<Text> names_{"R",     "α",   "θ",   "theta",   "p", "g", "θ'", "\\ddot\\theta ",
                                 "u_g''", "α_p", "ω_p", "\\alpha "},
      numbers_{"2", "3", "0,5", "1/2 ", "½", "3/2 ", "\\frac12 "}, signs_{" + ", " - ", "−", "+"},
      times_{"", " ", "*", "·", "/", " × ", "\\cdot "}, powers_{"", "", "", "²", "^2", "^{2}"},
      functions_{"sin", "cos", "tan", "\\sin", "\\cos", "exp"};
  const std::vector<Text> brackets_{"(x)", "[x]", "{x}"};
};

}  // namespace

TEST_CASE("what students write is read in one way") {
  each_case("read", [](const Text& typed, const Text& wanted, const Text& given) {
    const Readings readings = readings_of(typed, given);
    CHECK(readings.all.size() == 1);
    const Relation right = parse_statement(wanted);
    CHECK_MESSAGE(is_same_value(readings.all[0], right), print(readings.all[0], Notation::plain));
    check_echo(readings.all[0], typed);
  });
}

TEST_CASE("what has two readings is read in both, and neither is preferred") {
  each_case("asked", [](const Text& typed, const Text& one, const Text& other) {
    const Readings readings = readings_of(typed);
    REQUIRE(readings.all.size() >= 2);
    CHECK(!readings.reason.empty());
    for (const Text& wanted : {one, other})
      CHECK_MESSAGE(std::ranges::any_of(
                        readings.all,
                        [&](const Relation& read) { return is_same_value(read, parse_statement(wanted)); }),
                    wanted, " ", print(readings.all[0], Notation::plain), " ",
                    print(readings.all[1], Notation::plain));
    for (const Relation& read : readings.all) check_echo(read, typed);
  });
}

TEST_CASE("what cannot be read is refused") {
  each_case("refused", [](const Text& typed, const Text& note) { CHECK(note_of(typed) == note); });
}

TEST_CASE("the strict grammar's error says how the text is written, for one or two readings") {
  each_case("advised", [](const Text& typed, const Text& says) {
    try {
      (void)parse_statement(typed);
      FAIL("the strict grammar reads ", typed);
    } catch (const SyntaxError& error) {
      CHECK_MESSAGE(advice(error, typed, paper_symbols()) == says, typed);
    }
  });
}

TEST_CASE("printed trees are read back as the same trees, and from LaTeX as the same value") {
  RandomTrees trees(
      59, {"m", "R", "alpha", "theta", "thetadot", "x", "u_gddot", "omega_p", "a_p", "thetadot_ex"});
  int values = 0;
  for (int k = 0; k < 10'000; ++k) {
    const Relation read{{trees.next()}, {}};
    check_echo(read, "a tree");
    const Text latex = print(read, Notation::latex);
    const Readings again = readings_of(latex);
    try {
      const bool is_same =
          std::ranges::any_of(again.all, [&](const auto& it) { return is_same_value(it, read); });
      CHECK_MESSAGE(is_same, print(read, Notation::plain), " → ", latex, " → ",
                    print(again.all[0], Notation::plain));
      ++values;
    } catch (const SyntaxError&) {  // it has no value
    }
  }
  CHECK(values > 5'000);
}

TEST_CASE("what is read of texts as students write them is read back as the same trees") {
  StudentTexts texts;
  int read = 0;
  for (int k = 0; k < 2'000; ++k) {
    const Text typed = texts.next();
    try {
      for (const Relation& one : readings_of(typed).all) check_echo(one, typed), ++read;
    } catch (const SyntaxError& error) {
      CHECK_MESSAGE(error.position <= typed.size(), typed, ": ", error.what());
    }
  }
  CHECK(read > 1'500);
}

TEST_CASE("hostile texts end in a message") {
  for (const char* part : {"(",
                           "[",
                           "{",
                           "|",
                           "\\frac",
                           "\\frac{",
                           "sin ",
                           "√",
                           "-",
                           "x^",
                           "'",
                           "d/dt ",
                           "sin x cos x/2 ",
                           "x/y z ",
                           "\\dot",
                           "^{",
                           "_{",
                           "1 1/3",
                           "\\left(",
                           "mgR",
                           "2,"}) {
    for (const std::size_t times : {10U, 300U, 2'000U, 100'000U}) {
      Text text;
      for (std::size_t k = 0; k < times; ++k) text += part;
      try {
        (void)readings_of(text);
      } catch (const SyntaxError& error) {
        CHECK(error.position <= text.size());
      }
    }
  }
}
