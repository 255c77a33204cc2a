#include <fmt/format.h>

#include <algorithm>
#include <derivations/language/lexer.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/derivation_file.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/paper/steps.hpp>
#include <derivations/program/program.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rederive::paper {
using namespace language;
using namespace mechanics;
using namespace program;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t largest_file = 20'000'000;  // bytes

GiNaC::ex expression(const std::string& text, const Symbols& symbols) {
  try {
    return lower(parse(text, symbols), symbols);
  } catch (const SyntaxError& error) {
    throw std::runtime_error(explain(error, text, symbols));
  }
}

/// Refuses words in which the text between two $ is not mathematics.
void check_mathematics(const std::string& words, const Symbols& symbols) {
  for (std::size_t begin = 0; (begin = words.find('$', begin)) != words.npos;) {
    const std::size_t end = words.find('$', begin + 1);
    if (end == words.npos) throw std::runtime_error("a $ of the step '" + words + "' has no second one");
    const std::string text = words.substr(begin + 1, end - begin - 1);
    try {
      (void)parse_statement(text, symbols);
    } catch (const SyntaxError& error) {
      throw std::runtime_error("the step '" + words + "': " + explain(error, text, symbols));
    }
    begin = end + 1;
  }
}

Step step_in(const Json& json, const Symbols& symbols) {
  const std::string says = json.at("says");
  check_mathematics(says, symbols);
  if (json.contains("cites")) return from(json.at("cites").get<std::string>(), says);
  if (!json.contains("left")) return in_words(says);
  return {says, expression(json.at("left"), symbols), expression(json.at("right"), symbols),
          json.value("relation", "=")};
}

Derivation derivation_in(const Json& json, const Symbols& symbols) {
  if (json.contains("error")) throw std::runtime_error(json.at("error").get<std::string>());
  std::vector<Step> steps;
  for (const Json& step : json.at("steps")) steps.push_back(step_in(step, symbols));
  std::vector<Given> given;
  for (const Json& pair : json.value("given", Json::array()))
    given.push_back({expression(pair.at(0), symbols), expression(pair.at(1), symbols)});
  Derivation result = derived(expression(json.at("left"), symbols), expression(json.at("right"), symbols),
                              std::move(steps), std::move(given), json.value("relation", "="));
  result.assumption = json.value("assumption", "");
  result.order = json.value("order", 0);
  result.small = json.value("small", "");
  result.is_stated = json.value("stated", false);
  return result;
}

/// Returns whether the paper declares all symbols. The tools of mechanics name constants of their own.
bool are_declared(const GiNaC::ex& e, const Symbols& symbols) {
  return std::all_of(e.preorder_begin(), e.preorder_end(), [&](const GiNaC::ex& part) {
    return !GiNaC::is_a<GiNaC::symbol>(part) ||
           symbols.find(GiNaC::ex_to<GiNaC::symbol>(part).get_name()) != nullptr;
  });
}

Json json_of(const Step& step, const Symbols& symbols) {
  const auto text = [&](const GiNaC::ex& value) { return print(value, Notation::plain, symbols); };
  if (!step.cites.empty()) {
    std::string says = step.says;  // without the number, for which reading finds the place again
    const std::string number = "(" + step.cites + ")";
    if (const std::size_t place = says.find(number); place != says.npos)
      says.replace(place, number.size(), "#");
    return {{"says", says}, {"cites", step.cites}};
  }
  if (step.left.is_zero() && step.right.is_zero()) return {{"says", step.says}};
  if (!are_declared(step.left, symbols) || !are_declared(step.right, symbols))
    return {{"says", step.says + " " + print(step.left, Notation::unicode, symbols) + " " + step.relation +
                         " " + print(step.right, Notation::unicode, symbols)}};
  return {{"says", step.says},
          {"left", text(step.left)},
          {"relation", step.relation},
          {"right", text(step.right)}};
}

Json json_of(const Derivation& derivation, const Symbols& symbols) {
  const auto text = [&](const GiNaC::ex& value) { return print(value, Notation::plain, symbols); };
  Json steps = Json::array(), given = Json::array();
  // the last step is the conclusion, which reading adds again
  for (std::size_t k = 0; k + 1 < derivation.steps.size(); ++k)
    steps.push_back(json_of(derivation.steps[k], symbols));
  for (const Given& one : derivation.given) given.push_back({text(one.name), text(one.value)});
  return {{"left", text(derivation.left)},
          {"relation", derivation.relation},
          {"right", text(derivation.right)},
          {"steps", steps},
          {"given", given},
          {"assumption", derivation.assumption},
          {"order", derivation.order},
          {"small", derivation.small},
          {"stated", derivation.steps.size() < 2}};
}

}  // namespace

Derivations read_derivations(const std::filesystem::path& file, const Symbols& symbols) {
  const auto fail = [&](const std::string& what) -> BadInput {
    return BadInput(printable_name(file) + ": " + what + "; write it again with python3 -m rederive.derive");
  };
  Derivations rows;
  const Json json =
      Json::parse(read_whole(file, {.most = largest_file}), nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded() || !json.is_object() || !json.contains("derivations") ||
      !json["derivations"].is_object())
    throw fail("this is not a file of derivations");
  if (json.value("format", 0) != 1) throw fail("the format of this file is not 1");
  for (const auto& [id, entry] : json["derivations"].items())
    rows.add(id, [id = id, entry = entry, symbols] {
      try {
        return derivation_in(entry, symbols);
      } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error(std::string("derivations.json: ") + error.what());
      }
    });
  return rows;
}

std::string derivations_text(const Derivations& rows, const Symbols& symbols, const std::string& digest) {
  Json all = Json::object();
  for (const std::string& id : rows.ids()) {
    try {
      all[id] = json_of(rows.at(id), symbols);
    } catch (const std::exception& error) {
      all[id] = {{"error", error.what()}};
    }
  }
  return Json{{"format", 1}, {"digest", digest}, {"derivations", all}}.dump(1) + "\n";
}

std::string digest_in(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const Json json =
      Json::parse(read_whole(file, {.most = largest_file}), nullptr, /*allow_exceptions=*/false);
  return json.is_object() && json.contains("digest") && json["digest"].is_string() ? json["digest"] : "";
}

}  // namespace rederive::paper
