// Working, line by line: what follows is accepted, the first step that does not is pointed at.
#include <doctest/doctest.h>

#include <derivations/paper/mutate.hpp>
#include <lessons/exercises/working.hpp>
#include <sstream>
#include <tests/block.hpp>

#include "classroom.hpp"

using namespace rederive;
using namespace rederive::classroom;

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

TEST_CASE("what is undefined is refused where it stands") {
  const Opinion alone = followed("height-of-centre", "R/0"), first = followed("height-of-centre", "R/0\n= R");
  CHECK(alone.outcome == Outcome::invalid);
  CHECK(first.outcome == Outcome::invalid);
  CHECK(first.line == 1);
}

TEST_CASE("a working of a number is followed with the numbers of the exercise") {
  const std::string id = "frequency-of-a-bookcase";
  const std::string good =
      "h = 2/2 m\nb = 0.4/2 m = 20 cm\nR = sqrt(h^2 + b^2) = 1.02 m\np^2 = 3*g/(4*R) = 7.21\n"
      "p = sqrt(7.2146) = 2.69 1/s\n";
  CHECK(followed(id, good).outcome == Outcome::correct);
  const Opinion whole = followed(id, "R = sqrt(2^2 + 0.4^2) = 2.04 m\np = sqrt(3*g/(4*R)) = 2.69 1/s");
  CHECK(whole.outcome == Outcome::wrong);
  CHECK(whole.line == 1);
  const Opinion slip = followed(id, "p = sqrt(3*9.81/(4*1.02)) = 2.96 1/s");
  CHECK(slip.line == 1);
  CHECK(has(slip.feedback, "2.686"));
  const Opinion other = followed(id, "p = 7.21 1/s");
  CHECK(other.note.word == "power");
  CHECK(followed(id, "p = 1/2*sqrt(3*g/R)\np = 7.21 1/s").line == 2);
  CHECK(followed(id, "p = 2.69 = = 1/s").outcome == Outcome::invalid);
  CHECK(followed(id, "p = 2.69 apples").outcome == Outcome::invalid);
  CHECK(followed(id, "p = 9^9^9^9 = 2.69 1/s").outcome == Outcome::invalid);
}

TEST_CASE("chains, equations in what is asked for, and definitions") {
  const Opinion chain =
      followed("height-of-centre",
               "y_c = R*cos(alpha - theta) - R*cos(alpha) = R*(cos(alpha) - cos(alpha - theta))\n"
               "= R*(cos(alpha - theta) - cos(alpha))");
  CHECK(chain.line == 1);
  CHECK(chain.note.word == "sign");
  REQUIRE(chain.witness);
  CHECK(chain.witness->printed == "-" + chain.witness->derived);
  CHECK(followed("strike-velocity", "e*thetadot_before = alpha*p\nthetadot_before = alpha*p/e").outcome ==
        Outcome::correct);
  CHECK(followed("strike-velocity", "e*thetadot_before = alpha*p\nthetadot_before = e*alpha*p").line == 2);
  CHECK(followed("equation-of-motion",
                 "4/3*m*R^2*thetaddot = -m*R*(u_gddot*cos(alpha - theta) + g*sin(alpha - theta))\n"
                 "thetaddot = -p^2*(u_gddot/g*cos(alpha - theta) + sin(alpha - theta))")
            .outcome == Outcome::correct);
  const Opinion wrong_throughout = followed("height-of-centre",
                                            "R*cos(alpha + theta) - R*cos(alpha)\n"
                                            "= R*(cos(alpha + theta) - cos(alpha))");
  CHECK(wrong_throughout.line == 0);
  CHECK(wrong_throughout.note.word == "wrong_angle");
  CHECK(has(wrong_throughout.feedback, "the first is wrong already"));
}

TEST_CASE("what is assumed is said behind the line, and holds there alone") {
  const std::string exact =
      "thetaddot = -p^2*(a_p/g*sin(omega_p*t + psi)*cos(alpha - theta) + sin(alpha - theta))\n";
  const std::string linear = "thetaddot = -p^2*(a_p/g*sin(omega_p*t + psi) + alpha - theta)";
  CHECK(followed("linear-equation", exact + linear + " [small alpha, theta]").outcome == Outcome::correct);
  const Opinion unsaid = followed("linear-equation", exact + linear);
  CHECK(unsaid.line == 2);
  CHECK(unsaid.note.word == "small_angle");
  CHECK(unsaid.witness);
  CHECK(followed("linear-equation", exact + linear + " + p^2*theta^2/2 [small alpha]").outcome ==
        Outcome::wrong);
  CHECK(followed("sudden-start",
                 "(4 - 3*cos(alpha)^2)/(3*sin(alpha)*cos(alpha))\n"
                 "= (4 - 3*cos(alpha)^2)/(3*fabs(sin(alpha)*cos(alpha))) [sin(alpha) > 0, cos(alpha) > 0]\n"
                 "= (4 - 3*cos(alpha)^2)/(3*sin(alpha)*cos(alpha)) [sin(2*alpha) > 0]")
            .outcome == Outcome::correct);
  CHECK(followed("release-from-rest",
                 "alpha - alpha/2*cosh(p*t)\n= alpha - (alpha - theta_0)*cosh(p*t) [theta_0 = alpha/2]")
            .outcome == Outcome::correct);
  CHECK(followed("release-from-rest",  // it is given that theta_0 > 0
                 "alpha - alpha*cosh(p*t)\n= alpha - (alpha - theta_0)*cosh(p*t) [theta_0 = 0]")
            .note.word == "assumption");
  CHECK(followed("release-from-rest",
                 "alpha - alpha*cosh(p*t) [theta_0 = 0]\n= alpha - (alpha - theta_0)*cosh(p*t)")
            .line == 2);
  CHECK(followed("momentum", "J_o*thetadot\nJ_o*thetadot + 1 [R > 1, R < 0]").note.word == "assumption");
}

TEST_CASE("what cannot be read is refused with its line, and nothing hangs") {
  const auto line_and_note = [](const std::string& lines) {
    const Opinion opinion = followed("height-of-centre", lines);
    CHECK(opinion.outcome == Outcome::invalid);
    return std::to_string(opinion.line) + " " + opinion.note.word;
  };
  CHECK(line_and_note("= R") == "1 syntax");
  CHECK(line_and_note("R\n= R [theta > 0") == "2 syntax");
  CHECK(line_and_note("R\n= R [theta]") == "2 assumption");
  CHECK(line_and_note("R\n= R []") == "2 empty");
  CHECK(line_and_note("R\n= R [small theta, 3]") == "2 assumption");
  CHECK(line_and_note("R\n= R [small") == "2 syntax");
  CHECK(line_and_note("R\n=") == "2 empty");
  CHECK(line_and_note("R\nR > 0") == "2 equation_wanted");
  CHECK(line_and_note("R\nR*beta7") == "2 unknown_symbol");
  CHECK(line_and_note("R\n= R/0") == "2 undefined");
  CHECK(line_and_note("R = R" + std::string(9000, '(')) == "1 too_deep");
  std::string many = "R\n";
  for (int k = 0; k < 60; ++k) many += "= R\n";
  CHECK(line_and_note(many) == "41 too_long");
  CHECK(followed("equation-of-motion", "thetaddot").note.word == "equation_wanted");
  const Opinion hard = followed("restitution", "exp(exp(exp(alpha)))^(1/7)\n= log(1 + exp(exp(alpha^9)))^20");
  CHECK((hard.outcome == Outcome::wrong || hard.outcome == Outcome::undecided));
}

TEST_CASE("on the command line: the answer counts, exit codes are those of an answer") {
  TemporaryFolder folder;
  const auto file = folder.path / "working.txt";
  const auto run = [&](const std::string& id, const std::string& lines, bool json = false) {
    std::ofstream(file, std::ios::binary) << lines;
    std::vector<std::string> arguments{
        "--progress", (folder.path / "progress.txt").string(), "check", id, "--working", file.string()};
    if (json) arguments.push_back("--json");
    return run_program("exercises", arguments);
  };
  const std::string wrong = "# mine\n\n1 - 3/2*sin(alpha)^2\n= 1 - 3/2*(1 + cos(alpha)^2)\n";
  const Result pointed_at = run("restitution", wrong);
  CHECK(pointed_at.exit_code == 1);
  CHECK(pointed_at.out.find("Line 4\n") == 0);
  CHECK(has(pointed_at.out, "before: "));
  const auto json = nlohmann::json::parse(run("restitution", wrong, true).out);
  CHECK(json["line"] == 4);
  CHECK(json["witness"]["answer"] != json["witness"]["right"]);
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n\xff\n").exit_code == 2);
  CHECK(run("restitution", "# nothing\n").exit_code == 2);
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n= 1 -\n").out.find("Line 2\n") == 0);
  const Result number = run("which-momentum", "c\n");
  CHECK(run("first-lift", "tan(alpha) = 0.3\na_p = g*tan(alpha) = 2.94 m/s^2\n").exit_code == 0);
  CHECK(number.exit_code == 2);
  CHECK(has(number.err, "does not ask for a formula"));
  CHECK(run("restitution", "1 - 3/2*sin(alpha)^2\n= 1 - 3/2*(1 - cos(alpha)^2)\n").exit_code == 0);
  CHECK(has(read_file(folder.path / "progress.txt"), "restitution\tsolved\t3"));
  std::filesystem::remove(file);
  CHECK(has(run_program("exercises", {"check", "restitution", "--working", file.string()}).err,
            "there is no file"));
}
