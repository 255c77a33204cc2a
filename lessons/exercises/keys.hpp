// Single keys from a terminal.
#pragma once

#include <termios.h>
#include <unistd.h>

namespace rederive::classroom {

/// Makes the terminal give single keys, and restores it at the end. Ctrl-C is a key of code 3 if it is told
/// so.
class KeyMode {
 public:
  explicit KeyMode(bool with_interrupt = false) : active_(::isatty(0) != 0 && ::tcgetattr(0, &before_) == 0) {
    if (!active_) return;
    termios keys = before_;
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | (with_interrupt ? ISIG : 0));
    ::tcsetattr(0, TCSANOW, &keys);
  }
  ~KeyMode() {
    if (active_) ::tcsetattr(0, TCSANOW, &before_);
  }
  KeyMode(const KeyMode&) = delete;
  KeyMode& operator=(const KeyMode&) = delete;

 private:
  termios before_{};
  bool active_;
};

}  // namespace rederive::classroom
