#pragma once
#include <Eigen/Core>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "sensors/repair/repaired.h"

namespace seamline::sensors {

/// Flat surfaces are found and replaced by planes, which paper 000 (sections 4 and 5) names as future work
/// against depth that ripples. A plane that can be seen does not pass through the camera, so it is a vector a
/// with a . x = 1 of all its points x; a pixel whose ray runs x = z m has the depth z = 1 / (a . m) on it.
///
/// Planes are found by random sampling (Fischler and Bolles 1981): three pixels near one another give a
/// plane; it is supported by the pixels whose depth differs from the plane's by at most the tolerance *along
/// the ray*, which is where a sensor's noise acts; the best so far is fitted to its support by least squares
/// of (z - 1 / (a . m)) / tolerance (Gauss and Newton) and asked again (Chum, Matas and Kittler 2003). What
/// supports a plane is taken from the search, and the next one is looked for.
struct PlaneRepair {
  int most_planes = 6;
  double least_share = 0.03;        ///< of all pixels; a plane with less support is left
  double tolerance_m = 0.01;        ///< about three standard deviations of the noise
  double tolerance_relative = 0.0;  ///< added: this share of the depth
  int draws = 300;                  ///< samples of three pixels for each plane
  std::uint64_t seed = 1;

  auto operator<=>(const PlaneRepair&) const = default;
};

struct FoundPlane {
  Eigen::Vector3d inverse;  ///< a, 1/m: the normal divided by the distance from the camera, in its frame
  std::int64_t pixels = 0;  ///< replaced by this plane
};

struct RepairedPlanes {
  Repaired repaired;                ///< holes stay holes
  std::vector<FoundPlane> planes;   ///< as found, most often the largest first
  std::vector<int> plane_of_pixel;  ///< -1: none
};

/// Throws InputError naming `where`, field, wanted and found.
void require_valid(const PlaneRepair& repair, const std::string& where);

/// Replaces flat surfaces by planes, a pure function of its arguments. Pixels of no plane are kept. Throws
/// InputError as `require_valid`.
[[nodiscard]] RepairedPlanes replace_planes(const DepthFrame& measured, const PlaneRepair& repair);

}  // namespace seamline::sensors
