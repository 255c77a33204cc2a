// Of every test: 77, which tells CTest that a test is skipped, where nothing fails and something is left out.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <tests/precompiled_json.hpp>
#include <tests/skip.hpp>

int main(int argc, char** argv) {
  const int result = doctest::Context(argc, argv).run();
  return result == 0 && has_skipped ? 77 : result;
}

template class nlohmann::basic_json<>;
template class nlohmann::detail::serializer<nlohmann::json>;
template class nlohmann::detail::lexer<nlohmann::json, JsonText>;
template class nlohmann::detail::parser<nlohmann::json, JsonText>;
