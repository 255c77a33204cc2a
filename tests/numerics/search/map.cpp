#include <doctest/doctest.h>

#include <numerics/search/grid.hpp>

using namespace rederive::numerics;

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

TEST_CASE("either engine gives the same map") {
  for (const Model model : {Model::linear, Model::nonlinear}) {
    PulseCase asked;
    asked.block = make_block(0.25, 2.14);
    asked.model = model;
    std::vector<double> ratios, amplitudes;
    for (int i = 0; i < 21; ++i) ratios.push_back(0.2 + i * 0.49), amplitudes.push_back(0.6 + i * 0.56);
    Work alone, three;
    three.threads = 3;
    const auto codes = outcome_map(asked, ratios, amplitudes, three).codes;
    CHECK(outcome_map(asked, ratios, amplitudes, alone).codes == codes);
    asked.engine = Engine::gsl;
    CHECK(outcome_map(asked, ratios, amplitudes, alone).codes == codes);
  }
}
