// emit: the derived results as source code.
#include <derivations/emit/run_emit.hpp>
#include <derivations/rocking_block/emission.hpp>

int main(int argc, char** argv) {
  return rederive::emit::run_emit(rederive::rocking_block::emission, argc, argv);
}
