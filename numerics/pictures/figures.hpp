// The paper's figures 8 to 16, computed.
#pragma once

#include <array>
#include <numerics/motion/overturning.hpp>
#include <numerics/motion/parallel.hpp>
#include <numerics/pictures/plot.hpp>

namespace rederive::numerics {

struct FigureOptions {
  double ground_acceleration = 0.24;  ///< a_g/g of figure 16: the paper does not say which it used
  Engine engine = Engine::taylor;     ///< for the nonlinear model
  Work work{};                        ///< threads and progress for the figures that sweep omega_p/p
};

/// Returns the figure with its caption, which corrects the numbers of the paper. Throws std::invalid_argument
/// unless 8 <= number <= 16.
Plot paper_figure(int number, const FigureOptions& options);

Plot history_figure(int number, const FigureOptions& options);  ///< 8, 9, 12, 13
Plot threshold_figure(const FigureOptions& options);            ///< 10
Plot model_comparison_figure(const FigureOptions& options);     ///< 11
Plot initial_condition_figure(const FigureOptions& options);    ///< 14
Plot period_figure(const FigureOptions& options);               ///< 15
Plot code_comparison_figure(const FigureOptions& options);      ///< 16

/// One motion in the three panels of figures 8, 9, 12 and 13; dash and grey tell the curves apart.
struct HistoryCurve {
  std::string title;
  int dash = 1;
  bool grey = false;
  std::vector<std::array<double, 3>> states;  ///< tau, theta/alpha, thetadot/(alpha p)
};
std::vector<Panel> history_panels(const std::vector<HistoryCurve>& curves);

}  // namespace rederive::numerics
