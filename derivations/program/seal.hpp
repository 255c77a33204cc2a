// A process that computes and nothing else: no files, no programs, no connections, no signals to others.
#pragma once

namespace rederive {

/// Whether a sanitizer or valgrind runs this process: they open files, take memory, and write what they find.
bool is_watched();

/// Nothing more to open, no file to grow, no further process; and nothing but to compute, where the system
/// can see to it.
void seal(int report);

}  // namespace rederive
