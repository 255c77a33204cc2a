// A paper that is a folder, with all that the program `rederive` needs: the paper, its lessons and exercises.
#pragma once

#include <lessons/exercises/course.hpp>
#include <lessons/papers/markdown_lesson.hpp>
#include <string>
#include <vector>

namespace rederive::papers {

/// The action to take if derivations.json is older than paper.toml or the source of the derivations.
enum class Stale {
  derive_again,  ///< run derive.py; derive.cpp is an error that says to build it
  refuse         ///< an error: for commands that read what others hand in, which run no code of a paper
};

/// Makes derivations.json current. Throws BadInput, with what to do, if that is not possible.
void refresh_derivations(const std::filesystem::path& folder, Stale stale);

/// Compiles derive.cpp and runs it. Throws BadInput, with the messages of the compiler, if that fails.
void build_derivations(const std::filesystem::path& folder);

/// A paper's folder, read. The references that it returns are valid during its lifetime.
class PaperFolder {
 public:
  /// Reads the paper. Throws BadInput as read_paper and refresh_derivations do.
  PaperFolder(const std::filesystem::path& folder, Stale stale);
  PaperFolder(const PaperFolder&) = delete;

  const paper::Paper& paper() const { return paper_; }
  const classroom::Course& course() const { return course_; }
  bool has_exercises() const;
  /// Reads the lessons. Throws BadInput as read_lesson does.
  std::vector<page::Lesson> lessons() const;
  page::LessonSeries series() const;
  /// Returns the name of the web page of a lesson without ".html": "lesson-01".
  static std::string page_name(int lesson);

 private:
  std::vector<MarkdownLesson> read_lessons() const;
  std::vector<page::Passage> ask(const std::string& id) const;

  paper::Paper paper_;
  classroom::Course course_;
};

}  // namespace rederive::papers
