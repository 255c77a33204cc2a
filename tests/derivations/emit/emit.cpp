// The program `emit`: what it lists and writes, whole or a part, and what is not emitted.
#include <doctest/doctest.h>

#include <derivations/emit/emit.hpp>
#include <tests/block.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::emit;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;

TEST_CASE("the program writes the same bytes every time, to a file or not, whole or a part") {
  for (const std::string target : {"cpp", "c", "python", "javascript", "latex"}) {
    CAPTURE(target);
    const Result once = run_program("emit", {"--target", target});
    CHECK(once.exit_code == 0);
    CHECK(once.out.size() > 1000);
    const TemporaryFolder folder;
    const std::string file = folder.path / "file";
    CHECK(run_program("emit", {"--target", target, "--out", file}).out == "");
    CHECK(read_file(file) == once.out);
  }
  CHECK(run_program("emit", {"--target", "cpp", "--no-sharing"}).out !=
        run_program("emit", {"--target", "cpp"}).out);
  const Result some = run_program("emit", {"--target", "cpp", "--function", "restitution", "--function",
                                           "angular_acceleration_negative"});
  CHECK(some.out.find("T angular_acceleration_negative(") < some.out.find("T restitution("));
  CHECK_FALSE(contains(some.out, "energy"));
}

TEST_CASE("the list says of each function what it needs and where it comes from") {
  const auto document = json_from("emit", {"--list", "--json"});
  const auto list = document.at("functions"), steppers = document.at("steppers");
  const std::string text = run_program("emit", {"--list"}).out;
  const std::vector<EmittedFunction> functions = emitted_functions();
  REQUIRE(list.size() == functions.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    CHECK(list[i].at("name") == functions[i].name);
    CHECK(list[i].at("arguments").size() == functions[i].arguments.size());
    CHECK(list[i].at("shared_operations") <= list[i].at("operations"));
    CHECK(contains(text, functions[i].name + "("));
  }
  REQUIRE(steppers.size() == taylor_steppers().size());
  for (std::size_t i = 0; i < steppers.size(); ++i) {
    const TaylorStepper stepper = taylor_steppers()[i];
    CHECK(steppers[i].at("name") == stepper.name);
    CHECK(steppers[i].at("parameters").size() == stepper.parameters.size());
    CHECK(steppers[i].at("state").size() == stepper.rates.size());
    CHECK(contains(text, stepper.name + "("));
  }
}

TEST_CASE("what is unsound is not emitted") {
  const Symbols& s = emission_symbols();
  const auto emitted = [&](const GiNaC::ex& value) {
    return emit({{"f", {s["theta"], s["p"]}, value, {}, "0", "A trial"}}, Target::cpp);
  };
  CHECK_NOTHROW(emitted(s["theta"] * s["p"]));
  CHECK_THROWS_WITH(emitted(s["theta"] + s["p"]), doctest::Contains("1/s"));
  CHECK_THROWS_WITH(emitted(s["theta"] * s["g"]), doctest::Contains("g, which is not among its arguments"));
  CHECK(contains(emitted(1 / GiNaC::ex(3)), "T /*theta*/"));
}

TEST_CASE("LaTeX closes every brace it opens") {
  const std::string text = emit(emitted_functions(), Target::latex);
  int depth = 0;
  for (const char c : text) {
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    REQUIRE(depth >= 0);
  }
  CHECK(depth == 0);
  CHECK(contains(text, "\\cos\\psi - w \\sin\\psi"));
}
