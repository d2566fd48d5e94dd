#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace seamline::renderer {

struct Ray {
  Eigen::Vector3f origin_m;
  Eigen::Vector3f direction;  ///< unit
  float far_m = std::numeric_limits<float>::infinity();
};

/// Rays of one piece of work, counted by the worker that does it: what is asked of a `Geometry` is added to
/// `traced`, what the transport of light leaves out to the others.
struct RayCounts {
  std::int64_t traced = 0;
  std::int64_t tails_traced = 0;    ///< of paths (see PathRules)
  std::int64_t tail_rays = 0;       ///< that these needed; in `traced` too
  std::int64_t tails_left_out = 0;  ///< for which those traced stand
  std::int64_t dark_sky_rays = 0;   ///< not traced, because there is no light at their end

  RayCounts& operator+=(const RayCounts& other) {
    traced += other.traced;
    tails_traced += other.tails_traced;
    tail_rays += other.tail_rays;
    tails_left_out += other.tails_left_out;
    dark_sky_rays += other.dark_sky_rays;
    return *this;
  }
  friend RayCounts operator+(RayCounts a, const RayCounts& b) { return a += b; }
};

}  // namespace seamline::renderer
