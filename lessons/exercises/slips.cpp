#include <algorithm>
#include <array>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/slips.hpp>

namespace rederive::classroom {
using namespace program;
namespace {

/// The stable words, in the order of Slip.
constexpr std::array slip_names{"",
                                "sign",
                                "wrong_angle",
                                "wrong_argument",
                                "extra_term",
                                "missing_term",
                                "factor",
                                "taken_away",
                                "left_over",
                                "extra_factor",
                                "missing_factor",
                                "power",
                                "reciprocal",
                                "sin_cos",
                                "wrong_function",
                                "extra_function",
                                "absolute_value",
                                "wrong_symbol",
                                "exchanged",
                                "degrees",
                                "rounding",
                                "missing_dot",
                                "power_of_ten",
                                "dimension",
                                "small_angle",
                                "not_linear",
                                "not_everywhere",
                                "missing_symbol",
                                "extra_symbol",
                                "unit",
                                "assumption",
                                "wrong_term",
                                "wrong_choice",
                                "other"};
static_assert(slip_names.size() == static_cast<std::size_t>(Slip::other) + 1);

/// The names are in the order of SlipTable.
constexpr std::array table_names{"answer", "number", "part", "whole", "hint"};

using Texts = std::map<std::string, std::string>;

const std::array<Texts, table_names.size()>& tables() {
  static const auto all = [] {
    TomlTable document(exercises_folder() / "slips.toml");
    std::array<Texts, table_names.size()> texts;
    for (std::size_t k = 0; k < texts.size(); ++k) texts[k] = document.named_texts(table_names[k]);
    document.done();
    for (std::size_t k = 0; k < texts.size(); ++k)
      for (const auto& [note, text] : texts[k]) {
        const bool names = k == static_cast<std::size_t>(SlipTable::part) || note.ends_with("_symbol");
        std::string rest = text;
        const std::size_t place = rest.find("{}");
        if (names && place != std::string::npos) rest.erase(place, 2);
        if (rest.find_first_of("{}") != std::string::npos)
          document.table(table_names[k])
              ->fail(fmt::format("'{}' must have {}braces{}", note, names ? "no other " : "no ",
                                 names ? " than {}, where it names the part" : ""),
                     note);
      }
    return texts;
  }();
  return all;
}

}  // namespace

Note::Note(Slip which) : slip(which), word(slip_names[static_cast<std::size_t>(which)]) {}

Note::Note(const std::string& stable_word) : word(stable_word) {
  const auto found = std::ranges::find(slip_names, stable_word);
  if (found != slip_names.end()) slip = static_cast<Slip>(found - slip_names.begin());
}

void read_slip_words() { (void)tables(); }

std::string slip_words(SlipTable table, const Note& note) {
  const Texts& texts = tables()[static_cast<std::size_t>(table)];
  const auto found = texts.find(note.word);
  return found == texts.end() ? "" : found->second;
}

}  // namespace rederive::classroom
