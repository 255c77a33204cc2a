// The kernel without vectors.
#include <numerics/motion/batch_kernel.hpp>

namespace rederive {

using Vector = std::experimental::simd<double, std::experimental::simd_abi::scalar>;

template <>
inline Vector emitted::root(Vector x, int n) {
  return rough_root(x, n);
}

void run_batch_one_lane(const BatchBlock& block, const BatchStart* starts, BatchEnd* ends, int count) {
  run_batch<Vector>(block, starts, ends, count);
}

}  // namespace rederive
