// The functions that a page calls. A text that is returned is valid until the next call.
#include <derivations/program/program.hpp>
#include <lessons/module/desk.hpp>

namespace {

const char* kept(std::string text) {
  static std::string last;
  last = std::move(text);
  return last.c_str();
}

}  // namespace

extern "C" {

/// Returns the answer to a request; see rederive::module::reply_to.
__attribute__((used)) const char* rederive_reply(const char* request) {
  return kept(rederive::module::reply_to(request));
}

/// Returns the text of the progress file.
__attribute__((used)) const char* rederive_progress() { return kept(rederive::module::progress()); }

/// Replaces the progress file. Returns "", or what is wrong with the text.
__attribute__((used)) const char* rederive_set_progress(const char* text) try {
  rederive::module::set_progress(text);
  return kept("");
} catch (const std::exception& error) {
  return kept(rederive::program::printable(error.what()));
}
}

int main() {}
