// The pictures of the lessons: the block, upright and turned, and plots of computed curves.
#pragma once

#include <functional>
#include <lessons/page/lesson.hpp>
#include <string>
#include <utility>
#include <vector>

namespace rederive::illustrations {

/// Returns the block of Fig. 1 at rest and turned about O' by theta > 0, with the names of lengths and
/// angles.
page::Figure block_at_rest(const std::string& name);
/// Returns the block turned by each of the angles (in rad) about the corner on the ground, O' for theta >= 0
/// and O for theta < 0, with its weight, the inertia force of the ground acceleration and the two reactions.
page::Figure block_with_forces(const std::string& name, const std::string& caption,
                               const std::vector<double>& angles);
/// Returns the block at an impact: the radii from both corners to C, and the velocity of C just before.
page::Figure block_at_impact(const std::string& name);
/// Returns curves of constant energy of a block with alpha = 0.25 on ground at rest. The curve through θ = ±α
/// is red.
page::Figure phase_portrait_of_free_rocking(const std::string& name);

/// One curve of a plot: points, a title, a gnuplot style ("with lines ls 1").
struct StyledCurve {
  std::vector<std::pair<double, double>> points;
  std::string title, style = "with lines ls 1";
};
/// Returns `count` points of y(x) from `first` to `last`. A value that is not finite leaves a gap in a plot.
std::vector<std::pair<double, double>> sampled(double first, double last, int count,
                                               const std::function<double(double)>& y);
/// Returns a plot of curves in one frame. `settings` are lines of gnuplot for labels and ranges.
page::Figure plot(const std::string& name, const std::string& caption, const std::string& settings,
                  const std::vector<StyledCurve>& curves);

}  // namespace rederive::illustrations
