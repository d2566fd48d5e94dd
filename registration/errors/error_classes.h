#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "registration/frame/registered_frame.h"
#include "sensors/noise/seen_pixel.h"

namespace seamline::registration {

/// Why the registered depth of a pixel is wrong, as far as geometry knows (paper 000, section 2.2.3 and Fig.
/// 4). Of several reasons a pixel has the first.
enum class ErrorClass : std::uint8_t {
  right,       ///< within the tolerance, or without a depth where nothing is
  border,      ///< the true point lies beyond the depth camera's picture, or the depth was extruded
  near,        ///< the true point is nearer than the sensor's range
  far,         ///< or farther
  occluded,    ///< something else hides the true point from the depth camera
  nothing,     ///< a depth where the truth has no surface
  unmeasured,  ///< the sensor saw the point and gave no value: a hole, or what a repair put there
  gap,         ///< measured, but not brought here: a hole between points, or in a mesh that was cut
  edge,        ///< at an outline, where the depth of the depth camera or the photograph jumps
  noise        ///< none of these: seen, measured, and wrong
};
inline constexpr std::size_t error_class_count = 10;

/// The class's name in tables.
[[nodiscard]] const char* word(ErrorClass error_class);

struct ErrorSettings {
  double tolerance = 0.05;          ///< share of the true depth by which a right one may differ
  sensors::SensorRange range = {};  ///< of the depth camera, in its convention
  int threads = 0;                  ///< 0: one for each core
};

/// Every pixel's class, and what each class's pixels are.
struct ErrorClassMap {
  std::vector<ErrorClass> classes;  ///< row by row
  struct Tally {
    std::int64_t pixels = 0;
    std::int64_t without_depth = 0;  ///< of these: registered as holes
    double median_error_m = 0;       ///< of those with a depth beside a true one; NaN: none
  };
  std::array<Tally, error_class_count> tallies{};

  [[nodiscard]] const Tally& of(ErrorClass one) const { return tallies[static_cast<std::size_t>(one)]; }
};

/// Compares registered depth with the truth seen from the photograph's camera (planar, of its size).
/// `measured` is what the depth camera delivered, before any repair.
///
/// What the depth camera truly sees is the truth, brought into its view by a mesh that is cut where depth
/// jumps by more than the tolerance (at least a hundredth), at about the photograph's pixels per angle. A
/// point is hidden when all depths of that view within a pixel of it are nearer by more than the tolerance.
/// An outline, where depth jumps so, is near when it lies within two pixels of the depth camera, there or in
/// the photograph: half a pixel's footprint mixes what it holds, and a triangle reaches a pixel farther. What
/// the photograph does not see hides nothing here.
///
/// The same for any number of threads. Throws InputError as `require_valid`, and for a truth of another size
/// than the registered frame.
[[nodiscard]] ErrorClassMap classify_errors(const RegisteredFrame& registered,
                                            const sensors::DepthFrame& truth,
                                            const sensors::DepthFrame& measured,
                                            const Eigen::Isometry3d& colour_from_depth,
                                            const ErrorSettings& settings = {});

}  // namespace seamline::registration
