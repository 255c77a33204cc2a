#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <derivations/decide/problem.hpp>
#include <lessons/exercises/variants.hpp>
#include <regex>

namespace rederive::classroom {

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

/// The value, to ten digits, of a formula in which names stand for what is chosen.
std::string value_of(const std::string& formula, const Choice& choice, const Symbols& symbols) {
  Tree tree = parse(formula, symbols);
  for (const auto& name : names_of(tree)) {
    const auto found = choice.find(name);
    if (found == choice.end()) throw std::runtime_error("{" + formula + "}: '" + name + "' does not vary");
    const Tree value = parse(found->second, symbols);
    if (!names_of(value).empty())
      throw std::runtime_error(
          fmt::format("{{{}}}: '{}' is '{}' here, which is not a number", formula, name, found->second));
    tree = rederive::put_in(tree, name, value);
  }
  const Value value = value_at(tree, {}, 90);
  const double number = value.is == Value::Is::certain ? value.ball().to_double() : NAN;
  if (!std::isfinite(number))
    throw std::runtime_error("{" + formula + "} has no value here, or its value is too large");
  return fmt::format("{:.10g}", number);
}

}  // namespace

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
