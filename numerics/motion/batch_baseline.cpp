// The kernel of every processor; numerics/CMakeLists.txt says with which flags.
#include <numerics/motion/instruction_sets.hpp>
#include <numerics/motion/kernel.hpp>

namespace {

using Vector = std::experimental::native_simd<double>;

}  // namespace

template <>
inline Vector rederive::emitted::root(Vector x, int n) {
  return rederive::numerics::rough_root(x, n);
}

namespace rederive::numerics {

void run_batch_baseline(const KernelBlock<double>& block, const KernelStart<double>* starts,
                        KernelEnd<double>* ends, int count) {
  run_batch<Vector>(block, starts, ends, count);
}

}  // namespace rederive::numerics
