#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace seamline::sensors {

/// What a value of a depth map says.
enum class DepthValue {
  metres,   ///< a distance, in some unit
  inverse,  ///< 1 / distance = scale * value + shift, per metre: MiDaS, Depth Anything, disparity
  relative  ///< distance = scale * value + shift: affine-invariant depth, as of Marigold
};

/// The straight line between values and inverse or plain metres.
struct DepthLine {
  double scale = 1, shift = 0;
};

/// A place of the map whose distance is known.
struct KnownPoint {
  double x_px = 0, y_px = 0;  ///< from the map's upper left corner
  double depth_m = 0;
};

/// What an estimate's line is found from: one of the three.
struct DepthEstimate {
  DepthValue value = DepthValue::inverse;
  std::optional<DepthLine> stated;
  std::vector<KnownPoint> points;
  std::filesystem::path reference;                  ///< a depth map in metres of the same directions
  std::optional<double> reference_metres_per_step;  ///< of its whole numbers required
};

/// A value and its distance.
struct KnownValue {
  double value = 0, depth_m = 0;
};

/// A line and how far the known distances are from it.
struct DepthFit {
  DepthLine line;
  std::size_t used = 0;
  double abs_rel = 0;         ///< mean of |d - d*| / d*, d* being what is known
  double rmse_m = 0;          ///< root of the mean of (d - d*)^2
  double within_quarter = 0;  ///< share with max(d / d*, d* / d) < 1.25
};

/// The distance of a value; infinite where the line gives none (0 or less, or no number).
[[nodiscard]] double metres_of_value(DepthValue kind, const DepthLine& line, double value);

/// Least squares: of an inverse map in 1 / distance (Ranftl et al. 2020, Eq. 4), of a relative one in
/// distance. One known value fixes the scale alone, the shift being 0. Throws InputError naming `field` where
/// there is no known value, where all are of one value though their distances differ, or where nearer things
/// would come out farther (a scale of 0 or less).
[[nodiscard]] DepthFit fit_depth(DepthValue kind, std::span<const KnownValue> known,
                                 const std::string& field);

/// "1 / distance = 0.00021 value + 0.1, from 3 points: AbsRel 0.01, RMSE 0.02 m, delta < 1.25 100 %".
[[nodiscard]] std::string fit_text(DepthValue kind, const DepthFit& fit, const std::string& from);

}  // namespace seamline::sensors
