// What other programs contribute to a page: the pictures of gnuplot, the output of a command, the workbench.
#include <fmt/format.h>

#include <cstdio>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/program.hpp>
#include <lessons/page/render.hpp>
#include <numerics/pictures/plot.hpp>

namespace rederive::page {
using namespace program;
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

}  // namespace

Said said_by(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start a process");
  Said said;
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) said.text.append(buffer, n);
  const bool is_whole = std::ferror(pipe) == 0;
  said.status = ::pclose(pipe);
  if (!is_whole) throw BadInput("cannot read the output of a program");
  return said;
}

std::string in_quotes(const std::filesystem::path& path) {
  std::string text = "'";
  for (char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::optional<std::string> drawn(const Figure& figure, const std::string& kind) {
  return numerics::drawn_by_gnuplot(terminals + terminal(kind) + figure.script + "\n");
}

std::optional<std::filesystem::path> draw(const Figure& figure, const std::string& kind,
                                          std::filesystem::path& folder) {
  const auto picture = drawn(figure, kind);
  if (!picture) return {};
  if (folder.empty()) folder = private_folder("figures");
  const auto file = folder / (figure.name + "." + kind);
  write_whole(file, *picture);
  return file;
}

std::string workbench_element(const std::string& options) {
  const auto opening = read_if_there(data_folder() / "workbench_opening.html"),
             element = read_if_there(data_folder() / "workbench_element.html");
  if (!opening || !element)
    throw std::runtime_error("the workbench is not built: run cmake --build build --target workbench");
  return fmt::format(fmt::runtime(*opening), escaped(options)) + *element;
}

}  // namespace rederive::page
