// What a teacher gets of a class: the gradebook, the pages to hand back, the report.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <ctime>
#include <tests/cases.hpp>

#include "server.hpp"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A folder with the answers of a class in it.
struct ClassRoom {
  TemporaryFolder folder;
  fs::path answers = folder.path / "class", book = folder.path / "book.csv", pages = folder.path / "pages",
           report = folder.path / "report.html";

  fs::path file(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name, std::ios::binary) << text;
    return folder.path / name;
  }
  /// Handed in at noon (UTC) of that day in 2026.
  void hand_in(const fs::path& name, const std::string& text, int month, int day) const {
    std::tm noon{};
    noon.tm_year = 126, noon.tm_mon = month - 1, noon.tm_mday = day, noon.tm_hour = 12;
    const timespec times[2] = {{::timegm(&noon), 0}, {::timegm(&noon), 0}};
    REQUIRE(::utimensat(AT_FDCWD, file("class" / name, text).c_str(), times, 0) == 0);
  }
  Result grade(std::vector<std::string> options) const {
    options.insert(options.begin(), {"grade", answers.string()});
    return run_program("exercises", options);
  }
  std::vector<std::string> page_names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(pages)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
};

const std::string right = "1 - 3/2*sin(alpha)^2\n", slip = "cos(2*alpha)\n";

/// Three students, handed in on 10 March and 10 April 2026.
ClassRoom small_class() {
  ClassRoom room;
  room.hand_in("anna/restitution.txt", right, 3, 10);
  room.hand_in("anna/height-of-centre.txt", "R*(cos(alpha-theta)-cos(alpha))\n", 4, 10);
  room.hand_in("anna/exercises.txt", "restitution\tsolved\t3\t0\tx\nheight-of-centre\tsolved\t20\t0\tx\n", 3,
               10);
  room.hand_in("bert/restitution.txt", slip, 3, 10);
  room.hand_in("bert/frequency-of-a-bookcase.txt", "2.69\n", 3, 10);
  fs::create_directories(room.answers / "carl");
  room.file("class/README", "no student");
  return room;
}

}  // namespace

TEST_CASE("the gradebook: score, attempts, weights and the deadline") {
  const ClassRoom room = small_class();
  const std::string weights = room.file(
      "weights.csv", "exercise,weight\r\nrestitution,2\nheight-of-centre,1\n\nfrequency-of-a-bookcase,0.5\n");
  const auto book = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"--gradebook", room.book.string(), "--weights", weights});
    const Result result = room.grade(options);
    CHECK_MESSAGE(result.exit_code == 0, result.err);
    return read_file(room.book);
  };
  const std::string head =
      "student,height-of-centre,frequency-of-a-bookcase,restitution,total,out_of,to_decide\n";
  const std::string in_time = head + "anna,0.5,,1.6,2.1,3.5,0\nbert,,0.5,0,0.5,3.5,0\ncarl,,,,0,3.5,0\n";
  const std::string dated = head.substr(0, head.size() - 1) + ",late\n",
                    others = "bert,,0.5,0,0.5,3.5,0,\ncarl,,,,0,3.5,0,\n";
  const std::string punctual = dated + "anna,0.5,,1.6,2.1,3.5,0,\n" + others;
  const std::string late = dated + "anna,0,,1.6,1.6,3.5,0,height-of-centre\n" + others;
  CHECK(book({}) == in_time);
  CHECK(book({"--workers", "3"}) == in_time);
  CHECK(book({"--deadline", "2026-04-10"}) == punctual);  // that day's end
  CHECK(book({"--deadline", "2026-04-10T12:00"}) == punctual);
  CHECK(book({"--deadline", "2026-04-10T13:59:59+02:00"}) == late);
  CHECK(book({"--deadline", "2026-04-09"}) == late);
  const std::string by_exercise =
      room.file("deadlines.csv", "exercise,deadline\nheight-of-centre,2026-04-01\nrestitution,2026-05-01\n");
  CHECK(book({"--deadline", by_exercise}) == late);
  const std::string times = room.file(
      "times.csv", "student,exercise,time\nanna,,2026-03-09\nanna,restitution,2026-03-12\nzoe,,2026-01-01\n");
  CHECK(book({"--deadline", "2026-03-11", "--handed-in", times}) ==
        dated + "anna,0.5,,0,0.5,3.5,0,restitution\n" + others);
  room.grade({"--gradebook", room.book.string()});
  CHECK(contains(read_file(room.book), "\nanna,0.5,"));
  CHECK(contains(read_file(room.book), ",total,out_of,to_decide\n"));
  CHECK(contains(read_file(room.book), ",1.3,3,0\n"));  // each exercise counts 1 that anybody handed in
  room.grade({"--gradebook", room.book.string(), "--set", "restitution", "barrier"});
  CHECK(
      read_file(room.book) ==
      "student,barrier,restitution,total,out_of,to_decide\nanna,,0.8,0.8,2,0\nbert,,0,0,2,0\ncarl,,,0,2,0\n");
}

TEST_CASE("a page a student says what was answered, what is wrong with it, a hint and the marks") {
  const ClassRoom room = small_class();
  REQUIRE(room.grade({"--feedback", room.pages.string(), "--deadline", "2026-04-01"}).exit_code == 0);
  CHECK(room.page_names() == std::vector<std::string>{"anna.html", "bert.html", "carl.html"});
  const std::string anna = read_file(room.pages / "anna.html"), bert = read_file(room.pages / "bert.html");
  for (const auto* part : {"<h1>anna</h1>", "Marks: 0.8 of 3", "Marks: 0.8 of 1, after 3 attempts",
                           "Correct.", "Marks: 0 of 1, after 20 attempts; handed in after the deadline"})
    CHECK_MESSAGE(contains(anna, part), part);
  for (const auto* part : {"<pre>cos(2*alpha)\n</pre>", "You have left out the rotation about C",
                           "A hint: Write the", "Not right yet.", "The unit is missing: it is read as 1/s."})
    CHECK_MESSAGE(contains(bert, part), part);
  CHECK(!contains(bert, "3/2"));  // the answer itself is not in it
  CHECK(contains(read_file(room.pages / "carl.html"), "empty folder"));
  room.grade({"--feedback", room.pages.string() + "/", "--deadline", "2026-04-01"});
  CHECK(read_file(room.pages / "anna.html") == anna);
  // a folder that is named relative to the current one
  const std::string here = "cd " + quoted(room.folder.path) + " && " + quoted(REDERIVE_PROGRAMS "/exercises");
  CHECK(
      run_program("/bin/sh", {"-c", here + " grade class --feedback back --deadline 2026-04-01"}).exit_code ==
      0);
  CHECK(read_file(room.folder.path / "back/anna.html") == anna);
}

TEST_CASE("the report counts slips, the most common first, with typical answers and no names") {
  const ClassRoom room = small_class();
  room.hand_in("dora/restitution.txt", slip, 3, 10);
  room.hand_in("dora/frequency-of-a-bookcase.txt", "2.69 s", 3, 10);
  room.hand_in("emil/restitution.txt", "1 - 3/2*sin(alpha", 3, 10);
  REQUIRE(room.grade({"--report", room.report.string()}).exit_code == 0);
  const std::string page = read_file(room.report);
  CHECK(contains(page, "<td>missing term</td><td>2</td><td>restitution</td>"));
  CHECK(contains(page, "<td>missing term</td><td>2</td><td><code>cos(2*alpha)</code> × 2</td>"));
  CHECK(contains(page, "1 of 4 answers are right."));
  CHECK(page.find("<td>missing term</td>") < page.find("<td>unit</td>"));
  for (const auto* name : {"anna", "bert", "dora", "emil"}) CHECK_MESSAGE(!contains(page, name), name);
}

TEST_CASE("hostile names and answers are text in pages, cells and names of files") {
  const ClassRoom room;
  const std::string tag = "<img src=x onerror=alert(1)>", html = "<b>&\"'";
  for (const std::string& name :
       {std::string("=1+2"), std::string("@x"), std::string("+1"), std::string("-1"), html, std::string("A"),
        std::string("a"), std::string("a\\b;=1"), std::string("\xff\xfe"), std::string("Zoë"),
        std::string(250, 'x'), std::string(249, 'x') + "y", std::string("x\n=1")})
    room.hand_in(fs::path(name) / "restitution.txt", tag, 3, 10);
  const Result result = room.grade({"--gradebook", room.book.string(), "--feedback", room.pages.string(),
                                    "--report", room.report.string()});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  const auto names = room.page_names();
  CHECK(names.size() == 13);
  for (const auto& name : names) {
    CHECK(name.size() <= 90);
    CHECK_MESSAGE(name.find_first_of("<>&\"'=+@;\\\n ") == std::string::npos, name);
    CHECK_MESSAGE((name[0] != '-' && name[0] != '.'), name);
    const std::string page = read_file(room.pages / name);
    CHECK(contains(page, "&lt;img src=x onerror=alert(1)&gt;"));
    CHECK((!contains(page, "<img") && !contains(page, "<b>&")));
  }
  CHECK(std::count(names.begin(), names.end(), "Zoë.html") == 1);
  CHECK(std::count(names.begin(), names.end(), "a-2.html") == 1);  // beside A.html, which may be the same
  CHECK(!contains(read_file(room.report), "<img"));
  const std::string book = read_file(room.book);
  for (const auto* cell :
       {"\n'=1+2,", "\n'@x,", "\n'+1,", "\n'-1,", "\n\"<b>&\"\"'\",", "\n\"a\\b;=1\",", "\n\"x\n=1\","})
    CHECK_MESSAGE(contains(book, cell), cell);
}

TEST_CASE("bad input: exit code 2, a message, and nothing written") {
  const ClassRoom room = small_class();
  each_case("refused", [&](const Cells& row) {
    std::vector<std::string> options;
    for (std::string option : rest(row, 1)) {
      if (option.starts_with("text:")) option = room.file("list.csv", option.substr(5));
      if (option.starts_with("ROOM")) option.replace(0, 4, room.folder.path);
      options.push_back(option);
    }
    const Result result = room.grade(options);
    CHECK(result.exit_code == 2);
    CHECK(contains(result.err, row[0]));
    CHECK(result.out == "");
    CHECK(!fs::exists(room.book));
    CHECK(!fs::exists(room.pages));
  });
}

TEST_CASE("what ended by a crash is named, and is not graded: exit code 3") {
  ClassRoom room;
  for (int k = 0; k < 30; ++k)
    room.file("class/student" + std::to_string(k) + "/height-of-centre.txt",
              "R*(cos(alpha-theta)-cos(alpha))\n");
  const std::string csv = room.folder.path / "rows.csv", said = room.folder.path / "said.txt";
  const int error = ::open(said.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const pid_t program = start_program(
      {REDERIVE_PROGRAMS "/exercises", "grade", "--workers", "1", "--csv", csv, room.answers}, {{error, 2}});
  int status = 0;
  while (::waitpid(program, &status, WNOHANG) == 0)
    for (const pid_t child : children_of(program)) ::kill(child, SIGKILL);
  ::close(error);
  const std::string rows = read_file(csv), names = read_file(said);
  std::size_t ended = 0, listed = 0;
  for (std::size_t at = 0; (at = rows.find(",undecided,killed,0\n", at)) != std::string::npos; ++at) ++ended;
  for (std::size_t at = 0; (at = names.find("/height-of-centre: killed\n", at)) != std::string::npos; ++at)
    ++listed;
  CHECK(ended > 0);
  CHECK(listed == ended);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 3));
  CHECK(room.grade({}).exit_code == 0);
}

TEST_CASE(
    "right answers are right whichever standard descriptors are closed, and with any number of workers") {
  ClassRoom room;
  for (const std::string student : {"a", "b", "c", "d"})
    room.file("class/" + student + "/height-of-centre.txt", "R*(cos(alpha-theta)-cos(alpha))\n");
  const std::string csv = room.folder.path / "rows.csv";
  for (const std::string redirect : {"<&-", ">&-", "2>&-", "<&- 2>&-", "<&- >&- 2>&-"})
    for (const std::string workers : {"1", "16"}) {
      fs::remove(csv);
      run_program("/bin/sh", {"-c", "exec '" REDERIVE_PROGRAMS "/exercises' grade --workers " + workers +
                                        " --csv '" + csv + "' '" + room.answers.string() + "' " + redirect});
      const std::string rows = read_file(csv);
      CAPTURE(redirect);
      CHECK(std::count(rows.begin(), rows.end(), '\n') == 5);
      CHECK(!contains(rows, "undecided"));
      CHECK(contains(rows, "a,height-of-centre,correct,"));
      CHECK(contains(rows, "d,height-of-centre,correct,"));
    }
}

TEST_CASE("a file whose name is nearly right counts, with a note; what systems leave behind is nothing") {
  const ClassRoom room;
  for (const char* name :
       {"anna/Restitution.TXT", "bert/restitution.txt.txt", "carl/restitutoin.txt", "dora/restitution",
        "Zoe\u0308/restitution.txt", "emil/restitution.txt", ".git/restitution.txt",
        "__MACOSX/anna/restitution.txt", "anna/._Restitution.TXT", "anna/~$restitution.txt",
        "anna/.#restitution.txt", "anna/restitution.txt~", "anna/restitution.txt.lock", "anna/Thumbs.db",
        "anna/desktop.ini", "anna/.DS_Store"})
    room.hand_in(name, right, 3, 10);
  room.hand_in("emil/Restitution.txt", slip, 3, 10);  // the exact name is there
  room.hand_in("fay/RESTITUTION.txt", slip, 3, 10);   // which of the two?
  room.hand_in("fay/Restitution.txt", right, 3, 10);
  room.hand_in("gus/restitution.docx", right, 3, 10);
  const Result result = room.grade({});
  CHECK(result.exit_code == 0);
  for (const char* row :
       {"\nanna,restitution,correct,", "\nbert,restitution,correct,", "\ncarl,restitution,correct,",
        "\ndora,restitution,correct,", "\nZoe\u0308,restitution,correct,", "\nemil,restitution,correct,",
        "\nemil,Restitution.txt,invalid,unknown_exercise,", "\nfay,RESTITUTION.txt,invalid,unknown_exercise,",
        "\nfay,Restitution.txt,invalid,unknown_exercise,",
        "\ngus,restitution.docx,invalid,unknown_exercise,"})
    CHECK_MESSAGE(contains(result.out, row), row);
  CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 11);
  for (const char* note : {"anna, restitution: The file Restitution.TXT is taken for restitution.txt.",
                           "carl, restitution: The file restitutoin.txt is taken for restitution.txt."})
    CHECK_MESSAGE(contains(result.err, note), note);
  CHECK(!contains(result.err, "emil"));
}

TEST_CASE("what cannot be read or decided waits for the teacher, who decides it with a key, once") {
  const ClassRoom room;
  room.hand_in("anna/restitution.txt", "1 - 3/2*sin(alpha", 3, 10);
  room.hand_in("bert/restitution.txt", "1 - 3/2*sinn(alpha)^2", 3, 10);
  room.hand_in("carl/restitution.txt", "=\xff", 3, 10);
  room.hand_in("dora/restitution.txt", "", 3, 10);
  room.hand_in("emil/restitution.txt", right, 3, 10);
  const auto marks = [&](const std::string& keys) {
    const Result result = run_program(
        "/bin/sh", {"-c", "printf '%s' '" + keys + "' | " + quoted(REDERIVE_PROGRAMS "/exercises") +
                              " grade " + quoted(room.answers) + (keys.empty() ? "" : " --review") +
                              " --gradebook " + quoted(room.book)});
    CHECK(result.exit_code == 0);
    return read_file(room.book).substr(std::string("student,restitution,total,out_of,to_decide\n").size()) +
           (contains(result.err, "--review") ? "more\n" : "");
  };
  const std::string others = "dora,0,0,1,0\nemil,1,1,1,0\n";
  CHECK(marks("") == "anna,?,0,1,1\nbert,?,0,1,1\ncarl,?,0,1,1\n" + others + "more\n");
  CHECK(!fs::exists(room.answers / "decisions.csv"));
  CHECK(marks("zr\nq") == "anna,1,1,1,0\nbert,?,0,1,1\ncarl,?,0,1,1\n" + others + "more\n");  // z is no key
  CHECK(marks("sh") == "anna,1,1,1,0\nbert,?,0,1,1\ncarl,0.5,0.5,1,0\n" + others + "more\n");
  CHECK(marks("w") == "anna,1,1,1,0\nbert,0,0,1,0\ncarl,0.5,0.5,1,0\n" + others);
  CHECK(marks("") == "anna,1,1,1,0\nbert,0,0,1,0\ncarl,0.5,0.5,1,0\n" + others);
  room.hand_in("anna/restitution.txt", "2 - 3/2*sin(alpha", 3, 10);  // another answer: another question
  CHECK(marks("") == "anna,?,0,1,1\nbert,0,0,1,0\ncarl,0.5,0.5,1,0\n" + others + "more\n");
  write_file(room.answers / "decisions.csv", "student,exercise,answer,decision\nanna,restitution,x,good\n");
  const Result refused = room.grade({});
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.err, "decisions.csv, line 2: 'good' must be right, half, wrong, or 'reading '"));
}

TEST_CASE("an ambiguous answer is judged as the reading that the teacher's key names, also later") {
  const ClassRoom room;
  for (const char* student : {"anna", "bert", "carl"})
    room.hand_in(student + std::string("/inertia-about-corner.txt"), "1 1/3*m*R^2\n", 3, 10);
  const auto graded = [&](const std::string& keys) {
    return run_program(
        "/bin/sh", {"-c", "printf '%s' '" + keys + "' | " + quoted(REDERIVE_PROGRAMS "/exercises") +
                              " grade --json " + quoted(room.answers) + (keys.empty() ? "" : " --review")});
  };
  const auto scores = [](const Result& result) {
    std::string text;
    const json all = json::parse(result.out);
    for (const json& row : all["grades"])
      text += fmt::format("{} {} ", row["verdict"].get<std::string>(), row["score"].get<double>());
    return text + all["to_decide"].dump();
  };
  CHECK(scores(graded("")) == "ambiguous 0 ambiguous 0 ambiguous 0 3");
  const Result asked = graded("3 0 1 2 s");  // 3 and 0 are no readings
  CHECK(contains(asked.err, "[1]-[2] as read so  [r]ight"));
  const std::string decided = scores(asked);
  CHECK_MESSAGE(
      (decided == "correct 1 wrong 0 ambiguous 0 1" || decided == "wrong 0 correct 1 ambiguous 0 1"),
      decided);
  const std::string kept = read_file(room.answers / "decisions.csv");
  CHECK(contains(kept, "anna,inertia-about-corner,1 1/3*m*R^2,reading "));
  CHECK(scores(graded("")) == decided);
  const json all = json::parse(graded("").out);
  CHECK(contains(all["feedback"][0]["feedback"], "Your teacher has read this answer as"));
  CHECK(contains(all["feedback"][0]["answer"], "1 1/3*m*R^2"));  // as it was written
  write_file(room.answers / "decisions.csv",
             "student,exercise,answer,decision\nanna,inertia-about-corner,1 1/3*m*R^2,reading m\n");
  CHECK(scores(graded("")) == "ambiguous 0 ambiguous 0 ambiguous 0 3");  // it is none of its readings
}

TEST_CASE("a progress file that was handed in has answers and attempts, also one of format 1") {
  const ClassRoom room;
  room.hand_in("anna/exercises.txt", "restitution\tsolved\t3\t0\t1 - 3/2*sin(alpha)^2\n", 3, 10);
  room.hand_in("bert/Exercises (1).txt",
               "# Format 2\r\nrestitution\tsolved\t1\t0\tcos(2*alpha)\tright 1 - 3/2*sin(alpha)^2\r\n"
               "height-of-centre\ttried\t1\t0\tR\tlast R*(cos(\r\n",
               3, 10);
  room.hand_in("carl/exercises.txt", "restitution\tsolved\t1\t0\tx\n", 3, 10);
  room.hand_in("carl/restitution.txt", right, 3, 10);
  room.hand_in("dora/exercises.txt", "# Format 9\nrestitution\tsolved\t1\t0\tx\n", 3, 10);
  room.hand_in("emil/exercises.txt", "barrier\ttried\t1\t0\tm*g*R\tseed 77\n", 3, 10);
  const json all = json::parse(room.grade({"--json", "--set", "restitution"}).out);
  CHECK(all["set"] == json{"restitution"});
  CHECK(all["to_decide"] == 2);
  std::map<std::string, json> marks;
  for (const json& row : all["marks"]) marks[row["student"]] = row;
  CHECK(marks["anna"]["restitution"] == 0.8);
  CHECK(marks["bert"]["restitution"] == 1);
  CHECK(marks["carl"]["total"] == 1);
  CHECK(marks["dora"]["restitution"].is_null());
  std::string rows;
  for (const json& row : all["feedback"])
    rows += row["student"].get<std::string>() + " " + row["exercise"].get<std::string>() + " " +
            row["note"].get<std::string>() + "\n";
  for (const char* row : {"bert height-of-centre syntax\n", "dora exercises.txt unknown_exercise\n",
                          "emil barrier other_variant\n"})
    CHECK_MESSAGE(contains(rows, row), rows);
}

TEST_CASE("marks, feedback and report as CSV, HTML and JSON") {
  const ClassRoom room = small_class();
  for (const std::string ending : {".csv", ".html", ".json"}) {
    const std::string marks = room.folder.path / ("marks" + ending),
                      report = room.folder.path / ("r" + ending),
                      feedback = room.folder.path / ("feedback" + (ending == ".html" ? "" : ending));
    REQUIRE(room.grade({"--gradebook", marks, "--report", report, "--feedback", feedback}).exit_code == 0);
    if (ending == ".json") {
      CHECK(json::parse(read_file(marks))[0]["total"] == 1.3);
      CHECK(json::parse(read_file(feedback))[0]["student"] == "anna");
      CHECK(json::parse(read_file(report)).size() == 3);
    }
    if (ending == ".html") CHECK(contains(read_file(marks), "<table"));
    if (ending == ".csv") {
      CHECK(contains(read_file(feedback), "\nbert,restitution,wrong,missing_term,0,0,,cos(2*alpha),"));
      CHECK(contains(read_file(report), "\nrestitution,2,1,missing_term,1,cos(2*alpha)\n"));
    }
  }
}
