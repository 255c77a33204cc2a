// A stone that is dropped.
#include <rederive/derivations/mechanics/plane.hpp>
#include <rederive/derivations/paper/run_derive.hpp>

using namespace rederive::mechanics;
using namespace rederive::paper;
using GiNaC::ex;

namespace {

void derive(const rederive::language::Symbols& symbols, Derivations& rows) {
  const auto &s = symbols["s"], &t = symbols["t"], &g = symbols["g"];
  rows.add("1", [=] {
    const ex velocity = integral(g, t, 0, t);
    return derived(s, integral(velocity, t, 0, t),
                   {in_words("Integrate the acceleration $g$ over the time, and the velocity again")});
  });
}

}  // namespace

int main(int argc, char** argv) { return run_derive(derive, argc, argv); }
