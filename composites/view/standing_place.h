#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "raytracer/scene/camera.h"

namespace seamline::renderer {

/// A place on a real surface that the picture shows.
struct RealPlace {
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  ///< in the composite's world
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
  double across = 0.5, down = 0.5;  ///< where it is seen, shares of the picture's width and height
};

/// Where something stands that nobody has placed: the first surface that rises gently enough to stand on,
/// from the picture's middle downwards in the column `across`; else the surface in the middle, or the nearest
/// one to it upwards. `centre_m`: the camera's place in the world. None: there is no depth in that column.
[[nodiscard]] std::optional<RealPlace> place_in_view(const Camera& camera, const Geometry& depth,
                                                     const Eigen::Vector3d& centre_m, double across = 0.5);

/// The level on which most of the picture's level surfaces lie.
struct FloorInView {
  double height_m = 0;                   ///< Y in the composite's world
  double share = 0;                      ///< of the picture
  double nearest_m = 0, farthest_m = 0;  ///< from the camera, along rays
};
/// The lowest one that at least a fiftieth of the picture shows, within 5 cm or 2 % of the distance (noise of
/// depth); none where nothing level is seen.
[[nodiscard]] std::optional<FloorInView> floor_in_view(const Camera& camera, const Geometry& depth,
                                                       const Eigen::Vector3d& centre_m);

/// A flag a pixel, row by row: whether a line of a grid of `spacing_m` on the floor, along the world's axes,
/// goes through it. What stands before the floor hides it; `objects` may be null.
[[nodiscard]] std::vector<std::uint8_t> floor_grid(const Camera& camera, const Geometry& depth,
                                                   const Geometry* objects, const FloorInView& floor,
                                                   const Eigen::Vector3d& centre_m, double spacing_m,
                                                   int threads);

}  // namespace seamline::renderer
