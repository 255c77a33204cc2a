#include <fmt/format.h>

#include <derivations/emit/run_emit.hpp>
#include <derivations/language/print.hpp>
#include <derivations/program/command_line.hpp>
#include <nlohmann/json.hpp>

namespace rederive::emit {
using namespace language;
using namespace program;

namespace {

struct Options {
  bool list = false, json = false, no_sharing = false;
  std::string target, out;
  std::vector<std::string> functions;
};

nlohmann::ordered_json described(const SymbolExpression& symbol, const Symbols& symbols) {
  const Symbol& known = *symbols.find(symbol);
  return {{"name", known.name}, {"unit", known.unit}, {"range", known.range}, {"meaning", known.meaning}};
}

nlohmann::ordered_json described(const TaylorStepper& stepper, const Symbols& symbols) {
  nlohmann::ordered_json result{
      {"name", stepper.name}, {"equation", stepper.equation}, {"brief", stepper.brief}};
  for (const SymbolExpression& parameter : stepper.parameters)
    result["parameters"].push_back(described(parameter, symbols));
  for (const auto& [symbol, rate] : stepper.rates) {
    result["state"].push_back(described(symbol, symbols));
    result["state"].back()["rate"] = print(rate, Notation::plain, symbols);
  }
  return result;
}

nlohmann::ordered_json described(const EmittedFunction& function, const Symbols& symbols) {
  const Provenance facts = provenance(function, symbols);
  nlohmann::ordered_json arguments = nlohmann::ordered_json::array(),
                         derivatives = nlohmann::ordered_json::array();
  for (const SymbolExpression& argument : function.arguments)
    arguments.push_back(described(argument, symbols));
  for (const SymbolExpression& derivative : function.derivatives) derivatives.push_back(name_of(derivative));
  return {{"name", function.name},
          {"arguments", arguments},
          {"derivatives", derivatives},
          {"unit", facts.unit},
          {"equation", function.equation},
          {"brief", function.brief},
          {"operations", facts.operations},
          {"shared_operations", facts.shared_operations},
          {"hash", facts.hash}};
}

std::string names_of(const std::vector<SymbolExpression>& symbols) {
  std::string text;
  for (const SymbolExpression& symbol : symbols) text += (text.empty() ? "" : ", ") + name_of(symbol);
  return text;
}

std::string listed(const Emission& all, bool json) {
  nlohmann::ordered_json functions = nlohmann::ordered_json::array(),
                         steppers = nlohmann::ordered_json::array();
  std::string text;
  for (const EmittedFunction& function : all.functions) {
    text += fmt::format("{}({})\n    ({})  {}\n", function.name, names_of(function.arguments),
                        function.equation, function.brief);
    functions.push_back(described(function, all.symbols));
  }
  for (const TaylorStepper& stepper : all.steppers) {
    text += fmt::format("{}({})\n    ({})  Taylor stepper, cpp and javascript: {}\n", stepper.name,
                        names_of(stepper.parameters), stepper.equation, stepper.brief);
    steppers.push_back(described(stepper, all.symbols));
  }
  return json ? nlohmann::ordered_json{{"functions", functions}, {"steppers", steppers}}.dump(2) + "\n"
              : text;
}

std::vector<std::string> names_of_targets() {
  std::vector<std::string> names;
  for (const auto& [name, target] : targets()) names.push_back(name);
  return names;
}

int run(const Options& options, const std::function<Emission()>& emission) {
  if (!options.list && options.target.empty())
    throw BadInput("nothing to write: give a language, such as --target cpp, or --list");
  if (options.json && !options.list) throw BadInput("--json needs --list");
  const Target target = options.list ? Target::cpp : targets().at(options.target);  // cpp has all there is
  const Emission all = chosen_from(emission(), options.functions, target);
  const std::string text = options.list ? listed(all, options.json) : emit(all, target, !options.no_sharing);
  if (options.out.empty()) {
    std::fputs(text.c_str(), stdout);
  } else {
    write_whole(options.out, text);
  }
  return as_expected;
}

}  // namespace

int run_emit(const std::function<Emission()>& emission, int argc, char** argv) {
  CLI::App app{
      "Writes the derived functions as source code, with common subexpressions shared. In C++ and JavaScript "
      "it also\nwrites the steppers that integrate the motion by its Taylor series."};
  app.footer(
      "Examples:\n"
      "  $ PROGRAM --list\n"
      "  $ PROGRAM --target python --function NAME\n"
      "  $ PROGRAM --target cpp --out functions.hpp\n\n");
  Options options;
  app.add_flag("--list", options.list, "List the functions with their arguments and equations.");
  app.add_flag("--json", options.json, "With --list, write one JSON document.");
  app.add_option("--target", options.target, "Choose the language to write. Required unless --list is given.")
      ->check(CLI::IsMember(names_of_targets()));
  app.add_option("--function", options.functions,
                 "Write only this function. May be given several times. Default: all functions.")
      ->allow_extra_args(false)
      ->option_text("NAME");
  app.add_flag("--no-sharing", options.no_sharing,
               "Compute every subexpression where it is used, without sharing.");
  app.add_option("--out", options.out, "Write to this file. Default: standard output.")
      ->option_text("FILE")
      ->check(file_name);
  return run_command(app, argc, argv, [&] { return run(options, emission); });
}

}  // namespace rederive::emit
