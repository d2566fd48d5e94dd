#include "sensors/noise/structured_light.h"

#include <algorithm>

namespace seamline::sensors {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

double angle_of(const SeenPixel& seen) {
  return std::acos(std::clamp(seen.centre.cosine, 0.0, 1.0));
}

/// 0 up to `sure`, 1 from `lost` on, linear between; the two may be the same, and in either order.
double ramp(double value, double sure, double lost) {
  if (sure == lost) return 0;
  return std::clamp((value - sure) / (lost - sure), 0.0, 1.0);
}

/// Disparity's standard deviation in pixels at scale 1.
double sigma_of(const StructuredLightNoise& model, const SeenPixel& seen) {
  if (model.grazing_sigma_m == 0) return model.sigma_px;
  const double angle = angle_of(seen), z = seen.planar_m;
  const double rest = std::max(std::numbers::pi / 2 - angle, 1e-6);
  const double grazing_m = model.grazing_sigma_m / std::sqrt(z) * (angle * angle) / (rest * rest);
  return std::hypot(model.sigma_px, grazing_m * model.focal_px * model.baseline_m / (z * z));
}

}  // namespace

double dropout_chance(const StructuredLightNoise& model, const SeenPixel& seen, double scale) {
  const double cosine = std::clamp(seen.centre.cosine, 0.0, 1.0);
  const double signal = seen.centre.albedo * cosine / (seen.planar_m * seen.planar_m);
  const double kept = (1 - ramp(angle_of(seen) * degrees_per_radian, model.sure_deg, model.lost_deg)) *
                      (1 - ramp(signal, model.sure_signal, model.lost_signal));
  return std::min(1.0, scale * (1 - kept));
}

MeasuredPixel measure_pixel(const StructuredLightNoise& model, const SeenPixel& seen,
                            const NoiseStream& stream, double scale) {
  if (!std::isfinite(seen.planar_m) || !(seen.planar_m > 0)) return {.state = PixelState::nothing};
  if (!seen.lit_by_projector) return {.state = PixelState::shadowed};
  if (!(seen.centre.cosine > 0) || !(seen.centre.albedo > 0)) return {.state = PixelState::too_weak};
  if (stream.uniform(noise_number::dropout) < dropout_chance(model, seen, scale))
    return {.state = PixelState::dropped};
  if (is_outlier(model.outliers, stream, scale)) {
    MeasuredPixel pixel = pixel_of_value(outlier_value_m(model.outliers, stream), model.range);
    if (pixel.state == PixelState::measured) pixel.state = PixelState::outlier;
    return pixel;
  }
  const double product = model.focal_px * model.baseline_m;
  double disparity_px =
      product / seen.planar_m + scale * sigma_of(model, seen) * stream.normals(noise_number::normals).first;
  if (const double step_px = scale * model.step_px; step_px > 0)
    disparity_px = std::round(disparity_px / step_px) * step_px;
  return pixel_of_value(disparity_px > 0 ? product / disparity_px : 0, model.range);
}

double noise_sigma_m(const StructuredLightNoise& model, const SeenPixel& seen, double scale) {
  if (!std::isfinite(seen.planar_m)) return std::numeric_limits<double>::infinity();
  return scale * seen.planar_m * seen.planar_m / (model.focal_px * model.baseline_m) * sigma_of(model, seen);
}

void require_valid(const StructuredLightNoise& model, const std::string& where) {
  require_within(model.focal_px, 1e-3, 1e9, where + "focal_px");
  require_within(model.baseline_m, 1e-6, 1e6, where + "baseline_m");
  require_within(model.sigma_px, 0, 1e6, where + "sigma_px");
  require_within(model.step_px, 0, 1e6, where + "step_px");
  require_within(model.grazing_sigma_m, 0, 1e6, where + "grazing_sigma_m");
  require_within(model.sure_deg, 0, 90, where + "sure_deg");
  require_within(model.lost_deg, model.sure_deg, 90, where + "lost_deg");
  require_within(model.sure_signal, 0, 1e9, where + "sure_signal");
  require_within(model.lost_signal, 0, model.sure_signal, where + "lost_signal");
  require_valid(model.outliers, where);
  require_valid(model.range, where);
}

}  // namespace seamline::sensors
