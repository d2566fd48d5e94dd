#pragma once
#include "sensors/noise/noise_stream.h"
#include "sensors/noise/seen_pixel.h"

namespace seamline::sensors {

/// A camera that triangulates a projected pattern (Khoshelham and Elberink, "Accuracy and Resolution of
/// Kinect Depth Data for Indoor Mapping Applications", Sensors 12(2), 2012). With focal length f in pixels
/// and the baseline b between camera and projector, planar depth z is a disparity p in pixels, which is
/// measured with Gaussian noise and rounded:
///
///     p = f b / z         p' = nearest multiple of s step_px to  p + s sigma_px n         z' = f b / p'
///
/// with n standard normal and s the scale of the noise, so that (their Eq. 10 in these letters)
///
///     sigma_z = z^2 / (f b) sigma_px            and depths lie z^2 / (f b) step_px apart.
///
/// At grazing angles the measured noise grows faster (Nguyen, Izadi and Lovell, "Modeling Kinect Sensor Noise
/// for Improved 3D Reconstruction and Tracking", 3DIMPVT 2012); of their axial fit the term of the angle t is
/// taken here as it is, in quadrature with the one above:
///
///     sigma_t = grazing_sigma_m (z / 1 m)^(-1/2) t^2 / (pi/2 - t)^2             (0.0001 m in their fit)
///
/// Dropouts: the chance that a pixel is a hole rises from 0 at the angle `sure_deg` to 1 at `lost_deg`, and
/// from 0 at the signal `sure_signal` to 1 at `lost_signal`, linearly both times and independently, times s;
/// the signal is albedo cos t / (z / 1 m)^2. Literature agrees that these happen and gives no curve; the form
/// is ours. A pixel that the projector does not light is a hole; whether it does is traced by the caller.
///
/// Not modelled: the sideways noise of edges, the pattern's window that several pixels share (neighbouring
/// pixels here are independent), other light.
struct StructuredLightNoise {
  double focal_px = 585.6;
  double baseline_m = 0.075;
  double sigma_px = 0.0625;
  double step_px = 0.125;      ///< 0: no quantisation
  double grazing_sigma_m = 0;  ///< 0: the angle only drops
  double sure_deg = 70, lost_deg = 90;
  double sure_signal = 0, lost_signal = 0;
  Outliers outliers = {};
  SensorRange range = {};

  auto operator<=>(const StructuredLightNoise&) const = default;
};

/// One pixel's measurement, planar, a pure function of its arguments; `scale` 0 or more.
[[nodiscard]] MeasuredPixel measure_pixel(const StructuredLightNoise& model, const SeenPixel& seen,
                                          const NoiseStream& stream, double scale);

/// Standard deviation of the depth to first order, without the quantisation: both terms in quadrature, times
/// s; infinite where nothing is seen.
[[nodiscard]] double noise_sigma_m(const StructuredLightNoise& model, const SeenPixel& seen, double scale);

/// The chance that this pixel is a hole by angle and darkness, at this scale.
[[nodiscard]] double dropout_chance(const StructuredLightNoise& model, const SeenPixel& seen, double scale);

/// Throws InputError naming `where`, field, wanted and found.
void require_valid(const StructuredLightNoise& model, const std::string& where);

}  // namespace seamline::sensors
