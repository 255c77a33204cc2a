// `ledger prove`: two statements, and assumptions in the lines after them. What is refuted has a witness.
#include <derivations/paper/prove.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> lines = fuzz::lines_of(fuzz::text_of(data, size));
  if (lines.size() < 2) return -1;
  try {
    (void)decide(rederive::rocking_block::paper(),
                 ProveRequest{lines[0], lines[1], {lines.begin() + 2, lines.end()}, {}, {}});
  } catch (const BadInput&) {
  }
  return 0;
}
