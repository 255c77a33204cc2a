// Text → tree → text: what is printed is read again as the same, and every complaint can be shown.
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <tests/fuzz/fuzz.hpp>

using namespace rederive::language;
using namespace rederive::paper;
using namespace rederive::rocking_block;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  static const Symbols symbols =
      declared_symbols(rederive::rocking_block::paper(), {});  // every letter, and the names of the paper
  try {
    const Relation read = parse_statement(text, symbols);
    const std::string printed = print(read, Notation::plain, symbols);
    const std::string again = print(parse_statement(printed, symbols), Notation::plain, symbols);
    fuzz::must(again == printed, "printed as " + printed + ", then as " + again);
    (void)print(read, Notation::unicode, symbols), (void)print(read, Notation::latex, symbols);
  } catch (const SyntaxError& error) {
    fuzz::must(!explain(error, text).empty(), "no complaint");
  }
  return 0;
}
