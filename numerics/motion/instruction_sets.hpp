// The kernel of many motions, compiled once for each instruction set; numerics/CMakeLists.txt says with which
// flags.
#pragma once

#include <numerics/motion/kernel_case.hpp>

namespace rederive::numerics {

// Each follows `count` motions under pulses from `starts` to `ends`, see run_batch in kernel.hpp.

void run_batch_one_lane(const KernelBlock<double>& block, const KernelStart<double>* starts,
                        KernelEnd<double>* ends, int count);
void run_batch_baseline(const KernelBlock<double>& block, const KernelStart<double>* starts,
                        KernelEnd<double>* ends, int count);
void run_batch_v3(const KernelBlock<double>& block, const KernelStart<double>* starts,
                  KernelEnd<double>* ends, int count);
void run_batch_v4(const KernelBlock<double>& block, const KernelStart<double>* starts,
                  KernelEnd<double>* ends, int count);

}  // namespace rederive::numerics
