// The numbers that rocking is called with, an option or a value a line: a case that can be computed, or a
// refusal.
#include <algorithm>
#include <cmath>
#include <numerics/commands/options.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::program;
using namespace rederive::numerics;
using namespace rederive::numerics::commands;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> arguments = fuzz::lines_of(fuzz::text_of(data, size));
  const std::string last = arguments.back();
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  CLI::App app;
  CommonOptions options;
  add_common_options(app, options, Frequency::required);
  try {
    app.parse(arguments);
    const PulseCase asked = case_of(options);
    fuzz::must(std::isfinite(asked.block.restitution), "a restitution that is not finite");
    (void)exact_case_of(options);
    const Span span = span_of("--span", last);
    fuzz::must(std::isfinite(span.values().back()), "a span that does not end");
  } catch (const CLI::ParseError&) {
  } catch (const BadInput&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
