// An answer is what anybody may type: it is judged in a process that can neither hang nor starve this one.
#include <lessons/bounded.hpp>
#include <lessons/exercises/judge.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
namespace {

using Json = nlohmann::ordered_json;

std::string packed(const Opinion& opinion) {
  Json json{{"verdict", opinion.verdict},   {"note", opinion.note},   {"read_as", opinion.read_as},
            {"feedback", opinion.feedback}, {"score", opinion.score}, {"witness", nullptr}};
  if (opinion.witness)
    json["witness"] = {{"at", opinion.witness->at},
                       {"printed", opinion.witness->printed},
                       {"derived", opinion.witness->derived}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Opinion opinion_in(const std::string& text) {
  const Json json = Json::parse(text);
  Opinion opinion{json["verdict"], json["note"], json["read_as"], json["feedback"], {}, json["score"]};
  if (const Json& witness = json["witness"]; !witness.is_null()) {
    opinion.witness.emplace();
    opinion.witness->at = witness["at"].get<std::map<std::string, std::string>>();
    opinion.witness->printed = witness["printed"];
    opinion.witness->derived = witness["derived"];
  }
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
  constexpr double seconds = 1.5, patience = 1.7;  // of the two that an answer may take, with the preparation
  const Bounded outcome = run_bounded(work, seconds, 480, patience);
  return outcome.result ? opinion_in(*outcome.result) : undecided("limits", outcome.why);
}

}  // namespace rederive::classroom
