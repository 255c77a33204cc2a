// Where grade writes to: looked at before anything is judged, and written whole or not at all.
#include <unistd.h>

#include <derivations/program/program.hpp>
#include <lessons/exercises/grading.hpp>
#include <set>

namespace rederive::classroom {
namespace {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder, const std::string& refused) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw BadInput(refused + "there is no folder '" + printable_name(folder) + "' to write into");
  if (::access(folder.c_str(), W_OK) != 0)
    throw BadInput(refused + "the folder '" + printable_name(folder) + "' may not be written to");
}

void check_file(const fs::path& file, const std::string& students, std::set<fs::path>& others) {
  std::error_code error;
  if (file.empty()) return;
  const std::string name = printable_name(file);
  if (becomes_ordinary_file(file)) {
    const fs::path target = ordinary_target(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    check_folder(folder, "cannot write '" + name + "': ");
    const auto inside =
        fs::weakly_canonical(fs::absolute(folder), error).lexically_relative(fs::canonical(students, error));
    if (!inside.empty() && *inside.begin() != ".." && inside != ".")
      throw BadInput("cannot write '" + name + "': it is in the folder of a student");
  }
  if (!others.insert(fs::weakly_canonical(fs::absolute(file), error)).second)
    throw BadInput("'" + name + "' is named for two outputs");
}

void check_feedback(const GradeFlags& flags, const std::set<fs::path>& files) {
  if (flags.feedback.empty()) return;
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(flags.feedback), error);
  if (!folder.has_filename()) folder = folder.parent_path();  // "pages/"
  const std::string refused = "cannot write into '" + printable_line(flags.feedback) + "': ";
  const bool is_there = fs::exists(folder, error);
  if (is_there && !fs::is_directory(folder, error)) throw BadInput(refused + "it is not a folder");
  const fs::path place = is_there ? folder : folder.parent_path();
  check_folder(place, refused);
  const auto inside = folder.lexically_relative(fs::canonical(flags.folder, error));
  if (!inside.empty() && *inside.begin() != "..")
    throw BadInput(refused + "it is in the folder of the class, and would be taken for a student");
  for (const auto& file : files)
    if (file.parent_path() == folder)
      throw BadInput(refused + "'" + printable_name(file) + "' could be one of its pages");
}

}  // namespace

void check_outputs(const GradeFlags& flags) {
  std::set<fs::path> files;
  for (const auto& file : {flags.csv, flags.gradebook, flags.report}) check_file(file, flags.folder, files);
  check_feedback(flags, files);
}

void write_pages(fs::path folder, const std::vector<std::pair<std::string, std::string>>& pages) {
  if (!folder.has_filename()) folder = folder.parent_path();
  std::vector<std::pair<fs::path, std::string>> files;
  for (const auto& [name, text] : pages) files.emplace_back(folder / name, text);
  std::error_code error;
  const Uninterrupted whole;
  const bool is_new = make_output_folder(folder);
  try {
    write_together(files);
  } catch (...) {
    if (is_new) fs::remove(folder, error);
    throw;
  }
}

}  // namespace rederive::classroom
