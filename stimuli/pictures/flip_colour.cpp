#include "stimuli/pictures/flip_colour.h"

#include <Eigen/LU>
#include <cmath>

namespace seamline::inline stimuli {
namespace {

/// IEC 61966-2-1 primaries and D65 as exact fractions.
const Eigen::Matrix3d& xyz_from_rgb() {
  static const Eigen::Matrix3d matrix{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                      {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                      {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
  return matrix;
}

const Eigen::Matrix3d& rgb_from_xyz() {
  static const Eigen::Matrix3d matrix = xyz_from_rgb().inverse();
  return matrix;
}

const Eigen::Array3d& white_xyz() {
  static const Eigen::Array3d white = xyz_from_rgb().rowwise().sum().array();
  return white;
}

Eigen::Array3d relative_xyz(const Eigen::Array3d& rgb) {
  return (xyz_from_rgb() * rgb.matrix()).array() / white_xyz();
}

double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

constexpr double distance_power = 0.7;  // q_c
constexpr double bend_share = 0.4;      // p_c
constexpr double bend_value = 0.95;     // p_t

/// c_max of Eq. 9.
double largest_power() {
  static const double power = std::pow(
      hyab_distance(hunt_adjusted(lab_from_linear({0, 1, 0})), hunt_adjusted(lab_from_linear({0, 0, 1}))),
      distance_power);
  return power;
}

}  // namespace

Eigen::Array3d ycxcz_from_linear(const Eigen::Array3d& rgb) {
  const Eigen::Array3d xyz = relative_xyz(rgb);
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Eigen::Array3d linear_from_ycxcz(const Eigen::Array3d& ycxcz) {
  const double y = (ycxcz[0] + 16) / 116;
  const Eigen::Array3d xyz{y + ycxcz[1] / 500, y, y - ycxcz[2] / 200};
  return (rgb_from_xyz() * (xyz * white_xyz()).matrix()).array();
}

Eigen::Array3d lab_from_linear(const Eigen::Array3d& rgb) {
  const Eigen::Array3d xyz = relative_xyz(rgb);
  const double fx = lab_curve(xyz[0]), fy = lab_curve(xyz[1]), fz = lab_curve(xyz[2]);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Eigen::Array3d hunt_adjusted(const Eigen::Array3d& lab) {
  return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

double hyab_distance(const Eigen::Array3d& a, const Eigen::Array3d& b) {
  const Eigen::Array3d difference = a - b;
  return std::abs(difference[0]) + std::hypot(difference[1], difference[2]);
}

double colour_difference_of_distance(double hyab) {
  const double power = std::pow(hyab, distance_power), most = largest_power();
  const double bend = bend_share * most;
  if (power < bend) return bend_value / bend * power;
  return bend_value + (power - bend) / (most - bend) * (1 - bend_value);
}

}  // namespace seamline::inline stimuli
