// What a teacher gets of a class: the gradebook, the pages to hand back, the report.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <ctime>
#include <tests/cases.hpp>

#include "server.hpp"

namespace fs = std::filesystem;

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
  const std::string head = "student,height-of-centre,frequency-of-a-bookcase,restitution,total,out_of\n";
  const std::string in_time = head + "anna,0.5,,1.6,2.1,3.5\nbert,,0.25,0,0.25,3.5\ncarl,,,,0,3.5\n";
  const std::string dated = head.substr(0, head.size() - 1) + ",late\n",
                    others = "bert,,0.25,0,0.25,3.5,\ncarl,,,,0,3.5,\n";
  const std::string punctual = dated + "anna,0.5,,1.6,2.1,3.5,\n" + others;
  const std::string late = dated + "anna,0,,1.6,1.6,3.5,height-of-centre\n" + others;
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
        dated + "anna,0.5,,0,0.5,3.5,restitution\n" + others);
  room.grade({"--gradebook", room.book.string()});
  CHECK(contains(read_file(room.book), "\nanna,0.5,"));
  CHECK(contains(read_file(room.book), ",total,out_of\n"));
  CHECK(contains(read_file(room.book), ",1.3,42\n"));  // without weights each exercise counts 1
}

TEST_CASE("a page a student says what was answered, what is wrong with it, a hint and the marks") {
  const ClassRoom room = small_class();
  REQUIRE(room.grade({"--feedback", room.pages.string(), "--deadline", "2026-04-01"}).exit_code == 0);
  CHECK(room.page_names() == std::vector<std::string>{"anna.html", "bert.html", "carl.html"});
  const std::string anna = read_file(room.pages / "anna.html"), bert = read_file(room.pages / "bert.html");
  for (const auto* part : {"<h1>anna</h1>", "Marks: 0.8 of 42", "Marks: 0.8 of 1, after 3 attempts",
                           "Correct.", "Marks: 0 of 1, after 20 attempts; handed in after the deadline"})
    CHECK_MESSAGE(contains(anna, part), part);
  for (const auto* part : {"<pre>cos(2*alpha)\n</pre>", "You have left out the rotation about C",
                           "A hint: Write the", "Not right yet.", "The value is right, but the form is not."})
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
  room.hand_in("emil/restitution.txt", "1 - 3/2*sin(alpha", 3, 10);
  REQUIRE(room.grade({"--report", room.report.string()}).exit_code == 0);
  const std::string page = read_file(room.report);
  CHECK(contains(page, "<td>missing term</td><td>2</td><td>restitution</td>"));
  CHECK(contains(page, "<td>missing term</td><td>2</td><td><code>cos(2*alpha)</code> × 2</td>"));
  CHECK(contains(page, "1 of 4 answers are right."));
  CHECK(page.find("<td>missing term</td>") < page.find("<td>missing unit</td>"));
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
