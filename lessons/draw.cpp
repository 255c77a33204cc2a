// Figures: gnuplot does the drawing, for lines, curves and lettering alike.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <lessons/render.hpp>
#include <sstream>

namespace rederive {
namespace {

constexpr auto terminals =
    "set encoding utf8\n"
    "set style line 1 lw 2 lc rgb '#1f5fa8'\nset style line 2 lw 2 lc rgb '#c0392b'\n"
    "set style line 3 lw 2 lc rgb '#2e8b57'\nset style line 4 lw 1 lc rgb '#888888'\n";

std::string terminal(const std::string& kind) {
  return kind == "pdf" ? "set terminal pdfcairo size 12cm,8.4cm font 'DejaVu Sans,10'\n"
                       : "set terminal svg size 480,336 font 'DejaVu Sans,Helvetica,sans-serif,14' "
                         "background 'white' name 'figure'\n";
}

bool has_gnuplot() {
  static const bool found = std::system("command -v gnuplot >/dev/null 2>&1") == 0;
  return found;
}

}  // namespace

std::string in_quotes(const std::filesystem::path& path) {
  std::string text = "'";
  for (char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::optional<std::filesystem::path> draw(const Figure& figure, const std::string& kind,
                                          const std::filesystem::path& folder) {
  if (!has_gnuplot()) return {};
  std::filesystem::create_directories(folder);
  const auto picture = folder / (figure.name + "." + kind);
  const auto partial = folder / fmt::format(".{}.{}.{}", figure.name, ::getpid(), kind);
  const auto script = folder / fmt::format(".{}.{}.gnuplot", figure.name, ::getpid());
  const auto log = folder / fmt::format(".{}.{}.log", figure.name, ::getpid());
  std::ofstream(script) << terminals << terminal(kind) << "set output '" << partial.filename().string()
                        << "'\n"
                        << figure.script << "\n";
  const int status = std::system(fmt::format("cd {} && gnuplot {} >{} 2>&1", in_quotes(folder),
                                             in_quotes(script.filename()), in_quotes(log.filename()))
                                     .c_str());
  std::ostringstream said;
  said << std::ifstream(log).rdbuf();
  std::filesystem::remove(script);
  std::filesystem::remove(log);
  std::error_code none;
  if (status != 0 || std::filesystem::file_size(partial, none) == 0)
    throw std::runtime_error("gnuplot could not draw " + figure.name + ": " + said.str());
  std::filesystem::rename(partial, picture);
  return picture;
}

}  // namespace rederive
