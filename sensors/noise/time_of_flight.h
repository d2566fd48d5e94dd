#pragma once
#include "sensors/noise/noise_stream.h"
#include "sensors/noise/seen_pixel.h"

namespace seamline::sensors {

/// A continuous-wave time-of-flight camera (Lange and Seitz, "Solid-state time-of-flight range camera", IEEE
/// Journal of Quantum Electronics 37(3), 2001; Kolb, Barth, Koch and Larsen, "Time-of-Flight Sensors in
/// Computer Graphics", Eurographics state of the art report, 2009). Its light is modulated with the frequency
/// f; the pixel takes four samples a quarter of a period apart, and depth is the phase of what comes back. Of
/// a diffuse surface with albedo a, the angle t to its normal, at radial distance r, comes the amplitude (in
/// photoelectrons a sample)
///
///     A = amplitude_at_1m_e a cos t / (r / 1 m)^2
///
/// and a pixel whose footprint mixes K surfaces receives the sum of their phasors, which lies between their
/// distances where they differ by less than half the ambiguity range: a flying pixel (Kolb et al. 2009).
///
///     P = sum_k A_k / K exp(i 4 pi f r_k / c)
///
/// Each sample also holds unmodulated light, B = sum A_k / K / contrast + background_e in the mean, and has
/// the variance V = B + readout_e^2 of shot noise and readout. Half the difference of two opposite samples is
/// one component of P, so each has the variance V / 2:
///
///     P' = P + s sqrt(V / 2) (n1 + i n2)              n1, n2 standard normal, s the scale of the noise
///     d = c / (4 pi f) arg P'                         in [0, c / (2 f)), the ambiguity range
///
/// For A well above the noise this is Lange and Seitz' result,
///
///     sigma_d = c / (4 pi sqrt(2) f) sqrt(V) / A,
///
/// and where A drowns, d is uniform over the ambiguity range, as in a real camera. A camera with several
/// frequencies resolves the ambiguity (`wraps = false`): d is then the value nearest to the strongest surface
/// in the footprint; its noise is that of the frequency f all the same.
///
/// Not modelled: light that comes by more than one way (multipath), the systematic "wiggling" of modulations
/// that are no sines, motion between the four samples.
struct TimeOfFlightNoise {
  double modulation_hz = 20e6;
  double amplitude_at_1m_e = 20000;  ///< photoelectrons a sample, of a white surface seen head on at 1 m
  double contrast = 0.5;             ///< demodulation contrast: modulated share of the camera's own light
  double background_e = 5000;        ///< photoelectrons a sample, of other light
  double readout_e = 50;             ///< standard deviation of readout, photoelectrons
  double weakest_amplitude_e = 20;   ///< pixels whose noiseless |P| is not above it are holes
  double full_well_e = 1e9;          ///< pixels with a larger B are holes
  bool wraps = true;                 ///< false: the ambiguity is resolved
  bool mixes = true;                 ///< false: the centre's ray alone is measured, no flying pixels
  Outliers outliers = {};
  SensorRange range = {};

  auto operator<=>(const TimeOfFlightNoise&) const = default;
};

/// c / (2 f): distances that differ by it have the same phase. Metres.
[[nodiscard]] double ambiguity_range_m(const TimeOfFlightNoise& model);

/// Amplitude of one surface that fills the pixel, in photoelectrons a sample; 0 where there is none.
[[nodiscard]] double amplitude_e(const TimeOfFlightNoise& model, const SubRay& surface);

/// One pixel's measurement, radial, a pure function of its arguments; `scale` 0 or more. The amplitude
/// delivered is |P'|; the confidence q / (1 + q) with q = |P'|^2 / (s^2 V / 2), the ratio of signal and noise
/// in power.
[[nodiscard]] MeasuredPixel measure_pixel(const TimeOfFlightNoise& model, const SeenPixel& seen,
                                          const NoiseStream& stream, double scale);

/// s sigma_d of the formula above, with |P| for A; infinite where no light comes back.
[[nodiscard]] double noise_sigma_m(const TimeOfFlightNoise& model, const SeenPixel& seen, double scale);

/// Throws InputError naming `where`, field, wanted and found.
void require_valid(const TimeOfFlightNoise& model, const std::string& where);

}  // namespace seamline::sensors
