#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace seamline::renderer {

/// Checked reading of glTF accessors: every byte read is proven to lie inside its buffer first.
class GltfReader {
 public:
  GltfReader(const tinygltf::Model& model, std::string file) : model_(model), file_(std::move(file)) {}

  /// Accessor `index` as 3-vectors; throws InputError unless it is VEC3 of float or normalised integers.
  [[nodiscard]] std::vector<Eigen::Vector3d> vectors(int index, const std::string& field) const;
  /// Accessor `index` as texture coordinates; throws InputError unless it is VEC2 of finite numbers.
  [[nodiscard]] std::vector<Eigen::Vector2f> texture_coordinates(int index, const std::string& field) const;
  /// Accessor `index` as tangents with their sign; throws InputError unless it is VEC4 of finite numbers.
  [[nodiscard]] std::vector<Eigen::Vector4f> tangents(int index, const std::string& field) const;
  /// Accessor `index` as 4-vectors: rotations, joints, weights. Throws InputError unless it is VEC4 of finite
  /// numbers.
  [[nodiscard]] std::vector<Eigen::Vector4d> quadruples(int index, const std::string& field) const;
  /// Accessor `index` as linear red, green, blue and alpha, 0 to 1; alpha is 1 where it has none. Whole
  /// numbers are shares of their type's largest. Throws InputError unless it is VEC3 or VEC4 of finite
  /// numbers.
  [[nodiscard]] std::vector<Eigen::Array4f> colours(int index, const std::string& field) const;
  /// Accessor `index` as transforms; throws InputError unless it is MAT4 of finite numbers.
  [[nodiscard]] std::vector<Eigen::Affine3d> transforms(int index, const std::string& field) const;
  /// Accessor `index` as unsigned scalars; throws InputError unless it is SCALAR of unsigned integers.
  [[nodiscard]] std::vector<std::uint32_t> indices(int index, const std::string& field) const;

  /// All numbers of accessor `index`, element after element: keys of animations. Throws InputError unless it
  /// has so many components and only finite numbers.
  [[nodiscard]] std::vector<double> numbers(int index, int components, const std::string& field) const;

  /// How many elements accessor `index` claims to have; 0 for one that does not exist. Nothing is read.
  [[nodiscard]] std::int64_t count(int index) const;

 private:
  template <class Vector>
  [[nodiscard]] std::vector<Vector> finite_vectors(int index, const std::string& field) const;
  [[nodiscard]] std::vector<double> components(int index, int wanted_components,
                                               const std::string& field) const;
  void overwrite_sparse(int index, int component_count, std::vector<double>& values,
                        const std::string& field) const;

  const tinygltf::Model& model_;
  std::string file_;
};

}  // namespace seamline::renderer
