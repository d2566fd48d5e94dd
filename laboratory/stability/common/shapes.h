#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "laboratory/stability/common/namespaces.h"
#include "raytracer/scene/truth_scene.h"

namespace seamline::stability {

// Shapes whose light is known by hand, in the renderer's frame.

using PartPointer = std::shared_ptr<const SurfaceMesh>;

/// What a shape is made of.
struct Matter {
  float albedo = 0.5F;
  float emission = 0;    ///< radiance
  int object_index = 0;  ///< 0 background, 1 left, 2 middle, 3 right
};

[[nodiscard]] PartPointer shape_of(std::vector<Eigen::Vector3f> positions_m, std::vector<Triangle> triangles,
                                   const Matter& matter = {});
/// A sphere of `around` x `around / 2` facets.
[[nodiscard]] PartPointer ball_shape(const Eigen::Vector3f& centre_m, float radius_m, int around,
                                     const Matter& matter = {});
/// An axis-aligned box.
[[nodiscard]] PartPointer box_shape(const Eigen::Vector3f& least_m, const Eigen::Vector3f& most_m,
                                    const Matter& matter = {});
/// A square of the plane through `centre_m` spanned by unit vectors u and v, in cells x cells squares.
struct PlaneSquare {
  Eigen::Vector3d centre_m = {0, -1, -4};
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = -Eigen::Vector3d::UnitZ();
  double half_size_m = 20;
  int cells = 1;
};
[[nodiscard]] PartPointer plane_shape(const PlaneSquare& square, const Matter& matter = {});

/// A scene with a camera at the origin that looks along -Z; `object` is the left one.
struct SmallScene {
  std::vector<PartPointer> background;
  std::vector<PartPointer> object;
  Light light;
  int width_px = 64, height_px = 36;
};
[[nodiscard]] TruthScene truth_scene_of(const SmallScene& scene);

/// A light with a hard sun, a constant sky and a number of bounces.
[[nodiscard]] Light sun_and_sky(const Eigen::Vector3f& to_sun, float irradiance_w_m2, float sky_radiance,
                                int bounces);

}  // namespace seamline::stability
