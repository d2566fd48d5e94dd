#include <algorithm>
#include <cmath>

#include "laboratory/convergence/estimates/estimates.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/points/register_by_points.h"

namespace seamline::renderer {
namespace {

constexpr double bulge = 0.25, bulge_distance_m = 2;  ///< of the surface z = 2 + x^2 / 4 + y / 10
constexpr double tilt = 0.1;

/// Where a ray through (x, y, 1) from (from_m, 0, 0) meets the surface, as its z.
double depth_of_bulge(double from_m, const Eigen::Vector3d& through) {
  // z = 2 + (from + x z)^2 / 4 + y z / 10
  const double a = bulge * through.x() * through.x();
  const double b = 2 * bulge * from_m * through.x() + tilt * through.y() - 1;
  const double c = bulge_distance_m + bulge * from_m * from_m;
  return 2 * c / (-b + std::sqrt(std::max(0.0, b * b - 4 * a * c)));
}

sensors::DepthFrame frame_of_bulge(int width_px, double from_m) {
  sensors::DepthFrame frame;
  frame.camera = sensors::pinhole_of_field_of_view(width_px, 3 * width_px / 4, 50);
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < width_px; ++column) {
      const Eigen::Vector3d through((column + 0.5 - frame.camera.cx_px) / frame.camera.fx_px,
                                    (row + 0.5 - frame.camera.cy_px) / frame.camera.fy_px, 1);
      frame.depth_m.push_back(static_cast<float>(depth_of_bulge(from_m, through)));
    }
  return frame;
}

double rms_of_registered_m(const sensors::DepthFrame& found, const sensors::DepthFrame& truth) {
  double squares = 0, pixels = 0;
  for (std::size_t i = 0; i < found.depth_m.size(); ++i) {
    if (sensors::DepthFrame::is_hole(found.depth_m[i])) continue;
    const double off_m = double{found.depth_m[i]} - double{truth.depth_m[i]};
    squares += off_m * off_m;
    ++pixels;
  }
  return pixels > 0 ? std::sqrt(squares / pixels) : 0;
}

}  // namespace

EstimateResult measure_registration() {
  constexpr double between_cameras_m = 0.05;
  constexpr int colour_width_px = 320, repeats = 3;
  const sensors::DepthFrame truth = frame_of_bulge(colour_width_px, between_cameras_m);
  Eigen::Isometry3d colour_from_depth = Eigen::Isometry3d::Identity();
  colour_from_depth.translation().x() = -between_cameras_m;
  EstimateResult result{
      .part = "registration",
      .amount = "depth_width_px",
      .unit = "m",
      .truth = "the distances of a bent wall in the photograph's camera, 5 cm beside the depth camera",
      .rows = {},
      .limit = {.what = "one pass over memory", .seconds_each = 0},
      .expected = -2,
      .why =
          "the mesh's chords leave the square of their length; a point lies anywhere in a pixel of the "
          "photograph, however many there are, so theirs stays"};
  const auto add = [&](const std::string& name, const sensors::DepthFrame& measured, const auto& method) {
    const double before = processor_seconds();
    registration::RegisteredFrame found;
    for (int i = 0; i < repeats; ++i) found = method(measured);
    result.rows.push_back({name, static_cast<double>(measured.camera.width_px),
                           (processor_seconds() - before) / repeats,
                           rms_of_registered_m(found.frame, truth)});
  };
  for (int width_px = 40; width_px <= 640; width_px *= 2)
    add("points", frame_of_bulge(width_px, 0), [&](const sensors::DepthFrame& measured) {
      return registration::register_by_points(measured, colour_from_depth, truth.camera, {}, 1);
    });
  for (int width_px = 40; width_px <= 640; width_px *= 2)
    add("mesh", frame_of_bulge(width_px, 0), [&](const sensors::DepthFrame& measured) {
      return registration::register_by_mesh(measured, colour_from_depth, truth.camera, {.threads = 1});
    });
  constexpr int copies = 500;
  std::vector<float> to(truth.depth_m.size());
  const double before = processor_seconds();
  float kept = 0;
  for (int i = 0; i < copies; ++i) {
    std::copy(truth.depth_m.begin(), truth.depth_m.end(), to.begin());
    kept += to[i];
  }
  result.limit.seconds_each = (processor_seconds() - before + (std::isnan(kept) ? 1 : 0)) / copies;
  return result;
}

}  // namespace seamline::renderer
