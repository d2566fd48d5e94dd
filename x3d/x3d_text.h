#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

// Pieces of X3D in the HTML encoding of X3DOM.

/// Numbers as a field holds them, with a tenth of a millimetre in every kilometre.
[[nodiscard]] std::string field_text(double value);
[[nodiscard]] std::string field_text(const Eigen::Vector2d& v);
[[nodiscard]] std::string field_text(const Eigen::Vector3d& v);

/// Text of our own (a shader) inside an element: its line breaks stay.
[[nodiscard]] std::string element_text(std::string_view text);

/// What vertices have besides their places, where they have it.
struct VertexValues {
  std::span<const Eigen::Vector3f> normals;
  std::span<const Eigen::Vector3f> colours;
};

/// `<indexedTriangleSet>`.
[[nodiscard]] std::string triangle_set(std::span<const Eigen::Vector3f> positions_m,
                                       const VertexValues& values, std::span<const Triangle> triangles);

/// `<field>` of a ComposedShader.
[[nodiscard]] std::string shader_field(const char* name, const char* type, const std::string& value);

}  // namespace seamline::renderer
