// The kernel without vectors.
#include <numerics/motion/instruction_sets.hpp>
#include <numerics/motion/kernel.hpp>

namespace {

using Vector = std::experimental::simd<double, std::experimental::simd_abi::scalar>;

}  // namespace

template <>
inline Vector rederive::emitted::root(Vector x, int n) {
  return rederive::numerics::rough_root(x, n);
}

namespace rederive::numerics {

void run_batch_one_lane(const KernelBlock<double>& block, const KernelStart<double>* starts,
                        KernelEnd<double>* ends, int count) {
  run_batch<Vector>(block, starts, ends, count);
}

}  // namespace rederive::numerics
