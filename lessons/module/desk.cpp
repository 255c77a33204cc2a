#include <derivations/paper/json.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/program/program.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/prepared.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/ledger/report.hpp>
#include <lessons/module/desk.hpp>
#include <lessons/rocking_block/course.hpp>
#include <map>
#include <new>
#include <nlohmann/json.hpp>

namespace rederive::module {
using namespace classroom;
using namespace paper;
using namespace program;
namespace {

const std::filesystem::path& file_of_progress() {
  static const std::filesystem::path file = progress_file("", rocking_block::course().progress);
  return file;
}

/// Returns the classroom of a seed, with all exercises in its variant. A second call returns the same one.
const Classroom& classroom_of(const std::string& seed) {
  static std::map<std::string, Classroom> rooms;
  const auto found = rooms.find(seed);
  if (found != rooms.end()) return found->second;
  if (rooms.size() > 16) rooms.clear();
  const Course& course = rocking_block::course();
  return rooms
      .emplace(seed, Classroom{course, read_exercises(course, course.exercises, seed), file_of_progress()})
      .first->second;
}

Json button(const Json& request) {
  const Classroom& room = classroom_of(request.value("seed", ""));
  const Exercise& exercise = find_exercise(room, request.at("exercise").get<std::string>());
  const Reply told =
      reply(room, exercise, request.at("button").get<std::string>(), trimmed(request.value("answer", "")));
  return {{"says", told.says},
          {"standing", told.standing},
          {"opinion", told.opinion ? report_json(exercise, *told.opinion) : Json()}};
}

Json proof(const Json& request) {
  ProveRequest wanted{.left = request.at("left"),
                      .right = request.at("right"),
                      .assumptions = request.value("assume", std::vector<std::string>{}),
                      .small = request.value("small", std::vector<std::string>{}),
                      .order = {}};
  if (request.contains("order")) wanted.order = request.at("order").get<int>();
  return decide_bounded(rocking_block::paper(), wanted);
}

Json shown(const std::string& what) {
  const Paper& paper = rocking_block::course().paper;
  if (what == "exercises") {
    Json answers = Json::object();
    for (const Exercise& exercise : classroom_of("").exercises)
      answers[exercise.id] = model_answer(prepare(exercise));
    return answers;
  }
  if (what != "ledger") return to_json(judged(paper, what));
  std::vector<Entry> entries;
  for (const Row& row : rows_of(paper)) entries.push_back(judge(paper, row));
  return ledger::to_json(entries, paper);
}

Json answer_to(const Json& request) {
  if (request.contains("prove")) return proof(request.at("prove"));
  if (request.contains("show")) return shown(request.at("show").get<std::string>());
  if (request.contains("selftest")) return {{"code", selftest(classroom_of(""))}};
  return button(request);
}

}  // namespace

std::string reply_to(const std::string& request) {
  Json answer;
  try {
    answer = answer_to(Json::parse(request));
  } catch (const std::bad_alloc&) {
    answer = {{"error", "it needed more memory than there is"}};
  } catch (const std::exception& error) {
    answer = {{"error", printable(error.what())}};
  }
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string progress() { return read_if_there(file_of_progress(), {}).value_or(""); }

void set_progress(const std::string& text) {
  save_progress(file_of_progress(), read_progress(text, file_of_progress()));
}

}  // namespace rederive::module
