// Mistakes in files of exercises: what cannot be read names the file and the line, and what is not sound is
// found by the selftest.
#include <doctest/doctest.h>

#include <derivations/program/program.hpp>
#include <lessons/exercises/said.hpp>
#include <lessons/exercises/selftest.hpp>
#include <tests/cases.hpp>

#include "classroom.hpp"

using namespace rederive::classroom;
using rederive::program::BadInput;

namespace {

/// What is said about a file with these exercises: why it cannot be read, or the complaints of the selftest.
std::string said_about(const std::string& text, const std::string& lesson = "") {
  const TemporaryFolder folder;
  Course course = rederive::rocking_block::course();
  course.exercises = folder.path / "lesson-03.toml";
  course.lessons.titles = [] {
    return std::map<std::string, std::string>{{"one", "One"}, {"three", "Three"}, {"two", "Two"}};
  };
  course.lessons.markdown = [&](const std::string&) { return lesson; };
  write(course.exercises, text);
  try {
    const Classroom room{course, read_exercises(course, course.exercises), folder.path / "progress.txt"};
    std::string all;
    for (const std::string& complaint : tested(room, /*with_lessons=*/true).complaints)
      all += complaint + "\n";
    return all;
  } catch (const BadInput& error) {
    return error.what();
  }
}

std::string sound() {
  std::string text;
  each_case("sound", [&](const std::string& exercise) { text = "\n" + exercise; });
  return text;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE_MESSAGE(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

std::string another(const std::string& text) {
  return text + with(text, "worked-example", "another-example");
}

}  // namespace

TEST_CASE("an exercise that is sound has no complaints") { CHECK(said_about(sound()) == ""); }

TEST_CASE("a mistake in a file of exercises names the file and the line") {
  each_case("mistakes", [](const std::string& from, const std::string& to, const std::string& text) {
    const std::string said = said_about(with(sound(), from, to));
    CHECK_MESSAGE(contains(said, "lesson-03.toml" + text), said);
  });
}

TEST_CASE("the selftest names file and exercise of what is not sound") {
  each_case("faults", [](const std::string& from, const std::string& to, const std::string& text) {
    const std::string said = said_about(with(sound(), from, to));
    CHECK_MESSAGE(contains(said, "lesson-03.toml:2: exercise worked-example: "), said);
    CHECK_MESSAGE(contains(said, text), said);
  });
}

TEST_CASE("two examples of the syntax are not alike") {
  CHECK(contains(said_about(another(sound())),
                 "exercise another-example: its example R*sin(alpha)/7 is that of worked-example"));
}

TEST_CASE("a lesson does not give an answer before it asks for it") {
  const std::string complaint = "exercise worked-example: lesson 3 gives the answer before it: ";
  for (const char* answer :
       {"$`y_c = R - R \\cos\\alpha`$", "```math\ny_c = R \\left(1 - \\cos\\alpha\\right)\\,. \\tag{13}\n```",
        "$`2 R \\sin^2\\left(\\frac{\\alpha}{2}\\right)`$"}) {
    const std::string lesson = std::string("Turned, it has risen by ") + answer + " and stops.\n";
    CHECK_MESSAGE(contains(said_about(sound(), lesson), complaint), lesson);
    CHECK(said_about(sound(), "Ask. (Exercise worked-example.)\n" + lesson) == "");
    CHECK(contains(said_about(sound(), lesson + "(Exercise worked-example.)\n"), complaint));
    CHECK(contains(said_about(sound(), "(Exercise worked-example-2.)\n" + lesson), complaint));
  }
  CHECK(said_about(sound(), "It has risen by $`R - R \\sin\\alpha`$.") == "");
  const Prepared& bookcase = prepared("frequency-of-a-bookcase");
  CHECK(number_in(bookcase, "It comes to 2.69 there.") == "2.69");
  CHECK(number_in(bookcase, "It comes to 12.69, 2.695, (2.69.1) and 2.7 there.") == "");
}

TEST_CASE("what is the answer, and what is true of an answer, is decided by the exercise") {
  const Prepared& motion = prepared("equation-of-motion");
  CHECK(is_the_answer(motion, "thetaddot + p^2*(sin(alpha - theta) + u_gddot/g*cos(alpha - theta)) = 0"));
  CHECK_FALSE(is_the_answer(  // it has symbols that the exercise does not give
      motion, "J_o*thetaddot + m*g*R*sin(alpha - theta) + m*R*u_gddot*cos(alpha - theta) = 0"));
  Prepared bookcase = prepared("frequency-of-a-bookcase");
  bookcase.answer.number = 2.5;
  CHECK(number_in(bookcase, "It comes to 2.5 or 2.50 there.") == "2.50");
  CHECK(untrue(prepared("restitution"), "1 - 3/2*sin(alpha)", "Write the unit under each term.") ==
        "nothing in it has a unit");
  CHECK(untrue(prepared("inertia-about-corner"), "2/3*m*R^2", "Is the sine one there?") ==
        "there is neither a sine nor a cosine");
  CHECK(untrue(prepared("height-of-centre"), "R*cos(alpha - theta)", "Is the sine one there?") == "");
}
