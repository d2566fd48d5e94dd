#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "analysis/joint/joint_data.h"

namespace seamline::analysis {

/// What the curves of a study have in common; false: each curve has its own. Thresholds are always each
/// curve's own.
struct JointSharing {
  bool scale = true;          ///< s: how wide the transition is
  bool criteria = true;       ///< t_k and rho: where ratings begin
  bool lapse = true;          ///< how often something clearly visible is missed
  bool guess_ratings = true;  ///< g: how guessers rate

  auto operator<=>(const JointSharing&) const = default;
};

/// The largest lapse rate that the model knows.
inline constexpr double most_lapse = 0.1;

/// One curve in the letters of documentation/explanation/joint_model.md. With z = (m - x) / s and F the
/// normal distribution function, because the spread of people's thresholds is part of a group's curve:
///
///     psi(x) = (1 - lapse) F(z)                      seen
///     P(R >= k | seen) = F((z - t_k) / rho)          k = 2..K; t rises
///     P(right, r) = psi q(r) + (1 - psi) b g(r),     P(wrong, r) = (1 - psi) (1 - b) g(r)
///
/// q(r) is P(R = r | seen), b the chance of the cell.
struct JointCurve {
  double m = 0;      ///< threshold on the axis: half of what can be seen is seen
  double s = 1;      ///< scale, in units of the axis
  double lapse = 0;  ///< 0 to most_lapse
  std::array<double, most_joint_ratings - 1> t{};  ///< t_2..t_K, in units of s
  double rho = 1;                                  ///< spread of the ratings, in units of s
  std::array<double, most_joint_ratings> g = {1, 0, 0, 0};
  int ratings = most_joint_ratings;
};

/// Which of the model's coordinates belong to which curve. They are unbounded:
///
///     m,  log s,  l: lapse = most_lapse logistic(l),  t_2,  log(t_k - t_{k-1}),  log rho,
///     h_r: g(r) = exp(h_r) / sum exp(h), h_1 = 0
struct JointModel {
  int curves = 0;
  int ratings = most_joint_ratings;
  JointSharing sharing;
  /// Curves are one person's, whose thresholds are normal about m; the last coordinate is the logarithm of
  /// their standard deviation, and means are over people (joint_placed.h). false: curves are the group's.
  bool between_people = false;
  std::vector<JointCell> cells;
  double centre_x = 0, range_x = 1;  ///< of the levels tested: what the penalties measure with

  [[nodiscard]] Eigen::Index threshold(int curve) const { return curve; }
  [[nodiscard]] Eigen::Index log_scale(int curve) const;
  [[nodiscard]] Eigen::Index lapse(int curve) const;
  [[nodiscard]] Eigen::Index first_cut(int curve) const;  ///< t_2, then log distances; K > 1 only
  [[nodiscard]] Eigen::Index log_spread(int curve) const;
  [[nodiscard]] Eigen::Index first_guess(int curve) const;                     ///< h_2..h_K
  [[nodiscard]] Eigen::Index log_between() const { return parameters() - 1; }  ///< `between_people` only
  [[nodiscard]] Eigen::Index parameters() const;
};

/// `data` is checked.
[[nodiscard]] JointModel joint_model(const JointData& data, const JointSharing& sharing = {});

/// "m receiver", "log s", ...: one a coordinate.
[[nodiscard]] std::vector<std::string> parameter_names(const JointModel& model,
                                                       const std::vector<std::string>& curves);

[[nodiscard]] JointCurve curve_at(const JointModel& model, const Eigen::VectorXd& theta, int curve);

/// Probabilities of one cell's 2K outcomes in the order of `JointData::answers`.
[[nodiscard]] Eigen::VectorXd outcome_probabilities(const JointCurve& curve, double x, double chance);

}  // namespace seamline::analysis
