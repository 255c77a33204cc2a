#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <derivations/decide/problem.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/variants.hpp>
#include <lessons/page/prose.hpp>
#include <regex>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;

std::size_t picked(const std::string& seed, const std::string& list, std::size_t count) {
  if (seed.empty()) return 0;
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const unsigned char c : seed + '\0' + list) hash = (hash ^ c) * 0x100000001b3;
  return static_cast<std::size_t>((hash ^ hash >> 32) % count);
}

std::vector<std::string> values_of(const std::string& text) {
  static const std::regex range(R"((\d{1,9}\.?\d{0,9}):(\d{1,9}\.?\d{0,9}):(\d{1,9}\.?(\d{0,9})))");
  std::smatch found;
  if (!std::regex_match(text, found, range)) return {text};
  const double from = std::stod(found[1]), to = std::stod(found[2]), step = std::stod(found[3]);
  if (!(step > 0 && from <= to && (to - from) / step < 1000))
    throw std::runtime_error("'" + text + "' must be FROM:TO:STEP, with at most 1000 values");
  std::vector<std::string> values;
  for (int k = 0; from + k * step < to + step / 2; ++k)
    values.push_back(fmt::format("{:.{}f}", from + k * step, found[4].length()));
  return values;
}

namespace {

std::string without_brace(const std::string& text) {
  if (text.find('}') != std::string::npos)
    throw std::runtime_error("a closing brace has no opening brace: " + text);
  return text;
}

/// Returns all choices of one list of `vary`: texts, or names that go together; a range gives its values.
std::vector<Choice> cases_of(TomlTable& vary, const std::string& key) {
  std::vector<Choice> cases;
  for (const Choice& item : vary.alternatives(key)) {
    std::vector<Choice> expanded(1);
    for (const auto& [name, text] : item) {
      if (text.find_first_of("{}") != std::string::npos)
        throw std::runtime_error("'" + text + "' must be a text without braces");
      const std::vector<std::string> values = values_of(text);
      if (values.size() > 1 && expanded.size() > 1)
        throw std::runtime_error("only one name of a table can have a range");
      if (values.size() > 1) expanded.resize(values.size(), expanded[0]);
      for (std::size_t k = 0; k < expanded.size(); ++k) expanded[k][name] = values[k % values.size()];
    }
    cases.insert(cases.end(), expanded.begin(), expanded.end());
  }
  if (cases.empty()) throw std::runtime_error("the list is empty");
  const auto names = [](const Choice& one) {
    return joined(one, ", ", [](const auto& entry) { return entry.first; });
  };
  for (const Choice& one : cases)
    if (names(one) != names(cases.front()))
      throw std::runtime_error(
          fmt::format("all tables of a list must have the same names; one has {}, one {}",
                      names(cases.front()), names(one)));
  return cases;
}

/// Returns the value of a formula to ten digits, with the choice for its names.
std::string value_of(const std::string& formula, const Choice& choice, const Symbols& symbols) {
  Tree tree = parse(formula, symbols);
  for (const auto& name : names_of(tree)) {
    const auto found = choice.find(name);
    if (found == choice.end()) throw std::runtime_error("{" + formula + "}: '" + name + "' does not vary");
    const Tree value = parse(found->second, symbols);
    if (!names_of(value).empty())
      throw std::runtime_error(
          fmt::format("{{{}}}: '{}' is '{}' here, which is not a number", formula, name, found->second));
    tree = language::put_in(tree, name, value);
  }
  const Value value = value_at(tree, {}, 90);
  const double number = value.is == Value::Is::certain ? value.ball().to_double() : NAN;
  if (!std::isfinite(number))
    throw std::runtime_error("{" + formula + "} has no value here, or its value is too large");
  return fmt::format("{:.10g}", number);
}

}  // namespace

Choice chosen(TomlTable& exercise, const std::string& id, const std::string& seed) {
  Choice choice;
  std::optional<TomlTable> vary = exercise.table("vary");
  if (!vary) return choice;
  for (const std::string& key : vary->keys()) try {
      const std::vector<Choice> cases = cases_of(*vary, key);
      for (const auto& [name, text] : cases[picked(seed, id + "/" + key, cases.size())])
        if (!choice.emplace(name, text).second)
          throw std::runtime_error("another list also has the name '" + name + "'");
    } catch (const BadInput&) {
      throw;
    } catch (const std::runtime_error& error) {
      vary->fail(fmt::format("'{}' in 'vary': {}", key, error.what()), key);
    }
  return choice;
}

std::string filled(const std::string& text, const Choice& choice, const Symbols& symbols) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t open; (open = text.find('{', at)) != std::string::npos;) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos)
      throw std::runtime_error("an opening brace has no closing brace: " + text.substr(open));
    const std::string inside = text.substr(open + 1, close - open - 1);
    result += without_brace(text.substr(at, open - at));
    at = close + 1;
    const auto found = choice.find(inside);
    result += found != choice.end() ? found->second : value_of(inside, choice, symbols);
  }
  return result + without_brace(text.substr(at));
}

}  // namespace rederive::classroom
