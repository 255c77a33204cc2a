#include <algorithm>
#include <array>
#include <derivations/paper/prove.hpp>
#include <lessons/exercises/opinion.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace paper;
namespace {

struct OutcomeWords {
  const char *word, *sentence;
};
/// The words are in the order of Outcome.
constexpr std::array outcome_words{
    OutcomeWords{"correct", "Correct."},
    OutcomeWords{"correct_if", "Correct only under a condition."},
    OutcomeWords{"wrong", "Not right yet."},
    OutcomeWords{"invalid", "This could not be read; it does not count as an attempt."},
    OutcomeWords{"undecided", "Undecided."},
    OutcomeWords{"ambiguous", "This can be read in more than one way; it does not count as an attempt."}};

const OutcomeWords& words_of(Outcome outcome) { return outcome_words[static_cast<std::size_t>(outcome)]; }

}  // namespace

std::string to_string(Outcome outcome) { return words_of(outcome).word; }
std::string in_words(Outcome outcome) { return words_of(outcome).sentence; }

Opinion right_answer(const std::string& feedback) {
  return {.outcome = Outcome::correct, .note = {"correct"}, .feedback = feedback, .score = 1};
}

Opinion wrong_answer(const Note& note, const std::string& feedback) {
  return {.outcome = Outcome::wrong,
          .note = note,
          .feedback = feedback,
          .hint = slip_words(SlipTable::hint, note)};
}

Opinion wrong_answer(Slip slip) { return wrong_answer(slip, slip_words(SlipTable::answer, slip)); }

Opinion half_right(Opinion opinion) {
  opinion.outcome = Outcome::correct_if;
  opinion.score = 0.5;
  return opinion;
}

Opinion invalid(const Note& note, const std::string& feedback) {
  Opinion opinion = wrong_answer(note, feedback);
  opinion.outcome = Outcome::invalid;
  return opinion;
}

Opinion invalid(const SyntaxError& error, const std::string& text) {
  Opinion opinion = invalid(word_of(error.mistake), explain(error, text));
  opinion.shows_place = true;
  return opinion;
}

Opinion refused(Trouble trouble) { return invalid(to_string(trouble), in_words(trouble)); }

Opinion undecided(const std::string& reason) {
  return {.note = {"undecided"}, .feedback = "This could not be decided: " + reason};
}

Opinion ambiguous(const std::vector<std::string>& readings, const std::string& reason) {
  std::string list;
  for (std::size_t k = 0; k < readings.size(); ++k)
    list += (k == 0 ? "" : k + 1 == readings.size() ? " or " : ", ") + ("`" + readings[k] + "`");
  return {.outcome = Outcome::ambiguous,
          .note = {"ambiguous"},
          .feedback = "It is not clear " + reason + ". Type the one that you mean: " + list + ".",
          .readings = readings};
}

Opinion opinion_on_all(const std::vector<Opinion>& readings, const std::string& reason) {
  const Opinion& first = readings.front();
  const bool is_same = std::ranges::all_of(readings, [&](const Opinion& other) {
    return other.outcome == first.outcome &&
           (first.outcome == Outcome::correct || other.note.word == first.note.word);
  });
  if (readings.size() == 1 || is_same) return first;
  std::vector<std::string> texts;
  for (const Opinion& opinion : readings) texts.push_back(opinion.read_as);
  return ambiguous(texts, reason);
}

int exit_code(const Opinion& opinion) {
  if (opinion.outcome == Outcome::correct) return 0;
  if (opinion.outcome == Outcome::invalid || opinion.outcome == Outcome::ambiguous) return 2;
  return opinion.outcome == Outcome::undecided ? 3 : 1;
}

bool needs_teacher(const Opinion& opinion) {
  return opinion.outcome == Outcome::invalid || opinion.outcome == Outcome::undecided ||
         opinion.outcome == Outcome::ambiguous;
}

std::string feedback_of(const Opinion& opinion) {
  return opinion.outcome == Outcome::correct && opinion.feedback.empty() ? "Right." : opinion.feedback;
}

std::string packed(const Opinion& opinion) {
  nlohmann::json list{opinion.outcome, opinion.note.word,   opinion.feedback, opinion.score,   opinion.hint,
                      opinion.read_as, opinion.shows_place, opinion.line,     opinion.readings};
  if (const auto& witness = opinion.witness)
    list.insert(list.end(), {witness->at, witness->printed, witness->derived});
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Opinion unpacked(const std::string& text) {
  const nlohmann::json list = nlohmann::json::parse(text);
  Opinion opinion{.outcome = list[0],
                  .note = list[1].get<std::string>(),
                  .feedback = list[2],
                  .score = list[3],
                  .hint = list[4],
                  .read_as = list[5],
                  .shows_place = list[6],
                  .line = list[7],
                  .readings = list[8]};
  if (list.size() > 9)
    opinion.witness.emplace(Witness{.at = list[9], .printed = list[10], .derived = list[11]});
  return opinion;
}

}  // namespace rederive::classroom
