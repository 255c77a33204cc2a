// Restricts this process to computing: no files, no programs, no connections, no signals to others.
#pragma once

namespace rederive::program {

/// Returns whether a sanitizer or valgrind runs this process. They open files, use memory, and write reports.
bool is_watched();

/// Forbids this process to open anything, to let a file grow and to start a process and, where the system
/// supports it, every system call except those for computing and for writing to the descriptor `report`.
void seal(int report);

}  // namespace rederive::program
