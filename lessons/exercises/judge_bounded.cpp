// An answer is what anybody may type: it is judged in a process that can neither hang nor starve this one.
#include <derivations/program/bounded.hpp>
#include <lessons/exercises/judge.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
namespace {

using nlohmann::json;

std::string packed(const Opinion& opinion) {
  json list{opinion.verdict, opinion.note, opinion.read_as, opinion.feedback, opinion.score, opinion.line};
  if (const auto& witness = opinion.witness)
    list.insert(list.end(), {witness->at, witness->printed, witness->derived});
  return list.dump(-1, ' ', false, json::error_handler_t::replace);
}

Opinion opinion_in(const std::string& text) {
  const json list = json::parse(text);
  Opinion opinion{list[0], list[1], list[2], list[3], {}, list[4], list[5]};
  if (list.size() > 6)
    opinion.witness.emplace(Witness{.at = list[6], .printed = list[7], .derived = list[8]});
  return opinion;
}

Opinion undecided(const std::string& note, const std::string& why) {
  return {"undecided", note, "", "This could not be decided: " + why + ".", {}, 0};
}

}  // namespace

Opinion judge_bounded(const Exercise& exercise, const std::string& text) {
  const Prepared prepared = prepare(exercise);
  return bounded([&] { return judge_answer(prepared, text); });
}

Opinion bounded(const std::function<Opinion()>& judge) {
  const auto work = [&] {
    try {
      return packed(judge());
    } catch (const std::exception& error) {
      return packed(undecided("undecided", in_plain_words(error)));
    }
  };
  const auto read_words = [] { (void)slip_words("answer", ""); };
  const Bounded outcome = run_bounded(work, most_judging_seconds, most_judging_megabytes, 60, read_words);
  return outcome.result ? opinion_in(*outcome.result) : undecided("limits", outcome.why);
}

}  // namespace rederive::classroom
