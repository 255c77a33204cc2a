// The pictures that lessons share: the block, standing and turned, and plots of computed curves.
#pragma once

#include <functional>
#include <lessons/page/lesson.hpp>
#include <string>
#include <utility>
#include <vector>

namespace rederive {

/// The block of Fig. 1, at rest and turned about O' by theta > 0, with its lengths and angles named.
Figure block_at_rest(const std::string& name);
/// The block turned by each angle about the corner that stays on the ground, O' for theta >= 0 and O for
/// theta < 0, with all that acts on it: its weight, the inertia force of the ground's acceleration, the two
/// reactions.
Figure block_with_forces(const std::string& name, const std::string& caption,
                         const std::vector<double>& angles);
/// The block at an impact: the radii from both corners to C, and the velocity of C just before.
Figure block_at_impact(const std::string& name);
/// Curves of constant energy of a block of alpha = 0.25 on ground at rest; the one through θ = ±α in red.
Figure phase_portrait_of_free_rocking(const std::string& name);

/// One curve of a plot: points, a title, a gnuplot style ("with lines ls 1").
struct StyledCurve {
  std::vector<std::pair<double, double>> points;
  std::string title, style = "with lines ls 1";
};
/// `count` points of y(x) from `first` to `last`; a value that is not finite leaves a gap.
std::vector<std::pair<double, double>> sampled(double first, double last, int count,
                                               const std::function<double(double)>& y);
/// Curves in one frame. `settings` are gnuplot lines: labels, ranges.
Figure plot(const std::string& name, const std::string& caption, const std::string& settings,
            const std::vector<StyledCurve>& curves);

}  // namespace rederive
