// The program rederive: a paper in a folder, from its equations to a class.
#include <doctest/doctest.h>

#include <cmath>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

const fs::path papers = fs::path(REDERIVE_SOURCE) / "lessons/papers";

Result run(const std::vector<std::string>& arguments) {
  return run_program(std::string(REDERIVE_PROGRAMS) + "/rederive", arguments);
}

/// A copy of the example about the rod, in which tests change files.
struct Rod {
  TemporaryFolder folder;
  fs::path path = folder.path / "rod";

  Rod() { fs::copy(papers / "rod", path); }
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    const std::string text = read_file(path / file);
    REQUIRE_MESSAGE(contains(text, from), file, ": ", from);
    write_file(path / file, std::string(text).replace(text.find(from), from.size(), to));
  }
  Result run(std::vector<std::string> arguments = {}) const {
    arguments.insert(arguments.begin(), path.string());
    return ::run(arguments);
  }
};

/// Checks that a change is refused, with exit code 2, nothing on standard output, and these words.
void check_refused(const char* file, const std::string& from, const std::string& to,
                   const std::vector<std::string>& words, const std::vector<std::string>& command = {}) {
  const Rod rod;
  rod.change(file, from, to);
  const Result refused = rod.run(command);
  CAPTURE(to);
  CHECK(refused.exit_code == 2);
  CHECK_MESSAGE(refused.out.empty(), refused.out);
  for (const std::string& word : words) CHECK_MESSAGE(contains(refused.err, word), refused.err);
}

}  // namespace

TEST_CASE("each paper that ships passes its own test") {
  for (const auto& folder : fs::directory_iterator(papers)) {
    if (!fs::exists(folder.path() / "paper.toml")) continue;
    CAPTURE(folder.path().string());
    const Result tested = run({folder.path(), "test"});
    CHECK_MESSAGE(tested.exit_code == 0, tested.out, tested.err);
    CHECK(contains(tested.out, "All checks pass."));
  }
}

TEST_CASE("a new paper passes its own test, and is not written over another one") {
  const TemporaryFolder folder;
  for (const char* from : {"rod", "oscillator", "empty"}) {
    CAPTURE(from);
    const std::string path = folder.path / from;
    const Result made = run({"new", path, "--from", from});
    CHECK_MESSAGE(made.exit_code == 0, made.err);
    const Result tested = run({path, "test"});
    CHECK_MESSAGE(tested.exit_code == 0, tested.out, tested.err);
    CHECK(run({"new", path}).exit_code == 2);
  }
}

TEST_CASE("the ledger of a folder is that of any paper") {
  const Rod rod;
  const Json json = Json::parse(rod.run({"--json"}).out);
  CHECK(json["paper"] == "On a rod that swings on a hinge");
  CHECK(json["counts"]["proved"] == 2);
  CHECK(json["counts"]["refuted"] == 1);
  const std::string correction = json["equations"][2]["correction"];
  CHECK(rod.run({"prove", correction, "omega_0 = sqrt(3*g/(2*L))"}).exit_code == 0);
  CHECK(contains(rod.run({"show", "2"}).out, "θ̈ = −3·g/(2·L)·sin(θ)"));
  CHECK(contains(rod.run({"errata", "--format", "latex"}).out, "\\sqrt"));
  CHECK(contains(rod.run({"claims"}).out, "confirmed"));
  CHECK(rod.run({"prove", "sqrt(L^2)", "L"}).exit_code == 0);  // L is positive in this paper
  CHECK(contains(rod.run({"graph"}).out, "digraph"));
  rod.change("equations.toml", "printed = \"J = m*L^2/3\"", "printed = \"J = ∫_0^L m/L*x^3 dx\"");
  const std::string errata = rod.run({"errata"}).out;  // quotes what the file says
  CHECK_MESSAGE(contains(errata, "printed: J = ∫_0^L m/L*x^3 dx"), errata);
  CHECK_MESSAGE(contains(errata, "worked out: J = "), errata);
  rod.change("claims.toml", "\"1.64\"", "\"1.65\"");
  CHECK(rod.run({"claims"}).exit_code == 1);
  CHECK(rod.run({"test"}).exit_code == 1);
}

TEST_CASE("the files of a paper are refused with file, line and field") {
  check_refused("paper.toml", "unit = \"kg\"", "unit = \"kilogram\"", {"paper.toml:4", "symbol m"});
  check_refused("paper.toml", "range = \"(0, inf)\", meaning = \"mass",
                "range = \"0, inf\", meaning = \"mass", {"paper.toml:4", "symbol m", "0, inf"});
  check_refused("paper.toml", "rates = 2", "rates = 3", {"paper.toml:9", "symbol theta", "rates"});
  check_refused("paper.toml", "rates = 2", "ratess = 2", {"paper.toml:9", "ratess", "did you mean 'rates'"});
  check_refused("paper.toml", "title = ", "titel = ", {"paper.toml:1"});
  check_refused("equations.toml", "follows_from = [\"1\"]", "follows_from = [\"7\"]",
                {"equations.toml:", "row 2", "'7'"});
  check_refused("functions.toml", "row = \"3\"", "row = \"9\"", {"functions.toml:", "function frequency"},
                {"emit", "--list"});
  check_refused("functions.toml", "[\"g\", \"L\"]\nbrief = \"Circular", "[\"g\"]\nbrief = \"Circular",
                {"functions.toml:", "function frequency", "L"}, {"emit", "--list"});
  check_refused("lesson-01.md", "{{argue 1}}", "{{argue 8}}", {"lesson-01.md:12:", "'8'"}, {"lesson", "1"});
  check_refused("lesson-01.md", "{{argue 1}}", "{{arge 1}}", {"lesson-01.md:12:", "did you mean 'argue'"},
                {"lesson", "1"});
  check_refused("lesson-01.md", "{{argue 1}}", "### More", {"lesson-01.md:12:", "##"}, {"lesson", "1"});
  check_refused("lesson-01.md", "$m*L^2$", "$m*Q^2$", {"lesson-01.md:14:", "Q"}, {"lesson", "1"});
  check_refused("claims.toml", "L = \"1\", ", "", {"claims.toml:", "claim c1", "at"}, {"claims"});
  check_refused("claims.toml", "L = \"1\", ", "L = \"0\", ",
                {"claims.toml:1: claim c1", "L = 0", "outside the range (0, inf)"}, {"claims"});
  for (const char* name : {"no-such-folder", "/dev/null"}) CHECK(run({name}).exit_code == 2);
  const TemporaryFolder empty;
  const Result none = run({empty.path});
  CHECK(none.exit_code == 2);
  CHECK(contains(none.err, "paper.toml"));
}

TEST_CASE("exercises may ask for a number without symbols, and give bounds that are roots") {
  const Rod rod;
  fs::remove(rod.path / "lesson-01.md");  // which asks for other exercises
  const auto write = [&](const std::string& more) {
    write_file(rod.path / "exercises.toml",
               "[[exercise]]\nid = \"one\"\ntitle = \"One\"\nkind = \"expression\"\nexample = \"1/7\"\n"
               "hints = [\"Look at the hinge.\", \"Look at the rod.\", \"Look at both.\"]\n" +
                   more);
  };
  write(
      "statement = \"How large is $J$ for $m = 3$ and $L = sqrt(2)$?\"\nsymbols = []\nname = \"J\"\n"
      "answer = { derivation = \"1\", put = { m = \"3\", L = \"sqrt(2)\" } }\n");
  for (const auto& [answer, code] : {std::pair("2", 0), {"0", 1}, {"-sqrt(2)", 1}}) {
    const Result judged =
        rod.run({"exercises", "--progress", rod.folder.path / "progress.txt", "check", "one", "--", answer});
    CHECK_MESSAGE(judged.exit_code == code, answer, ": ", judged.out, judged.err);
  }
  for (const std::string bound : {"1/sqrt(2)", "sqrt(2)/2", "sqrt(1/2)"}) {
    write(
        "statement = \"What is $thetaddot$ for $theta < " + bound + "$?\"\ngiven = [\"theta < " + bound +
        "\"]\nsymbols = [\"g\", \"L\", \"theta\"]\nname = \"thetaddot\"\nanswer = { derivation = \"2\" }\n");
    const Result tested = rod.run({"exercises", "selftest"});
    CHECK_MESSAGE(tested.exit_code == 0, bound, ": ", tested.out, tested.err);
    CHECK_MESSAGE(contains(tested.out, "1 exercise, 0 variants"), tested.out);
  }
}

TEST_CASE("two folders whose papers have one name have their own classes, decisions and progress") {
  const Rod first, second;  // the answer is 2 for the one, 4 for the other
  const auto prepare = [](const Rod& rod, const std::string& mass) {
    std::string text;
    for (const std::string id : {"part-a", "part-b"})
      text +=
          "[[exercise]]\nid = \"" + id +
          "\"\nlesson = 1\ntitle = \"One\"\nkind = \"expression\"\nname = \"J\"\n" +
          "symbols = []\nstatement = \"How large is $J$?\"\nanswer = { derivation = \"1\", put = { m = \"" +
          mass + "\", L = \"sqrt(2)\" } }\n";
    write_file(rod.path / "exercises.toml", text);
    for (const auto& [name, answer] :
         {std::pair("anna/part-a.txt", "2"), {"bert/part-a.txt", "2*("}, {"carl/part-c.txt", "2"}}) {
      fs::create_directories((rod.folder.path / "class" / name).parent_path());
      write_file(rod.folder.path / "class" / name, answer);
    }
  };
  prepare(first, "3"), prepare(second, "6");
  const TemporaryFolder state;
  const auto run = [&](const Rod& rod, const std::string& words, const std::string& keys = "") {
    return run_program("/bin/sh", {"-c", "printf '%s' '" + keys + "' | XDG_STATE_HOME=" + quoted(state.path) +
                                             " " + quoted(REDERIVE_PROGRAMS "/rederive") + " " +
                                             quoted(rod.path) + " exercises " + words});
  };
  const auto graded = [&](const Rod& rod, const std::string& keys = "") {
    return run(rod, "grade " + quoted(rod.folder.path / "class") + (keys.empty() ? "" : " --review"), keys)
        .out;
  };
  CHECK(contains(graded(first, "r"), "\nbert,part-a,correct,decided,1\n"));
  CHECK(contains(graded(first), "\nanna,part-a,correct,correct,1\nbert,part-a,correct,decided,1\n"));
  const std::string other = graded(second);
  CHECK(contains(other, "\nanna,part-a,wrong,"));
  CHECK(contains(other, "\nbert,part-a,invalid,"));
  CHECK(contains(other, "\ncarl,part-c.txt,invalid,unknown_exercise,"));  // which of the two?
  CHECK(run(first, "check part-a 2").exit_code == 0);
  CHECK(contains(run(first, "list").out, "1 of 2"));
  CHECK(contains(run(second, "list").out, "0 of 2"));
}

TEST_CASE("help and errata speak of the paper in the folder") {
  const Rod rod;
  CHECK(contains(rod.run({"emit", "--help"}).out, "$ rederive rod emit --list"));
  CHECK(contains(rod.run({"exercises", "check", "--help"}).out, "$ rederive rod exercises check ID"));
  CHECK(contains(rod.run({"prove", "--help"}).out, "$ rederive rod prove"));
  rod.change("equations.toml", "section = \"Small swings\"\n", "");
  CHECK(contains(rod.run({"errata"}).out, "factor\n"));
  rod.change("equations.toml", "error = \"factor\"\n", "");
  CHECK(contains(rod.run({"errata"}).out, "not as printed\n"));
}

TEST_CASE("derivations that are older than their source are not used") {
  const Rod rod;
  rod.change("derive.cpp", "int main", "// changed\nint main");
  for (const auto& command :
       std::vector<std::vector<std::string>>{{}, {"exercises"}, {"grade", "."}, {"test"}}) {
    const Result refused = rod.run(command);
    CHECK(refused.exit_code == 2);
    CHECK_MESSAGE(contains(refused.err, "run rederive "), refused.err);
  }
}

TEST_CASE("no command that reads what students hand in runs the code of a paper") {
  const Rod rod;
  fs::remove(rod.path / "derive.cpp");
  write_file(rod.path / "derive.py", "open('" + (rod.path / "was-run").string() + "', 'w')\n");
  for (const auto& command : std::vector<std::vector<std::string>>{
           {"exercises"}, {"exercises", "check", "period", "sqrt(g/L)"}, {"grade", "."}})
    CHECK(rod.run(command).exit_code == 2);
  CHECK_FALSE(fs::exists(rod.path / "was-run"));
}

TEST_CASE("a derivation that is no longer there, or fails, is an error of its row alone") {
  const Rod rod;
  rod.change("derivations.json", "\"right\": \"1/3*m*L^2\"", "\"right\": \"1/3*m*Z^2\"");
  const Result ledger = rod.run({"--json"});
  CHECK(ledger.exit_code == 1);
  const Json rows = Json::parse(ledger.out)["equations"];
  CHECK(rows[0]["verdict"] == "error");
  CHECK_MESSAGE(contains(rows[0]["reason"], "Z"), rows[0]["reason"]);
  CHECK(rows[2]["verdict"] == "refuted");
  rod.change("derivations.json", "1/3*m*Z^2", "1/3*m*L^2");
  rod.change("derivations.json", "$x^2$", "$x^Q$");
  CHECK_MESSAGE(contains(Json::parse(rod.run({"--json"}).out)["equations"][0]["reason"], "Q"),
                "mathematics of a step");
}

TEST_CASE("an equation of motion is solved, with its events") {
  const Rod rod;
  const std::vector<std::string> values{"--set", "theta=0.5", "--set", "thetadot=0",
                                        "--set", "g=9.81",    "--set", "L=1"};
  std::vector<std::string> command{"solve", "--until", "2", "--json"};
  command.insert(command.end(), values.begin(), values.end());
  const Json json = Json::parse(rod.run(command).out);
  REQUIRE(json["events"].size() == 2);
  // The first passage is a quarter of the period 4 K(sin(theta_0/2))/omega_0, with K by the
  // arithmetic-geometric mean.
  double a = 1, b = std::cos(0.25);
  for (int k = 0; k < 6; ++k) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double quarter = M_PI / (2 * a) / std::sqrt(1.5 * 9.81);
  CHECK(json["events"][0]["time"].get<double>() == doctest::Approx(quarter).epsilon(1e-11));
  CHECK(json["events"][1]["time"].get<double>() == doctest::Approx(3 * quarter).epsilon(1e-11));
  CHECK(json["difference"].get<double>() < 1e-6);
  for (const auto& wrong : std::vector<std::vector<std::string>>{
           {"--set", "theta=0.5"}, {"--set", "q=1"}, {"--row", "7"}, {"--set", "theta"}, {"--until", "-1"}}) {
    std::vector<std::string> bad{"solve", "--until", "2"};
    bad.insert(bad.end(), wrong.begin(), wrong.end());
    CHECK(rod.run(bad).exit_code == 2);
  }
}

TEST_CASE("a lesson is there in every format, and the site has every page") {
  const Rod rod;
  for (const char* format : {"unicode", "plain", "latex", "markdown", "notebook", "html"}) {
    const Result page = rod.run({"lesson", "1", "--format", format});
    CHECK_MESSAGE(page.exit_code == 0, page.err);
    CHECK(contains(page.out, "hinge"));
  }
  CHECK(contains(rod.run({"lesson"}).out, "A rod on its hinge"));
  CHECK(rod.run({"lesson", "2"}).exit_code == 2);
  const fs::path out = rod.folder.path / "pages";
  CHECK(rod.run({"site", out}).exit_code == 0);
  for (const auto& file : fs::directory_iterator(out)) {
    if (file.path().extension() != ".html") continue;
    const std::string text = read_file(file.path());
    for (std::size_t at = 0; (at = text.find("href=\"", at)) != text.npos;) {  // each link leads to a page
      at += 6;
      const std::string link = text.substr(at, text.find_first_of("\"#", at) - at);
      if (link.empty() || link.starts_with("data:") || link.starts_with("https:")) continue;
      CHECK_MESSAGE(fs::exists(out / link), file.path().string(), " ", link);
    }
    CHECK_FALSE(contains(text, "build/bin"));  // of the built-in paper
  }
}

TEST_CASE("watch judges again what has changed") {
  const Rod rod;
  const Result once = rod.run({"watch", "--once"});
  CHECK(once.exit_code == 0);
  CHECK(contains(once.out, "(3): refuted"));
}
