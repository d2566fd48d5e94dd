#include "sensors/noise/generic_noise.h"

namespace seamline::sensors {
namespace {

double true_value_m(const GenericNoise& model, const SeenPixel& seen) {
  return model.convention == DepthConvention::radial ? seen.centre.radial_m : seen.planar_m;
}

}  // namespace

MeasuredPixel measure_pixel(const GenericNoise& model, const SeenPixel& seen, const NoiseStream& stream,
                            double scale) {
  const double true_m = true_value_m(model, seen);
  if (!std::isfinite(true_m)) return {.state = PixelState::nothing};
  if (stream.uniform(noise_number::dropout) < model.dropout_share * scale)
    return {.state = PixelState::dropped};
  if (is_outlier(model.outliers, stream, scale)) {
    MeasuredPixel pixel = pixel_of_value(outlier_value_m(model.outliers, stream), model.range);
    if (pixel.state == PixelState::measured) pixel.state = PixelState::outlier;
    return pixel;
  }
  double value_m = true_m * (1 + scale * model.relative_sigma * stream.normals(noise_number::normals).first);
  if (const double step_m = scale * model.step_m; step_m > 0) value_m = std::round(value_m / step_m) * step_m;
  return pixel_of_value(value_m, model.range);
}

double noise_sigma_m(const GenericNoise& model, const SeenPixel& seen, double scale) {
  return scale * model.relative_sigma * true_value_m(model, seen);
}

void require_valid(const GenericNoise& model, const std::string& where) {
  require_within(model.relative_sigma, 0, 1e6, where + "relative_sigma");
  require_within(model.step_m, 0, 1e6, where + "step_m");
  require_within(model.dropout_share, 0, 1, where + "dropout_share");
  require_valid(model.outliers, where);
  require_valid(model.range, where);
}

}  // namespace seamline::sensors
