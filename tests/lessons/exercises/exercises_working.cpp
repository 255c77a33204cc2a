// Working, line by line: what follows is accepted, the first step that does not is pointed at.
#include <doctest/doctest.h>

#include <derivations/paper/mutate.hpp>
#include <lessons/exercises/working.hpp>
#include <sstream>
#include <tests/block.hpp>
#include <tests/cases.hpp>

#include "classroom.hpp"

using namespace rederive::language;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::page;
using namespace rederive::classroom;
using namespace rederive::classroom;
using namespace rederive::test;

namespace {

Opinion followed(const std::string& id, const std::string& lines) {
  std::vector<std::pair<int, std::string>> numbered;
  std::istringstream text(lines);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) numbered.emplace_back(number, line);
  return judge_working(exercise(id), numbered).opinion;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE(
    "in every exercise about a formula, right answers follow from each other, and a slip is pointed at") {
  int workings = 0, slips = 0, pointed_at = 0, named = 0;
  for (const auto& one : exercises()) {
    if (one.kind != Kind::expression && one.kind != Kind::equation) continue;
    std::vector<std::string> lines = one.equivalents;
    lines.insert(lines.begin(), model_answer(prepare(one)));
    const Opinion right = followed(one.id, joined(lines));
    CHECK_MESSAGE(right.outcome == Outcome::correct, one.id, ": line ", right.line, " ", right.feedback);
    ++workings;
    const auto spoilt = mutants(parse_statement(lines.back(), paper_symbols()));
    lines.insert(lines.end() - 1, "");
    for (std::size_t k = 0; k < spoilt.size(); k += 1 + spoilt.size() / 3) {
      const Relation& slip = spoilt[k].relation;
      lines[lines.size() - 2] = slip.operators.empty() ? print(slip.sides[0]) : print(slip);
      const Opinion opinion = followed(one.id, joined(lines));
      if (opinion.outcome == Outcome::correct || opinion.outcome == Outcome::undecided) continue;
      ++slips;
      pointed_at += opinion.line == static_cast<int>(lines.size()) - 1 && opinion.witness;
      named += opinion.note.word != "other";
    }
  }
  MESSAGE(workings, " workings; of ", slips, " slips ", pointed_at, " pointed at with a witness, ", named,
          " named");
  CHECK(workings >= 10);
  CHECK(slips >= 40);
  CHECK(pointed_at == slips);
  CHECK(10 * named >= 9 * slips);
}

TEST_CASE("a step that does not follow is shown with numbers, and it is said what is wrong with it") {
  const Opinion slip = followed("frequency-of-a-bookcase", "p = sqrt(3*9.81/(4*1.02)) = 2.96 1/s");
  CHECK(slip.line == 1);
  CHECK(contains(slip.feedback, "2.686"));
  const Opinion chain =
      followed("height-of-centre",
               "y_c = R*cos(alpha - theta) - R*cos(alpha) = R*(cos(alpha) - cos(alpha - theta))\n"
               "= R*(cos(alpha - theta) - cos(alpha))");
  CHECK(chain.line == 1);
  CHECK(chain.note.slip == Slip::sign);
  REQUIRE(chain.witness);
  CHECK(chain.witness->printed == "-" + chain.witness->derived);
  const Opinion wrong_throughout = followed(
      "height-of-centre", "R*cos(alpha + theta) - R*cos(alpha)\n= R*(cos(alpha + theta) - cos(alpha))");
  CHECK(wrong_throughout.line == 0);
  CHECK(wrong_throughout.note.slip == Slip::wrong_angle);
  CHECK(contains(wrong_throughout.feedback, "the first is wrong already"));
  const Opinion unsaid =
      followed("linear-equation",
               "thetaddot = -p^2*(a_p/g*sin(omega_p*t + psi)*cos(alpha - theta) + sin(alpha - theta))\n"
               "thetaddot = -p^2*(a_p/g*sin(omega_p*t + psi) + alpha - theta)");
  CHECK(unsaid.line == 2);
  CHECK(unsaid.note.slip == Slip::small_angle);
  CHECK(unsaid.witness);
}

TEST_CASE("a working gets its verdict and its note, and the line at which it goes wrong is pointed at") {
  for (const Cells& row : cases("workings")) {
    INFO(in_one_line(row));
    const Opinion opinion = followed(row[0], row[1]);
    if (!row[2].empty()) CHECK(to_string(opinion.outcome) == row[2]);
    if (row.size() > 3 && !row[3].empty()) CHECK(opinion.note.word == row[3]);
    if (row.size() > 4) CHECK(std::to_string(opinion.line) == row[4]);
  }
}

TEST_CASE("the steps that follow have marks, and what is said of each line can be asked for") {
  const auto score = [](const char* id, const std::string& lines) {
    return judge_working(exercise(id), numbered_lines(lines)).opinion.score;
  };
  const std::string law = "# mine\n\nby moment of momentum\n",
                    good = "4/3*m*R^2*thetaddot = -m*R*(u_gddot*cos(alpha - theta) + g*sin(alpha - theta))\n",
                    sign = "thetaddot = -p^2*(u_gddot/g*cos(alpha - theta) - sin(alpha - theta))\n",
                    right = "thetaddot = -p^2*(u_gddot/g*cos(alpha - theta) + sin(alpha - theta))\n";
  CHECK(score("equation-of-motion", law + good + right) == 1);
  CHECK(score("equation-of-motion", law + good + sign) == 0.25);
  CHECK(score("equation-of-motion", law + good + good) == 0.5);
  CHECK(score("equation-of-motion", law) == 0);
  CHECK(score("equation-of-motion", sign + sign) == 0);  // it begins wrongly
  const Exercise& one = exercise("equation-of-motion");
  const auto json = working_json(one, judge_working(one, numbered_lines(law + "17b\n" + good + sign)));
  std::string words;
  for (const auto& line : json["lines"]) words += line["status"].get<std::string>() + " ";
  CHECK(words == "cited unreadable follows does_not_follow ");
  CHECK(json["lines"][3]["line"] == 6);
  const Working misprint = judge_working(one, numbered_lines("by (17b)"));
  CHECK(contains(misprint.lines[0].remark, "The paper prints (17b) with an error"));
}

TEST_CASE("a step that does not follow from a law is shown at a point where the law holds") {
  const Opinion opinion = followed("energy-lost", "by restitution\nthetadot_plus = e*thetadot_minus^2");
  REQUIRE(opinion.witness);
  const auto& at = opinion.witness->at;
  CHECK(std::stod(at.at("thetadot_plus")) ==
        doctest::Approx(std::stod(at.at("e")) * std::stod(at.at("thetadot_minus"))));
  CHECK(opinion.witness->derived == "0");
}

TEST_CASE("nothing hangs") {
  CHECK(followed("height-of-centre", "R = R" + std::string(9000, '(')).note.word == "too_deep");
  std::string many = "R\n";
  for (int k = 0; k < 60; ++k) many += "= R\n";
  const Opinion long_one = followed("height-of-centre", many);
  CHECK(long_one.note.word == "too_long");
  CHECK(long_one.line == 41);
  const Opinion hard = followed("restitution", "exp(exp(exp(alpha)))^(1/7)\n= log(1 + exp(exp(alpha^9)))^20");
  CHECK((hard.outcome == Outcome::wrong || hard.outcome == Outcome::undecided));
}

TEST_CASE("on the command line: the answer counts, exit codes are those of an answer") {
  const Desk desk;
  const auto file = desk.folder.path / "working.txt";
  const auto run = [&](const std::string& id, const std::string& lines) {
    write_file(file, lines);
    return desk.run({"check", id, "--working", file.string()});
  };
  const std::string wrong = "# mine\n\n1 - 3/2*sin(alpha)^2\n= 1 - 3/2*(1 + cos(alpha)^2)\n";
  const Result pointed_at = run("restitution", wrong);
  CHECK(pointed_at.exit_code == 1);
  CHECK(pointed_at.out.find("Line 4\n") == 0);
  CHECK(contains(pointed_at.out, "before: "));
  const auto json = desk.json_of({"check", "restitution", "--working", file.string()});
  CHECK(json["line"] == 4);
  CHECK(json["witness"]["answer"] != json["witness"]["right"]);
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n\xff\n").exit_code == 2);
  CHECK(run("restitution", "# nothing\n").exit_code == 2);
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n= 1 -\n").out.find("Line 2\n") == 0);
  const Result number = run("which-momentum", "c\n");
  CHECK(run("first-lift", "tan(alpha) = 0.3\na_p = g*tan(alpha) = 2.94 m/s^2\n").exit_code == 0);
  CHECK(number.exit_code == 2);
  CHECK(contains(number.err, "does not ask for a formula"));
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n= 1 - 3/2*(1 - cos(alpha)^2)\n").exit_code == 0);
  CHECK(contains(read_file(desk.progress), "restitution\tsolved\t3"));
  std::filesystem::remove(file);
  CHECK(contains(desk.run({"check", "restitution", "--working", file.string()}).err, "there is no file"));
}
