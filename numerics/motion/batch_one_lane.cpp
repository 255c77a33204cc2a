// The kernel without vectors.
#include <numerics/motion/batch_kernel.hpp>

namespace {

using Vector = std::experimental::simd<double, std::experimental::simd_abi::scalar>;

}  // namespace

template <>
inline Vector rederive::emitted::root(Vector x, int n) {
  return rederive::numerics::rough_root(x, n);
}

namespace rederive::numerics {

void run_batch_one_lane(const BatchBlock& block, const BatchStart* starts, BatchEnd* ends, int count) {
  run_batch<Vector>(block, starts, ends, count);
}

}  // namespace rederive::numerics
