#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <derivations/program/csv.hpp>
#include <derivations/program/program.hpp>
#include <numerics/pictures/plot.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace rederive::numerics {
using namespace program;
namespace {

/// A file without a name that exists as long as this object. Its descriptor is larger than 2: a child process
/// uses 0, 1 and 2 itself.
struct Unnamed {
  std::FILE* file = std::tmpfile();
  int descriptor = file == nullptr ? -1 : ::fcntl(::fileno(file), F_DUPFD, 3);
  Unnamed() = default;
  Unnamed(const Unnamed&) = delete;
  Unnamed& operator=(const Unnamed&) = delete;
  ~Unnamed() {
    if (descriptor >= 0) ::close(descriptor);
    if (file != nullptr) std::fclose(file);
  }
  std::string name() const {
    if (descriptor < 0) throw std::runtime_error("cannot create a temporary file");
    return fmt::format("/dev/fd/{}", descriptor);
  }
};

/// Returns all that a stream contains. Throws BadInput if it cannot be read to its end.
std::string all_of(std::FILE* file) {
  std::string text;
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, n);
  if (std::ferror(file) != 0) throw BadInput("cannot read what gnuplot wrote");
  return text;
}

/// Returns the command that lets gnuplot draw what `script` says, its complaints going to another file. It
/// reads none of the user's settings: neither .gnuplot (-d) nor the environment, of which only what finds
/// programs and libraries is kept. The time zone would appear in the date of a PDF.
std::string command_to_draw(const std::string& script, const std::string& complaints) {
  return fmt::format(
      "exec env -i ${{PATH:+PATH=\"$PATH\"}} ${{LD_LIBRARY_PATH:+LD_LIBRARY_PATH=\"$LD_LIBRARY_PATH\"}} "
      "TZ=UTC0 gnuplot -d {} 2>{}",
      script, complaints);
}

void take_date_out(std::string& picture) {
  const std::string mark = "/CreationDate (D:", date = "19700101000000";
  const std::size_t at = picture.find(mark);
  if (!picture.starts_with("%PDF") || at == std::string::npos ||
      at + mark.size() + date.size() > picture.size())
    return;
  std::ranges::copy(date, picture.begin() + static_cast<std::ptrdiff_t>(at + mark.size()));
}

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '&') result += "\\\\";  // alone, it would be a phantom box in enhanced text
    if (c == '`') c = '\'';          // between two of them gnuplot would run a command
    result += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return result + "\"";
}

std::string terminal(const fs::path& file, double width, double height) {
  const std::string kind = file.extension().string();
  if (kind == ".svg")
    return fmt::format("set terminal svg size {:.0f},{:.0f} font 'DejaVu Sans,13' background '#ffffff'\n",
                       width, height);
  if (kind == ".png")
    return fmt::format("set terminal pngcairo size {:.0f},{:.0f} font 'DejaVu Sans,12'\n", width, height);
  if (kind == ".pdf")
    return fmt::format("set terminal pdfcairo size {:.2f}in,{:.2f}in font 'DejaVu Sans,12'\n", width / 96,
                       height / 96);
  throw std::invalid_argument("'" + printable_name(file) + "' must end in .svg, .png or .pdf");
}

void write_plot(const std::string& script, const fs::path& file, double width, double height) {
  const std::string begin = "set encoding utf8\n" + terminal(file, width, height);
  const auto refuse = [&](const std::string& why) {
    throw BadInput("cannot write '" + printable_name(file) + "': " + why);
  };
  std::optional<std::string> picture;
  try {
    picture = drawn_by_gnuplot(begin + script + "\n");
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  }
  if (!picture) refuse("gnuplot is not installed (package gnuplot-nox)");
  write_whole(file, *picture);
}

std::string data_block(const std::string& name, const Curve& curve) {
  std::string text = name + " << EOD\n";
  for (const auto& [x, y] : curve.points)
    text += std::isfinite(x) && std::isfinite(y) ? fmt::format("{:.10g} {:.10g}\n", x, y) : std::string("\n");
  return text + "EOD\n";
}

std::string drawn(const std::string& name, const Curve& curve) {
  const std::string colour = curve.grey ? "#909090" : "#000000";
  const std::string how =
      curve.marks ? fmt::format("with points pt {} ps 1.1 lc rgb '{}'", curve.symbol, colour)
                  : fmt::format("with lines lw {:.2g} dt {} lc rgb '{}'", curve.width, curve.dash, colour);
  return fmt::format("{} using 1:2 {} {}", name, how,
                     curve.title.empty() ? "notitle" : "title " + quoted(curve.title));
}

std::string range_of(const std::pair<double, double>& range) {
  return range.first == range.second ? "[*:*]" : fmt::format("[{:.10g}:{:.10g}]", range.first, range.second);
}

std::string panel_script(const Panel& panel, std::size_t index) {
  std::string text, plots;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    if (panel.curves[i].points.empty()) continue;
    const std::string name = fmt::format("$p{}c{}", index, i);
    text += data_block(name, panel.curves[i]);
    plots += (plots.empty() ? "plot " : ", ") + drawn(name, panel.curves[i]);
  }
  text += "set title " + quoted(panel.title) + "\nset xlabel " + quoted(panel.x_label) + "\nset ylabel " +
          quoted(panel.y_label) + "\nset key " + panel.key +
          " Left reverse font ',10' samplen 3 spacing 1.1\n";
  text += "set xrange " + range_of(panel.x_range) + "\nset yrange " + range_of(panel.y_range) + "\n";
  return text + plots + "\n";
}

int lines_in(const std::string& text) {
  return 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

std::optional<std::string> drawn_by_gnuplot(const std::string& script) {
  const Unnamed commands, complaints;
  std::fwrite(script.data(), 1, script.size(), commands.file);
  if (std::fflush(commands.file) != 0 || std::ferror(commands.file) != 0)
    throw BadInput("cannot write a temporary file");
  std::FILE* pipe = ::popen(command_to_draw(commands.name(), complaints.name()).c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("gnuplot cannot be run");
  std::string picture = all_of(pipe);
  const int status = ::pclose(pipe);
  if (status == 127 * 256) return {};
  std::rewind(complaints.file);
  if (status != 0 || picture.empty()) throw std::runtime_error("gnuplot failed: " + all_of(complaints.file));
  take_date_out(picture);
  return picture;
}

void check_plot_name(const fs::path& file) { (void)terminal(file, 0, 0); }

void draw(const Plot& figure, const fs::path& file) {
  const auto count = figure.panels.size();
  const double columns = count > 1 ? 2 : 1, rows = std::ceil(static_cast<double>(count) / columns);
  const double caption = 26 + 17 * lines_in(figure.caption);
  const double width = count > 1 ? 1180 : 860, height = (count > 1 ? 450 : 600) * rows + caption;
  std::string script = "set border 3\nset tics nomirror\nset grid lc rgb '#d8d8d8' lt 1 lw 0.5\n";
  script += fmt::format("set label 1 {} at screen 0.02, screen {:.6f} left font ',10'\n",
                        quoted(figure.caption), (caption - 20) / height);
  script += fmt::format(
      "set multiplot layout {:.0f},{:.0f} margins screen {:.3g},0.98,{:.6f},{:.6f} "
      "spacing screen 0.085,{:.6f}\n",
      rows, columns, count > 1 ? 0.075 : 0.09, (caption + 50) / height, 1 - 34 / height, 112 / height);
  for (std::size_t i = 0; i < count; ++i) {
    script += panel_script(figure.panels[i], i);
    if (i == 0) script += "unset label 1\n";
  }
  write_plot(script + "unset multiplot\n", file, width, height);
}

void draw(const Shades& shades, const fs::path& file) {
  // 0 white, no impact dark, one impact middle, more impacts light; to theta > 0 hatched by a darker edge.
  std::string script = "$map << EOD\n";
  std::set<int> present;
  for (std::size_t i = 0; i < shades.x.size(); ++i) {
    for (std::size_t j = 0; j < shades.codes[i].size(); ++j) {
      script += fmt::format("{:.10g} {:.10g} {}\n", shades.x[i], shades.y[j], shades.codes[i][j]);
      present.insert(shades.codes[i][j]);
    }
    script += "\n";
  }
  script +=
      "EOD\nset palette defined (-9 '#e4e4e4', -5 '#d0d0d0', -3 '#b4b4b4', -1 '#303030', -0.4 '#303030', "
      "-0.4 "
      "'#ffffff', 0.4 '#ffffff', 0.4 '#585858', 1 '#585858', 2 '#8c8c8c', 4 '#bcbcbc', 9 '#e4e4e4')\n";
  script +=
      "set cbrange [-9:9]\nset cblabel 'code = side (impacts + 1), 0 = safe' offset 1.5\nset border 3\nset "
      "tics "
      "nomirror out\n";
  script +=
      "set xlabel " + quoted(shades.x_label) + "\nset ylabel " + quoted(shades.y_label) + "\nunset key\n";
  script += "plot $map using 1:2:3 with image pixels\n";
  write_plot(script, file, 960, 640);
}

std::string figure_data(const Plot& figure) {
  std::string text = "panel,curve,x,y\n";
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves)
      for (const auto& [x, y] : curve.points)
        if (std::isfinite(x) && std::isfinite(y))
          text += fmt::format("{},{},{:.17g},{:.17g}\n", csv_cell(panel.title, CsvQuotes::always),
                              csv_cell(curve.title, CsvQuotes::always), x, y);
  return text;
}

}  // namespace rederive::numerics
