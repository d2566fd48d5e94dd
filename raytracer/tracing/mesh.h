#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "raytracer/material/direction_map.h"
#include "raytracer/material/material.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// Three indices into a mesh's vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// Diffuse albedo by direction from the renderer's origin.
using AlbedoMap = DirectionMap<Rgb>;

/// A triangle mesh with one material, in the renderer's frame (metres, centred on the camera).
struct SurfaceMesh {
  std::string name;
  int object_index = 0;  ///< 0 background, 1 left, 2 middle, 3 right
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Eigen::Vector3f> normals;  ///< unit shading normals, or empty: geometric ones are used
  std::vector<Triangle> triangles;
  Rgb albedo = Rgb::Constant(0.5F);  ///< of the diffuse base; with a material, no point of it has more
  Rgb emission = Rgb::Zero();        ///< radiance, both sides; likewise
  Rgb f0 = Rgb::Zero();              ///< of the specular layer (`Scatterer`); likewise
  float alpha = 1.0F;                ///< of the specular layer, where there is no material
  float f90 = 1.0F;                  ///< likewise
  std::shared_ptr<const Material> material;  ///< only where it differs from point to point
  /// Texture coordinates of each vertex, of the sets that the material asks for, and where its normal
  /// texture's right lies (`make_tangents`); else empty.
  std::array<std::vector<Eigen::Vector2f>, 2> uvs;
  std::vector<Eigen::Vector4f> tangents;
  std::vector<Eigen::Array4f> colours;  ///< of each vertex, times the base colour and alpha; empty: white
  /// Of the local scene's mesh, where it is painted: in place of `albedo`.
  std::shared_ptr<const AlbedoMap> albedo_by_direction;
};

/// The local scene D: the mesh rebuilt from a depth map, in metres, relative to the panorama's centre.
struct DepthMesh {
  std::vector<Eigen::Vector3f> vertices_m;
  std::vector<Triangle> triangles;
  double max_relative_error =
      0;  ///< largest |t_mesh - r| / r over the dense sphere's vertices; 0 for the full mesh
};

}  // namespace seamline::renderer
