#include "laboratory/figures/marker_scene.h"

#include <tiny_gltf.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "registration/calibration/aruco.h"
#include "support/files/gltf_writing.h"

namespace seamline::renderer {
namespace {

/// Squares of one colour, all facing +z.
struct Squares {
  std::string name;
  double albedo = 0.5;
  std::vector<Eigen::Vector3f> corners_m = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {};

  void add(double left_m, double low_m, double width_m, double height_m, double z_m) {
    const auto first = static_cast<std::uint32_t>(corners_m.size());
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      corners_m.push_back(Eigen::Vector3d(left_m + x * width_m, low_m + y * height_m, z_m).cast<float>());
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  }
};

std::array<Squares, 3> squares_of(const MarkerBoard& board) {
  using registration::marker_pattern;
  using registration::marker_squares;
  const double square_m = board.side_m / marker_squares;
  std::array<Squares, 3> parts = {Squares{.name = "black", .albedo = 0.05},
                                  {.name = "white", .albedo = 0.85},
                                  {.name = "wall", .albedo = 0.4}};
  for (int row = -1; row <= marker_squares; ++row)
    for (int column = -1; column <= marker_squares; ++column) {
      const bool margin = row < 0 || column < 0 || row == marker_squares || column == marker_squares;
      const bool white = margin || marker_pattern[row][column] != 0;
      parts[white ? 1 : 0].add((column - 0.5 * marker_squares) * square_m,
                               (0.5 * marker_squares - 1 - row) * square_m, square_m, square_m, 0);
    }
  constexpr double wall_half_m = 20;
  parts[2].add(-wall_half_m, -wall_half_m, 2 * wall_half_m, 2 * wall_half_m, -board.wall_m);
  return parts;
}

int add_positions(tinygltf::Model& model, const std::vector<Eigen::Vector3f>& corners_m) {
  const int accessor =
      add_accessor(model, std::as_bytes(std::span(corners_m)),
                   {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER});
  Eigen::Vector3f least = corners_m.front(), most = corners_m.front();
  for (const Eigen::Vector3f& corner_m : corners_m) {
    least = least.cwiseMin(corner_m);
    most = most.cwiseMax(corner_m);
  }
  model.accessors.back().minValues = {least.x(), least.y(), least.z()};
  model.accessors.back().maxValues = {most.x(), most.y(), most.z()};
  return accessor;
}

void add_part(tinygltf::Model& model, const Squares& squares) {
  tinygltf::Material material;
  material.name = squares.name;
  material.pbrMetallicRoughness.baseColorFactor = {squares.albedo, squares.albedo, squares.albedo, 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.doubleSided = true;
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material);
  primitive.attributes["POSITION"] = add_positions(model, squares.corners_m);
  primitive.indices = add_accessor(
      model, std::as_bytes(std::span(squares.triangles)),
      {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
  tinygltf::Node node;
  node.name = squares.name;
  node.mesh = static_cast<int>(model.meshes.size());
  tinygltf::Mesh mesh;
  mesh.name = squares.name;
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(node);
}

void add_camera(tinygltf::Model& model, double distance_m) {
  constexpr double aspect = 4.0 / 3;
  tinygltf::Camera camera;
  camera.type = "perspective";
  camera.perspective.aspectRatio = aspect;
  camera.perspective.yfov = 2 * std::atan(std::tan(marker_view_deg * std::numbers::pi / 360) / aspect);
  camera.perspective.znear = 0.01;
  model.cameras.push_back(camera);
  tinygltf::Node node;
  node.name = "camera";
  node.camera = 0;
  node.translation = {0, 0, distance_m};
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(node);
}

}  // namespace

void write_marker_scene(const std::filesystem::path& path, const MarkerBoard& board) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "seamline";
  model.buffers.emplace_back();
  model.scenes.emplace_back();
  model.defaultScene = 0;
  for (const Squares& squares : squares_of(board)) add_part(model, squares);
  add_camera(model, board.camera_m);
  write_glb_file(path, model);
}

}  // namespace seamline::renderer
