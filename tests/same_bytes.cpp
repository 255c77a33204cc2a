// The same input gives the same bytes on every run, wherever the system puts the program in memory.
#include <doctest/doctest.h>

#include <map>
#include <tests/run_program.hpp>

namespace {

namespace fs = std::filesystem;

/// Runs a script, and `emit` for every language, with the programs in `bin`; returns each file that they
/// write, by its name.
std::map<std::string, std::string> written_by(const fs::path& bin, const std::string& calls) {
  const TemporaryFolder folder;
  std::string script = "cd " + quoted(folder.path) + " && export PATH=" + quoted(bin) + ":$PATH && " + calls;
  for (const char* target : {"cpp", "c", "python", "javascript", "latex"})
    script += std::string(" && emit --target ") + target + " --out emitted." + target;
  const Result run = run_program("/bin/bash", {"-c", script});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  fs::remove(folder.path / "progress");  // it tells the time
  std::map<std::string, std::string> texts;
  for (const auto& file : fs::recursive_directory_iterator(folder.path))
    if (file.is_regular_file()) {
      const std::string name = fs::relative(file.path(), folder.path);
      texts[name] = read_file(file.path());
      CHECK_MESSAGE(!contains(texts[name], folder.path), name, " names its folder");
    }
  return texts;
}

/// Returns calls that write all that others read or build.
std::string all_calls() {
  std::string script =
      "ledger certify coq >said && ledger --json >ledger.json && ledger graph >graph"
      " && ledger mutate 21a --json >mutants.json";
  for (const char* format : {"text", "markdown", "latex", "json"})
    script += std::string(" && ledger errata --format ") + format + " >errata." + format;
  for (const char* format : {"unicode", "latex", "markdown", "notebook", "html"})
    script += std::string(" && lesson-05-the-impact --format ") + format + " --out lesson." + format;
  return script +
         " && exercises --progress progress list >exercises && TZ=Asia/Tokyo rocking response --omega 3 "
         "--amplitude 1.41 --plot figure.pdf";
}

}  // namespace

TEST_CASE(
    "programs in another folder, under another environment, write the same bytes, and no path of ours") {
  const TemporaryFolder moved;
  const fs::path build = fs::path(REDERIVE_PROGRAMS).parent_path(),
                 other = moved.path / "a folder/of another/length";
  fs::create_directories(other / "bin");
  for (const char* program : {"emit", "ledger", "exercises", "rocking"})
    fs::copy(build / "bin" / program, other / "bin");
  for (const std::string& lesson : lesson_programs()) fs::copy(build / "bin" / lesson, other / "bin");
  for (const char* more : {"share", "python"})  // notebooks call the module where it is beside the programs
    if (fs::exists(build / more))
      fs::copy(build / more, other / more, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  const auto first = written_by(build / "bin", all_calls());
  ::setenv("ANOTHER_ENVIRONMENT", std::string(100'000, 'x').c_str(), 1);  // moves the stack
  const auto second = written_by(other / "bin", all_calls());
  ::unsetenv("ANOTHER_ENVIRONMENT");
  CHECK(first.size() == second.size());
  CHECK(first.size() > 30);
  for (const auto& [its_name, text] : first) {
    const auto& name = its_name;
    CHECK_MESSAGE(second.at(name) == text, name);
    for (const auto& path : {build.string(), std::string(REDERIVE_SOURCE)})
      CHECK_MESSAGE(text.find(path) == std::string::npos, name, " names ", path);
  }
  CHECK(first.at("emitted.cpp") == read_file(build / "emitted/rocking_block.hpp"));
}

TEST_CASE("programs are hardened") {
  const fs::path bin = REDERIVE_PROGRAMS;
  for (const std::string program : {"emit", "ledger", "exercises", "rocking"}) {
    INFO(program);
    const std::string head = run_program("/usr/bin/readelf", {"-h", "-l", "-d", "-W", bin / program}).out;
    for (const char* property :
         {"DYN (Position-Independent Executable file)", "GNU_RELRO", "BIND_NOW", "PIE"})
      CHECK_MESSAGE(contains(head, property), property);
    const std::string imports = run_program("/usr/bin/readelf", {"--dyn-syms", "-W", bin / program}).out;
    if (std::string(REDERIVE_BUILD_TYPE).starts_with("Rel"))
      for (const char* import : {"__stack_chk_fail", "_chk@"})
        CHECK_MESSAGE(contains(imports, import), import);
  }
}

TEST_CASE("six runs at random addresses write the same bytes") {
  std::string calls =
      "ledger --json >ledger && ledger certify coq 13 50 88 >said && ledger mutate 13 --json >mutants"
      " && rocking threshold --omega 3 --json >threshold"
      " && (exercises --progress progress check restitution 'sin(alpha)' >answer; [ $? = 1 ])";
  for (const char* statement :
       {"'tan(x+y)' '(tan(x)+tan(y))/(1-tan(x)*tan(y))'", "'sin(x+pi/3)' 'sin(x)/2+sqrt(3)/2*cos(x)'",
        "--assume '0 < x < y' 'log(x*y)' 'log(x)+log(y)'", "'b-w = h' 'sqrt(1/(b-w)) = sqrt(1/(h))'",
        "--assume 'e = 1-3/2*sin(alpha)^2' 'fabs(V-tan(alpha)^2)' 'fabs(V-2*(1-e)/(1+2*e))'"})
    calls += std::string(" && (ledger prove --json ") + statement + " >>proofs; [ $? != 2 ])";
  const auto first = written_by(REDERIVE_PROGRAMS, calls);
  REQUIRE(first.size() > 10);
  for (int run = 1; run < 6; ++run) CHECK(written_by(REDERIVE_PROGRAMS, calls) == first);
}
