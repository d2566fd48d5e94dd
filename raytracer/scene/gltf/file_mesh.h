#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/material/material.h"
#include "raytracer/tracing/mesh.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// One mesh primitive of a scene file in world space.
struct FileMesh {
  std::string name;  ///< of the node that places it
  std::vector<Eigen::Vector3d> positions_m;
  std::vector<Eigen::Vector3f> normals;  ///< unit shading normals, or empty
  std::vector<Triangle> triangles;
  std::optional<Rgb> albedo;                      ///< base colour factor; none when the mesh has no material
  Rgb emission = Rgb::Zero();                     ///< radiance
  std::shared_ptr<const Material> material = {};  ///< none when the mesh has none
  /// Of each vertex, TEXCOORD_0 and TEXCOORD_1; empty where no texture of the material asks for them.
  std::array<std::vector<Eigen::Vector2f>, 2> uvs = {};
  /// Of each vertex (`make_tangents`); empty without a normal texture.
  std::vector<Eigen::Vector4f> tangents = {};
  /// Of each vertex, COLOR_0: linear red, green, blue and alpha, 0 to 1, by which the base colour is
  /// multiplied; empty: there are none, or all are white.
  std::vector<Eigen::Array4f> colours = {};
};

}  // namespace seamline::renderer
