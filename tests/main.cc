// The main function of every test. It returns 77, which CTest reads as "skipped", if no assertion fails but a
// part is left out.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <tests/skip.hpp>

int main(int argc, char** argv) {
  const int result = doctest::Context(argc, argv).run();
  return result == 0 && has_skipped ? 77 : result;
}
