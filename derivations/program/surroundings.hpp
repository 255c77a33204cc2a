// What a program finds around it: standard streams, a terminal, the user's own folders.
#pragma once

#include <filesystem>
#include <string>

namespace rederive {

/// Opens those of the descriptors 0, 1 and 2 that are closed, so that no file of ours becomes one of them.
/// Standard input is empty then, and writing to standard output fails as it did before. The first call in
/// `main`.
void open_standard_streams();

/// Returns whether colour and progress may be shown on this stream (1 or 2): it is a terminal other than
/// TERM=dumb, and NO_COLOR is unset or empty.
bool is_lively(int stream);

/// Returns the user's folder for what programs keep: rederive in $XDG_STATE_HOME, or in ~/.local/state. It
/// need not exist.
std::filesystem::path state_folder();

/// Makes a folder, and those above it, for this user alone (mode 0700). Those that exist stay as they are.
/// Throws BadInput if that fails.
void make_own_folder(const std::filesystem::path& folder);

/// Returns a folder that no other user can write to or has prepared: `name` in the state folder or, where
/// that cannot be had, a new one in the folder for temporary files. Throws BadInput if neither can be had.
std::filesystem::path private_folder(const std::string& name);

}  // namespace rederive
