#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracer/scene/gltf/transparency.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/definition/surface/material_model.h"

namespace seamline::renderer {

/// Where a joint stands in the frame of its parent.
struct JointPose {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// A node of a glTF file that moves what hangs on it.
struct FigureJoint {
  std::string name;  ///< of the node; may be empty
  int parent = -1;   ///< among the joints, before its children; -1: the root
  Eigen::Affine3d bound = Eigen::Affine3d::Identity();  ///< from its frame to that of `FigureSkin`
  JointPose place = {};                                 ///< in the moment that was read
  std::vector<JointPose> keys = {};                     ///< at each of the figure's times
};

/// The vertices of one mesh in the pose in which they were bound to the joints.
struct FigureSkin {
  std::vector<Eigen::Vector3d> positions = {};
  std::vector<Eigen::Vector3f> normals = {};  ///< unit, or empty
  /// Of each vertex the joints that hold it, and their weights, whose sum is 1.
  std::vector<std::vector<std::pair<int, double>>> held_by = {};
};

/// A figure that joints move: vertex = sum over joints j of weight_j world_j bound_j^-1 position, where
/// world_j is the product of `above_root` and the places from the root to j. One joint is the root.
struct SceneFigure {
  std::vector<FigureJoint> joints;
  std::vector<FigureSkin> meshes;                            ///< as many as `read_scene_moment` has
  Eigen::Affine3d above_root = Eigen::Affine3d::Identity();  ///< of the nodes above, which stand
  Eigen::Affine3d from_bound =
      Eigen::Affine3d::Identity();  ///< world_j bound_j^-1 of a joint that holds skin
  std::string animation;            ///< its name; empty: there is none
  std::vector<double> times_s;      ///< of the animation's keys
};

struct FigureRequest {
  std::filesystem::path path;
  MaterialModel materials = MaterialModel::diffuse;
  Transparency transparency = Transparency::refused;
  std::optional<FileMoment> moment = {};
  /// Whether a node's name is that of a person's joint. Files without a skin are figures where `least_joints`
  /// nodes have such names.
  std::function<bool(std::string_view)> is_joint = {};
  std::size_t least_joints = 4;
};

/// A figure, or why it is none in one sentence; neither: nothing in the file says that it is one.
struct FigureRead {
  std::optional<SceneFigure> figure;
  std::string why_not;
};

/// Reads the joints, the skin and the keys of the moment's animation, else of the first. Between keys turns
/// go the shorter way and places along lines; steps and splines are read 60 times a second. The moment's
/// nodes stand where it places them meanwhile. What only the figure needs and the file has wrong is why there
/// is none; the file itself must be one that `read_scene_moment` has read before, else InputError.
[[nodiscard]] FigureRead read_figure(const FigureRequest& request);

}  // namespace seamline::renderer
