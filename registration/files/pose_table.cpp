#include "registration/files/pose_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "sensors/rig/rig.h"
#include "support/text/limits.h"

namespace seamline::registration {
namespace {

constexpr NumberRange any_term{-1e6, 1e6};
constexpr NumberRange any_metres{-limits::farthest_place_m, limits::farthest_place_m, "m"};

Eigen::Matrix3d rotation_of_matrix(const TomlTable& table) {
  const std::vector<double> values = table.numbers("rotation", any_term);
  if (values.size() != 9)
    throw table.complaint("rotation", "nine numbers, a matrix row by row",
                          fmt::format("{} numbers", values.size()));
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

Eigen::Matrix3d rotation_of_quaternion(const TomlTable& table) {
  const std::vector<double> q = table.numbers("quaternion_xyzw", any_term);
  const double length = q.size() == 4 ? std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) : 0;
  if (std::abs(length - 1) > 1e-3)
    throw table.complaint(
        "quaternion_xyzw", "four numbers x, y, z, w whose squares have the sum 1",
        q.size() == 4 ? fmt::format("a length of {:.4g}", length) : fmt::format("{} numbers", q.size()));
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
}

Eigen::Matrix3d rotation_of_axis(const TomlTable& table) {
  const std::array<double, 3> axis = table.triple("axis", {0, 0, 0}, any_term);
  const Eigen::Vector3d direction(axis[0], axis[1], axis[2]);
  if (!(direction.norm() > 1e-9)) throw table.complaint("axis", "a direction that is not zero", "none");
  const double angle_deg = table.number("angle_deg", 0, {-360, 360, "degrees"});
  return sensors::pose_of({0, 0, 0}, direction, angle_deg).linear();
}

std::string numbers_text(std::span<const double> values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace

Eigen::Isometry3d read_pose(const TomlTable& table) {
  if (!table.has("translation_m")) throw table.missing("translation_m", "three numbers");
  const std::array<double, 3> place = table.triple("translation_m", {0, 0, 0}, any_metres);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(place[0], place[1], place[2]);
  const bool matrix = table.has("rotation"), quaternion = table.has("quaternion_xyzw"),
             axis = table.has("axis") || table.has("angle_deg");
  if (int{matrix} + int{quaternion} + int{axis} > 1)
    throw table.complaint("rotation", "one of rotation, quaternion_xyzw, and axis with angle_deg",
                          "more than one");
  if (matrix) pose.linear() = rotation_of_matrix(table);
  if (quaternion) pose.linear() = rotation_of_quaternion(table);
  if (axis) pose.linear() = rotation_of_axis(table);
  table.finish();
  return pose;
}

std::string pose_text(const std::string& name, const Eigen::Isometry3d& pose) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = pose.linear();
  const Eigen::Vector3d place = pose.translation();
  return fmt::format("\n[{}]\ntranslation_m = {}\nrotation = {}\n", name, numbers_text({place.data(), 3}),
                     numbers_text({rotation.data(), 9}));
}

}  // namespace seamline::registration
