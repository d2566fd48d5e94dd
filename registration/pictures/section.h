#pragma once
#include <filesystem>
#include <utility>
#include <vector>

#include "registration/frame/registered_frame.h"
#include "registration/mesh/register_by_mesh.h"

namespace seamline::registration {

/// The mesh of a depth frame cut by the plane of one row of the photograph, seen from above (paper 000, Fig.
/// 3): points (x, z) of the colour camera's frame, right and forward, in metres.
struct Section {
  using Point = std::pair<double, double>;
  std::vector<std::pair<Point, Point>> measured, extruded;  ///< a piece for each triangle that is cut
  std::vector<Point> seen;                                  ///< what the photograph's pixels of the row get
  std::vector<Point> depth_view, colour_view;               ///< left edge of view, camera, right edge
};

/// `registered` is what `register_by_mesh` made of the same. Throws InputError naming `--section` for a row
/// that the photograph does not have.
[[nodiscard]] Section section_of(const sensors::DepthFrame& measured,
                                 const Eigen::Isometry3d& colour_from_depth,
                                 const sensors::PinholeCamera& colour, const MeshRegistration& mesh,
                                 const RegisteredFrame& registered, int row);

/// Draws it. Throws InputError without gnuplot.
void draw_section(const std::filesystem::path& svg, const Section& section, int row);

}  // namespace seamline::registration
