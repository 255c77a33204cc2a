#include <fmt/format.h>
#include <glob.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <derivations/emit/emit.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/papers/paper_folder.hpp>
#include <stdexcept>

extern char** environ;  // POSIX declares it nowhere

namespace rederive::papers {
using namespace language;
using namespace program;
using namespace paper;
using namespace page;
using namespace classroom;
namespace fs = std::filesystem;

namespace {

/// Runs a program with these arguments and the terminal of this one. Standard output goes to standard error,
/// because results of `rederive` alone belong there. Returns the exit status, or 127 if it is not installed.
int run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, 2, 1);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  constexpr int not_installed = 127;
  if (error != 0) return not_installed;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : not_installed;
}

/// Puts the folder of the Python module that belongs to this program before those of the user.
void find_python_module() {
  const fs::path prefix = loaded_from().parent_path().parent_path();
  glob_t found;
  std::string module;  // empty: installed where Python looks
  if (::glob((prefix.string() + "/{,lib/}python*/{,dist-packages/}rederive").c_str(), GLOB_BRACE, nullptr,
             &found) == 0)
    module = fs::path(found.gl_pathv[0]).parent_path();
  ::globfree(&found);
  if (module.empty()) return;
  const char* others = std::getenv("PYTHONPATH");
  const std::string path = module + (others == nullptr ? "" : ":" + std::string(others));
  ::setenv("PYTHONPATH", path.c_str(), /*overwrite=*/1);
}

void derive_in_python(const fs::path& folder) {
  find_python_module();
  const std::string path = fs::absolute(folder).string();
  const int status = run({"python3", "-m", "rederive.derive", path});
  if (status == 0 && has_current_derivations(folder)) return;
  throw BadInput(
      "derive.py of '" + printable_name(folder) +
      (status == 0 ? "' wrote no current derivations.json" : "' failed; what is wrong is said above"));
}

/// Returns the folder with the files by which CMake finds this program's libraries.
fs::path cmake_folder() {
  const fs::path prefix = data_folder().parent_path().parent_path();
  return fs::exists(prefix / "RederiveConfig.cmake") ? prefix : prefix / "lib" / "cmake" / "Rederive";
}

/// Returns the progress file of a paper's folder. Its name says which folder, because others may have that
/// name.
fs::path progress_of(const fs::path& folder) {
  const std::string path = fs::weakly_canonical(folder).string();
  return state_folder() /
         fmt::format("exercises-{}-{}.txt", fs::path(path).filename().string(), emit::hash_of(path));
}

Paper current_paper(const fs::path& folder, Stale stale) {
  refresh_derivations(folder, stale);
  return read_paper(folder);
}

}  // namespace

void build_derivations(const fs::path& folder) {
  const fs::path source = source_of_derivations(folder);
  if (source.extension() == ".py") return derive_in_python(folder);
  if (source.empty())
    throw BadInput("there is nothing to build in '" + printable_name(folder) + "': it has no derive.cpp");
  const std::string path = fs::canonical(folder).string(), cmake = cmake_folder().string();
  const fs::path work = private_folder("builds") / emit::hash_of(path + cmake);
  make_own_folder(work);
  write_whole(work / "CMakeLists.txt",
              "cmake_minimum_required(VERSION 3.22)\nproject(paper CXX)\n"
              "find_package(Rederive REQUIRED COMPONENTS paper)\nrederive_paper(paper \"" +
                  path + "\")\n");
  const std::string build = (work / "build").string();
  if (run({"cmake", "-S", work.string(), "-B", build, "-DRederive_DIR=" + cmake, "-DCMAKE_BUILD_TYPE=Debug",
           "--log-level=WARNING"}) != 0 ||
      run({"cmake", "--build", build}) != 0 || !has_current_derivations(folder))
    throw BadInput("derive.cpp of '" + printable_name(folder) +
                   "' could not be built; the messages are above (Debian: cmake, g++, librederive-dev)");
}

void refresh_derivations(const fs::path& folder, Stale stale) {
  (void)read_declarations(folder);  // what is wrong with paper.toml comes first
  if (has_current_derivations(folder)) return;
  const std::string name = printable_name(folder);
  if (source_of_derivations(folder).extension() == ".cpp")
    throw BadInput("the derivations of '" + name + "' are older than its files: run rederive " + name +
                   " build");
  if (stale == Stale::refuse)
    throw BadInput("the derivations of '" + name + "' are older than its files: run rederive " + name +
                   " first");
  derive_in_python(folder);
}

PaperFolder::PaperFolder(const fs::path& folder, Stale stale)
    : paper_(current_paper(folder, stale)),
      course_{.paper = paper_,
              .exercises = paper_.folder / "exercises.toml",
              .lessons = {.titles =
                              [this] {
                                std::map<std::string, std::string> titles;
                                for (const Lesson& lesson : lessons())
                                  titles[page_name(lesson.number)] =
                                      fmt::format("Lesson {}. {}", lesson.number, lesson.title);
                                return titles;
                              },
                          .page =
                              [this](const std::string& name, const fs::path& forms) {
                                for (const Lesson& lesson : lessons())
                                  if (page_name(lesson.number) == name)
                                    return lesson_page(paper_, lesson, series(), forms);
                                throw BadInput("there is no lesson " + name);
                              },
                          .markdown =
                              [this](const std::string& name) {
                                for (const Lesson& lesson : lessons())
                                  if (page_name(lesson.number) == name)
                                    return lesson_in_markdown(paper_, lesson, series());
                                throw BadInput("there is no lesson " + name);
                              }},
              .program = "rederive " + paper_.folder.filename().string() + " exercises",
              .progress = progress_of(paper_.folder)} {}

bool PaperFolder::has_exercises() const { return fs::exists(course_.exercises); }

std::string PaperFolder::page_name(int lesson) { return fmt::format("lesson-{:02}", lesson); }

std::vector<Passage> PaperFolder::ask(const std::string& id) const {
  const auto exercises =
      has_exercises() ? read_exercises(course_, course_.exercises) : std::vector<Exercise>();
  const auto found = std::ranges::find(exercises, id, &Exercise::id);
  if (found == exercises.end())
    throw std::out_of_range("there is no exercise '" + id + "' in exercises.toml");
  std::vector<Passage> passages{Paragraph{"Exercise " + found->id + ": " + literal(found->title) + "."}};
  for (const std::string& paragraph : paragraphs(found->statement)) passages.push_back(Paragraph{paragraph});
  passages.push_back(Commands{{command_on(paper_, "exercises check " + id + " \"ANSWER\"")}});
  return passages;
}

std::vector<MarkdownLesson> PaperFolder::read_lessons() const {
  std::vector<MarkdownLesson> all;
  for (const fs::path& file : lesson_files(paper_.folder))
    all.push_back(read_lesson(paper_, file, static_cast<int>(all.size()) + 1,
                              [this](const std::string& id) { return ask(id); }));
  return all;
}

std::vector<Lesson> PaperFolder::lessons() const {
  std::vector<Lesson> all;
  for (MarkdownLesson& one : read_lessons()) all.push_back(std::move(one.lesson));
  return all;
}

LessonSeries PaperFolder::series() const {
  LessonSeries series;
  for (const MarkdownLesson& one : read_lessons()) {
    series.pages.push_back(page_name(one.lesson.number));
    series.coverage[one.lesson.number] = one.rows;
  }
  return series;
}

}  // namespace rederive::papers
