#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "x3d/x3d_subject.h"

namespace seamline::renderer {

/// Where an HAnimJoint is, as a Transform of X3D: translation, then rotation and scale about its centre.
struct X3dJointPose {
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// A joint in the frame of X3D, in which the figure was bound to it.
struct X3dJoint {
  std::string name = {};
  int parent = -1;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond scale_axes = Eigen::Quaterniond::Identity();  ///< along which it is scaled
  X3dJointPose place = {};
  std::vector<X3dJointPose> keys = {};
};

/// A figure in the frame of X3D: vertices of all meshes in one row, each mesh's own behind those before it.
struct X3dFigure {
  std::vector<X3dJoint> joints = {};
  std::vector<Eigen::Vector3f> positions_m = {}, normals = {}, colours = {};
  std::vector<std::vector<std::pair<int, double>>> held_by = {};
  std::vector<std::vector<Triangle>> triangles = {};  ///< of each mesh, into that row
  std::string animation = {};
  std::vector<double> fractions = {};  ///< of the cycle, at each key
  double cycle_s = 0;
};

/// What of a figure X3D's joints cannot say; empty: nothing.
[[nodiscard]] std::string why_no_x3d_figure(const SceneFigure& figure, const Eigen::Affine3d& x3d_from_file);

/// The subject's figure, bound where it stands; meshes without normals get their triangles' own. `openness`:
/// of the objects' vertices.
[[nodiscard]] X3dFigure x3d_figure(const X3dSubject& subject, std::span<const std::vector<float>> openness);

}  // namespace seamline::renderer
