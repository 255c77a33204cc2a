// Ground-motion files of every format: a record that can be integrated, or a complaint that names file and
// line.
#include <cmath>
#include <numerics/records/record.hpp>
#include <stdexcept>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::numerics;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::File file(fuzz::text_of(data, size));
  for (const double step : {0.0, 0.01}) try {
      const Record record =
          read_record(file.name(), {.unit = RecordUnit::metres_per_second_squared, .step = step});
      fuzz::must(record.time.size() == record.acceleration.size() && record.time.size() >= 2,
                 "too few samples");
      for (std::size_t i = 0; i < record.time.size(); ++i) {
        fuzz::must(std::isfinite(record.acceleration[i]), "an acceleration that is not finite");
        fuzz::must(std::isfinite(record.time[i]) && (i == 0 || record.time[i] > record.time[i - 1]),
                   "time must increase");
      }
    } catch (const std::invalid_argument& error) {
      fuzz::must(std::string(error.what()).find("rederive-") != std::string::npos, error.what());
    }
  return 0;
}
