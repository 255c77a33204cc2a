#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <derivations/program/program.hpp>
#include <numerics/pictures/gnuplot.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

/// A file that has no name and goes with this object; behind 0, 1 and 2, which a child has for itself.
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

/// Returns all that comes out of a stream. Throws BadInput if it cannot be read to its end.
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

}  // namespace rederive::numerics
