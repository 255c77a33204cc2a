// The surroundings of a program: standard streams, a terminal, the folders of the user.
#pragma once

#include <filesystem>
#include <string>

namespace rederive::program {

/// Opens the descriptors 0, 1 and 2 if they are closed, so that no file of ours becomes one of them. Then
/// standard input is empty, and writing to standard output fails as before. Call this first in `main`.
void open_standard_streams();

/// Returns whether colour and progress may be shown on this stream (1 or 2): it is a terminal other than
/// TERM=dumb, and NO_COLOR is unset or empty.
bool is_lively(int stream);

/// Returns the user's folder for data that programs keep: rederive in $XDG_STATE_HOME or ~/.local/state. It
/// need not exist.
std::filesystem::path state_folder();

/// Creates a folder, and the folders above it, for this user alone (mode 0700). Existing folders do not
/// change. Throws BadInput if that fails.
void make_own_folder(const std::filesystem::path& folder);

/// Returns a folder that no other user can write to or has prepared: `name` in the state folder or, if that
/// is not possible, a new one in the folder for temporary files. Throws BadInput if neither is possible.
std::filesystem::path private_folder(const std::string& name);

}  // namespace rederive::program
