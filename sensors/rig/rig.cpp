#include "sensors/rig/rig.h"

#include <fmt/core.h>

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

void require_valid_noise(const NoiseModel& noise, const std::string& where) {
  std::visit([&](const auto& model) { require_valid(model, where + "noise."); }, noise);
}

}  // namespace

Eigen::Isometry3d pose_of(const Eigen::Vector3d& translation_m, const Eigen::Vector3d& axis,
                          double angle_deg) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
  pose.translation() = translation_m;
  return pose;
}

void require_rigid(const Eigen::Isometry3d& pose, const std::string& field) {
  if (!pose.matrix().allFinite())
    throw input_error({.field = field, .wanted = "finite numbers", .found = "others"});
  const Eigen::Matrix3d rotation = pose.linear();
  const double deviation =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (deviation > 1e-6)
    throw input_error({.field = field,
                       .wanted = "a rotation, whose columns are of length 1 and at right angles",
                       .found = fmt::format("a matrix that is off by {:.2g}", deviation)});
  if (rotation.determinant() < 0)
    throw input_error({.field = field, .wanted = "a rotation", .found = "a reflection (determinant -1)"});
}

void require_valid(const Rig& rig, const std::string& where) {
  require_valid(rig.depth, where + "depth.");
  require_valid(rig.colour, where + "colour.");
  require_rigid(rig.colour_from_depth, where + "colour_from_depth");
  if (rig.projector_m && !rig.projector_m->allFinite())
    throw input_error({.field = where + "projector_m", .wanted = "finite numbers", .found = "others"});
  require_valid_noise(rig.noise, where);
}

void require_valid(const Scanner& scanner, const std::string& where) {
  require_within(scanner.width_px, 4, 1e6, where + "width_px");
  require_within(scanner.height_px, 2, 1e6, where + "height_px");
  require_within(scanner.lowest_elevation_deg, -90, 90, where + "lowest_elevation_deg");
  require_within(scanner.highest_elevation_deg, scanner.lowest_elevation_deg + 1e-3, 90,
                 where + "highest_elevation_deg");
  require_valid_noise(scanner.noise, where);
}

}  // namespace seamline::sensors
