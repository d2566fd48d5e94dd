#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace seamline::sensors {

/// A node of a figure's file, as the file has it at rest.
struct FigureNode {
  std::string name;
  int parent = -1;                                    ///< -1: a root
  Eigen::Affine3d own = Eigen::Affine3d::Identity();  ///< in its parent
  Eigen::Affine3d world = Eigen::Affine3d::Identity();
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();  ///< of `world`: the product of all rotations
};

/// How one node moves, by keys at the times of an animation.
struct MovedNode {
  int node = 0;
  std::vector<Eigen::Quaterniond> rotations;         ///< its own, empty: it does not turn
  std::vector<Eigen::Vector3d> translations_m = {};  ///< its own, empty: it keeps its place
};

/// A .glb file whose nodes are read and to which an animation is added; all else stays as it is, unknown
/// chunks too.
class FigureFile {
 public:
  /// Throws InputError naming the file for what is no .glb, or has no nodes, or nodes that are their own
  /// parents.
  explicit FigureFile(const std::filesystem::path& path);

  [[nodiscard]] const std::vector<FigureNode>& nodes() const { return nodes_; }

  /// Throws InputError where `out` is in another folder and files beside this one are named, which would not
  /// be found from there.
  void need_place_of(const std::filesystem::path& out) const;

  /// Throws InputError where there is one of that name or the name is no UTF-8, where times are not 0 or more
  /// and rise as floats, and where a node that moves has a matrix.
  void add_animation(const std::string& name, const std::vector<double>& times_s,
                     const std::vector<MovedNode>& motions);

  [[nodiscard]] std::string bytes() const;

 private:
  void read_nodes();
  [[nodiscard]] int add_numbers(const std::vector<float>& numbers, const char* type, std::size_t parts);

  std::string file_;
  nlohmann::ordered_json json_;
  std::string binary_, other_chunks_;
  std::vector<FigureNode> nodes_;
};

}  // namespace seamline::sensors
