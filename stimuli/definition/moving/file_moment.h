#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace seamline::inline stimuli {

/// A node of a glTF file that stands elsewhere than the file has it.
struct PlacedNode {
  std::string name;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();    ///< from there, along its parent's axes
  Eigen::Vector3d rotation_deg = Eigen::Vector3d::Zero();  ///< as of objects, about its own origin

  [[nodiscard]] bool stands() const { return position_m.isZero(0) && rotation_deg.isZero(0); }
};

/// How the nodes of a glTF file stand: in a moment of an animation, and some of them moved from there.
struct FileMoment {
  std::string animation = {};  ///< its name, or its number from 0; empty: the file's only one
  double time_s = 0;
  bool is_animated = true;  ///< else the file is at rest
  std::vector<PlacedNode> nodes = {};
};

/// A scene file as studies write it: `door.glb`, or `door.glb#Open@0.25`, which is the file 0.25 s into its
/// animation "Open". Within the program nodes stand before that, `door.glb#leaf@[0 0 0 0 90 0]`: metres, then
/// pitch, yaw and roll.
struct NamedFile {
  std::string file;
  std::optional<FileMoment> moment = {};
};

/// What stands before and behind the mark. Only what ends in .gltf or .glb before it, and `builtin:NAME`, has
/// a moment, so that other files keep a # in their names.
[[nodiscard]] NamedFile split_moment(const std::string& written);

/// The same file in another moment; its nodes stay where they were, but for those of the moment.
[[nodiscard]] std::string with_moment(const std::string& written, const FileMoment& moment);

/// The same file with a node there; a node that stands where the file has it is not written. Names have none
/// of `marks_of_nodes`.
inline constexpr const char* marks_of_nodes = "#@[]";
[[nodiscard]] std::string with_node(const std::string& written, const PlacedNode& node);
/// A node as it stands in a file that is written so.
[[nodiscard]] PlacedNode node_of(const std::string& written, const std::string& name);

/// What stands for an object's name where a node of the background moves, and back.
[[nodiscard]] std::string place_of_node(const std::string& name);
[[nodiscard]] std::optional<std::string> moved_node(const std::string& place);

}  // namespace seamline::inline stimuli
