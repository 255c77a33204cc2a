// ledger: what the paper says, and what is true.
//
// Sample runs:  ledger                       a row an equation, counts by verdict
//               ledger show 17b              all about one row
//               ledger errata --format markdown
//               ledger claims                every number and statement of the text
//               ledger prove "sin(2*x)" "2*sin(x)*cos(x)"
#include <derivations/rocking_block/paper.hpp>
#include <lessons/ledger/run_ledger.hpp>
#include <lessons/rocking_block/claims.hpp>

int main(int argc, char** argv) {
  return rederive::ledger::run_ledger(rederive::rocking_block::paper, argc, argv,
                                      rederive::rocking_block::claims);
}
