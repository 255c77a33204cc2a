// The kernel with AVX2; numerics/CMakeLists.txt says with which flags.
#include <numerics/motion/batch_kernel.hpp>

namespace rederive {

using Vector = std::experimental::native_simd<double>;

template <>
inline Vector emitted::root(Vector x, int n) {
  return rough_root(x, n);
}

void run_batch_v3(const BatchBlock& block, const BatchStart* starts, BatchEnd* ends, int count) {
  run_batch<Vector>(block, starts, ends, count);
}

}  // namespace rederive
