// Plots by gnuplot: black lines told apart by their dashes, so that they survive a black-and-white printer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive::numerics {

/// A curve, or points (`marks`), with a name for the key; a point that is not finite breaks the curve.
struct Curve {
  std::string title;
  std::vector<std::pair<double, double>> points;
  int dash = 1;        ///< 1 solid, 2 dashed, 3 dotted, 4 dash-dotted ...
  bool marks = false;  ///< points alone
  bool grey = false;
  int symbol = 2;  ///< of the marks: gnuplot's point type
  double width = 2;
};

/// A pair of axes. gnuplot chooses an empty range (low == high).
struct Panel {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  std::pair<double, double> x_range{0, 0}, y_range{0, 0};
  std::string key = "top left";
};

/// Shades of grey over a grid, with a legend by code.
struct Shades {
  std::vector<double> x, y;
  std::vector<std::vector<int>> codes;  ///< codes[x][y]; an empty column is left white
  std::string x_label, y_label;
};

/// One or several pairs of axes with a caption.
struct Plot {
  std::string caption;  ///< lines separated by '\n'
  std::vector<Panel> panels;
};

/// Throws std::invalid_argument unless the file ends in .svg, .png or .pdf.
void check_plot_name(const std::filesystem::path& file);

/// Draws to SVG, PNG or PDF by the extension of the file, which is written whole or not at all. Throws
/// std::invalid_argument for another extension, and BadInput if the file cannot be written or gnuplot is
/// missing.
void draw(const Plot& figure, const std::filesystem::path& file);
void draw(const Shades& shades, const std::filesystem::path& file);

/// Returns all curves as CSV with the columns panel, curve, x, y.
std::string figure_data(const Plot& figure);

/// Returns the picture that a gnuplot script draws in the terminal that it sets, or nothing if gnuplot is not
/// installed. The bytes are the same each time: the date in a PDF is in 1970. No temporary file stays behind.
/// Throws std::runtime_error with gnuplot's message if the script is wrong, and BadInput if there is no room
/// for a temporary file.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace rederive::numerics
