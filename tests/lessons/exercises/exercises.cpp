// The classroom as students and teachers meet it: right answers in unusual forms, wrong ones in usual ways,
// and a class that hands in anything at all.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include "classroom.hpp"

using namespace rederive::classroom;
namespace fs = std::filesystem;
using nlohmann::json;

TEST_CASE("the exercise set is sound") {
  const Result result = run_program("exercises", {"selftest", "--json"});
  CHECK_MESSAGE(result.exit_code == 0, result.out);
  const auto report = json::parse(result.out);
  CHECK(report["exercises"].get<int>() >= 36);
  CHECK(report["variants"].get<int>() >= 150);
  CHECK(report["complaints"].empty());
}

TEST_CASE("a wrong answer that no rule knows gets a point to try by hand") {
  const Desk desk;
  const json opinion = desk.judged("height-of-centre", "R*(cos(alpha - theta/2)^3 - cos(alpha))");
  CHECK(opinion["note"] == "other");
  CHECK(opinion["witness"]["at"].size() == 3);
  CHECK(opinion["witness"]["answer"] != opinion["witness"]["right"]);
  CHECK(opinion["score"] == 0);
}

TEST_CASE("what cannot be read is explained with a caret and costs nothing") {
  const Desk desk;
  const Result result = desk.run({"check", "height-of-centre", "R*(cos(alpha)"});
  CHECK(result.exit_code == 2);
  CHECK(contains(result.out, "\n    ^"));
  for (const auto* hostile : {"1e999999999", "((((((((((", "R^R^R^R^R^999", "1/0", "", "?", "R 2", "sin",
                              "\xff\xfe", "R; rm -rf /"})
    CHECK_MESSAGE(desk.run({"check", "height-of-centre", "--", hostile}).exit_code == 2, hostile);
  CHECK(desk.run({"check", "first-lift", "--", std::string(60'000, 'm')}).exit_code == 2);
  const auto listed = desk.json_of({"list"});
  CHECK(listed["exercises"][0]["attempts"] == 0);
}

TEST_CASE("exit codes are those of the contract") {
  const Desk desk;
  CHECK(desk.run({"check", "restitution", "1 - 3/2*sin(alpha)^2"}).exit_code == 0);
  CHECK(desk.run({"check", "restitution", "cos(2*alpha)"}).exit_code == 1);
  CHECK(desk.run({"check", "no-such-exercise", "1"}).exit_code == 2);
  CHECK(desk.run({"check", "restitution"}).exit_code == 2);
  CHECK(contains(desk.run({"check", "restitution", "--file", "/no/such/file"}).err, "/no/such/file"));
  CHECK(desk.run({"no-such-command"}).exit_code == 2);
  CHECK(desk.run({"grade", "/no/such/folder"}).exit_code == 2);
}

TEST_CASE("hints come one by one, the solution only when it is due, and reset keeps the old answer") {
  const Desk desk;
  const std::string first = desk.run({"hint", "restitution"}).out,
                    second = desk.run({"hint", "restitution"}).out;
  CHECK(first.find("Hint 1 of 3") == 0);
  CHECK(second.find("Hint 2 of 3") == 0);
  CHECK(desk.run({"solution", "restitution"}).exit_code == 1);
  CHECK(desk.run({"solution", "restitution"}).out == "");
  desk.run({"check", "restitution", "1 - 3/2*sin(alpha)^2"});
  const Result solved = desk.run({"solution", "restitution"});
  CHECK(solved.exit_code == 0);
  CHECK(contains(solved.out, "How it comes about"));
  CHECK(desk.run({"solution", "strike-velocity", "--give-up"}).exit_code == 0);
  desk.run({"reset", "restitution"});
  const std::string kept = read_file(desk.progress);
  CHECK(contains(kept, "old\trestitution\t1 - 3/2*sin(alpha)^2"));
  const auto listed = desk.json_of({"list"});
  CHECK(listed["next"] == "height-of-centre");
}

TEST_CASE("after a slip that was recognised the next hint is the one for it, once, and then the others") {
  const Desk desk;
  const auto hint = [&](const char* id) { return desk.json_of({"hint", id}); };
  desk.judged("restitution", "cos(2*alpha)");
  const json its_own = hint("restitution");
  CHECK(its_own["slip"] == "missing_term");
  CHECK(its_own["hint"].get<std::string>().find("turning about C") != std::string::npos);
  CHECK(its_own["number"] == 0);
  CHECK(hint("restitution")["slip"].is_null());
  desk.judged("restitution", "cos(2*alpha)");  // the same again: nothing new to say
  CHECK(hint("restitution")["number"] == 2);
  desk.judged("restitution", "1 - 3*sin(alpha)^2");  // another slip, which the exercise does not list
  const json by_name = hint("restitution");
  CHECK(by_name["slip"] == "factor");
  CHECK(by_name["hint"].get<std::string>().find("numbers") != std::string::npos);
  desk.judged("restitution", "sin(alpha)^7 + alpha^3");  // none that is recognised
  CHECK(hint("restitution")["number"] == 3);
  desk.judged("which-momentum", "b");
  CHECK(hint("which-momentum")["slip"] == "wrong_point");
  desk.judged("restitution", "1 - 3/2*sin(alpha)^2");  // solved; and then another slip, to see what it says
  CHECK(hint("restitution")["slip"].is_null());
  desk.judged("restitution", "1 - 3*sin(alpha)^2");
  CHECK(hint("restitution")["slip"] == "factor");
  desk.judged("momentum", "J_o*thetadot - m*R*u_gdot*cos(alpha-theta)");
  desk.judged("momentum", "J_o*thetadot + m*R*u_gdot*cos(alpha-theta)");
  CHECK(hint("momentum")["number"] == 1);  // solved: no slip is left
}

TEST_CASE("without a command it says what is next, and praises no giving up") {
  const Desk desk;
  const Result first = desk.run({});
  CHECK(first.exit_code == 0);
  CHECK(contains(first.out, "Next: exercises show height-of-centre"));
  const json listed = desk.json_of({"list"});
  for (const auto& exercise : listed["exercises"])
    write(desk.progress,
          read_file(desk.progress) + exercise["id"].get<std::string>() + "\tgiven_up\t1\t0\tx\n");
  const std::string last = desk.run({}).out;
  CHECK(contains(last, "given up"));
  CHECK(!contains(last, "Well worked"));
}

TEST_CASE("what is said in JSON has no marks, and functions are called as they were typed") {
  const Desk desk;
  for (const auto& [id, answer] :
       {std::pair("height-of-centre", "R*cos(alpha - theta)"),
        std::pair("velocity-of-centre", "u_gdot - R*thetadot*cos(alpha - theta)")}) {
    const auto said = desk.judged(id, answer)["feedback"].get<std::string>();
    CHECK_MESSAGE(said.find_first_of("$`") == std::string::npos, said);
  }
  CHECK(desk.judged("height-of-centre", "R*abs(cos(alpha))")["read_as"] == "R*abs(cos(alpha))");
}

TEST_CASE("watch names a file that is no exercise's") {
  const Desk desk;
  write(desk.folder.path / "work" / "restitutoin.txt", "1 - 3/2*sin(alpha)^2\n");
  const std::string said = desk.run({"watch", (desk.folder.path / "work").string(), "--once"}).out;
  CHECK(contains(said, "restitutoin.txt is not judged"));
  CHECK(contains(said, "restitution"));
}

TEST_CASE("a progress file that was damaged is not overwritten") {
  const Desk desk;
  write(desk.progress, "height-of-centre\tsolved\tmany\t0\tx\n");
  CHECK(desk.run({"list"}).exit_code == 2);
  CHECK(contains(desk.run({"list"}).err, "line 1"));
  CHECK(desk.run({"check", "restitution", "1 - 3/2*sin(alpha)^2"}).exit_code == 0);
  CHECK(contains(read_file(desk.progress), "many"));
}

TEST_CASE("watch makes a file for the next exercise and judges what is written into it") {
  const Desk desk;
  const fs::path folder = desk.folder.path / "work";
  fs::create_directories(folder);
  CHECK(desk.run({"watch", folder.string(), "--once"}).exit_code == 0);
  const std::string stub = read_file(folder / "height-of-centre.txt");
  CHECK(contains(stub, "# How high does C rise?"));
  write(folder / "height-of-centre.txt", stub + "R*(cos(alpha - theta) - cos(alpha))\n");
  CHECK(contains(desk.run({"watch", folder.string(), "--once"}).out, "Correct."));
  CHECK(desk.json_of({"list"})["next"] == "velocity-of-centre");
}

TEST_CASE("a class with everything that can go wrong is graded, twice alike") {
  TemporaryFolder folder;
  const fs::path room = folder.path / "class", csv = folder.path / "grades.csv";
  write(room / "anna" / "restitution.txt", "# my answer\n1 - 3/2*sin(alpha)^2\n");
  write(room / "anna" / "height-of-centre.txt", "R*(cos(alpha+theta)-cos(alpha))\n");
  write(room / "bert" / "restitution.txt", "1 - 3/2*sin(\xe4lpha)^2\n");
  write(room / "bert" / "momentum.txt", "");
  write(room / "bert" / "notes.docx", "PK");
  write(room / "line\nbreak, \"quoted\"" / "restitution.txt", "cos(2*alpha)");
  write(room / "README", "not a student");
  write(room / ".zoe" / "restitution.txt", "1");
  write(room / "=1+2" / "restitution.txt", "1");
  fs::create_directories(room / "empty");
  write(folder.path / "secret.txt", "1 - 3/2*sin(alpha)^2");
  fs::create_symlink(folder.path / "secret.txt", room / "anna" / "energy-lost.txt");
  fs::create_symlink(folder.path, room / "linked");
  ::mkfifo((room / "anna" / "stiffness.txt").c_str(), 0600);
  write(room / "carl" / "restitution.txt", "");
  fs::resize_file(room / "carl" / "restitution.txt", 1u << 30);
  write(room / "carl" / "barrier.txt", std::string(9000, '('));
  for (int i = 0; i < 300; ++i) write(room / "dora" / ("x" + std::to_string(i) + ".txt"), "1");
  fs::create_directories(room / "dora" / "restitution.txt");
  const Result first = run_program("exercises", {"grade", room.string(), "--csv", csv.string()});
  REQUIRE(first.exit_code == 0);
  const std::string text = read_file(csv);
  for (const auto* row :
       {"student,exercise,verdict,note,score\n", "anna,restitution,correct,correct,1\n",
        "anna,height-of-centre,wrong,wrong_angle,0\n", "anna,energy-lost,invalid,symlink,0\n",
        "anna,stiffness,invalid,not_a_file,0\n", "bert,restitution,invalid,encoding,0\n",
        "bert,momentum,invalid,empty,0\n", "bert,notes.docx,invalid,unknown_exercise,0\n",
        "carl,restitution,invalid,too_large,0\n", "carl,barrier,invalid,",
        "dora,restitution,invalid,not_a_file,0\n", "dora,,invalid,too_many_files,0\n",
        "empty,,invalid,empty_folder,0\n", "\n'=1+2,restitution,", "linked,,invalid,symlink,0\n",
        "README,,invalid,not_a_folder,0\n",
        "\"line\nbreak, \"\"quoted\"\"\",restitution,wrong,missing_term,0\n"})
    CHECK_MESSAGE(contains(text, row), row);
  CHECK(!contains(text, ".zoe"));
  CHECK(contains(first.out, "restitution"));
  run_program("exercises", {"grade", room.string(), "--csv", csv.string(), "--workers", "3"});
  CHECK(read_file(csv) == text);
}
