// `exercises serve`: the lessons with their exercises in a browser on this machine.
#pragma once

#include <lessons/exercises/classroom.hpp>

namespace rederive::classroom {

/// Serves until SIGINT, SIGTERM or SIGHUP. `port` 0 means a free one. Returns the exit code.
int serve(const Classroom& room, int port);

}  // namespace rederive::classroom
