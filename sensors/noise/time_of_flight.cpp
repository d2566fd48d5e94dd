#include "sensors/noise/time_of_flight.h"

#include <algorithm>
#include <complex>

namespace seamline::sensors {
namespace {

constexpr double speed_of_light_m_s = 299792458;
constexpr double two_pi = 2 * std::numbers::pi;

/// The light of a pixel before noise.
struct PixelLight {
  std::complex<double> phasor;  ///< P, its phase counted from `reference_m`
  double variance = 0;          ///< V, of one sample
  double offset_e = 0;          ///< B
  double reference_m = 0;       ///< distance of the strongest surface
};

PixelLight light_of(const TimeOfFlightNoise& model, const SeenPixel& seen) {
  const auto footprint = model.mixes && !seen.sub_rays.empty() ? seen.sub_rays : std::span(&seen.centre, 1);
  const double share = 1.0 / footprint.size();
  PixelLight light;
  double strongest = 0, sum = 0;
  for (const SubRay& ray : footprint)
    if (const double amplitude = amplitude_e(model, ray); amplitude > strongest) {
      strongest = amplitude;
      light.reference_m = ray.radial_m;
    }
  // Phases are counted from the strongest surface, so that far ones lose no digits.
  const double radians_per_metre = two_pi / ambiguity_range_m(model);
  for (const SubRay& ray : footprint) {
    const double amplitude = share * amplitude_e(model, ray);
    if (amplitude == 0) continue;
    sum += amplitude;
    light.phasor += std::polar(amplitude, radians_per_metre * (ray.radial_m - light.reference_m));
  }
  light.offset_e = sum / model.contrast + model.background_e;
  light.variance = light.offset_e + model.readout_e * model.readout_e;
  return light;
}

}  // namespace

double ambiguity_range_m(const TimeOfFlightNoise& model) {
  return speed_of_light_m_s / (2 * model.modulation_hz);
}

double amplitude_e(const TimeOfFlightNoise& model, const SubRay& surface) {
  if (!std::isfinite(surface.radial_m) || !(surface.radial_m > 0)) return 0;
  const double reflected = std::max(0.0, surface.albedo) * std::max(0.0, surface.cosine);
  // What lies at the lens itself stays finite: phasors of infinity would be none.
  return std::min(model.amplitude_at_1m_e * reflected / (surface.radial_m * surface.radial_m), 1e30);
}

MeasuredPixel measure_pixel(const TimeOfFlightNoise& model, const SeenPixel& seen, const NoiseStream& stream,
                            double scale) {
  const PixelLight light = light_of(model, seen);
  if (!std::isfinite(seen.centre.radial_m) && light.reference_m == 0) return {.state = PixelState::nothing};
  const double true_amplitude = std::abs(light.phasor);
  if (!(true_amplitude > model.weakest_amplitude_e))
    return {.amplitude = static_cast<float>(true_amplitude), .state = PixelState::too_weak};
  if (light.offset_e > model.full_well_e)
    return {.amplitude = static_cast<float>(true_amplitude), .state = PixelState::saturated};

  const double sigma = scale * std::sqrt(light.variance / 2);
  const NoiseStream::Pair n = stream.normals(noise_number::normals);
  const std::complex<double> measured = light.phasor + sigma * std::complex<double>(n.first, n.second);
  const bool wild = is_outlier(model.outliers, stream, scale);
  double value_m = outlier_value_m(model.outliers, stream);
  if (!wild) {
    const double range_m = ambiguity_range_m(model);
    value_m = light.reference_m + range_m * std::arg(measured) / two_pi;
    if (model.wraps) value_m -= range_m * std::floor(value_m / range_m);
  }
  MeasuredPixel pixel = pixel_of_value(value_m, model.range);
  const double power = std::norm(measured), noise_power = sigma * sigma;
  pixel.amplitude = static_cast<float>(std::sqrt(power));
  if (pixel.state != PixelState::measured) return pixel;
  pixel.confidence = power > 0 ? static_cast<float>(power / (power + noise_power)) : 0.0F;
  if (wild) pixel.state = PixelState::outlier;
  return pixel;
}

double noise_sigma_m(const TimeOfFlightNoise& model, const SeenPixel& seen, double scale) {
  const PixelLight light = light_of(model, seen);
  return scale * ambiguity_range_m(model) / two_pi * std::sqrt(light.variance / 2) / std::abs(light.phasor);
}

void require_valid(const TimeOfFlightNoise& model, const std::string& where) {
  require_within(model.modulation_hz, 1e3, 1e12, where + "modulation_hz");
  require_within(model.amplitude_at_1m_e, 0, 1e15, where + "amplitude_at_1m_e");
  require_within(model.contrast, 1e-6, 1, where + "contrast");
  require_within(model.background_e, 0, 1e15, where + "background_e");
  require_within(model.readout_e, 0, 1e9, where + "readout_e");
  require_within(model.weakest_amplitude_e, 0, 1e15, where + "weakest_amplitude_e");
  require_within(model.full_well_e, 0, 1e15, where + "full_well_e");
  require_valid(model.outliers, where);
  require_valid(model.range, where);
}

}  // namespace seamline::sensors
