#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/language/text.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/program.hpp>
#include <lessons/illustrations/drawings.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/papers/markdown_lesson.hpp>
#include <regex>

namespace rederive::papers {
using namespace language;
using namespace emit;
using namespace program;
using namespace paper;
using namespace page;
namespace fs = std::filesystem;

namespace {

/// The arguments of a table or a plot: the symbol that varies, its range and number of values, and the
/// values of the other symbols.
struct Series {
  std::string name;
  double first = 0, last = 1;
  int count = 0;
  Values others;
};

class Reader {
 public:
  Reader(const Paper& paper, const fs::path& file, int number, Ask ask)
      : paper_(paper), name_(printable_name(file.filename())), ask_(std::move(ask)) {
    lesson_.lesson.number = number;
    std::istringstream stream(read_whole(file));
    for (std::string line; std::getline(stream, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      lines_.push_back(line);
    }
  }

  MarkdownLesson lesson() {
    read_front();
    while (at_ < lines_.size()) read_block();
    if (lesson_.lesson.steps.empty()) fail(1, "the lesson has no step; a step begins with ## and a heading");
    return std::move(lesson_);
  }

 private:
  using Write = std::function<void(Page&)>;

  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw BadInput(fmt::format("{}:{}: {}", name_, line, what));
  }
  const std::string& line() const { return lines_[at_]; }
  bool begins_block() const {
    return line().starts_with("#") || line().starts_with("{{") || line().starts_with("```") ||
           line().starts_with("|") || line().starts_with("- ");
  }

  void read_front() {
    for (; at_ < lines_.size() && !line().starts_with("## "); ++at_) {
      for (const auto& [label, text] : {std::pair("# ", &lesson_.lesson.title),
                                        {"Teaches: ", &lesson_.lesson.teaches},
                                        {"Builds on: ", &lesson_.lesson.builds_on}})
        if (line().starts_with(label)) *text = trimmed(line().substr(std::string_view(label).size()));
    }
    if (lesson_.lesson.title.empty()) fail(1, "the lesson must begin with # and its title");
  }

  void read_block() {
    const std::size_t begin = at_ + 1;  // as editors count
    if (trimmed(line()).empty()) {
      ++at_;
    } else if (line().starts_with("## ")) {
      lesson_.lesson.steps.push_back({trimmed(line().substr(3)), write_all()});
      ++at_;
    } else if (line().starts_with("#")) {
      fail(begin, "a heading of a step begins with ## and a blank; there are no others");
    } else if (line().starts_with("{{")) {
      add(begin, directive(trimmed(line()), begin));
      ++at_;
    } else if (line().starts_with("```")) {
      std::vector<std::string> commands;
      for (++at_; at_ < lines_.size() && !line().starts_with("```"); ++at_) commands.push_back(line());
      if (at_ == lines_.size()) fail(begin, "the code that begins here has no end: ```");
      ++at_;
      add(begin, [commands](Page& page) { page.commands(commands); });
    } else if (line().starts_with("|")) {
      read_table(begin);
    } else if (line().starts_with("- ")) {
      std::vector<std::string> items;
      for (; at_ < lines_.size() && !trimmed(line()).empty(); ++at_)
        if (line().starts_with("- "))
          items.push_back(line().substr(2));
        else
          items.back() += " " + trimmed(line());
      for (const std::string& item : items) check_sentences(begin, item);
      add(begin, [items](Page& page) { page.points(items); });
    } else {
      std::string text;
      for (; at_ < lines_.size() && !trimmed(line()).empty() && !begins_block(); ++at_) text += line() + "\n";
      check_sentences(begin, text);
      add(begin, [text](Page& page) { page.say(text); });
    }
  }

  void read_table(std::size_t begin) {
    std::vector<std::vector<std::string>> rows;
    for (; at_ < lines_.size() && line().starts_with("|"); ++at_) {
      std::istringstream cells(line().substr(1));
      std::vector<std::string> row;
      for (std::string cell; std::getline(cells, cell, '|');)
        if (!trimmed(cell).empty() || !cells.eof()) row.push_back(trimmed(cell));
      const auto is_rule = [](const std::string& cell) {
        return cell.find_first_not_of("-:") == cell.npos && !cell.empty();
      };
      if (!std::ranges::all_of(row, is_rule)) rows.push_back(row);
    }
    const std::vector<std::string> header = rows.front();
    rows.erase(rows.begin());
    for (const auto& row : rows)
      for (const std::string& cell : row) check_sentences(begin, cell);
    for (const auto& row : rows)
      if (row.size() != header.size()) fail(begin, "the rows of this table have different numbers of cells");
    add(begin, [header, rows](Page& page) { page.table(header, rows); });
  }

  /// Refuses mathematics and marks that cannot be read.
  void check_sentences(std::size_t line, const std::string& text) const {
    try {
      for (const std::string& paragraph : paragraphs(text))
        for (const Span& span : spans(paragraph))
          if (span.kind == Span::Kind::math) (void)parse_math(line, span.text);
    } catch (const std::invalid_argument& error) {
      fail(line, error.what());
    }
  }
  Relation parse_math(std::size_t line, const std::string& text) const {
    try {
      return parse_statement(text, paper_.symbols);
    } catch (const SyntaxError& error) {
      fail(line, explain(error, text, paper_.symbols));
    }
  }

  /// Adds a passage to the latest step. What cannot be written is an error of its line.
  void add(std::size_t line, Write write) {
    if (lesson_.lesson.steps.empty()) fail(line, "this comes before the first step, which begins with ##");
    parts_.back()->emplace_back([this_name = name_, line, write = std::move(write)](Page& page) {
      try {
        write(page);
      } catch (const SyntaxError& error) {
        throw BadInput(
            fmt::format("{}:{}: the mathematics cannot be read: {}", this_name, line, error.what()));
      } catch (const std::invalid_argument& error) {
        throw BadInput(fmt::format("{}:{}: {}", this_name, line, error.what()));
      } catch (const std::out_of_range& error) {
        throw BadInput(fmt::format("{}:{}: {}", this_name, line, error.what()));
      }
    });
  }

  Write write_all() {
    parts_.push_back(std::make_shared<std::vector<Write>>());
    return [parts = parts_.back()](Page& page) {
      for (const Write& write : *parts) write(page);
    };
  }

  Write directive(const std::string& text, std::size_t line) {
    static const std::regex form(R"(\{\{\s*(\w+)\s*(.*?)\s*\}\})");
    static const std::vector<std::string> words{"argue", "result", "verdict", "ask", "table", "plot"};
    std::smatch match;
    if (!std::regex_match(text, match, form))
      fail(line, "a directive has a line of its own, such as {{argue 1}}");
    const std::string word = match[1], rest = match[2];
    if (word == "argue") return of_row(rest, line, [](Page& page, const std::string& id) { page.argue(id); });
    if (word == "result")
      return of_row(rest, line, [](Page& page, const std::string& id) { page.result(id); });
    if (word == "verdict")
      return of_row(rest, line, [](Page& page, const std::string& id) { page.verdict(id); });
    if (word == "ask")
      return [ask = ask_, rest](Page& page) {
        for (const Passage& passage : ask(rest)) page.add(passage);
      };
    if (word == "table" || word == "plot") return of_function(word == "plot", rest, line);
    fail(line, fmt::format("there is no directive '{}'{}; there are {}", printable_line(word),
                           did_you_mean(nearest(word, words)), joined(words, ", ")));
  }

  template <class Show>
  Write of_row(const std::string& id, std::size_t line, const Show& show) {
    const std::vector<Row>& rows = rows_of(paper_);
    if (std::ranges::find(rows, id, &Row::id) == rows.end())
      fail(line, "there is no row '" + printable_line(id) + "' in equations.toml");
    if (std::ranges::find(lesson_.rows, id) == lesson_.rows.end()) lesson_.rows.push_back(id);
    return [id, show](Page& page) { show(page, id); };
  }

  Write of_function(bool is_plot, const std::string& text, std::size_t line) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string name = text.substr(0, blank);
    const Emission emission = paper_.emission();
    const auto function = std::ranges::find(emission.functions, name, &EmittedFunction::name);
    if (function == emission.functions.end())
      fail(line, "there is no function '" + printable_line(name) + "' in functions.toml");
    const Series series = series_in(text.substr(blank), *function, line, is_plot ? 121 : 5);
    const std::string figure = fmt::format("lesson-{:02}-{}-{}", lesson_.lesson.number, name, line);
    const EmittedFunction chosen = *function;
    return [chosen, series, is_plot, figure](Page& page) {
      const auto value = [&](double x) -> double {
        Values values = series.others;
        values[series.name] = fmt::format("{}", x);
        try {
          return page.number_of(chosen.value, values);
        } catch (const std::exception&) {  // a pole, or no real value: a gap
          return std::nan("");
        }
      };
      const auto points = illustrations::sampled(series.first, series.last, series.count, value);
      const Symbol& symbol = *page.paper().symbols.find(series.name);
      if (!is_plot) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& [x, y] : points)
          rows.push_back({fmt::format("{:.6g}", x), fmt::format("{:.6g}", y)});
        page.table({"$" + series.name + "$", literal(chosen.brief)}, rows);
        return;
      }
      page.figure(illustrations::plot(figure, literal(chosen.brief),
                                      fmt::format("set xlabel '{}'", symbol.unicode), {{points, ""}}));
    };
  }

  /// Reads "x = 0:1:5, a = 2": `count` values if no number is given.
  Series series_in(const std::string& text, const EmittedFunction& function, std::size_t line,
                   int count) const {
    Series series;
    series.count = count;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
      const std::size_t sign = part.find('=');
      if (sign == part.npos) fail(line, "'" + trimmed(part) + "' must be a value such as a = 2 or x = 0:1");
      const std::string name = trimmed(part.substr(0, sign)), value = trimmed(part.substr(sign + 1));
      if (std::ranges::find(function.arguments, name, name_of) == function.arguments.end())
        fail(line, "'" + printable_line(name) + "' is not an argument of " + function.name);
      static const std::regex range(R"(([^:]+):([^:]+)(?::(\d{1,3}))?)");
      std::smatch match;
      if (!std::regex_match(value, match, range)) {
        series.others[name] = value;
        continue;
      }
      if (!series.name.empty()) fail(line, "only one argument can have a range");
      series.name = name;
      const auto end = [&](const std::string& one) {
        const Page page(paper_);
        try {
          return page.number_of(lower(parse(one, paper_.symbols), paper_.symbols));
        } catch (const SyntaxError& error) {
          fail(line, explain(error, one, paper_.symbols));
        } catch (const std::invalid_argument&) {
          fail(line, "the ends of the range of " + name + " must be numbers");
        }
      };
      series.first = end(match[1]);
      series.last = end(match[2]);
      if (match[3].matched) series.count = std::max(2, std::stoi(match[3]));
    }
    if (series.name.empty())
      fail(line, "one argument of " + function.name + " needs a range, such as x = 0:1");
    for (const SymbolExpression& argument : function.arguments)
      if (name_of(argument) != series.name && !series.others.contains(name_of(argument)))
        fail(line, "the argument " + name_of(argument) + " of " + function.name + " has no value");
    return series;
  }

  const Paper& paper_;
  std::string name_;
  Ask ask_;
  std::vector<std::string> lines_;
  std::size_t at_ = 0;
  MarkdownLesson lesson_;
  std::vector<std::shared_ptr<std::vector<Write>>> parts_;  ///< of the steps
};

}  // namespace

MarkdownLesson read_lesson(const Paper& paper, const fs::path& file, int number, const Ask& ask) {
  return Reader(paper, file, number, ask).lesson();
}

std::vector<fs::path> lesson_files(const fs::path& folder) {
  std::vector<fs::path> files;
  constexpr int most = 99;
  for (int number = 1; number <= most; ++number) {
    const fs::path file = folder / fmt::format("lesson-{:02}.md", number);
    if (!fs::exists(file)) continue;
    if (static_cast<int>(files.size()) != number - 1)
      throw BadInput(printable_name(file) + ": the lesson before it is missing");
    files.push_back(file);
  }
  return files;
}

}  // namespace rederive::papers
