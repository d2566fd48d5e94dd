#pragma once
#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "sensors/frame/depth_frame.h"
#include "sensors/noise/generic_noise.h"
#include "sensors/noise/structured_light.h"
#include "sensors/noise/time_of_flight.h"

namespace seamline::sensors {

using NoiseModel = std::variant<GenericNoise, TimeOfFlightNoise, StructuredLightNoise>;

/// What a whole sensor truly sees, row by row from the upper left, every vector with one value a pixel. It is
/// what a renderer traces, and knows nothing of noise.
struct SeenFrame {
  PinholeCamera camera;
  std::vector<float> radial_m;                 ///< of the pixel's centre; +infinity: nothing there
  std::vector<float> albedo;                   ///< empty: 1 everywhere
  std::vector<float> cosine;                   ///< empty: 1 everywhere
  std::vector<std::uint8_t> lit_by_projector;  ///< 0 or 1; empty: 1 everywhere
  int sub_rays_per_pixel = 0;
  std::vector<SubRay> sub_rays;  ///< those of a pixel one after another
};

/// What a sensor delivers, with what became of each pixel.
struct Measurement {
  DepthFrame frame;
  std::vector<PixelState> states;
  std::array<std::int64_t, pixel_state_count> counts{};  ///< pixels of each state

  [[nodiscard]] std::int64_t count(PixelState state) const { return counts[static_cast<std::size_t>(state)]; }
};

/// Radial for time of flight, planar for structured light, stated by the generic model.
[[nodiscard]] DepthConvention convention_of(const NoiseModel& model);

/// Standard deviation of what the model measures of a pixel, at this scale of the noise.
[[nodiscard]] double noise_sigma_m(const NoiseModel& model, const SeenPixel& seen, double scale);

/// What a pixel of a frame sees, as models ask it; it points into the frame.
[[nodiscard]] SeenPixel seen_pixel(const SeenFrame& seen, int column, int row);

/// The depths themselves, without any model.
[[nodiscard]] DepthFrame true_depth(const SeenFrame& seen, DepthConvention convention);

/// What the sensor delivers of this frame: a pure function of (seen, model, key, scale), the same bytes for
/// any number of threads (0: one for each core).
///
/// `scale` multiplies every standard deviation, step and share (shares end at 1). What is no error but the
/// way the instrument works stays as it is, at 0 too: mixing, wrapping, range, the least amplitude,
/// saturation, the projector's shadow. So 0 is the limit of small scales, with the instrument's holes; what
/// no instrument lacks is `true_depth`.
///
/// Throws InputError for a scale below 0, a model or camera that is none, and vectors of another size.
[[nodiscard]] Measurement measure(const SeenFrame& seen, const NoiseModel& model, const NoiseKey& key,
                                  double scale = 1, int threads = 0);

}  // namespace seamline::sensors
