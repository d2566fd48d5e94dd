#pragma once
#include "sensors/noise/noise_stream.h"
#include "sensors/noise/seen_pixel.h"

namespace seamline::sensors {

/// A sensor of which nothing is known but the size of its errors, with n standard normal:
///
///     d' = d (1 + s relative_sigma n)                then the nearest multiple of s step_m
///
/// and, independently, a share s dropout_share of holes and s outliers.share of wild values, where s is the
/// scale of the noise (shares end at 1). The quantisation adds about step^2 / 12 to the variance where sigma
/// is above half a step (Widrow and Kollar, "Quantization Noise", 2008).
struct GenericNoise {
  DepthConvention convention = DepthConvention::planar;
  double relative_sigma = 0;  ///< standard deviation as a share of the depth
  double step_m = 0;          ///< 0: no quantisation
  double dropout_share = 0;
  Outliers outliers = {};
  SensorRange range = {};

  auto operator<=>(const GenericNoise&) const = default;
};

/// One pixel's measurement, a pure function of its arguments; `scale` 0 or more.
[[nodiscard]] MeasuredPixel measure_pixel(const GenericNoise& model, const SeenPixel& seen,
                                          const NoiseStream& stream, double scale);

/// Standard deviation of the value of a pixel that is measured and no outlier, without the quantisation;
/// infinite where nothing is seen.
[[nodiscard]] double noise_sigma_m(const GenericNoise& model, const SeenPixel& seen, double scale);

/// Throws InputError naming `where`, field, wanted and found.
void require_valid(const GenericNoise& model, const std::string& where);

}  // namespace seamline::sensors
