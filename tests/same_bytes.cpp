// The same input gives the same bytes on every run, wherever the system puts the program in memory.
#include <doctest/doctest.h>

#include <map>
#include <tests/run_program.hpp>

namespace {

struct Statement {
  const char *left, *right, *assumption;
};

std::string answer(const Statement& s) {
  std::vector<std::string> arguments{"prove", "--json"};
  if (*s.assumption != '\0') arguments.insert(arguments.end(), {"--assume", s.assumption});
  arguments.insert(arguments.end(), {"--", s.left, s.right});
  return run_program("ledger", arguments).out;
}

namespace fs = std::filesystem;

/// All that is written for others to read or to build, by the programs in `bin`, each text by its name.
std::map<std::string, std::string> written_by(const fs::path& bin, const fs::path& folder) {
  std::string script =
      "cd " + quoted(folder) + " && export PATH=" + quoted(bin) +
      ":$PATH && ledger certify coq >said && ledger --json >ledger.json && ledger graph >graph"
      " && ledger mutate 21a --json >mutants.json";
  for (const char* target : {"cpp", "c", "python", "javascript", "latex"})
    script += std::string(" && emit --target ") + target + " --out emitted." + target;
  for (const char* format : {"text", "markdown", "latex", "json"})
    script += std::string(" && ledger errata --format ") + format + " >errata." + format;
  for (const char* format : {"unicode", "latex", "markdown", "notebook", "html"})
    script += std::string(" && lesson-05-the-impact --format ") + format + " --out lesson." + format;
  script +=
      " && exercises --progress progress list >exercises && TZ=Asia/Tokyo rocking response --omega 3 "
      "--amplitude 1.41 --plot figure.pdf";
  const Result run = run_program("/bin/bash", {"-c", script});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  std::map<std::string, std::string> texts;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    if (file.is_regular_file()) texts[fs::relative(file.path(), folder)] = read_file(file.path());
  return texts;
}

}  // namespace

TEST_CASE("answers are the same on every run") {
  for (const Statement& s : {Statement{"tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", ""},
                             {"sin(x+pi/3)", "sin(x)/2+sqrt(3)/2*cos(x)", ""},
                             {"log(x*y)", "log(x)+log(y)", "0 < x < y"},
                             {"b-w = h", "sqrt(1/(b-w)) = sqrt(1/(h))", ""},
                             {"fabs(V-tan(alpha)^2)", "fabs(V-2*(1-e)/(1+2*e))", "e = 1-3/2*sin(alpha)^2"}}) {
    INFO(s.left << " | " << s.right);
    const std::string first = answer(s);
    REQUIRE(first.find("verdict") != std::string::npos);
    for (int run = 0; run < 7; ++run) CHECK(answer(s) == first);
  }
}

TEST_CASE(
    "programs in another folder, under another environment, write the same bytes, and no path of ours") {
  const TemporaryFolder here, there, moved;
  const fs::path build = fs::path(REDERIVE_PROGRAMS).parent_path(),
                 other = moved.path / "a folder/of another/length";
  fs::create_directories(other / "bin");
  for (const char* program : {"emit", "ledger", "exercises", "rocking"})
    fs::copy(build / "bin" / program, other / "bin");
  for (const std::string& lesson : lesson_programs()) fs::copy(build / "bin" / lesson, other / "bin");
  for (const char* more : {"share", "python"})  // notebooks call the module where it is beside the programs
    if (fs::exists(build / more)) fs::copy(build / more, other / more, fs::copy_options::recursive);
  const auto first = written_by(build / "bin", here.path);
  ::setenv("ANOTHER_ENVIRONMENT", std::string(100'000, 'x').c_str(), 1);  // moves the stack
  const auto second = written_by(other / "bin", there.path);
  ::unsetenv("ANOTHER_ENVIRONMENT");
  CHECK(first.size() == second.size());
  CHECK(first.size() > 30);
  for (const auto& [its_name, text] : first) {
    const auto& name = its_name;
    CHECK_MESSAGE(second.at(name) == text, name);
    for (const auto& path : {build.string(), std::string(REDERIVE_SOURCE), here.path.string()})
      CHECK_MESSAGE(text.find(path) == std::string::npos, name, " names ", path);
  }
  CHECK(first.at("emitted.cpp") == read_file(build / "emitted/rocking_block.hpp"));
}

TEST_CASE("programs are hardened, and twenty runs at random addresses write the same bytes") {
  const fs::path bin = REDERIVE_PROGRAMS;
  for (const std::string program : {"emit", "ledger", "exercises", "rocking"}) {
    INFO(program);
    const std::string head = run_program("/usr/bin/readelf", {"-h", "-l", "-d", "-W", bin / program}).out;
    for (const char* property :
         {"DYN (Position-Independent Executable file)", "GNU_RELRO", "BIND_NOW", "PIE"})
      CHECK_MESSAGE(head.find(property) != std::string::npos, property);
    const std::string imports = run_program("/usr/bin/readelf", {"--dyn-syms", "-W", bin / program}).out;
    if (std::string(REDERIVE_BUILD_TYPE).starts_with("Rel"))
      for (const char* import : {"__stack_chk_fail", "_chk@"})
        CHECK_MESSAGE(imports.find(import) != std::string::npos, import);
  }
  std::map<std::string, std::string> first;
  for (int run = 0; run < 20; ++run) {
    const TemporaryFolder folder;
    std::string script =
        "cd " + quoted(folder.path) + " && export PATH=" + quoted(bin) +
        ":$PATH && ledger --json >ledger && ledger certify coq 13 50 88 >said"
        " && ledger mutate 13 --json >mutants && rocking threshold --omega 3 --json >threshold"
        " && (exercises --progress progress check restitution 'sin(alpha)' >answer; [ $? = 1 ])";
    for (const char* target : {"cpp", "c", "python", "javascript", "latex"})
      script += std::string(" && emit --target ") + target + " --out emitted." + target;
    const Result made = run_program("/bin/bash", {"-c", script});
    REQUIRE_MESSAGE(made.exit_code == 0, made.err);
    fs::remove(folder.path / "progress");  // it tells the time
    std::map<std::string, std::string> texts;
    for (const auto& file : fs::recursive_directory_iterator(folder.path))
      if (file.is_regular_file()) texts[fs::relative(file.path(), folder.path)] = read_file(file.path());
    REQUIRE(texts.size() > 9);
    if (run == 0) first = texts;
    CHECK(texts == first);
  }
}
