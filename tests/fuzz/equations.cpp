// equations.toml: rows are read, or refused with file and line; so are their domains and what they print.
#include <derivations/language/syntax.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/program/program.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::language;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::File file(fuzz::text_of(data, size));
  try {
    for (const Row& row : read_rows(file.name())) try {
        (void)parse_statement(row.claim(), symbols_in(rederive::rocking_block::paper(), row.domain));
      } catch (const std::invalid_argument&) {
      } catch (const SyntaxError&) {
      }
  } catch (const BadInput& error) {
    fuzz::must(fuzz::names_line_of(error.what(), file.name()), error.what());
  }
  return 0;
}
