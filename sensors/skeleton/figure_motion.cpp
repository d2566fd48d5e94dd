#include "sensors/skeleton/figure_motion.h"

#include <fmt/core.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "support/files/toml_table.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::sensors {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr const char* gestures_format = "seamline gestures 1";

InputError bad_joint(const std::string& joint, const std::string& wanted, const std::string& found) {
  return input_error({.field = "joint \"" + printable(joint) + "\"", .wanted = wanted, .found = found});
}

/// Recorded joints as a skeleton, those that hold others first.
struct RecordedRig {
  Skeleton skeleton;
  std::vector<int> nodes;             ///< of each of its joints
  std::vector<std::size_t> recorded;  ///< which recorded joint it is
  /// Of a joint whose bones all lie along one line: that line, at rest. What it turns about the line moves
  /// none of its bones, so recorded places do not tell it.
  std::vector<std::optional<Eigen::Vector3d>> lines;
  std::vector<Eigen::Affine3d> above;  ///< of its node's parent, in the node of the joint that holds it
};

std::optional<Eigen::Vector3d> line_of_bones(const Skeleton& skeleton, std::size_t joint) {
  constexpr double least_sine = 1e-3;
  std::optional<Eigen::Vector3d> line;
  for (const Joint& other : skeleton.joints) {
    if (other.parent != static_cast<int>(joint) || !(other.offset_m.norm() > 0)) continue;
    const Eigen::Vector3d bone = other.offset_m.normalized();
    if (line && line->cross(bone).norm() > least_sine) return std::nullopt;
    line = line.value_or(bone);
  }
  return line;
}

/// Of a node: how many are above it.
int depth_of(const std::vector<FigureNode>& nodes, int node) {
  int depth = 0;
  for (int up = nodes[node].parent; up >= 0; up = nodes[up].parent) ++depth;
  return depth;
}

int node_of(const std::vector<FigureNode>& nodes, const std::string& joint) {
  int found = -1;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].name != joint) continue;
    if (found >= 0) throw bad_joint(joint, "one node of its name in the figure", "several");
    found = static_cast<int>(i);
  }
  if (found < 0) throw bad_joint(joint, "a node of its name in the figure", "none");
  return found;
}

RecordedRig recorded_rig(const FigureFile& figure, const RecordedMotion& motion) {
  const std::vector<FigureNode>& nodes = figure.nodes();
  std::vector<std::pair<int, std::size_t>> order;  // by depth
  std::vector<int> node_of_joint;
  for (std::size_t j = 0; j < motion.joints.size(); ++j) {
    node_of_joint.push_back(node_of(nodes, motion.joints[j]));
    order.emplace_back(depth_of(nodes, node_of_joint.back()), j);
  }
  std::sort(order.begin(), order.end());
  RecordedRig rig;
  std::vector<int> place(nodes.size(), -1);
  for (const auto& [depth, j] : order) {
    const int node = node_of_joint[j];
    Joint joint{.name = motion.joints[j], .hinges = {}};
    for (int up = nodes[node].parent; up >= 0 && joint.parent < 0; up = nodes[up].parent)
      joint.parent = place[up];
    if (joint.parent < 0 && !rig.nodes.empty())
      throw bad_joint(joint.name, "a joint that hangs on \"" + rig.skeleton.joints[0].name + "\"",
                      "one that does not");
    if (joint.parent >= 0) {
      const int holder = rig.nodes[joint.parent];
      joint.offset_m = nodes[node].world.translation() - nodes[holder].world.translation();
      rig.skeleton.joints[joint.parent].hinges = {
          {Eigen::Vector3d::UnitX()}, {Eigen::Vector3d::UnitY()}, {Eigen::Vector3d::UnitZ()}};
    }
    place[node] = static_cast<int>(rig.nodes.size());
    rig.nodes.push_back(node);
    rig.recorded.push_back(j);
    const int parent = nodes[node].parent;
    rig.above.push_back(parent < 0 ? Eigen::Affine3d::Identity() : nodes[parent].world);
    if (joint.parent >= 0) {
      const int holder = rig.nodes[joint.parent];
      rig.above.back() = nodes[holder].world.inverse() * rig.above.back();
    }
    rig.skeleton.joints.push_back(joint);
  }
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) rig.lines.push_back(line_of_bones(rig.skeleton, i));
  return rig;
}

/// The joints at rest, turned as one body to where they were measured (Kabsch): where the descent begins.
SkeletonPose turned_as_one(const Skeleton& skeleton, const MeasuredJoints& measured_m) {
  SkeletonPose pose = rest_pose(skeleton);
  const std::vector<PlacedJoint> rest = place_joints(skeleton, pose);
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero(), to_m = Eigen::Vector3d::Zero();
  double count = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (measured_m[i]) from_m += rest[i].position_m, to_m += *measured_m[i], ++count;
  if (count == 0) return pose;
  from_m /= count, to_m /= count;
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (measured_m[i]) moment += (*measured_m[i] - to_m) * (rest[i].position_m - from_m).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  const Eigen::Matrix3d turned = u * svd.matrixV().transpose();
  pose.root_m = to_m - turned * from_m;
  if (skeleton.joints[0].hinges.empty()) return pose;
  const Eigen::Vector3d angles_rad = turned.eulerAngles(0, 1, 2);
  std::copy(angles_rad.begin(), angles_rad.end(), pose.angles_rad.begin());
  return pose;
}

/// Bones as long as they were seen last, as long as the figure's until then.
void take_bones(const Skeleton& figure, const MeasuredJoints& measured_m, Skeleton& recorded) {
  const Skeleton now = with_bones_of(figure, measured_m);
  for (std::size_t i = 1; i < now.joints.size(); ++i)
    if (measured_m[i] && measured_m[now.joints[i].parent])
      recorded.joints[i].offset_m = now.joints[i].offset_m;
}

/// Which joints have one behind them that was seen.
std::vector<char> seen_behind(const Skeleton& skeleton, const MeasuredJoints& measured_m) {
  std::vector<char> seen(measured_m.size(), 0);
  for (std::size_t i = seen.size() - 1; i > 0; --i)
    if (measured_m[i] || seen[i] != 0) seen[skeleton.joints[i].parent] = 1;
  return seen;
}

/// How far each joint is turned against the one that holds it. It keeps that where nothing behind it was
/// seen, and where its bones lie along a line it is the shortest turn that brings them there.
void take_turns(const RecordedRig& rig, const std::vector<PlacedJoint>& placed, const std::vector<char>& seen,
                std::vector<Eigen::Matrix3d>& turns) {
  std::vector<Eigen::Matrix3d> world;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const int parent = rig.skeleton.joints[i].parent;
    const Eigen::Matrix3d before = parent < 0 ? Eigen::Matrix3d::Identity() : world[parent];
    const Eigen::Matrix3d found = before.transpose() * placed[i].orientation;
    if (seen[i] != 0 && rig.lines[i])
      turns[i] = Eigen::Quaterniond::FromTwoVectors(*rig.lines[i], found * *rig.lines[i]).toRotationMatrix();
    else if (seen[i] != 0)
      turns[i] = found;
    world.emplace_back(before * turns[i]);
  }
}

}  // namespace

FigureMotion move_figure(const FigureFile& figure, const RecordedMotion& motion) {
  const RecordedRig rig = recorded_rig(figure, motion);
  const std::size_t joints = rig.nodes.size();
  FigureMotion out;
  out.nodes.resize(motion.joints.size());
  out.turned_deg.resize(motion.joints.size());
  SkeletonPose pose;
  Skeleton recorded = rig.skeleton;
  std::vector<Eigen::Matrix3d> turns(joints, Eigen::Matrix3d::Identity());
  for (std::size_t t = 0; t < motion.times_s.size(); ++t) {
    stop_if_interrupted();
    MeasuredJoints measured_m;
    for (const std::size_t j : rig.recorded) measured_m.push_back(motion.places_m[t][j]);
    take_bones(rig.skeleton, measured_m, recorded);
    pose = fit_pose(recorded, measured_m, t == 0 ? turned_as_one(recorded, measured_m) : pose).pose;
    take_turns(rig, place_joints(recorded, pose), seen_behind(recorded, measured_m), turns);
    std::vector<Eigen::Affine3d> world;  // of each joint's node, as the file will have it
    double square_m2 = 0, count = 0;
    for (std::size_t i = 0; i < joints; ++i) {
      const FigureNode& node = figure.nodes()[rig.nodes[i]];
      const FigureNode above = node.parent < 0 ? FigureNode{} : figure.nodes()[node.parent];
      MovedNode& moved = out.nodes[rig.recorded[i]];
      moved.node = rig.nodes[i];
      out.turned_deg[rig.recorded[i]].push_back(degrees * Eigen::AngleAxisd(turns[i]).angle());
      Eigen::Affine3d own = node.own;
      if (i == 0) {
        own.translation() = above.world.inverse() * pose.root_m;
        moved.translations_m.emplace_back(own.translation());
      }
      const Eigen::Quaterniond at_rest = above.turned.conjugate() * node.turned;
      Eigen::Quaterniond turned = above.turned.conjugate() * Eigen::Quaterniond(turns[i]) * node.turned;
      own.linear() = (turned * at_rest.conjugate()).toRotationMatrix() * node.own.linear();
      world.push_back(rig.above[i] * own);
      if (i > 0) world[i] = world[recorded.joints[i].parent] * world[i];
      if (measured_m[i]) square_m2 += (world[i].translation() - *measured_m[i]).squaredNorm(), ++count;
      if (recorded.joints[i].hinges.empty()) continue;
      if (!moved.rotations.empty() && moved.rotations.back().dot(turned) < 0) turned.coeffs() *= -1;
      moved.rotations.push_back(turned.normalized());
    }
    out.rms_m.push_back(std::sqrt(square_m2 / count));
  }
  return out;
}

std::vector<Gesture> read_gestures(const std::filesystem::path& path,
                                   const std::vector<std::string>& joints) {
  const TomlTable table = TomlTable::read(path);
  if (const std::string format = table.text("format"); format != gestures_format)
    throw table.complaint("format", fmt::format("\"{}\"", gestures_format), "\"" + format + "\"");
  std::vector<Gesture> gestures;
  for (const TomlTable& one : table.tables("gesture")) {
    Gesture gesture{.name = one.text("name"), .ranges = {}};
    const auto ranges = one.table("turned_deg");
    if (!ranges) throw one.complaint("turned_deg", "a table of joints", "nothing");
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (!ranges->has(joints[j])) continue;
      const std::vector<double> range = ranges->numbers(joints[j], {0, 180, "degrees"});
      if (range.size() != 2 || !(range[0] < range[1]))
        throw ranges->complaint(joints[j], "two angles, the smaller one first", "others");
      gesture.ranges.push_back({j, range[0], range[1]});
    }
    ranges->finish();
    one.finish();
    if (gesture.ranges.empty()) throw one.complaint("turned_deg", "a recorded joint", "none");
    gestures.push_back(std::move(gesture));
  }
  table.finish();
  return gestures;
}

std::vector<std::pair<double, double>> times_of(const Gesture& gesture, const FigureMotion& figure,
                                                const std::vector<double>& times_s) {
  std::vector<std::pair<double, double>> out;
  bool held = false;
  for (std::size_t t = 0; t < times_s.size(); ++t) {
    const bool holds = std::all_of(gesture.ranges.begin(), gesture.ranges.end(), [&](const auto& range) {
      const double deg = figure.turned_deg[range.joint][t];
      return deg >= range.least_deg && deg <= range.most_deg;
    });
    if (holds && !held) out.emplace_back(times_s[t], times_s[t]);
    if (holds) out.back().second = times_s[t];
    held = holds;
  }
  return out;
}

}  // namespace seamline::sensors
