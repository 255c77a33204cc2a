#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/manuscript/formula.hpp>
#include <derivations/manuscript/stated.hpp>
#include <derivations/manuscript/statements.hpp>
#include <derivations/program/program.hpp>
#include <regex>

namespace rederive::manuscript {
using namespace program;
namespace {

/// Returns a constant in our syntax; nothing for a formula with names, or one that is not read.
std::optional<std::string> constant_of(const TexTokens& tokens) {
  const bool is_infinite = !tokens.empty() && tokens.back().is("\\infty") && tokens.size() <= 2;
  if (is_infinite) return tokens[0].is("-") ? "-inf" : "inf";
  try {
    Meanings meanings;
    Choices choices;
    const Value value = read_value(tokens, meanings, choices);
    if (!value.is_number() || value.entries[0].imaginary || !meanings.symbols.names().empty()) return {};
    return language::print(value.entries[0].real);
  } catch (const std::exception&) {
    return {};
  }
}

/// Returns the name that is the whole of a formula.
std::string whole_name(const TexTokens& tokens) {
  const Name name = name_at(tokens, 0);
  return name.size > 0 && name.size == tokens.size() ? name.name : "";
}

std::string joined(const TexTokens& tokens, std::size_t from = 0) {
  std::string text;
  for (std::size_t k = from; k < tokens.size(); ++k) text += tokens[k].text;
  return text;
}

/// Returns the names in a list with commas; "" for each part that is not a name.
std::vector<std::string> listed_names(const TexTokens& tokens) {
  std::vector<std::string> names;
  for (auto start = tokens.begin(); true; ++start) {
    const auto comma = std::find_if(start, tokens.end(), [](const TexToken& token) { return token.is(","); });
    names.push_back(whole_name({start, comma}));
    if (comma == tokens.end()) return names;
    start = comma;
  }
}

/// Takes n \in \mathbb{N}, x \in (0, 1), x \in \mathbb{R}.
bool take_membership(const Statement& statement, StatedSymbols& symbols, bool is_from_text) {
  const std::string set = joined(statement.sides[1]);
  const std::vector<std::string> names = listed_names(statement.sides[0]);
  if (std::ranges::any_of(names, &std::string::empty)) return false;
  Stated stated{.is_from_text = is_from_text};
  if (set.find("mathbb{N}") != set.npos || set == "\\mathbbN") {
    stated.is_integer = true;
    stated.range = "[0, inf)";
  } else if (set.find("mathbb{Z}") != set.npos) {
    stated.is_integer = true;
    if (set.find("+") != set.npos) stated.range = "(0, inf)";
  } else if (set.find("mathbb{R}") != set.npos) {
    if (set.find("+") != set.npos || set.find(">0") != set.npos) stated.range = "(0, inf)";
  } else if (set.find("mathbb{C}") != set.npos) {
    stated.is_complex = true;
  } else {
    const TexTokens& side = statement.sides[1];
    if (side.size() < 5) return false;
    const bool opens = side.front().is("(") || side.front().is("["),
               closes = side.back().is(")") || side.back().is("]");
    const auto comma = std::ranges::find_if(side, [](const TexToken& t) { return t.is(",") || t.is(";"); });
    if (!opens || !closes || comma == side.end()) return false;
    const auto low = constant_of({side.begin() + 1, comma}), high = constant_of({comma + 1, side.end() - 1});
    if (!low || !high) return false;
    stated.range = fmt::format("{}{}, {}{}", *low == "-inf" ? "(" : side.front().text, *low, *high,
                               *high == "inf" ? ")" : side.back().text);
  }
  for (const std::string& name : names) symbols[name] = stated;
  return true;
}

struct End {
  std::string value;
  bool is_closed = false;
};

}  // namespace

bool take_range(const TexTokens& tokens, StatedSymbols& symbols, bool is_from_text) {
  std::vector<std::string> labels;
  const std::vector<Statement> statements = statements_of(tokens, "$", labels);
  bool is_taken = false;
  for (const Statement& statement : statements) {
    if (statement.goes_on || statement.sides.size() < 2 || statement.sides.size() > 3) continue;
    if (statement.relations[0].is("\\in") && statement.sides.size() == 2) {
      is_taken = take_membership(statement, symbols, is_from_text) || is_taken;
      continue;
    }
    const auto is_less = [](const TexToken& t) { return t.is("<") || t.is("<="); };
    const auto is_more = [](const TexToken& t) { return t.is(">") || t.is(">="); };
    if (!std::ranges::all_of(statement.relations, is_less) &&
        !std::ranges::all_of(statement.relations, is_more))
      continue;
    for (std::size_t k = 0; k < statement.sides.size(); ++k) {
      TexTokens side = statement.sides[k];
      const bool has_bars = side.size() > 2 && side.front().is("|") && side.back().is("|");
      if (has_bars) side = {side.begin() + 1, side.end() - 1};
      const std::vector<std::string> names = listed_names(side);  // a, b > 0
      if (std::ranges::any_of(names, &std::string::empty)) continue;
      const bool is_rising = is_less(statement.relations[0]);
      End low{"-inf"}, high{"inf"};
      const auto bound = [&](std::size_t other, std::size_t relation, bool is_low) {
        const auto value = constant_of(statement.sides[other]);
        if (!value) return false;
        (is_low ? low : high) = {*value, statement.relations[relation].text.ends_with("=")};
        return true;
      };
      bool is_bounded = true;
      if (k > 0) is_bounded = bound(k - 1, k - 1, is_rising);
      if (k + 1 < statement.sides.size()) is_bounded = bound(k + 1, k, !is_rising) && is_bounded;
      if (!is_bounded) continue;
      if (has_bars) {
        if (high.value == "inf") continue;
        low = {"-(" + high.value + ")", high.is_closed};
      }
      for (const std::string& name : names) {
        Stated& stated = symbols[name];
        stated.range = fmt::format("{}{}, {}{}", low.is_closed && low.value != "-inf" ? "[" : "(", low.value,
                                   high.value, high.is_closed && high.value != "inf" ? "]" : ")");
        stated.is_from_text = is_from_text;
      }
      is_taken = true;
      break;
    }
  }
  return is_taken;
}

namespace {

/// Takes what a sentence states.
void take_sentence(const std::string& prose, StatedSymbols& symbols) {
  // A relation is a condition behind such a word, in the same sentence.
  static const std::regex condition(
      R"((?:for|[Ll]et|where|with|[Aa]ssum\w*|[Ss]uppose|[Ww]hen|[Ii]f|provided|[Gg]iven|since|that|all|any|every|and|[Tt]ake)\s+(?:that\s+)?(?:all\s+|any\s+|every\s+|real\s+|positive\s+|integers?\s+|numbers?\s+)*\$([^$]*)\$)",
      std::regex::icase);
  for (std::sregex_iterator found(prose.begin(), prose.end(), condition), end; found != end; ++found) {
    const std::string formula = (*found)[1];
    (void)take_range(tokens_of(formula, 0, formula.size()), symbols, true);
  }
  const auto say = [&](const std::string& formula, const std::string& words) {
    for (const std::string& name : listed_names(tokens_of(formula, 0, formula.size()))) {
      if (name.empty()) continue;
      Stated& stated = symbols[name];
      stated.is_from_text = true;
      const bool is_integer = words.find("integer") != words.npos || words.find("whole") != words.npos ||
                              words.find("natural") != words.npos;
      if (is_integer) stated.is_integer = true;
      if (words.find("complex") != words.npos) stated.is_complex = true;
      if (words.find("natural") != words.npos) stated.range = "[0, inf)";
      if (words.find("non-negative") != words.npos || words.find("nonnegative") != words.npos)
        stated.range = "[0, inf)";
      else if (words.find("positive") != words.npos)
        stated.range = "(0, inf)";
      if (words.find("negative") == 0) stated.range = "(-inf, 0)";
    }
  };
  static const std::string kinds =
      R"(((?:(?:strictly|fixed|given|arbitrary|an?|the|all|both|real|non-negative|nonnegative|positive|negative|natural|whole|complex)\s+)*(?:integers?|positive|non-negative|nonnegative|negative|numbers?|complex)))";
  static const std::regex is_said(
      R"(\$([^$]+)\$(?:\s*(?:and|,)\s*\$([^$]+)\$)?\s+(?:is|are|be|being|denotes?)\s+)" + kinds);
  for (std::sregex_iterator found(prose.begin(), prose.end(), is_said), end; found != end; ++found) {
    say((*found)[1], (*found)[3]);
    if ((*found)[2].matched) say((*found)[2], (*found)[3]);
  }
  static const std::regex before(
      kinds +
      R"(\s+(?:constants?\s+|parameters?\s+|lengths?\s+)?\$([^$]+)\$(?:\s*(?:and|,)\s*\$([^$]+)\$)?)");
  for (std::sregex_iterator found(prose.begin(), prose.end(), before), end; found != end; ++found) {
    say((*found)[2], (*found)[1]);
    if ((*found)[3].matched) say((*found)[3], (*found)[1]);
  }
}

}  // namespace

std::vector<std::string> sentences_of(std::string_view text) {
  constexpr std::size_t longest = 2'000;
  std::vector<std::string> sentences;
  while (!text.empty()) {
    std::size_t end = text.size();
    for (const std::string_view mark : {". ", ".\n", "\n\n"})
      if (const std::size_t at = text.find(mark); at != text.npos) end = std::min(end, at + mark.size());
    sentences.emplace_back(text.substr(0, std::min(end, longest)));
    text.remove_prefix(end);
  }
  return sentences;
}

void take_stated(const std::string& prose, StatedSymbols& symbols) {
  for (const std::string& sentence : sentences_of(prose)) take_sentence(sentence, symbols);
}

Directive read_directive(const std::string& text, StatedSymbols& symbols) {
  if (text.size() > 2'000) throw BadInput("a directive has at most 2000 characters: write several");
  Directive result;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(';', start), text.size());
    const std::string part = trimmed(text.substr(start, end - start));
    start = end + 1;
    if (part.empty()) continue;
    static const std::regex kind(
        R"(([A-Za-z\\][\w\\{}]*(?:\s*,\s*[A-Za-z\\][\w\\{}]*)*)\s+((?:positive |non-negative |nonnegative |negative )?)(integer|function|complex|real)s?)"),
        member(R"(([A-Za-z\\][\w\\{}]*)\s+in\s+([(\[].*[)\]]))");
    std::smatch found;
    if (part == "identity") {
      result.is_identity = true;
    } else if (part.starts_with("from ")) {
      static const std::regex label(R"([^\s,]+)");
      const std::string labels = part.substr(5);
      for (std::sregex_iterator one(labels.begin(), labels.end(), label), last; one != last; ++one)
        result.from.push_back(one->str());
    } else if (std::regex_match(part, found, kind)) {
      const std::string names = found[1], sign = trimmed(std::string(found[2])), word = found[3];
      static const std::regex name(R"([^\s,]+)");
      for (std::sregex_iterator one(names.begin(), names.end(), name), last; one != last; ++one) {
        const std::string tex = one->str();
        const std::string known = whole_name(tokens_of(tex, 0, tex.size()));
        Stated& stated = symbols[known.empty() ? tex : known];
        if (sign == "positive") stated.range = "(0, inf)";
        if (sign == "negative") stated.range = "(-inf, 0)";
        if (sign.starts_with("non")) stated.range = "[0, inf)";
        stated.is_integer = word == "integer";
        stated.is_function = word == "function";
        stated.is_complex = word == "complex";
      }
    } else if (std::regex_match(part, found, member)) {
      const std::string tex = found[1], known = whole_name(tokens_of(tex, 0, tex.size())), range = found[2];
      try {
        (void)language::read_range(range);
      } catch (const std::invalid_argument& error) {
        throw BadInput(fmt::format("'{}': {}", part, error.what()));
      }
      symbols[known.empty() ? tex : known].range = range;
    } else {
      std::string tex = part;
      for (const auto& [typed, meant] : {std::pair("<=", "\\le "), {">=", "\\ge "}})
        for (std::size_t at = 0; (at = tex.find(typed)) != tex.npos;) tex.replace(at, 2, meant);
      tex = std::regex_replace(
          tex,
          std::regex(
              R"((^|[^\\A-Za-z])(alpha|beta|gamma|delta|theta|phi|psi|omega|lambda|mu|nu|rho|sigma|tau|eta|xi|pi|kappa|epsilon)(?![A-Za-z]))"),
          "$1\\$2");
      tex = std::regex_replace(tex, std::regex("_([A-Za-z0-9]{2,})"), "_{$1}");  // T_ex
      if (!take_range(tokens_of(tex, 0, tex.size()), symbols, false))
        throw BadInput(
            fmt::format("'{}' is not read: write x > 0, 0 < x < 1, x in (0, 1), n integer, f function, z "
                        "complex, identity or "
                        "from LABEL, separated by ';'",
                        part));
    }
  }
  return result;
}

namespace {

/// Returns the field of a name in a table of symbols: integer, function or complex.
bool& flag_of(std::string_view name, Stated& stated) {
  if (name == "integer") return stated.is_integer;
  return name == "function" ? stated.is_function : stated.is_complex;
}

}  // namespace

void read_symbols(const std::filesystem::path& file, StatedSymbols& symbols) {
  toml::table table;
  try {
    table = toml::parse(read_whole(file, {.most = 1'000'000}), file.string());
  } catch (const toml::parse_error& error) {
    throw BadInput(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, std::string(error.description())));
  }
  const toml::table* list = table["symbols"].as_table();
  if (list == nullptr) throw BadInput(file.string() + ": a table [symbols] is expected");
  for (const auto& [key, node] : *list) {
    const std::string place =
        fmt::format("{}:{}: {}", file.string(), node.source().begin.line, std::string(key.str()));
    const toml::table* one = node.as_table();
    if (one == nullptr) throw BadInput(place + ": a table is expected, such as { range = \"(0, inf)\" }");
    Stated stated;
    for (const auto& [field, value] : *one) {
      const std::string name(field.str());
      const bool is_flag = name == "integer" || name == "function" || name == "complex";
      if (name == "range" && value.is_string())
        stated.range = value.as_string()->get();
      else if (is_flag && value.is_boolean())
        flag_of(name, stated) = value.as_boolean()->get();
      else
        throw BadInput(place + "." + name +
                       ": range is a text, and integer, function and complex are true or false");
    }
    try {
      (void)language::read_range(stated.range);
    } catch (const std::invalid_argument& error) {
      throw BadInput(place + ".range: " + error.what());
    }
    symbols[std::string(key.str())] = stated;
  }
}

}  // namespace rederive::manuscript
