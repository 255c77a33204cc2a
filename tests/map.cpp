#include <numerics/map.hpp>

#include <doctest/doctest.h>

using namespace rederive;

TEST_CASE("a map holds the outcome of each point, whatever the number of threads") {
  PulseCase asked;
  asked.block = make_block(0.25, 2.14);
  std::vector<double> ratios, amplitudes;
  for (int i = 0; i < 12; ++i) ratios.push_back(0.5 + i * 0.7), amplitudes.push_back(0.6 + i * 0.5);
  Work alone, four;
  four.threads = 4;
  const OutcomeMap one = outcome_map(asked, ratios, amplitudes, alone),
                   many = outcome_map(asked, ratios, amplitudes, four);
  CHECK(one.codes == many.codes);
  asked.omega_ratio = ratios[3];
  CHECK(one.codes[3][4] == outcome_at(asked, amplitudes[4]).code);
  CHECK(one.codes[0][0] == 0);
}
