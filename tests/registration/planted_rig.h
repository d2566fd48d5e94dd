#pragma once
#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include "registration/calibration/calibrate.h"
#include "sensors/rig/rig.h"
#include "support/arithmetic/random.h"

/// Rigs that are known, what they see of boards and points with Gaussian noise, and whether a calibration
/// finds them again within its own covariance.
namespace seamline::registration::test {

struct PlantedRig {
  sensors::PinholeCamera depth, colour;
  Eigen::Isometry3d colour_from_depth = Eigen::Isometry3d::Identity();
};

inline PlantedRig planted_rig() {
  PlantedRig rig;
  rig.depth = sensors::pinhole_of_field_of_view(320, 240, 58);
  rig.depth.cx_px += 3;
  rig.depth.cy_px -= 2;
  rig.depth.fy_px *= 1.01;
  rig.depth.distortion = {.k1 = -0.12, .k2 = 0.05, .p1 = 0.001, .p2 = -0.0005, .k3 = -0.02};
  rig.colour = sensors::pinhole_of_field_of_view(640, 480, 62);
  rig.colour.cx_px -= 4;
  rig.colour.distortion = {.k1 = 0.05, .k2 = -0.1, .p1 = -0.0007, .p2 = 0.0004, .k3 = 0.03};
  rig.colour_from_depth = sensors::pose_of({-0.025, 0.001, 0.002}, {0.2, 1, 0.1}, 1.5);
  return rig;
}

/// Boards in different tilts and distances, all over the pictures. (In the pictures' middle alone they leave
/// the lens so loosely determined that its curvature shows: ten of them held 90 instead of 95 % of the rigs.)
inline std::vector<Eigen::Isometry3d> planted_boards(const Board& board, int count, Random& random) {
  std::vector<Eigen::Isometry3d> poses;
  const Eigen::Vector3d middle_m = 0.5 * board.corner_m(board.corners() - 1);
  for (int i = 0; i < count; ++i) {
    const auto uniform = [&](double least, double most) { return least + (most - least) * random.uniform(); };
    const double distance_m = uniform(0.5, 0.8);
    Eigen::Isometry3d pose = sensors::pose_of(
        {0, 0, 0}, {random.normal(), random.normal(), 0.3 * random.normal()}, uniform(15, 40));
    const Eigen::Vector3d place_m(uniform(-0.3, 0.3) * distance_m, uniform(-0.22, 0.22) * distance_m,
                                  distance_m);
    pose.translation() = place_m - pose.linear() * middle_m;
    poses.push_back(pose);
  }
  return poses;
}

inline BoardPictures seen_boards(const sensors::PinholeCamera& camera,
                                 const Eigen::Isometry3d& camera_from_depth, const Board& board,
                                 const std::vector<Eigen::Isometry3d>& poses, double noise_px,
                                 Random& random) {
  BoardPictures pictures{camera.width_px, camera.height_px, {}};
  for (const Eigen::Isometry3d& pose : poses) {
    Corners corners;
    for (std::size_t i = 0; i < board.corners(); ++i)
      corners.push_back(*sensors::project(camera, camera_from_depth * pose * board.corner_m(i)) +
                        noise_px * Eigen::Vector2d(random.normal(), random.normal()));
    pictures.boards.push_back(corners);
  }
  return pictures;
}

/// By how much one camera differs from another, in the order of the parameters.
inline Eigen::VectorXd difference(const sensors::PinholeCamera& found,
                                  const sensors::PinholeCamera& true_one) {
  Eigen::VectorXd by(camera_parameters);
  const auto &a = found.distortion, &b = true_one.distortion;
  by << found.fx_px - true_one.fx_px, found.fy_px - true_one.fy_px, found.cx_px - true_one.cx_px,
      found.cy_px - true_one.cy_px, a.k1 - b.k1, a.k2 - b.k2, a.p1 - b.p1, a.p2 - b.p2, a.k3 - b.k3;
  return by;
}

inline Eigen::VectorXd difference(const Eigen::Isometry3d& found, const Eigen::Isometry3d& true_one) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(found.linear() * true_one.linear().transpose()));
  Eigen::VectorXd by(pose_parameters);
  by << turn.angle() * turn.axis(), found.translation() - true_one.translation();
  return by;
}

/// Whether an error lies in the ellipsoid that should hold 95 % of them: e^T C^-1 e / k against F.
inline bool is_within_95_percent(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance, int spare) {
  const double distance = error.dot(covariance.ldlt().solve(error)) / static_cast<double>(error.size());
  const boost::math::fisher_f f(static_cast<double>(error.size()), spare);
  return distance <= boost::math::quantile(f, 0.95);
}

/// How many of `trials` held, and whether a share of 95 % says so (at one in ten thousand on either side).
struct Held {
  int held = 0, trials = 0;
  [[nodiscard]] bool is_95_percent() const {
    const boost::math::binomial count(trials, 0.95);
    return boost::math::cdf(count, held) > 1e-4 &&
           (held == 0 || boost::math::cdf(boost::math::complement(count, held - 1)) > 1e-4);
  }
};

/// What is held of a rig in one set of trials: all of it together, its parts, and each parameter.
struct RigCoverage {
  Held together, depth, colour, pose;
  std::vector<Held> each = std::vector<Held>(2 * camera_parameters + pose_parameters);
};

inline RigCoverage rig_coverage(int trials, std::uint64_t seed) {
  const PlantedRig rig = planted_rig();
  const Board board{.columns = 8, .rows = 6, .square_m = 0.03};
  RigCoverage coverage;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(seed, static_cast<std::uint64_t>(trial));
    const auto poses = planted_boards(board, 16, random);
    const BoardPictures depth =
        seen_boards(rig.depth, Eigen::Isometry3d::Identity(), board, poses, 0.15, random);
    const BoardPictures colour = seen_boards(rig.colour, rig.colour_from_depth, board, poses, 0.15, random);
    const Refined found = calibrate_two_cameras(board, depth, colour, "trial");
    constexpr int count = 2 * camera_parameters + pose_parameters;
    Eigen::VectorXd error(count);
    error << difference(found.estimate.cameras[0], rig.depth),
        difference(found.estimate.cameras[1], rig.colour),
        difference(found.estimate.second_from_first, rig.colour_from_depth);
    const int spare = 2 * found.points - static_cast<int>(found.covariance.rows());
    const auto ask = [&](Held& held, int first, int size) {
      held.held += is_within_95_percent(error.segment(first, size),
                                        found.covariance.block(first, first, size, size), spare)
                       ? 1
                       : 0;
      ++held.trials;
    };
    ask(coverage.together, 0, count);
    ask(coverage.depth, 0, camera_parameters);
    ask(coverage.colour, camera_parameters, camera_parameters);
    ask(coverage.pose, 2 * camera_parameters, pose_parameters);
    for (int i = 0; i < count; ++i) ask(coverage.each[static_cast<std::size_t>(i)], i, 1);
  }
  return coverage;
}

/// Points before the depth camera and where the colour camera sees them.
inline std::vector<PointPair> planted_pairs(const PlantedRig& rig, int count, double noise_px,
                                            Random& random) {
  std::vector<PointPair> pairs;
  while (static_cast<int>(pairs.size()) < count) {
    const Eigen::Vector3d point_m(random.normal(), random.normal(), 1 + 3 * random.uniform());
    const auto place = sensors::project(rig.colour, rig.colour_from_depth * point_m);
    if (!place || !sensors::is_in_picture(rig.colour, *place)) continue;
    pairs.push_back({*place + noise_px * Eigen::Vector2d(random.normal(), random.normal()), point_m, 1});
  }
  return pairs;
}

inline Held pairs_coverage(int trials, std::uint64_t seed) {
  const PlantedRig rig = planted_rig();
  Held held;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(seed, static_cast<std::uint64_t>(trial));
    const Refined found = pose_of_pairs(rig.colour, planted_pairs(rig, 12, 0.5, random), "trial");
    const int spare = 2 * found.points - pose_parameters;
    held.held += is_within_95_percent(difference(found.estimate.first_from_view[0], rig.colour_from_depth),
                                      found.covariance, spare)
                     ? 1
                     : 0;
    ++held.trials;
  }
  return held;
}

}  // namespace seamline::registration::test
