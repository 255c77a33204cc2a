// emit: the derived results as source code.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <derivations/emit/emit.hpp>
#include <map>
#include <nlohmann/json.hpp>

using namespace rederive;

namespace {

struct Options {
  bool list = false, json = false, no_sharing = false;
  std::string target, out;
  std::vector<std::string> functions;
};

std::string name_of(const SymbolExpression& symbol) { return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name(); }

/// The functions asked for, in the order of the list; all if none is named.
std::vector<EmittedFunction> chosen(const std::vector<std::string>& names) {
  std::vector<EmittedFunction> all = emitted_functions();
  if (names.empty()) return all;
  for (const std::string& name : names) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
    if (!known) throw BadInput("there is no function '" + name + "'; 'emit --list' shows all of them");
  }
  std::erase_if(all,
                [&](const auto& f) { return std::find(names.begin(), names.end(), f.name) == names.end(); });
  return all;
}

nlohmann::ordered_json described(const EmittedFunction& function) {
  const Provenance facts = provenance(function);
  nlohmann::ordered_json arguments = nlohmann::ordered_json::array(),
                         derivatives = nlohmann::ordered_json::array();
  for (const SymbolExpression& argument : function.arguments) {
    const Symbol& symbol = *emission_symbols().find(name_of(argument));
    arguments.push_back(
        {{"name", symbol.name}, {"unit", symbol.unit}, {"range", symbol.range}, {"meaning", symbol.meaning}});
  }
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

std::string listed(const std::vector<EmittedFunction>& functions, bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text;
  for (const EmittedFunction& function : functions) {
    std::string arguments;
    for (const SymbolExpression& argument : function.arguments) {
      arguments += (arguments.empty() ? "" : ", ") + name_of(argument);
    }
    text +=
        fmt::format("{}({})\n    ({})  {}\n", function.name, arguments, function.equation, function.brief);
    list.push_back(described(function));
  }
  return json ? nlohmann::ordered_json{{"functions", list}}.dump(2) + "\n" : text;
}

int run(const Options& options) {
  static const std::map<std::string, Target> targets = {{"cpp", Target::cpp},
                                                        {"c", Target::c},
                                                        {"python", Target::python},
                                                        {"javascript", Target::javascript},
                                                        {"latex", Target::latex}};
  if (!options.list && options.target.empty()) throw BadInput("say what to write: --target cpp, or --list");
  if (options.json && !options.list) throw BadInput("--json goes with --list");
  const auto functions = chosen(options.functions);
  const std::string text = options.list ? listed(functions, options.json)
                                        : emit(functions, targets.at(options.target), !options.no_sharing);
  if (options.out.empty()) {
    std::fputs(text.c_str(), stdout);
  } else {
    write_whole(options.out, text);
  }
  return as_expected;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes the derived functions as source code, common subexpressions shared."};
  Options options;
  app.add_flag("--list", options.list, "show the functions with their arguments and equations");
  app.add_flag("--json", options.json, "with --list: one JSON document");
  app.add_option("--target", options.target, "the language to write")
      ->check(CLI::IsMember({"cpp", "c", "python", "javascript", "latex"}));
  app.add_option("--function", options.functions, "only this function; may be given several times")
      ->allow_extra_args(false)
      ->option_text("NAME");
  app.add_flag("--no-sharing", options.no_sharing, "compute every subexpression where it is used");
  app.add_option("--out", options.out, "write to this file instead of standard output")->check(file_name);
  return run_command(app, argc, argv, [&] { return run(options); });
}
