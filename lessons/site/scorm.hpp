// A site as a package that learning platforms import: SCORM 1.2.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rederive::site {

/// The judge as a script, for pages that are opened as files. A platform serves pages, so packages lack it.
inline constexpr const char* inlined_judge = "judge.inline.js";

/// Returns imsmanifest.xml for these files, (name, text). The package has one item, exercises.html, from
/// which the other pages are reached. See "SCORM 1.2 Content Aggregation Model", ADL 2001, section 2.3.
std::string scorm_manifest(const std::string& title,
                           const std::vector<std::pair<std::filesystem::path, std::string>>& files);
/// Packs the files that imsmanifest.xml in a folder names into FOLDER/scorm.zip. Throws std::runtime_error,
/// with what Python says, if that fails.
void pack_scorm(const std::filesystem::path& folder);

}  // namespace rederive::site
