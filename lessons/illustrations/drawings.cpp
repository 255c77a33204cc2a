#include <fmt/format.h>

#include <array>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/illustrations/drawings.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::illustrations {
using namespace mechanics;
using namespace paper;
using namespace page;
namespace {

constexpr double half_width = 0.5, half_height = 1.5;

struct Place {
  double x, y;
};

/// A point of the block given from the corner O', after the block has turned clockwise about it.
Place turned(Place from_corner, double theta, Place corner) {
  return {corner.x + from_corner.x * std::cos(theta) + from_corner.y * std::sin(theta),
          corner.y - from_corner.x * std::sin(theta) + from_corner.y * std::cos(theta)};
}

/// The four corners as a closed gnuplot data block; `width` is -2b about O', 2b about O.
std::string outline(const std::string& block, double theta, Place corner, double width = -2 * half_width) {
  const std::array<Place, 5> corners{
      {{0, 0}, {0, 2 * half_height}, {width, 2 * half_height}, {width, 0}, {0, 0}}};
  std::string text = "$" + block + " << EOD\n";
  for (const auto& place : corners) {
    const Place at = turned(place, theta, corner);
    text += fmt::format("{:.4f} {:.4f}\n", at.x, at.y);
  }
  return text + "EOD\n";
}

std::string label(const std::string& text, Place at, const std::string& more = "center") {
  return fmt::format("set label '{}' at {:.3f},{:.3f} {}\n", text, at.x, at.y, more);
}

std::string line(Place from, Place to, const std::string& style) {
  return fmt::format("set arrow from {:.3f},{:.3f} to {:.3f},{:.3f} {}\n", from.x, from.y, to.x, to.y, style);
}

constexpr auto bare = "unset border; unset tics; unset key\nset size ratio -1\n";

/// A vector with its name at its head.
std::string vector(Place from, Place along, const std::string& name, const std::string& colour) {
  const double length = std::hypot(along.x, along.y);
  const Place head{from.x + along.x, from.y + along.y},
      beyond{head.x + 0.24 * along.x / length, head.y + 0.24 * along.y / length};
  return line(from, head, "lw 2.5 lc rgb '" + colour + "'") +
         label(name, beyond, "center textcolor rgb '" + colour + "'");
}

std::string dot(int number, Place at) {
  return fmt::format("set object {} circle at {:.3f},{:.3f} size 0.05 fs solid fc rgb 'black'\n", number,
                     at.x, at.y);
}

}  // namespace

Figure block_with_forces(const std::string& name, const std::string& caption,
                         const std::vector<double>& angles) {
  constexpr double apart = 4.4;
  const double right = apart * static_cast<double>(angles.size()) - 2.2;
  std::string script = bare, blocks = "plot ";
  script += fmt::format("set xrange [-2.2:{:.2f}]\nset yrange [-1.3:3.7]\n", right);
  script += line({-2.1, 0}, {right - 0.1, 0}, "nohead lw 2 lc rgb '#555555'");
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double theta = angles[i], side = theta < 0 ? 1 : -1;  // where the block stands, seen from its pivot
    const Place pivot{apart * static_cast<double>(i) - side * half_width, 0};
    const Place centre = turned({side * half_width, half_height}, theta, pivot);
    script += outline(fmt::format("block{}", i), theta, pivot, 2 * side * half_width);
    script +=
        line(pivot, centre, "nohead dt 2 lw 1.5 lc rgb '#1f5fa8'") + dot(static_cast<int>(i) + 1, centre);
    script += label("C", {centre.x + 0.2, centre.y + 0.2});
    script += vector(centre, {0, -0.9}, "m g", "#c0392b") + vector(centre, {-0.9, 0}, "m ü_g", "#2e8b57");
    script += vector({pivot.x, -0.75}, {0, 0.75}, "", "#8e44ad") +
              label("V", {pivot.x + 0.2, -0.6}, "center textcolor rgb '#8e44ad'");
    script += vector({pivot.x - 0.9, -0.12}, {0.9, 0}, "", "#8e44ad") +
              label("H", {pivot.x - 0.7, -0.35}, "center textcolor rgb '#8e44ad'");
    script += label(theta < 0 ? "O" : "O′", {pivot.x + 0.3, -0.25});
    blocks += fmt::format("{}$block{} with lines lw 2 lc rgb 'black'", i == 0 ? "" : ", ", i);
  }
  return {name, caption, script + blocks + "\n"};
}

Figure block_at_impact(const std::string& name) {
  const Place left{-half_width, 0}, right{half_width, 0}, centre{0, half_height};
  std::string script = bare;
  script += "set xrange [-2.2:2.6]\nset yrange [-0.6:3.4]\n" + outline("block", 0, right);
  script += line({-2.1, 0}, {2.5, 0}, "nohead lw 2 lc rgb '#555555'") + dot(1, centre);
  script += line(left, centre, "nohead dt 2 lw 1.5 lc rgb '#1f5fa8'") +
            line(right, centre, "nohead dt 2 lw 1.5 lc rgb '#c0392b'");
  script += vector(centre, {0.6 * half_height, 0.6 * half_width * -1}, "R θ̇⁻", "#1f5fa8");
  script += vector({right.x, -0.5}, {0, 0.5}, "", "#8e44ad") +
            label("the blow", {right.x + 0.6, -0.35}, "center textcolor rgb '#8e44ad'");
  script += label("2α", {0, half_height - 0.55}) + label("C", {-0.2, centre.y + 0.15});
  script += label("O", {left.x - 0.15, -0.25}) + label("O′", {right.x + 0.2, 0.2});
  script += label("R", {-0.36, 0.7}) + label("R", {0.36, 0.7});
  return {name,
          "The block at the impact on O'. Until then it turned about O, and C moves across the radius from "
          "O (blue); the other radius (red) stands to it at twice the angle $alpha$. The blow acts at O' "
          "and has no moment about it.",
          script + "plot $block with lines lw 2 lc rgb 'black'\n"};
}

Figure block_at_rest(const std::string& name) {
  const Place left_foot{0.5, 0}, right_foot{4.6, 0};
  const double theta = 0.17, alpha = std::atan(half_width / half_height);
  const Place centre{left_foot.x - half_width, half_height};
  const Place centre_turned = turned({-half_width, half_height}, theta, right_foot);
  std::string script = bare;
  script += "set xrange [-1.6:6.4]\nset yrange [-0.7:3.7]\n";
  script += outline("standing", 0, left_foot) + outline("turned", theta, right_foot);
  script += line({-1.5, 0}, {6.3, 0}, "nohead lw 2 lc rgb '#555555'");
  script += line(left_foot, centre, "nohead dt 2 lw 1.5 lc rgb '#1f5fa8'");
  script += line({left_foot.x, 0}, {left_foot.x, 2.6}, "nohead dt 3 lc rgb '#999999'");
  script += line({-0.5, 3.2}, {0.5, 3.2}, "heads lc rgb '#555555'") + label("2b", {0, 3.42});
  script += line({-0.75, 0}, {-0.75, 3}, "heads lc rgb '#555555'") + label("2h", {-1.05, 1.5});
  script += label("C", {centre.x - 0.2, centre.y}) + label("R", {centre.x + 0.12, 0.75});
  script += label("α", {left_foot.x - 0.11, 1.0}) + label("O", {-0.5, -0.3}) + label("O′", {0.5, -0.3});
  script += dot(1, centre) + dot(2, centre_turned);
  script += line(right_foot, centre_turned, "nohead dt 2 lw 1.5 lc rgb '#1f5fa8'");
  script += line(right_foot, {right_foot.x, 3.2}, "nohead dt 3 lc rgb '#999999'");
  const Place edge = turned({0, 3.3}, theta, right_foot);
  script += line(right_foot, edge, "nohead dt 3 lc rgb '#c0392b'");
  script += label("θ", turned({0, 2.75}, theta / 2, right_foot), "center textcolor rgb '#c0392b'");
  const Place between = turned({0, 1.0}, (theta - alpha) / 2, right_foot);
  script += label("α − θ", {right_foot.x - 1.3, 0.75}, "right");
  script += line({right_foot.x - 1.25, 0.77}, between, "lw 1 lc rgb '#1f5fa8'");
  script += label("C", {centre_turned.x - 0.2, centre_turned.y}) + label("O′", {right_foot.x, -0.3});
  script += line({2.0, -0.45}, {2.9, -0.45}, "lw 2 lc rgb '#2e8b57'") + label("u_g", {3.2, -0.45});
  script += "plot $standing with lines lw 2 lc rgb 'black', $turned with lines lw 2 lc rgb '#c0392b'\n";
  return {name,
          "The block at rest, and turned clockwise by $theta > 0$ about its right corner O' (red). "
          "The ground moves by $u_g$ to the right.",
          script};
}

Figure phase_portrait_of_free_rocking(const std::string& name) {
  constexpr double alpha = 0.25;
  constexpr int steps = 80;
  std::string data = "$energy << EOD\n";
  for (int i = -steps; i <= steps; ++i) {
    for (int k = -steps; k <= steps; ++k) {
      const double theta = 1.4 * alpha * i / steps, rate = 0.4 * k / steps;
      const double energy = theta < 0 ? emitted::rocking_energy_negative(alpha, theta, rate, 1.0)
                                      : emitted::rocking_energy_positive(alpha, theta, rate, 1.0);
      data += fmt::format("{:.5f} {:.5f} {:.7f}\n", theta / alpha, rate / alpha, energy);
    }
    data += "\n";
  }
  data += "EOD\n";
  const double barrier = emitted::rocking_energy_positive(alpha, alpha, 0.0, 1.0);
  const std::string levels = joined(std::array{0.2, 0.5, 0.8, 1.3, 1.8}, ",",
                                    [&](double part) { return fmt::format("{:.7f}", part * barrier); });
  const std::string script =
      data +
      fmt::format(
          "set contour base; unset surface\nset cntrparam levels discrete {}\nset table $rocking\n"
          "splot $energy using 1:2:3\nunset table\nset cntrparam levels discrete {:.7f}\nset table $limit\n"
          "splot $energy using 1:2:3\nunset table\n"
          "set xlabel 'θ / α'; set ylabel 'rate of turning / (α p)'\nset xrange [-1.4:1.4]; set yrange "
          "[-1.6:1.6]\n"
          "set grid lc rgb '#dddddd'; unset key\nset arrow from 0.05,0.84 to 0.3,0.70 lw 2 lc rgb '#1f5fa8'\n"
          "plot $rocking using 1:2 with lines ls 1, $limit using 1:2 with lines ls 2\n",
          levels, barrier);
  return {
      name,
      "Free rocking of a block with $alpha = 0.25$. Blue: motions of constant energy. Red: the energy that "
      "just lifts C above the corner; inside it the block rocks, outside it falls.",
      script};
}

std::vector<std::pair<double, double>> sampled(double first, double last, int count,
                                               const std::function<double(double)>& y) {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < count; ++i) {
    const double x = first + (last - first) * i / (count - 1);
    points.emplace_back(x, y(x));
  }
  return points;
}

Figure plot(const std::string& name, const std::string& caption, const std::string& settings,
            const std::vector<StyledCurve>& curves) {
  std::string data, command = "plot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    data += fmt::format("$curve{} << EOD\n", i);
    for (const auto& [x, y] : curves[i].points)
      data += std::isfinite(y) ? fmt::format("{:.8g} {:.8g}\n", x, y) : std::string("\n");
    data += "EOD\n";
    const std::string title = curves[i].title.empty() ? "notitle" : "title '" + curves[i].title + "'";
    command += fmt::format("{}$curve{} using 1:2 {} {}", i == 0 ? "" : ", ", i, curves[i].style, title);
  }
  return {name, caption,
          data + "set grid lc rgb '#dddddd'\nset key below\n" + settings + "\n" + command + "\n"};
}

}  // namespace rederive::illustrations
