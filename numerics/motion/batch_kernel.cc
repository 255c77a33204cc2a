// The kernel of many motions under pulses. numerics/CMakeLists.txt compiles this file once for each
// instruction set, and sets REDERIVE_INSTRUCTION_SET to its name in `InstructionSet`.
#include <numerics/motion/kernel.hpp>
#include <type_traits>

namespace {

constexpr auto instruction_set = rederive::numerics::InstructionSet::REDERIVE_INSTRUCTION_SET;
using Lane = std::experimental::simd<double, std::experimental::simd_abi::scalar>;
using Vector = std::conditional_t<instruction_set == rederive::numerics::InstructionSet::one_lane, Lane,
                                  std::experimental::native_simd<double>>;

}  // namespace

template <>
inline Vector rederive::emitted::root(Vector x, int n) {
  return rederive::numerics::rough_root(x, n);
}

namespace rederive::numerics {

/// Takes the order that costs least: a step takes operations as the square of the order, a linear one as the
/// order.
template <>
void run_batch<instruction_set>(const KernelBlock<double>& block, const KernelStart<double>* starts,
                                KernelEnd<double>* ends, int count) {
  const auto run = block.is_linear ? run_packs<Vector, emitted::linear_motion_in_pulse_positive<Vector, 24>>
                   : block.tolerance >= 1e-10 * block.alpha
                       ? run_packs<Vector, emitted::motion_in_pulse_positive<Vector, 13>>
                       : run_packs<Vector, emitted::motion_in_pulse_positive<Vector, 18>>;
  run(block, starts, ends, count);
}

}  // namespace rederive::numerics
