#pragma once
#include <Eigen/Core>
#include <cmath>
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// y(x) = lower + (upper - lower) / (1 + exp((x - centre) / scale)), x a coordinate on which it falls: log2
/// width, or what the study's quantity has for it. Its inflection point is the centre.
struct Logistic4 {
  double upper = 0;
  double lower = 0;
  double centre_x = 0;
  double scale_x = 1;  ///< a length on x: octaves where x is log2 width
};

/// 1 / (1 + exp(z)): 1 far below 0, 0 far above.
[[nodiscard]] inline double falling_logistic(double z) {
  return 1 / (1 + std::exp(z));
}

[[nodiscard]] double value_at(const Logistic4& curve, double level_x);

/// Whether the data say where the centre is.
enum class Centre {
  identified,
  step,           ///< the fit is a step between two widths: every centre between them is as good
  straight,       ///< the fit is all but a straight line: any centre is as good
  below_range,    ///< steepest below the smallest width tested
  above_range,    ///< steepest above the largest width tested
  not_falling,    ///< noticeability does not fall with width
  too_few_levels  ///< under four for four parameters
};

struct Logistic4Fit {
  Logistic4 curve;
  double residual_sum_of_squares = 0;
  Centre verdict = Centre::not_falling;
  /// The centres that the data leave open: one value when identified, the two neighbouring widths for a step,
  /// an infinite end where the centre may lie outside the tested range.
  LevelInterval centre_range;
};

/// Where centres and scales are looked for.
struct LogisticBox {
  double lowest_centre = 0, highest_centre = 0;  ///< log2 px: 2 octaves beyond the tested widths
  double smallest_scale = 0;                     ///< octaves: a tenth of the smallest spacing of widths
  double largest_scale = 0;                      ///< the whole range
};

/// `level_x` is rising, at least two widths.
[[nodiscard]] LogisticBox logistic_box(std::span<const double> level_x);

/// Where a climb begins; the asymptotes follow by linear least squares.
struct Logistic4Start {
  double centre_x = 0, scale_x = 1;
};

/// Fits four-parameter logistics by least squares to means at fixed widths, one after the other, fast enough
/// for a bootstrap. By variable projection (Golub and Pereyra 1973): for a given centre and scale the two
/// asymptotes are linear least squares, so the best curve is the (centre, scale) whose logistic has the
/// largest projection of the data.
/// 1. The projections onto a grid (centres an eighth of an octave apart from 2 octaves below to 2 above the
/// tested range;
///    16 scales from a tenth of the smallest spacing of widths to the whole range) are computed once for the
///    widths, so scanning the whole grid costs a matrix-vector product and no local optimum is missed.
/// 2. The three best local optima of the grid are polished by Levenberg-Marquardt on all four parameters; the
/// best wins. The asymptotes are not bounded to 0 and 4: they are what the curve tends to, not ratings.
class Logistic4Fitter {
 public:
  /// `level_x` is rising.
  explicit Logistic4Fitter(std::vector<double> level_x);

  /// `means` has one value a width.
  [[nodiscard]] Logistic4Fit fit(std::span<const double> means) const;

  [[nodiscard]] const std::vector<double>& level_x() const { return level_x_; }

 private:
  [[nodiscard]] std::vector<Logistic4Start> starts(const Eigen::VectorXd& means) const;
  [[nodiscard]] double polish(const Logistic4Start& start, const Eigen::VectorXd& means,
                              Logistic4& curve) const;
  [[nodiscard]] Logistic4Fit judge(const Logistic4& curve, double residual) const;

  std::vector<double> level_x_;
  std::vector<double> centres_;
  std::vector<double> scales_;
  Eigen::MatrixXd
      basis_;  ///< (centre, scale) pairs x widths: centred logistics of unit norm, 0 where all but constant
};

}  // namespace seamline::analysis
