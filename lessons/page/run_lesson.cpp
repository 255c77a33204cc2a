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
#include <optional>

namespace rederive {
namespace {

namespace fs = std::filesystem;

struct Flags {
  bool list = false, quiet = false;
  std::optional<int> step;
  std::string format = "unicode", out;
};

const std::map<std::string, Format> formats{{"unicode", Format::unicode},   {"plain", Format::plain},
                                            {"latex", Format::latex},       {"markdown", Format::markdown},
                                            {"notebook", Format::notebook}, {"html", Format::html}};

/// The lesson before (-1) or after (+1) this one.
std::string neighbour(const std::vector<std::string>& names, int distance) {
  const auto here =
      std::find(names.begin(), names.end(), loaded_from().filename().string()) - names.begin() + distance;
  return here < 0 || here >= static_cast<std::ptrdiff_t>(names.size())
             ? ""
             : names[static_cast<std::size_t>(here)];
}

std::size_t terminal_width() {
  winsize size{};
  if (::isatty(1) == 0 || ::ioctl(1, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::clamp<std::size_t>(size.ws_col, 40, 100);
}

Setting setting_from(const Paper& paper, const Flags& flags) {
  Setting setting{.paper = paper};
  setting.format = formats.at(flags.format);
  setting.width = terminal_width();
  setting.lively = flags.out.empty() && is_lively(1) && setting.format == Format::unicode;
  setting.beside = !flags.out.empty() && becomes_ordinary_file(flags.out);
  if (setting.beside) *setting.figures = fs::absolute(flags.out).parent_path();
  setting.lessons = all_lessons();
  setting.previous = neighbour(setting.lessons, -1);
  setting.next = neighbour(setting.lessons, +1);
  setting.module = is_module_there();
  if (!flags.list) setting.coverage = read_coverage(paper);
  return setting;
}

/// The verdict on each equation of the lesson, one a line; 1 if one is not as expected.
int verdicts(const Lesson& lesson, const Setting& setting, std::string& text) {
  int code = as_expected;
  for (const auto& id : setting.equations_of(lesson)) {
    const Entry entry = judged(setting.paper, id);
    const bool expected = entry.row.expected == to_string(entry.proof.verdict);
    if (!expected) code = not_as_expected;
    text += headline(entry) + (expected ? "" : "   not as expected: " + entry.row.expected) + "\n";
  }
  return code;
}

std::string contents(const Lesson& lesson) {
  std::string text = fmt::format("Lesson {}. {}\n", lesson.number, lesson.title);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    text += fmt::format("{:3}  {}\n", i + 1, lesson.steps[i].heading);
  return text;
}

/// Hands on each part as soon as it is there.
void write_lesson(const Lesson& lesson, const Flags& flags, const Setting& setting,
                  const std::function<void(const std::string&)>& put) {
  const auto renderer = make_renderer(setting);
  if (!flags.step) put(renderer->begin(lesson));
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (flags.step && *flags.step != static_cast<int>(i + 1)) continue;
    Page page(setting.paper);
    lesson.steps[i].write(page);
    put(renderer->step(i + 1, lesson.steps[i].heading, page));
  }
  if (!flags.step || flags.format == "notebook") put(renderer->end(lesson));
}

int run(const Paper& paper, const Lesson& lesson, const Flags& flags) {
  if (flags.step && (flags.list || flags.quiet))
    throw BadInput("--step cannot be used with --list or --quiet, which are about the whole lesson");
  if (flags.step && (*flags.step < 1 || *flags.step > static_cast<int>(lesson.steps.size())))
    throw BadInput(
        fmt::format("--step must be from 1 to {1}, but it is {0}", *flags.step, lesson.steps.size()));
  if (!flags.out.empty() && !fs::is_directory(fs::absolute(flags.out).parent_path()))
    throw BadInput("--out " + printable_name(flags.out) + ": there is no such folder");
  const Setting setting = setting_from(paper, flags);
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

std::vector<std::string> Setting::equations_of(const Lesson& lesson) const {
  const auto found = coverage.find(lesson.number);
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

int run_lesson(const Paper& paper, const Lesson& lesson, int argc, char** argv) {
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
  const std::string program = argc > 0 ? printable_name(fs::path(argv[0]).filename()) : "lesson";
  app.footer(
      fmt::format("Examples:\n  $ {0} --step 2\n  $ {0} --format html --out lesson.html\n\n", program));
  return run_command(app, argc, argv, [&] { return run(paper, lesson, flags); });
}

}  // namespace rederive
