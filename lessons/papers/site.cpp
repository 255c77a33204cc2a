#include <fmt/format.h>

#include <derivations/program/command_line.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/report.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/papers/site.hpp>
#include <map>
#include <nlohmann/json.hpp>

namespace rederive::papers {
using namespace language;
using namespace program;
using namespace decide;
using namespace paper;
using namespace page;
namespace fs = std::filesystem;

namespace {

class Site {
 public:
  explicit Site(const PaperFolder& folder)
      : folder_(folder), paper_(folder.paper()), setting_{.paper = paper_, .format = Format::html} {
    for (const Row& row : rows_of(paper_)) entries_.push_back(judge(paper_, row));
  }

  /// Returns the names of the files with their texts.
  std::vector<std::pair<fs::path, std::string>> files() const {
    std::vector<std::pair<fs::path, std::string>> all{
        {"index.html", index()},
        {"ledger.html", ledger_page()},
        {"errata.html", ledger::errata(entries_, "html", paper_)},
        {"ledger.json", ledger::to_json(entries_, paper_).dump(2) + "\n"}};
    for (const Lesson& lesson : folder_.lessons())
      all.emplace_back(PaperFolder::page_name(lesson.number) + ".html",
                       lesson_page(paper_, lesson, folder_.series(), ""));
    if (folder_.has_exercises()) {
      const classroom::Course& course = folder_.course();
      const classroom::Classroom room{course, read_exercises(course, course.exercises), course.progress};
      all.emplace_back("exercises.html", classroom::page_of_statements(room));
    }
    return all;
  }

 private:
  std::string index() const {
    const std::string authors = joined(paper_.authors, ", ");
    std::vector<Passage> passages;
    if (!authors.empty())
      passages.push_back(Paragraph{literal(authors + (paper_.year.empty() ? "" : ", " + paper_.year))});
    if (!paper_.doi.empty())
      passages.push_back(
          Paragraph{"[" + literal("doi:" + paper_.doi) + "](https://doi.org/" + paper_.doi + ")"});
    passages.push_back(
        Paragraph{"Each equation of this paper is derived again from first principles, and compared with "
                  "what is printed."});
    Table counted_verdicts{.header = {"verdict", "rows"}, .rows = {}};
    for (const auto& [verdict, count] : ledger::counts(entries_))
      counted_verdicts.rows.push_back({verdict, std::to_string(count)});
    passages.push_back(counted_verdicts);
    BulletList links;
    for (const auto& [page, title] : folder_.course().lessons.titles())
      links.items.push_back("[" + literal(title) + "](" + page + ".html)");
    if (folder_.has_exercises()) links.items.push_back("[The exercises](exercises.html)");
    links.items.push_back("[The ledger](ledger.html): every equation, its derivation and its verdict");
    links.items.push_back("[The errata](errata.html)");
    passages.push_back(links);
    return rendered({paper_.title}, passages, setting_);
  }

  std::string ledger_page() const {
    std::vector<Passage> passages{Paragraph{"[All pages](index.html)"}};
    std::string section;
    for (const Entry& entry : entries_) {
      if (entry.row.section != section) passages.push_back(Heading{literal(entry.row.section)});
      section = entry.row.section;
      passages.push_back(findings(entry, paper_));
      if (!entry.derivation || entry.proof.verdict == Verdict::error) continue;
      Page page(paper_);
      page.argue(*entry.derivation, entry.row.id);
      passages.insert(passages.end(), page.blocks().begin(), page.blocks().end());
    }
    return rendered({"The ledger: " + paper_.title}, passages, setting_);
  }

  const PaperFolder& folder_;
  const Paper& paper_;
  Setting setting_;
  std::vector<Entry> entries_;
};

}  // namespace

int run_site(const std::function<const PaperFolder&()>& folder, int argc, char** argv) {
  CLI::App app{"Writes everything about a paper as one static site: lessons, exercises, ledger, errata."};
  std::string out;
  app.add_option("OUT", out, "Folder for the pages. It is created if it does not exist.")->required();
  app.footer("Examples:\n  $ rederive housner-1963 site pages\n\n");
  return run_command(app, argc, argv, [&] {
    auto files = Site(folder()).files();
    make_output_folder(out);
    for (auto& [name, text] : files) name = fs::path(out) / name;
    write_together(files);
    fmt::print("{}\n", (fs::path(out) / "index.html").string());
    return as_expected;
  });
}

}  // namespace rederive::papers
