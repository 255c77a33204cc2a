// What holds for every program: the same bytes twice, help, a version, and a clear refusal of bad input.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <tests/run_program.hpp>

namespace {

std::set<std::string> programs() {
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(REDERIVE_PROGRAMS))
    names.insert(file.path().filename());
  return names;
}

struct Call {
  const char* program;
  std::vector<std::string> arguments;
  const char* names;  ///< what the refusal must mention; "" where the call is good
};

const std::vector<Call> good{
    {"ledger", {}, ""},
    {"ledger", {"show", "50", "--json"}, ""},
    {"ledger", {"prove", "cos(x)^2", "1 - sin(x)^2", "--json"}, ""},
    {"emit", {"--list"}, ""},
    {"emit", {"--target", "cpp"}, ""},
    {"rocking", {"threshold", "--omega", "2.7", "--json"}, ""},
    {"rocking", {"response", "--omega", "2.7", "--amplitude", "1.3", "--json"}, ""},
    {"exercises", {"list"}, ""},
};

const std::vector<Call> bad{
    {"ledger", {"show", "999"}, "999"},
    {"ledger", {"--equations", "/no/such/file.toml"}, "/no/such/file.toml"},
    {"ledger", {"prove", "sin(x", "x"}, "sin(x"},
    {"ledger", {"prove", "x"}, "two statements"},
    {"ledger", {"prove", "2x", "x"}, "2*x"},
    {"emit", {"--target", "cpp", "--out", ""}, "the name of the file is empty"},
    {"ledger", {"frobnicate"}, "frobnicate"},
    {"emit", {"--target", "cobol"}, "cobol"},
    {"emit", {"--target", "cpp", "--function", "no_such"}, "no_such"},
    {"emit", {"--target", "cpp", "--out", "/no/such/folder/file"}, "/no/such/folder/file"},
    {"rocking", {"threshold", "--omega", "nan"}, "nan"},
    {"rocking", {"threshold", "--omega", "-2"}, "-2"},
    {"rocking", {"threshold", "--omega", "2", "--alpha", "7"}, "7"},
    {"rocking", {"threshold", "--omega", "2", "--restitution", "1.5"}, "1.5"},
    {"rocking", {"response", "--omega", "2", "--amplitude", "lots"}, "lots"},
    {"rocking", {"response", "--omega", "2"}, "amplitude"},
    {"rocking",
     {"response", "--omega", "2", "--amplitude", "3", "--csv", "/no/such/folder/file"},
     "/no/such/folder/file"},
    {"exercises", {"check", "no-such-exercise", "x"}, "no-such-exercise"},
    {"lesson-01-the-block-and-its-motion", {"--step", "99"}, "99"},
    {"lesson-01-the-block-and-its-motion", {"--format", "papyrus"}, "papyrus"},
};

std::string command(const Call& call) {
  std::string text = call.program;
  for (const auto& argument : call.arguments) text += " " + argument;
  return text;
}

}  // namespace

TEST_CASE("every program explains itself") {
  for (const std::string& name : programs()) {
    INFO(name);
    const Result help = run_program(name, {"--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.out.size() > 100);
    CHECK(help.err.empty());
    CHECK(run_program(name, {"--version"}).out.starts_with("Rederive "));
    const Result unknown = run_program(name, {"--no-such-flag"});
    CHECK(unknown.exit_code == 2);
    CHECK(unknown.err.find("no-such-flag") != std::string::npos);
    CHECK(unknown.out.empty());
  }
}

TEST_CASE("two runs give the same bytes") {
  for (const Call& call : good) {
    INFO(command(call));
    const Result first = run_program(call.program, call.arguments),
                 second = run_program(call.program, call.arguments);
    CHECK(first.exit_code == 0);
    CHECK(first.out == second.out);
    CHECK(first.err == second.err);
  }
  for (const std::string& name : lesson_programs()) {
    INFO(name);
    CHECK(run_program(name, {}).out == run_program(name, {}).out);
  }
}

TEST_CASE("what asks for JSON gets one JSON document and nothing else") {
  for (const Call& call : good)
    if (call.arguments.size() > 1 && call.arguments.back() == "--json") {
      INFO(command(call));
      CHECK(nlohmann::json::accept(run_program(call.program, call.arguments).out));
    }
}

TEST_CASE("bad input ends with 2, names what was wrong, and says nothing on standard output") {
  for (const Call& call : bad) {
    INFO(command(call));
    const Result r = run_program(call.program, call.arguments);
    CHECK(r.exit_code == 2);
    CHECK_MESSAGE(r.err.find(call.names) != std::string::npos, r.err);
    CHECK(r.out.empty());
  }
}

TEST_CASE("a link stays a link, a pipe stays a pipe, and what is behind them is written") {
  namespace fs = std::filesystem;
  TemporaryFolder folder;
  const fs::path file = folder.path / "file", link = folder.path / "link", pipe = folder.path / "pipe";
  std::ofstream(file) << "old";
  fs::create_symlink("file", link);
  const auto write_to = [](const fs::path& path) {
    return run_program("emit", {"--target", "cpp", "--function", "restitution", "--out", path.string()})
        .exit_code;
  };
  REQUIRE(write_to(link) == 0);
  CHECK(fs::is_symlink(link));
  CHECK(read_file(file) == run_program("emit", {"--target", "cpp", "--function", "restitution"}).out);
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);  // so that the writer need not wait
  REQUIRE(write_to(pipe) == 0);                                  // no more than the pipe holds
  CHECK(fs::is_fifo(pipe));
  std::string text(100, ' ');
  CHECK(::read(reader, text.data(), text.size()) > 0);
  ::close(reader);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 3);
}

TEST_CASE("what cannot be written is not passed over in silence") {
  const auto code = [](const std::string& arguments) {
    const int status = std::system((REDERIVE_PROGRAMS "/" + arguments + " >/dev/full 2>/dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  std::string sum = "x";
  for (int k = 0; k < 900; ++k) sum += "+x";
  for (const std::string& arguments :
       {std::string("ledger prove x x"), std::string("ledger prove --help"),
        "ledger prove --json " + sum + " 1", std::string("emit --target c"),
        std::string("rocking threshold --omega 5"), std::string("ledger --version"),
        std::string("rocking map --omega 1:5:99 --amplitude 1:5:99 --json"),  // more than a buffer holds
        std::string("rocking spectrum --from 1 --to 3 --points 9"), std::string("rocking figure 8"),
        std::string("ledger claims"), std::string("ledger errata"), std::string("ledger graph"),
        std::string("exercises selftest --help"), std::string("exercises show barrier"),
        std::string("lesson-01-the-block-and-its-motion")}) {
    INFO(arguments);
    CHECK(code(arguments) == 2);
  }
}
