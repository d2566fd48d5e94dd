#pragma once
#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/joint/joint_mean_curve.h"

namespace seamline::analysis {

/// What is read off a curve of the joint model.
enum class JointQuantity {
  perceptual,                     ///< PT: mean noticeability, guesses included, is 0.5
  slightly_noticeable,            ///< SN: it is 1
  perceptual_corrected,           ///< the same of what is seen
  slightly_noticeable_corrected,  ///< the same of what is seen
  inflection,                     ///< IP: where mean noticeability, guesses included, is steepest
  detection                       ///< psi is 0.5
};

inline constexpr std::array every_joint_quantity = {
    JointQuantity::perceptual,           JointQuantity::slightly_noticeable,
    JointQuantity::perceptual_corrected, JointQuantity::slightly_noticeable_corrected,
    JointQuantity::inflection,           JointQuantity::detection};

/// "PT", "SN", "PT corrected", "SN corrected", "IP", "detection".
[[nodiscard]] std::string_view word(JointQuantity quantity);

/// What reaches which level at a quantity; none for IP.
struct SoughtMean {
  JointMean mean = JointMean::as_counted;
  double level = 0;
};
[[nodiscard]] std::optional<SoughtMean> sought_mean(JointQuantity quantity);

/// A place on the axis and its exact gradient by theta, by the implicit function theorem:
/// x = m - s z, z of the shape alone.
struct JointPlace {
  double x = 0;
  Eigen::VectorXd gradient;
};

/// The mean chance of a curve's cells.
[[nodiscard]] double chance_of_curve(const JointModel& model, int curve);

/// Of people whose thresholds differ by a standard deviation: shares of people and their shifts in standard
/// deviations, equal steps.
struct PeopleNode {
  double shift = 0, share = 0;
};
[[nodiscard]] const std::vector<PeopleNode>& people_nodes();

/// Where a quantity lies; empty where the curve has no such place (the level lies in the floor, or above the
/// curve), for PT, SN and IP where nobody was asked for ratings, and for IP of a model `between_people`.
[[nodiscard]] std::optional<JointPlace> place_of(const JointModel& model, const Eigen::VectorXd& theta,
                                                 int curve, JointQuantity quantity);

/// A mean noticeability at x with its gradient by theta, and its slope by x.
struct MeanAtX {
  double value = 0, slope = 0;
  Eigen::VectorXd gradient;
};
[[nodiscard]] MeanAtX mean_at_x(const JointModel& model, const Eigen::VectorXd& theta, int curve,
                                JointMean mean, double x);

/// The floor of a mean, which it has far beyond the threshold, with its gradient.
[[nodiscard]] MeanAtX floor_at(const JointModel& model, const Eigen::VectorXd& theta, int curve,
                               JointMean mean);

}  // namespace seamline::analysis
