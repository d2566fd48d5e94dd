#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "renderer/depth/depth_map.h"

namespace seamline::renderer {

/// How flat surfaces are looked for in a panorama.
struct PlaneSearch {
  double tolerance = 0.01;      ///< share of the distance by which what supports a plane may lie off it
  double least_share = 0.0003;  ///< of all directions; a smaller face is none
  int most_faces = 128;
  int draws = 400;  ///< of three texels near one another, for each plane
  std::uint64_t seed = 1;
};

/// A connected part of a plane a . x = 1, which is seen at the distance 1 / (a . m) in the direction m.
struct PlaneFace {
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();  ///< a, 1/m: away from the centre
  double share = 0;                                   ///< of all directions
  std::int64_t fitted_texels = 0;                     ///< of the whole map, that the plane was fitted to

  [[nodiscard]] Eigen::Vector3d normal() const { return -inverse.normalized(); }  ///< towards the centre
  [[nodiscard]] double distance_m(const Eigen::Vector3d& direction) const {
    return 1 / inverse.dot(direction);
  }
};

/// Faces of a map, found in a thinner one of at most 512 columns and fitted to all its texels.
struct PlaneFaces {
  DepthMap thin;
  std::vector<Eigen::Vector3d> directions;  ///< of its texels, in the world
  std::vector<PlaneFace> faces;             ///< as found, most often the largest first
  std::vector<int> face_of_texel;           ///< of the thin map; -1: none
};

/// Looks for planes by random sampling, as `sensors::replace_planes` does, with what supports a plane parted
/// into connected faces; each is then fitted by least squares of (r - 1 / (a . m)) a . m to the texels within
/// three standard deviations. A pure function of its arguments. `yaw_texels`: see MeshOptions.
[[nodiscard]] PlaneFaces find_plane_faces(const DepthMap& map, double yaw_texels, const PlaneSearch& search);

}  // namespace seamline::renderer
