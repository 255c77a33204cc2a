// Where grade writes to: looked at before anything is judged, and written whole or not at all.
#include <derivations/emit/program.hpp>
#include <lessons/exercises/grading.hpp>
#include <set>

namespace rederive::classroom {
namespace {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder, const std::string& refused) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw BadInput(refused + "there is no folder '" + folder.string() + "' to write into");
  if (::access(folder.c_str(), W_OK) != 0)
    throw BadInput(refused + "the folder '" + folder.string() + "' may not be written to");
}

void check_file(const fs::path& file, const std::string& students, std::set<fs::path>& others) {
  std::error_code error;
  if (file.empty()) return;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (fs::is_directory(file, error)) throw BadInput("cannot write '" + file.string() + "': it is a folder");
  const auto status = fs::status(file, error);
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);  // a device, a pipe
  if (error && status.type() != fs::file_type::not_found)
    throw BadInput("cannot write '" + file.string() + "': " + error.message());
  if (!in_place) check_folder(folder, "cannot write '" + file.string() + "': ");
  if (!others.insert(fs::weakly_canonical(fs::absolute(file), error)).second)
    throw BadInput("'" + file.string() + "' cannot be two of the files that are written");
  const auto inside =
      fs::weakly_canonical(fs::absolute(folder), error).lexically_relative(fs::canonical(students, error));
  if (!inside.empty() && *inside.begin() != ".." && inside != ".")
    throw BadInput("cannot write '" + file.string() + "': it lies in the folder of a student");
}

void check_feedback(const GradeFlags& flags, const std::set<fs::path>& files) {
  if (flags.feedback.empty()) return;
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(flags.feedback), error);
  if (!folder.has_filename()) folder = folder.parent_path();  // "pages/"
  const std::string refused = "cannot write into '" + flags.feedback + "': ";
  const bool is_there = fs::exists(folder, error);
  if (is_there && !fs::is_directory(folder, error)) throw BadInput(refused + "it is no folder");
  const fs::path place = is_there ? folder : folder.parent_path();
  check_folder(place, refused);
  const auto inside = folder.lexically_relative(fs::canonical(flags.folder, error));
  if (!inside.empty() && *inside.begin() != "..")
    throw BadInput(refused + "it lies in the class's folder, and would be taken for a student");
  for (const auto& file : files)
    if (file.parent_path() == folder)
      throw BadInput(refused + "'" + file.string() + "' could be one of its pages");
}

}  // namespace

void check_outputs(const GradeFlags& flags) {
  std::set<fs::path> files;
  for (const auto& file : {flags.csv, flags.gradebook, flags.report}) check_file(file, flags.folder, files);
  check_feedback(flags, files);
}

void write_pages(fs::path folder, const std::vector<std::pair<std::string, std::string>>& pages) {
  if (!folder.has_filename()) folder = folder.parent_path();
  const fs::path draft = folder.string() + ".part" + std::to_string(::getpid());
  std::error_code error;
  const Uninterrupted all;
  try {
    for (const auto& [name, text] : pages)
      if (fs::is_directory(folder / name, error))
        throw BadInput("cannot write '" + (folder / name).string() + "': it is a folder");
    fs::create_directories(draft);
    for (const auto& [name, text] : pages) write_whole(draft / name, text);
    fs::create_directories(folder);
    for (const auto& [name, text] : pages) fs::rename(draft / name, folder / name);
    fs::remove_all(draft, error);
  } catch (const fs::filesystem_error& failed) {
    fs::remove_all(draft, error);
    throw BadInput("cannot write into '" + folder.string() + "': " + failed.code().message());
  } catch (...) {
    fs::remove_all(draft, error);
    throw;
  }
}

}  // namespace rederive::classroom
