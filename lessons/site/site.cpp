#include <fmt/format.h>

#include <derivations/program/command_line.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/surroundings.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/report.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <lessons/site/scorm.hpp>
#include <lessons/site/site.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

namespace rederive::site {
using namespace language;
using namespace program;
using namespace decide;
using namespace paper;
using namespace page;
using classroom::Course;
namespace fs = std::filesystem;

namespace {

struct SiteOptions {
  fs::path out;
  fs::path judge;     ///< folder with judge.js and judge.wasm; empty: the pages do not judge
  fs::path mathlive;  ///< unpacked package of MathLive; empty: formulas are typed as text
  bool is_scorm = false;
  bool is_built_in = false;  ///< the judge knows the course by itself
};

using Files = std::vector<std::pair<fs::path, std::string>>;

/// Returns the style with the letters of MathLive inside. A page that is opened as a file may not load fonts.
std::string letters_of_mathlive(const fs::path& folder) {
  std::string style = read_whole(folder / "mathlive-fonts.css"), text;
  static const std::regex url(R"(url\((fonts/[A-Za-z0-9_-]+\.woff2)\))");
  auto from = style.cbegin();
  for (std::sregex_iterator match(style.begin(), style.end(), url), end; match != end; ++match) {
    text.append(from, style.cbegin() + match->position());
    text += "url(data:font/woff2;base64," + base64(read_whole(folder / (*match)[1].str())) + ")";
    from = style.cbegin() + match->position() + match->length();
  }
  return text.append(from, style.cend());
}

/// Returns the folder of the judge that is installed or built, or an empty path.
fs::path usual_judge() {
  const fs::path folder = data_folder() / "judge";
  return fs::exists(folder / "judge.wasm") ? folder : fs::path();
}

/// Returns the files of a paper's folder from which the judge reads the paper and its exercises.
std::map<std::string, std::string> files_for_judge(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".toml" || file.path().filename() == "derivations.json")
      files[file.path().filename()] = read_whole(file.path());
  return files;
}

class Site {
 public:
  Site(const Course& course, const SiteOptions& options)
      : course_(course),
        has_exercises_(fs::exists(course.exercises)),
        options_(options),
        setting_{.paper = course.paper, .format = Format::html} {
    for (const Row& row : rows_of(course.paper)) entries_.push_back(judge(course.paper, row));
  }

  /// Returns the names of the files with their texts.
  Files files() const {
    Files all{{"index.html", index()},
              {"ledger.html", ledger_page()},
              {"errata.html", ledger::errata(entries_, "html", course_.paper)},
              {"ledger.json", ledger::to_json(entries_, course_.paper).dump(2) + "\n"}};
    add_lessons(all);
    if (course_.lessons.has_workbench)
      all.emplace_back("workbench.html", read_whole(data_folder() / "workbench.html"));
    if (!options_.mathlive.empty()) {
      all.emplace_back("mathlive.min.js", read_whole(options_.mathlive / "mathlive.min.js"));
      all.emplace_back("mathlive.css", letters_of_mathlive(options_.mathlive));
      all.emplace_back("mathlive-LICENSE.txt", read_whole(options_.mathlive / "LICENSE.txt"));
    }
    if (judges()) {
      const std::string code = read_whole(options_.judge / "judge.js"),
                        binary = read_whole(options_.judge / "judge.wasm");
      all.emplace_back("judge.js", code);
      all.emplace_back("judge.wasm", binary);
      all.emplace_back(
          inlined_judge,
          "const inlined = " + nlohmann::json{{"code", code}, {"binary", base64(binary)}}.dump() + ";\n");
    }
    if (options_.is_scorm) all.emplace_back("imsmanifest.xml", scorm_manifest(course_.paper.title, all));
    return all;
  }

 private:
  bool judges() const { return has_exercises_ && !options_.judge.empty(); }

  /// Adds the lessons and the exercises, with forms where the pages judge.
  void add_lessons(Files& all) const {
    const auto titles = course_.lessons.titles();
    fs::path forms;
    if (has_exercises_) {
      const classroom::Classroom room{course_, read_exercises(course_, course_.exercises), course_.progress};
      classroom::ServedBy desk{.is_module = judges(), .has_mathlive = !options_.mathlive.empty()};
      if (judges() && !options_.is_built_in) desk.files = files_for_judge(course_.paper.folder);
      all.emplace_back("exercises.html", judges() ? classroom::page_of_exercises(room, titles, desk)
                                                  : classroom::page_of_statements(room));
      if (judges()) {
        forms = private_folder("forms") / "forms.json";
        write_whole(forms, classroom::forms_json(room, desk));
      }
    }
    for (const auto& [name, title] : titles)
      all.emplace_back(name + ".html", course_.lessons.page(name, forms));
    if (!forms.empty()) fs::remove_all(forms.parent_path());
  }

  std::string index() const {
    const Paper& paper = course_.paper;
    const std::string authors = joined(paper.authors, ", ");
    std::vector<Passage> passages;
    if (!authors.empty())
      passages.push_back(Paragraph{literal(authors + (paper.year.empty() ? "" : ", " + paper.year))});
    if (!paper.doi.empty())
      passages.push_back(
          Paragraph{"[" + literal("doi:" + paper.doi) + "](https://doi.org/" + paper.doi + ")"});
    passages.push_back(
        Paragraph{"Each equation of this paper is derived again from first principles, and compared with "
                  "what is printed."});
    Table counted_verdicts{.header = {"verdict", "rows"}, .rows = {}};
    for (const auto& [verdict, count] : ledger::counts(entries_))
      counted_verdicts.rows.push_back({verdict, std::to_string(count)});
    passages.push_back(counted_verdicts);
    BulletList links;
    for (const auto& [page, title] : course_.lessons.titles())
      links.items.push_back("[" + literal(title) + "](" + page + ".html)");
    if (has_exercises_) links.items.push_back("[The exercises](exercises.html)");
    if (course_.lessons.has_workbench)
      links.items.push_back("[The workbench](workbench.html): the block in motion");
    links.items.push_back("[The ledger](ledger.html): every equation, its derivation and its verdict");
    links.items.push_back("[The errata](errata.html)");
    passages.push_back(links);
    return rendered({paper.title}, passages, setting_);
  }

  std::string ledger_page() const {
    std::vector<Passage> passages{Paragraph{"[All pages](index.html)"}};
    std::string section;
    for (const Entry& entry : entries_) {
      if (entry.row.section != section) passages.push_back(Heading{literal(entry.row.section)});
      section = entry.row.section;
      passages.push_back(findings(entry, course_.paper));
      if (!entry.derivation || entry.proof.verdict == Verdict::error) continue;
      Page page(course_.paper);
      page.argue(*entry.derivation, entry.row.id);
      passages.insert(passages.end(), page.blocks().begin(), page.blocks().end());
    }
    Setting setting = setting_;
    setting.script = read_whole(data_folder() / "site" / "ledger.js");
    return rendered({"The ledger: " + course_.paper.title}, passages, setting);
  }

  const Course& course_;
  const bool has_exercises_;
  const SiteOptions& options_;
  Setting setting_;
  std::vector<Entry> entries_;
};

}  // namespace

int run_site(const std::function<const Course&()>& course, bool is_built_in, int argc, char** argv) {
  CLI::App app{"Writes everything about a paper as one static site: lessons, exercises, ledger, errata."};
  SiteOptions options{.out = {}, .judge = usual_judge(), .mathlive = {}, .is_built_in = is_built_in};
  app.add_option("OUT", options.out, "Folder for the pages. It is created if it does not exist.")->required();
  app.add_option("--judge", options.judge,
                 "Folder with judge.js and judge.wasm. Default: where .setup/wasm/build made them, or where "
                 "they are installed. Without them, the pages do not judge.");
  app.add_option("--mathlive", options.mathlive,
                 "The unpacked package of MathLive. Without it, formulas are typed as text.");
  app.add_flag("--scorm", options.is_scorm, "Make OUT/scorm.zip, too, a package of SCORM 1.2.");
  app.footer("Examples:\n  $ PROGRAM pages\n\n");
  return run_command(app, argc, argv, [&] {
    if (options.judge.empty())
      fmt::print(stderr, "The pages will not judge: judge.wasm is missing, which .setup/wasm/build makes.\n");
    Files files = Site(course(), options).files();
    make_output_folder(options.out);
    for (auto& [name, text] : files) name = options.out / name;
    write_together(files);
    if (options.is_scorm) pack_scorm(options.out);
    fmt::print("{}\n", (options.out / "index.html").string());
    return as_expected;
  });
}

}  // namespace rederive::site
