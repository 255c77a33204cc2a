// Variants: other numbers, the other side, another slip; by a seed, which may be a student's name.
#include <doctest/doctest.h>

#include <derivations/program/program.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <set>

#include "classroom.hpp"

using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::rocking_block;
using namespace rederive::classroom;
using namespace rederive::classroom;
namespace fs = std::filesystem;

TEST_CASE("what a seed picks is the same on every machine") {
  CHECK(picked("", "x", 1000) == 0);
  CHECK(picked("1", "x", 1000) == 140);
  CHECK(picked("anna", "height-of-centre/side", 1000) == 997);
  CHECK(picked("Zoë", "first-lift/b", 997) == 837);
}

TEST_CASE("a range beside other names in a table gives all its values") {
  std::set<std::string> statements;
  for (int seed = 0; seed < 40; ++seed)
    statements.insert(exercise("least-amplitude", std::to_string(seed)).statement);
  CHECK(statements.size() > 5);
}

TEST_CASE("texts are filled in, and what cannot be is refused") {
  const Choice choice{{"b", "0.35"}, {"what", "a wall"}};
  CHECK(filled("{what}, {200*b} cm: {b}^2", choice, rederive::rocking_block::paper().symbols) ==
        "a wall, 70 cm: 0.35^2");
  CHECK_THROWS(filled("{b}", {}, rederive::rocking_block::paper().symbols));
  CHECK_THROWS(filled("b}", choice, rederive::rocking_block::paper().symbols));
  CHECK(values_of("0.6:0.9:0.1") == std::vector<std::string>{"0.6", "0.7", "0.8", "0.9"});
  CHECK(values_of("1:3:1") == std::vector<std::string>{"1", "2", "3"});
  CHECK(values_of("a ratio of 1:2") == std::vector<std::string>{"a ratio of 1:2"});
  CHECK(values_of(".:.:.") == std::vector<std::string>{".:.:."});
  for (const char* range : {"1.08:0.2:0.01", "1:2:0", "0:1000000:0.001"})
    CHECK_THROWS_WITH_AS(values_of(range), doctest::Contains("must be FROM:TO:STEP"), std::runtime_error);
  CHECK_THROWS(filled("{b", choice, rederive::rocking_block::paper().symbols));
  CHECK_THROWS(filled("{h}", choice, rederive::rocking_block::paper().symbols));
  CHECK_THROWS(filled("{b +}", choice, rederive::rocking_block::paper().symbols));
}

TEST_CASE(
    "without a seed an exercise stands as it is; with seeds there are several of it, with their own "
    "answers") {
  CHECK(contains(exercise("frequency-of-a-bookcase").statement, "is 2 m high and 0.4 m wide"));
  int varying = 0;
  for (const auto& one : exercises()) {
    if (one.choice.empty()) continue;
    ++varying;
    std::set<std::string> statements, answers;
    for (const std::string seed : {"", "1", "2", "3", "4", "5", "6"}) {
      const Exercise variant = exercise(one.id, seed);
      statements.insert(presentation(variant));
      answers.insert(one.kind == Kind::wrong_term ? presentation(variant) : model_answer(prepare(variant)));
    }
    CHECK_MESSAGE(statements.size() > 1, one.id);
    CHECK_MESSAGE(answers.size() > 1, one.id);
  }
  CHECK(varying == 42);  // all of them
}

TEST_CASE("a variant is judged by its own answer, and its solution ends at it") {
  for (const std::string seed : {"anna", "bert", "3"})
    for (const auto& one : exercises(seed)) {
      if (one.choice.empty()) continue;
      CAPTURE(one.id);
      const Prepared prepared = prepare(one);
      std::string text = solution_text(prepared);
      text.pop_back();
      CHECK(judge_answer(prepared, text.substr(text.rfind('\n') + 1)).outcome == Outcome::correct);
    }
  std::string left, right;  // seeds with θ < 0 and θ > 0
  for (int k = 1; left.empty() || right.empty(); ++k) {
    const std::string seed = std::to_string(k);
    (exercise("height-of-centre", seed).choice.at("corner") == "O" ? left : right) = seed;
  }
  CHECK(note("height-of-centre", "R*(cos(alpha + theta) - cos(alpha))", left) == "correct");
  CHECK(note("height-of-centre", "R*(cos(alpha - theta) - cos(alpha))", left) == "wrong_angle");
  CHECK(note("height-of-centre", "R*(cos(alpha - theta) - cos(alpha))", right) == "correct");
}

TEST_CASE("help is for the variant that was tried last") {
  const Desk desk;
  const std::string id = "height-of-centre";
  std::string left;  // a seed with θ < 0
  for (int k = 1; left.empty(); ++k)
    if (exercise(id, std::to_string(k)).choice.at("corner") == "O") left = std::to_string(k);
  const Result tried = desk.run({"check", id, "--seed", left, "R*(cos(alpha - theta) - cos(alpha))"});
  CHECK(tried.out.find("Stuck? exercises hint " + id + " --seed \"" + left + "\"") != std::string::npos);
  CHECK(contains(desk.run({"hint", id}).out, "turned to the left about O."));
  CHECK(desk.run({"solution", id, "--give-up"}).out.ends_with("y_c = R*cos(alpha + theta) - R*cos(alpha)\n"));
  CHECK(desk.run({"solution", id, "--give-up", "--seed", ""})
            .out.ends_with("cos(alpha - theta) - R*cos(alpha)\n"));
  CHECK(contains(read_file(desk.progress), "\tseed " + left + "\n"));
  CHECK(desk.run({"check", id, "R*(cos(alpha - theta) - cos(alpha))"}).exit_code ==
        0);  // without a seed: unchanged
  CHECK(!contains(read_file(desk.progress), "\tseed"));
  CHECK(desk.run({"solution", id}).out.ends_with("y_c = R*cos(alpha - theta) - R*cos(alpha)\n"));
  CHECK(contains(read_file(desk.progress), "given_up"));  // what was shown is not solved
}

TEST_CASE("on the command line, and in a class where each has the own variant") {
  const Desk desk;
  const fs::path folder = desk.folder.path;
  const std::string id = "frequency-of-a-bookcase";
  std::map<std::string, std::string> answers;
  for (const std::string name : {"anna", "bert", "Zoë Ångström"}) {
    answers[name] = model_answer(prepared(id, name));
    CHECK(contains(desk.run({"show", id, "--seed", name}).out, "--seed \"" + name + "\""));
    CHECK(desk.run({"check", id, "--seed", name, answers[name]}).exit_code == 0);
    CHECK(desk.run({"solution", id, "--seed", name}).out.ends_with("\n" + answers[name] + "\n"));
    write(folder / "class" / name / (id + ".txt"), answers[name]);
    write(folder / "class" / name / "restitution.txt", model_answer(prepared("restitution", name)));
  }
  REQUIRE(answers["anna"] != answers["bert"]);
  CHECK(desk.run({"check", id, "--seed", "bert", answers["anna"]}).exit_code == 1);
  write(folder / "class" / "carl" / (id + ".txt"), answers["anna"]);
  const fs::path pages = folder / "pages";
  const Result graded =
      desk.run({"grade", (folder / "class").string(), "--variants", "--feedback", pages.string()});
  for (const auto& [name, answer] : answers) {
    CHECK(graded.out.find(name + "," + id + ",correct,correct,1\n") != std::string::npos);
    CHECK(graded.out.find(name + ",restitution,correct,correct,1\n") != std::string::npos);
  }
  CHECK(graded.out.find("carl," + id + ",wrong") != std::string::npos);
  std::string seed = "1";  // with which another variant comes to carl
  while (exercise(id, seed + "carl").statement == exercise(id, "carl").statement) seed += "1";
  const fs::path others = folder / "others";
  desk.run(
      {"--seed", seed, "grade", (folder / "class").string(), "--variants", "--feedback", others.string()});
  const std::string theirs = exercise(id, seed + "carl").statement;
  CHECK(read_file(others / "carl.html").find(theirs.substr(1, theirs.find(" wide") - 1)) !=
        std::string::npos);
  const std::string statement = exercise(id, "carl").statement;
  CHECK(read_file(pages / "carl.html").find(statement.substr(1, statement.find(" wide") - 1)) !=
        std::string::npos);
  const Result without = desk.run({"grade", (folder / "class").string()});
  CHECK(without.out.find("anna," + id + ",correct") == std::string::npos);
}
