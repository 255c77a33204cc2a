#include <derivations/paper/folder.hpp>
#include <derivations/paper/json.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/prepared.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/ledger/report.hpp>
#include <lessons/module/desk.hpp>
#include <lessons/rocking_block/course.hpp>
#include <map>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>

namespace rederive::module {
using namespace classroom;
using namespace paper;
using namespace program;
namespace fs = std::filesystem;
namespace {

/// A paper that a page has handed over, with its exercises.
struct HandedOver {
  Paper paper;
  Course course;

  explicit HandedOver(const fs::path& folder)
      : paper(read_paper(folder)),
        course{.paper = paper,
               .exercises = folder / "exercises.toml",
               .lessons = {},
               .program = "exercises",
               .progress = {}} {}
};

/// The paper that is asked about, and its exercises in the variants that were asked for.
struct Subject {
  std::unique_ptr<HandedOver> handed_over;  ///< none: the built-in paper
  std::map<std::string, Classroom> rooms;

  const Course& course() const { return handed_over ? handed_over->course : rocking_block::course(); }
};

Subject& subject() {
  static Subject one;
  return one;
}

const fs::path& file_of_progress() {
  static const fs::path file = progress_file("", rocking_block::course().progress);
  return file;
}

/// Returns the classroom of a seed, with all exercises in its variant. A second call returns the same one.
const Classroom& classroom_of(const std::string& seed) {
  auto& rooms = subject().rooms;
  const auto found = rooms.find(seed);
  if (found != rooms.end()) return found->second;
  if (rooms.size() > 16) rooms.clear();
  const Course& course = subject().course();
  return rooms
      .emplace(seed, Classroom{course, read_exercises(course, course.exercises, seed), file_of_progress()})
      .first->second;
}

/// Puts the paper in a folder with these files in place of the one before.
Json handed_over(const Json& files) {
  const fs::path folder = private_folder("paper");
  fs::remove_all(folder);
  make_own_folder(folder);
  for (const auto& [name, text] : files.items()) {
    if (fs::path(name).filename() != name)
      throw BadInput("a file of the paper needs a name without a folder, not '" + name + "'");
    write_whole(folder / name, text.get<std::string>());
  }
  auto paper = std::make_unique<HandedOver>(folder);
  subject().rooms.clear();
  subject().handed_over = std::move(paper);
  return Json::object();
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
  return decide_bounded(subject().course().paper, wanted);
}

Json shown(const std::string& what) {
  const Paper& paper = subject().course().paper;
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
  if (request.contains("paper")) return handed_over(request.at("paper"));
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
