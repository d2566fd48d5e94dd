#include "registration/pictures/section.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "registration/mesh/depth_grid.h"
#include "support/files/gnuplot.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::registration {
namespace {

using Point = Section::Point;

/// Where a triangle meets the plane y = slope z, if it does.
void cut(const Triangle& triangle, double slope, std::vector<std::pair<Point, Point>>& pieces) {
  std::vector<Point> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = triangle[i]->point_m, &b = triangle[(i + 1) % 3]->point_m;
    const double from = a.y() - slope * a.z(), to = b.y() - slope * b.z();
    if ((from < 0) == (to < 0)) continue;
    const Eigen::Vector3d at = a + from / (from - to) * (b - a);
    ends.emplace_back(at.x(), at.z());
  }
  if (ends.size() == 2) pieces.emplace_back(ends[0], ends[1]);
}

/// Both edges of a camera's view in its middle row, as far as the farthest depth.
std::vector<Point> view_of(const sensors::PinholeCamera& camera, const Eigen::Isometry3d& colour_from_camera,
                           double farthest_m) {
  const Eigen::Vector3d eye_m = colour_from_camera.translation();
  std::vector<Point> view;
  for (const int column : {0, camera.width_px}) {
    const auto direction =
        sensors::direction_through(camera, {column + (column == 0 ? 0.5 : -0.5), 0.5 * camera.height_px});
    if (!direction) continue;
    const Eigen::Vector3d forward = colour_from_camera.linear() * *direction;
    if (!(forward.z() > 0)) continue;
    const Eigen::Vector3d end_m = eye_m + (farthest_m - eye_m.z()) / forward.z() * forward;
    view.emplace_back(end_m.x(), end_m.z());
    if (view.size() == 1) view.emplace_back(eye_m.x(), eye_m.z());
  }
  return view;
}

std::string block(const std::string& name, const std::vector<Point>& points) {
  std::string text = "$" + name + " << EOD\n";
  for (const auto& [x, z] : points) text += fmt::format("{:.5f} {:.5f}\n", x, z);
  return text + "EOD\n";
}

std::string block(const std::string& name, const std::vector<std::pair<Point, Point>>& pieces) {
  std::string text = "$" + name + " << EOD\n";
  for (const auto& [a, b] : pieces)
    text += fmt::format("{:.5f} {:.5f}\n{:.5f} {:.5f}\n\n", a.first, a.second, b.first, b.second);
  return text + "EOD\n";
}

}  // namespace

Section section_of(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                   const sensors::PinholeCamera& colour, const MeshRegistration& mesh,
                   const RegisteredFrame& registered, int row) {
  if (row < 0 || row >= colour.height_px)
    throw input_error({.field = request_name("section"),
                       .wanted = fmt::format("a row of the photograph, 0 to {}", colour.height_px - 1),
                       .found = std::to_string(row)});
  Section section;
  const auto middle = sensors::direction_through(colour, {0.5 * colour.width_px, row + 0.5});
  const double slope = middle ? middle->y() / middle->z() : 0;
  const DepthGrid grid(measured, colour_from_depth, mesh, {});
  for (int squares = 0; squares < grid.rows_of_squares(); ++squares)
    grid.each_measured(squares, [&](const Triangle& t) { cut(t, slope, section.measured); });
  grid.each_extruded([&](const Triangle& t) { cut(t, slope, section.extruded); });
  double farthest_m = 0;
  for (int column = 0; column < colour.width_px; ++column) {
    const float depth_m = registered.frame.at(column, row);
    const auto direction = sensors::direction_through(colour, {column + 0.5, row + 0.5});
    if (sensors::DepthFrame::is_hole(depth_m) || !direction) continue;
    const double z = double{depth_m};
    section.seen.emplace_back(z * direction->x() / direction->z(), z);
    farthest_m = std::max(farthest_m, z);
  }
  section.depth_view = view_of(measured.camera, colour_from_depth, 1.05 * farthest_m);
  section.colour_view = view_of(colour, Eigen::Isometry3d::Identity(), 1.05 * farthest_m);
  return section;
}

void draw_section(const std::filesystem::path& svg, const Section& section, int row) {
  constexpr int width_px = 900, height_px = 760;
  const auto style = [](std::size_t i) { return plot_style(i).colour; };
  std::string script = block("measured", section.measured) + block("extruded", section.extruded) +
                       block("seen", section.seen) + block("depthview", section.depth_view) +
                       block("colourview", section.colour_view);
  script += fmt::format(
      "set title 'The mesh cut along row {} of the photograph, from above'\n"
      "set xlabel 'to the right, m'\nset ylabel 'forward, m'\nset size ratio -1\nset key outside below\n"
      "set border 3\nset tics nomirror out\nset yrange [-0.2:*]\n"
      "plot $depthview using 1:2 with lines dt 2 lc rgb '#999999' title 'view of the depth camera', \\\n"
      " $colourview using 1:2 with lines dt 3 lw 2 lc rgb '#555555' title 'view of the photograph', \\\n"
      " $measured using 1:2 with lines lw 4 lc rgb '{}' title 'mesh of measured depth', \\\n"
      " $extruded using 1:2 with lines lw 4 lc rgb '{}' title 'extruded border', \\\n"
      " $seen using 1:2 with points pt 7 ps 0.25 lc rgb '{}' title 'what pixels of the photograph get'\n",
      row, style(0), style(1), plot_ink);
  draw_svg(svg, width_px, height_px, script);
}

}  // namespace seamline::registration
