#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// What one ray of a pixel's footprint truly meets. Each of a pixel's K sub-rays stands for one K-th of it.
struct SubRay {
  double radial_m = std::numeric_limits<double>::infinity();  ///< infinity: nothing there
  double albedo = 0;  ///< diffuse reflectance at the sensor's own light, 0 to 1
  double cosine = 0;  ///< of the angle between ray and surface normal, 0 to 1
};

/// What one pixel truly sees: along the ray of its centre, and in its footprint.
struct SeenPixel {
  SubRay centre;
  double planar_m = std::numeric_limits<double>::infinity();  ///< the centre's distance as z
  bool lit_by_projector = true;           ///< false: in the shadow of the sensor's own projector
  std::span<const SubRay> sub_rays = {};  ///< empty: the whole footprint is as the centre
};

/// What became of a pixel. Only `measured` and `outlier` have a depth.
enum class PixelState : std::uint8_t {
  measured,
  outlier,       ///< a value that has nothing to do with the scene
  nothing,       ///< no surface
  too_weak,      ///< too little of the sensor's own light comes back
  saturated,     ///< too much light
  dropped,       ///< lost at random, by the surface's angle or darkness
  shadowed,      ///< the projector does not light it
  out_of_range,  ///< the measured value is no distance, or outside the sensor's range
};
inline constexpr int pixel_state_count = 8;

/// The state's name in words, for tables.
[[nodiscard]] const char* name_of(PixelState state);

/// What a sensor says of one pixel; a hole unless the state is `measured` or `outlier`.
struct MeasuredPixel {
  float depth_m = hole;  ///< in the model's convention
  float amplitude = 0;   ///< the model's own unit; 0 where it has none
  float confidence = 0;  ///< 0 to 1
  PixelState state = PixelState::nothing;
};

/// The distances that a sensor delivers; what falls outside becomes a hole, and is counted.
struct SensorRange {
  double nearest_m = 0;
  double farthest_m = 1e9;

  auto operator<=>(const SensorRange&) const = default;
};

/// Single wild values, "sporadic and extreme" (paper 002, section 8): this share of the pixels, each with a
/// value that is uniform over the range and knows nothing of the scene.
struct Outliers {
  double share = 0;
  double nearest_m = 0.1;
  double farthest_m = 7.5;

  auto operator<=>(const Outliers&) const = default;
};

/// What the models share: a value becomes the pixel's depth, or a hole where it is no number, not above 0,
/// not a finite float or outside the range.
[[nodiscard]] MeasuredPixel pixel_of_value(double depth_m, const SensorRange& range);

class NoiseStream;

/// Whether a pixel is an outlier at this scale of the noise, and the value it then has.
[[nodiscard]] bool is_outlier(const Outliers& outliers, const NoiseStream& stream, double scale);
[[nodiscard]] double outlier_value_m(const Outliers& outliers, const NoiseStream& stream);

/// Throw InputError naming `where`, field, wanted and found.
void require_valid(const SensorRange& range, const std::string& where);
void require_valid(const Outliers& outliers, const std::string& where);

/// Throws InputError unless the value is a finite number within [lowest, highest].
void require_within(double value, double lowest, double highest, const std::string& field);

}  // namespace seamline::sensors
