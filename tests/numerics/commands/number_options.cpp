// Every number option of rocking, as --help lists them, refuses what is no number.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <tests/run_program.hpp>

namespace {

using Arguments = std::vector<std::string>;

/// A good call of each subcommand.
const std::map<std::string, Arguments> calls{{"threshold", {"--omega", "2"}},
                                             {"response", {"--omega", "2", "--amplitude", "1.6"}},
                                             {"spectrum", {"--from", "1", "--to", "2", "--points", "2"}},
                                             {"map", {"--omega", "1:2:2", "--amplitude", "1:2:2"}},
                                             {"fragility", {"--amplitudes", "1:2:2"}},
                                             {"figure", {"16"}}};

/// The options that take a number, from the lines "--omega W …" of --help; a span A:B:N takes three.
std::map<std::string, std::string> number_options(const std::string& subcommand) {
  static const std::regex line(R"(\n  (--[a-z0-9-]+) ([A-Z][A-Z0-9:|a-z]*)[ :])");
  const std::string help = run_program("rocking", {subcommand, "--help"}).out;
  std::map<std::string, std::string> found;
  for (std::sregex_iterator at(help.begin(), help.end(), line), end; at != end; ++at)
    if ((*at)[2] != "FILE" && !(*at)[2].str().starts_with("NAME")) found[(*at)[1]] = (*at)[2];
  return found;
}

/// The good call with this value, and what the option needs beside it.
Arguments call_with(const std::string& subcommand, const std::string& option, const std::string& value,
                    const std::string& record) {
  Arguments call = calls.at(subcommand);
  const auto at = std::find(call.begin(), call.end(), option);
  if (at != call.end())
    *(at + 1) = value;
  else
    call.insert(call.end(), {option, value});
  if (option == "--half-width") call.insert(call.end(), {"--half-height", "1"});
  if (option == "--half-height") call.insert(call.end(), {"--half-width", "0.2"});
  if (subcommand == "fragility")
    call.insert(call.end(), {"--records", std::filesystem::path(record).parent_path()});
  else if (option == "--step" || option == "--scale")
    call.insert(call.end(), {"--record", record});
  call.insert(call.begin(), subcommand);
  return call;
}

}  // namespace

TEST_CASE("every number option refuses what is no finite number, by its name") {
  const TemporaryFolder folder;
  const std::string record = folder.path / "record.txt";
  std::ofstream(record) << "0 0\n1 0.1\n2 0\n";
  int options = 0;
  for (const auto& [its_subcommand, good] : calls)
    for (const auto& [its_option, type] : number_options(its_subcommand)) {
      const auto& subcommand = its_subcommand;
      const auto& option = its_option;
      ++options;
      for (std::string value : {"nan", "inf", "-inf", "1e400", "", "1x", "0,5", "0x10", "+-1", " ", "--"}) {
        if (type.find(':') != std::string::npos) value = "1:" + value + ":2";
        const Result result = run_program("rocking", call_with(subcommand, option, value, record));
        CAPTURE(subcommand);
        CAPTURE(value);
        CAPTURE(result.err);
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK_MESSAGE(result.err.find(option.substr(2)) != std::string::npos, option);
      }
    }
  CHECK(options > 40);  // seven of the block in four subcommands, and their own
}

TEST_CASE("what lies outside of its range, and an option without its value, is refused by its name") {
  const auto refused = [](const std::string& option, const Arguments& beside) {
    Arguments call{"response", "--omega", "2", "--amplitude", "1.6", option};
    call.insert(call.end(), beside.begin(), beside.end());
    const Result result = run_program("rocking", call);
    const std::string name = option.substr(0, option.find('='));
    CHECK_MESSAGE(result.exit_code == 2, option);
    CHECK_MESSAGE(result.err.find(name) != std::string::npos, option, ": ", result.err);
  };
  for (const char* option :
       {"--alpha=-1", "--alpha=2", "--frequency-parameter=0", "--restitution=0", "--restitution=2",
        "--theta0=1e308", "--thetadot0=1e308", "--until=-1", "--alpha=", "--theta0=", "--csv="})
    refused(option, {});
  refused("--half-width=-1", {"--half-height", "1"});
  refused("--half-height=1e308", {"--half-width", "1e-300"});
}

TEST_CASE("--digits rounds to so many figures, with its carry") {
  // Of least amplitudes 1.96339131732 and 4.77863…, edges 5.81884337303 and 9.97028931087, and a
  // root 16.4340847056.
  const auto threshold = [](const std::string& omega, const std::string& digits, const std::string& model) {
    const Result result = run_program(
        "rocking", {"threshold", "--omega", omega, "--digits", digits, "--model", model, "--json"});
    REQUIRE_MESSAGE(result.exit_code == 0, result.err);
    return nlohmann::json::parse(result.out);
  };
  struct Case {
    const char *omega, *digits, *least, *last;  // window
  };
  for (const Case& c : {Case{"4.2", "1", "2", "6"},
                        {"4.2", "2", "2.0", "5.8"},
                        {"4.2", "3", "1.96", "5.82"},
                        {"6.02", "1", "5", "1e+01"},
                        {"6.02", "2", "4.8", "10"},
                        {"6.02", "3", "4.78", "9.97"}}) {
    CAPTURE(c.omega);
    CAPTURE(c.digits);
    const auto document = threshold(c.omega, c.digits, "nonlinear");
    CHECK(document["minimum"]["amplitude"] == c.least);
    CHECK(document["windows"].back()["from"] == c.last);
  }
  const auto forms = threshold("8.5", "1", "linear")["closed_forms"];
  CHECK(forms[0]["amplitude"] == "2e+01");
  CHECK(threshold("8.5", "3", "linear")["closed_forms"][0]["amplitude"] == "16.4");
  for (const char* omega : {"2", "3", "6.3"}) {
    const auto exact = threshold(omega, "17", "linear")["closed_forms"];
    for (const int digits : {1, 2, 5}) {
      const auto rounded = threshold(omega, std::to_string(digits), "linear")["closed_forms"];
      for (std::size_t i = 0; i < exact.size(); ++i)
        for (const char* name : {"amplitude", "psi"}) {
          const double value = std::stod(exact[i][name].get<std::string>());
          CHECK(std::stod(rounded[i][name].get<std::string>()) ==
                std::stod(fmt::format("{:.{}e}", value, digits - 1)));
        }
    }
  }
}

TEST_CASE("the other programs refuse what is no number, too") {
  const TemporaryFolder folder;
  for (const std::string value :
       {"nan", "inf", "1e400", "", "1x", "0,5", "-1", "0x10", "010", " 5", "5 ", "+5"})
    for (Arguments call :
         {Arguments{"exercises", "grade", folder.path, "--workers"},
          Arguments{"exercises", "serve", "--port"}, Arguments{lesson_programs().at(0), "--step"},
          Arguments{"ledger", "mutate", "71", "--seed"},
          Arguments{"ledger", "prove", "sin(x)", "x", "--small", "x", "--order"}}) {
      const std::string program = call.front(), option = call.back();
      call.erase(call.begin());
      call.push_back(value);
      const Result result = run_program(program, call);
      CAPTURE(value);
      CAPTURE(result.err);
      CHECK(result.exit_code == 2);
      CHECK_MESSAGE(result.err.find(option.substr(2)) != std::string::npos, option);
    }
}
