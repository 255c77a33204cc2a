// The main that all lessons share: one set of flags.
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <derivations/program/command_line.hpp>
#include <derivations/program/data_folder.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

namespace rederive::page {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
namespace {

namespace fs = std::filesystem;

struct Flags {
  bool list = false, quiet = false;
  std::optional<int> step;
  std::string format = "unicode", out, forms;
};

const std::map<std::string, Format> formats{{"unicode", Format::unicode},   {"plain", Format::plain},
                                            {"latex", Format::latex},       {"markdown", Format::markdown},
                                            {"notebook", Format::notebook}, {"html", Format::html}};

/// The page of the lesson with that number; "" if there is none.
std::string page_of(const std::vector<std::string>& pages, int number) {
  return number < 1 || number > static_cast<int>(pages.size()) ? ""
                                                               : pages[static_cast<std::size_t>(number - 1)];
}

std::size_t terminal_width() {
  winsize size{};
  if (::isatty(1) == 0 || ::ioctl(1, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::clamp<std::size_t>(size.ws_col, 40, 100);
}

/// Reads the forms of exercises that `exercises serve` writes for a page, and the script that serves them.
void read_forms(const std::string& file, Setting& setting) {
  const auto json = nlohmann::json::parse(read_whole(file));
  setting.script = json.at("script");
  for (const auto& form : json.at("forms"))
    setting.forms.push_back({form.at("id"), form.at("lesson"), form.at("html")});
}

Setting setting_from(const Paper& paper, const Lesson& lesson, const LessonSeries& series,
                     const Flags& flags) {
  Setting setting{.paper = paper};
  setting.lesson = lesson.number;
  setting.format = formats.at(flags.format);
  setting.width = terminal_width();
  setting.lively = flags.out.empty() && is_lively(1) && setting.format == Format::unicode;
  setting.beside = !flags.out.empty() && becomes_ordinary_file(flags.out);
  if (setting.beside) *setting.figures = fs::absolute(flags.out).parent_path();
  setting.lessons = series.pages;
  setting.previous = page_of(series.pages, lesson.number - 1);
  setting.next = page_of(series.pages, lesson.number + 1);
  setting.module = is_module_there();
  setting.coverage = series.coverage;
  if (!flags.forms.empty()) read_forms(flags.forms, setting);
  return setting;
}

/// The verdict on each equation of the lesson, one a line; 1 if one is not as expected.
int verdicts(const Lesson& lesson, const Setting& setting, std::string& text) {
  int code = as_expected;
  for (const auto& id : setting.equations_of(lesson.number)) {
    const Entry entry = judged(setting.paper, id);
    const bool expected = entry.row.expected == entry.proof.verdict;
    if (!expected) code = not_as_expected;
    text += headline(entry) + (expected ? "" : "   not as expected: " + to_string(entry.row.expected)) + "\n";
  }
  return code;
}

std::string contents(const Lesson& lesson) {
  std::string text = fmt::format("Lesson {}. {}\n", lesson.number, lesson.title);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    text += fmt::format("{:3}  {}\n", i + 1, lesson.steps[i].heading);
  return text;
}

/// The rows that the lesson covers first and shows nowhere, for links to them: what was derived, or what is
/// printed of a definition.
std::vector<Passage> other_rows(const Lesson& lesson, const Setting& setting,
                                const std::vector<Passage>& shown) {
  const auto is_about = [](const std::string& id) {
    return [&id](const Passage& passage) {
      const auto* formula = std::get_if<Formula>(&passage);
      const auto* found = std::get_if<Findings>(&passage);
      return (formula != nullptr && formula->number == id) || (found != nullptr && found->row == id);
    };
  };
  std::vector<Passage> rest;
  for (const std::string& id : setting.equations_of(lesson.number)) {
    if (lesson_with(id, setting.coverage) != lesson.number || std::ranges::any_of(shown, is_about(id)) ||
        std::ranges::any_of(rest, is_about(id)))
      continue;
    const Entry entry = judged(setting.paper, id);
    if (!entry.row.fault.empty()) continue;
    rest.push_back(Formula{entry.derivation ? derived_relation(*entry.derivation, setting.paper.symbols)
                                            : parse_relation(entry.row.claim(), setting.paper.symbols),
                           id});
  }
  if (!rest.empty())
    rest.insert(rest.begin(), {Heading{"Other equations of this lesson"},
                               Paragraph{"The steps to each: `" + command_on(setting.paper, "ledger show") +
                                         "` and its number."}});
  return rest;
}

/// Writes each part as soon as it is computed.
void write_lesson(const Lesson& lesson, const Flags& flags, const Setting& setting,
                  const std::function<void(const std::string&)>& put) {
  const auto renderer = make_renderer(setting);
  Front front{fmt::format("Lesson {}. {}", lesson.number, lesson.title)};
  for (const auto& [label, words] : {std::pair("Teaches", lesson.teaches),
                                     {"Builds on", lesson.builds_on},
                                     {"Equations", numbers_of(setting.equations_of(lesson.number))}})
    if (!words.empty()) front.about.emplace_back(label, words);
  if (!flags.step) put(renderer->begin(front));
  std::vector<Passage> shown;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const int number = static_cast<int>(i + 1);
    if (flags.step && *flags.step != number) continue;
    Page page(setting.paper);
    lesson.steps[i].write(page);
    std::vector<Passage> step = page.blocks();
    step.insert(step.begin(), Heading{lesson.steps[i].heading, number});
    put(renderer->passages(step));
    shown.insert(shown.end(), step.begin(), step.end());
  }
  if (!flags.step && setting.format == Format::html)
    put(renderer->passages(other_rows(lesson, setting, shown)));
  if (!flags.step || setting.format == Format::notebook) put(renderer->end());
}

int run(const Paper& paper, const Lesson& lesson, const LessonSeries& series, const Flags& flags) {
  if (flags.step && (flags.list || flags.quiet))
    throw BadInput("--step cannot be used with --list or --quiet, which are about the whole lesson");
  if (flags.step && (*flags.step < 1 || *flags.step > static_cast<int>(lesson.steps.size())))
    throw BadInput(
        fmt::format("--step must be from 1 to {1}, but it is {0}", *flags.step, lesson.steps.size()));
  if (!flags.out.empty() && !fs::is_directory(fs::absolute(flags.out).parent_path()))
    throw BadInput("--out " + printable_name(flags.out) + ": there is no such folder");
  const Setting setting = setting_from(paper, lesson, series, flags);
  std::string text;
  int code = as_expected;
  const auto put = [&](const std::string& part) {
    text += part;
    if (!flags.out.empty()) return;
    std::fwrite(part.data(), 1, part.size(), stdout);
    std::fflush(stdout);
  };
  if (flags.list) {
    put(contents(lesson));
  } else if (flags.quiet) {
    std::string lines;
    code = verdicts(lesson, setting, lines);
    put(lines);
  } else {
    write_lesson(lesson, flags, setting, put);
    if (!setting.beside && !setting.figures->empty() && ::isatty(2) != 0)
      std::fprintf(stderr, "The figures are in %s\n", printable_name(*setting.figures).c_str());
  }
  if (!flags.out.empty()) write_whole(flags.out, text);
  return code;
}

}  // namespace

std::vector<std::string> all_lessons() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(loaded_from().parent_path()))
    if (file.path().filename().string().starts_with("lesson-") && !file.path().has_extension())
      names.push_back(file.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::map<std::string, std::string> titles_of_lessons() {
  std::map<std::string, std::string> titles;
  for (const std::string& lesson : all_lessons()) {
    const Said said = said_by(in_quotes(loaded_from().parent_path() / lesson) + " --list");
    if (said.status != 0) throw std::runtime_error(lesson + " failed");
    titles[lesson] = said.text.substr(0, said.text.find('\n'));
  }
  return titles;
}

std::vector<std::string> Setting::equations_of(int lesson) const {
  const auto found = coverage.find(lesson);
  return found == coverage.end() ? std::vector<std::string>() : found->second;
}

std::unique_ptr<Renderer> make_renderer(const Setting& setting) {
  switch (setting.format) {
    case Format::latex:
      return latex_renderer(setting);
    case Format::markdown:
    case Format::notebook:
      return markdown_renderer(setting);
    case Format::html:
      return html_renderer(setting);
    default:
      return text_renderer(setting);
  }
}

std::string Renderer::passages(const std::vector<Passage>& passages) {
  return joined(passages, "", [this](const Passage& passage) {
    return "\n" + std::visit([this](const auto& part) { return render(part); }, passage);
  });
}

std::string Renderer::flat(const std::string& sentence) {
  return joined(spans(sentence), "", [this](const Span& span) {
    return span.kind == Span::Kind::math ? math(parse_statement(span.text, symbols())) : styled(span);
  });
}

std::vector<std::string> Renderer::flat(const std::vector<std::string>& sentences) {
  std::vector<std::string> texts;
  for (const std::string& sentence : sentences) texts.push_back(flat(sentence));
  return texts;
}

std::string Renderer::render(const Buttons& part) { return render(Paragraph{part.words}); }

std::string Renderer::render(const ExerciseForm& part) {
  std::vector<Passage> all{Paragraph{"*Exercise: " + literal(part.title) + "*"}};
  all.insert(all.end(), part.statement.begin(), part.statement.end());
  BulletList choices;
  for (const auto& [value, sentence] : part.choices) choices.items.push_back(value + ") " + sentence);
  all.push_back(part.choices.empty() ? Passage(Paragraph{part.prompt}) : Passage(choices));
  return passages(all);
}

std::string rendered(const Front& front, const std::vector<Passage>& passages, const Setting& setting) {
  const auto renderer = make_renderer(setting);
  const std::string begin = renderer->begin(front), middle = renderer->passages(passages);
  return begin + middle + renderer->end();
}

LessonSeries built_in_series(const Paper& paper) { return {all_lessons(), read_coverage(paper)}; }

namespace {

std::string lesson_as(const std::string& format, const fs::path& forms, const Paper& paper,
                      const Lesson& lesson, const LessonSeries& series) {
  Flags flags;
  flags.format = format;
  flags.forms = forms;
  std::string text;
  write_lesson(lesson, flags, setting_from(paper, lesson, series, flags),
               [&](const std::string& part) { text += part; });
  return text;
}

}  // namespace

std::string lesson_page(const Paper& paper, const Lesson& lesson, const LessonSeries& series,
                        const fs::path& forms) {
  return lesson_as("html", forms, paper, lesson, series);
}

std::string lesson_in_markdown(const Paper& paper, const Lesson& lesson, const LessonSeries& series) {
  return lesson_as("markdown", {}, paper, lesson, series);
}

int run_lesson(const Paper& paper, const Lesson& lesson, const std::function<LessonSeries()>& series,
               int argc, char** argv) {
  std::string teaches = lesson.teaches;
  std::erase(teaches, '*');  // which sets words in italics
  CLI::App app{fmt::format("Lesson {}. {}\n{}", lesson.number, lesson.title, teaches)};
  Flags flags;
  app.add_flag("--list", flags.list, "List the steps of this lesson.");
  app.add_option("--step", flags.step,
                 "Show step N alone, from 1 to the number of steps. Default: all steps.")
      ->check(whole_number)
      ->type_name("N");
  app.add_option("--format", flags.format, "Choose the format. Default: unicode.")
      ->check(CLI::IsMember({"unicode", "plain", "latex", "markdown", "notebook", "html"}))
      ->type_name("FORMAT");
  app.add_flag("--quiet", flags.quiet, "Show the verdicts of the ledger alone.");
  app.add_option("--out", flags.out, "Write to this file. Default: standard output.")
      ->check(file_name)
      ->type_name("FILE");
  app.add_option("--forms", flags.forms, "Put these forms of exercises into a web page.")->group("");
  const std::string program = argc > 0 ? printable_name(fs::path(argv[0]).filename()) : "lesson";
  app.footer(
      fmt::format("Examples:\n  $ {0} --step 2\n  $ {0} --format html --out lesson.html\n\n", program));
  return run_command(app, argc, argv,
                     [&] { return run(paper, lesson, flags.list ? LessonSeries() : series(), flags); });
}

}  // namespace rederive::page
