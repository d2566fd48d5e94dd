#include "analysis/joint/joint_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

/// A curve is at chance unless a test of no more than chance rejects at this probability.
constexpr double above_chance_at = 0.01;
constexpr std::size_t levels_of_a_scale = 3, levels_of_a_threshold = 2;
/// A step fits as well where a scale so many times smaller loses less than this of the log likelihood.
constexpr double much_smaller = 8, loses_little = 0.5;
constexpr int most_step_iterations = 40;

/// Under so many people a test over people seldom rejects, whatever they saw: one of their answers is asked,
/// too.
constexpr std::size_t fewest_for_test = 5;

struct CurveTally {
  double right = 0, wrong = 0;
  double beyond = 0, variance = 0;  ///< right answers beyond chance, and their binomial variance by chance
  std::vector<double> excess;  ///< each person's right answers beyond chance, as a share of their answers
};

CurveTally tally_curve(const JointData& data, int curve) {
  CurveTally tally;
  const Eigen::Index width = data.cell_counts();
  for (Eigen::Index p = 0; p < data.answers.rows(); ++p) {
    double answers = 0, beyond = 0;
    for (std::size_t c = 0; c < data.cells.size(); ++c) {
      if (data.cells[c].curve != curve || !std::isfinite(data.cells[c].x)) continue;
      const auto counts = data.answers.row(p).segment(static_cast<Eigen::Index>(c) * width, width);
      const double right = counts.head(data.ratings).sum(), all = counts.sum();
      tally.right += right;
      tally.wrong += all - right;
      answers += all;
      beyond += right - all * data.cells[c].chance;
      tally.beyond += right - all * data.cells[c].chance;
      tally.variance += all * data.cells[c].chance * (1 - data.cells[c].chance);
    }
    if (answers > 0) tally.excess.push_back(beyond / answers);
  }
  return tally;
}

/// One-sided t test over people that right answers are no more frequent than by chance.
bool above_chance(const std::vector<double>& excess) {
  const double n = excess.size();
  if (excess.size() < 2) return !excess.empty() && excess.front() > 0;
  double mean = 0, squares = 0;
  for (const double value : excess) mean += value / n;
  for (const double value : excess) squares += (value - mean) * (value - mean);
  const double error = std::sqrt(squares / (n - 1) / n);
  return mean > 0 && (error <= 0 || student_above(n - 1, mean / error) < above_chance_at);
}

/// One-sided binomial test (normal approximation) of the same. Where nobody sees anything people differ by
/// chance alone, so it holds for any number of them. Chance that may rest on reference trials
/// (`joint_data`) has their variance.
bool answers_above_chance(const JointData& data, const CurveTally& tally) {
  const double answers = tally.right + tally.wrong, references = data.references.sum();
  const double variance = tally.variance * (references > 0 ? 1 + answers / references : 1);
  return variance > 0 && normal_above(tally.beyond / std::sqrt(variance)) < above_chance_at;
}

JointVerdict verdict_of_curve(const JointData& data, int curve, bool own_scale) {
  const CurveTally tally = tally_curve(data, curve);
  if (tally.right + tally.wrong <= 0) return NoThreshold::no_answers;
  if (levels_of_curve(data, curve).size() < (own_scale ? levels_of_a_scale : levels_of_a_threshold))
    return NoThreshold::too_few_levels;
  if (tally.wrong <= 0) return NoThreshold::never_wrong;
  const bool few = tally.excess.size() < fewest_for_test;
  const bool above = above_chance(tally.excess) || (few && answers_above_chance(data, tally));
  return above ? JointVerdict() : NoThreshold::at_chance;
}

/// What is maximised, without the penalty of one coordinate.
double value_without_pull(const JointModel& model, const JointCounts& counts, const Eigen::VectorXd& theta,
                          Eigen::Index at) {
  const double away = theta[at] - penalty_centre(model)[at],
               curvature = joint_penalty(model, theta).hessian(at, at);
  return joint_log_likelihood(model, counts, theta) + joint_penalty(model, theta).value -
         away * away * curvature / 2;
}

/// Whether the answers exclude that the curve is a step: the maximum with a much smaller scale is compared.
bool excludes_step(const JointFit& fit, const JointCounts& counts, int curve) {
  const Eigen::Index at = fit.model.log_scale(curve);
  Eigen::VectorXd start = fit.theta;
  start[at] -= std::log(much_smaller);
  const NewtonResult steep = maximise(
      [&](const Eigen::VectorXd& theta) {
        Evaluation held = joint_objective(fit.model, counts, theta);
        held.gradient[at] = 0;
        held.hessian.row(at).setZero();
        held.hessian.col(at).setZero();
        held.hessian(at, at) = -1;
        return held;
      },
      start, most_step_iterations);
  return value_without_pull(fit.model, counts, steep.at, at) <
         value_without_pull(fit.model, counts, fit.theta, at) - loses_little;
}

void conclude(JointFit& fit, JointVerdict verdict, std::string explanation) {
  fit.verdict = verdict;
  fit.explanation = std::move(explanation);
}

bool any_estimated(const JointFit& fit) {
  return std::find(fit.curves.begin(), fit.curves.end(), std::nullopt) != fit.curves.end();
}

bool every_never_wrong(const JointFit& fit) {
  return std::all_of(fit.curves.begin(), fit.curves.end(),
                     [](JointVerdict one) { return one == NoThreshold::never_wrong; });
}

/// Curves whose scale, their own or the shared one, may be a step's.
void mark_steps(JointFit& fit, const JointCounts& counts) {
  std::optional<bool> shared;
  for (int c = 0; c < fit.model.curves; ++c) {
    if (!fit.estimated(c)) continue;
    const bool known = shared ? *shared : excludes_step(fit, counts, c);
    if (fit.model.sharing.scale) shared = known;
    if (!known) fit.curves[c] = NoThreshold::separated;
  }
}

/// False, with a verdict, for answers to which the model cannot be fitted.
bool joint_can_be_fitted(const JointData& data, JointFit& fit) {
  if (data.people.empty() || fit.answers <= 0) {
    conclude(fit, NoThreshold::no_answers, "Nobody answered at any level.");
    return false;
  }
  std::size_t most_levels = 0;
  for (int c = 0; c < fit.model.curves; ++c)
    most_levels = std::max(most_levels, levels_of_curve(data, c).size());
  if (most_levels < levels_of_a_scale) {
    conclude(fit, NoThreshold::too_few_levels,
             fmt::format("No curve has {} levels, so how steeply they fall would be assumed, not measured.",
                         levels_of_a_scale));
    return false;
  }
  if (any_estimated(fit)) return true;
  if (every_never_wrong(fit))
    conclude(fit, NoThreshold::never_wrong,
             "All answers are right, so nothing says at which level people cease to see.");
  else
    conclude(fit, NoThreshold::only_guesses, "On no curve are answers right more often than by guessing.");
  return false;
}

}  // namespace

std::string_view verdict_text(JointVerdict verdict) {
  return verdict ? sentence(*verdict) : "estimated";
}

JointFit fit_joint(const JointData& data, const JointSharing& sharing) {
  check_joint_data(data);
  JointFit fit;
  fit.model = joint_model(data, sharing);
  fit.people = static_cast<int>(data.people.size());
  fit.answers = data.answers.sum();
  for (int c = 0; c < fit.model.curves; ++c) fit.curves.push_back(verdict_of_curve(data, c, !sharing.scale));
  if (!joint_can_be_fitted(data, fit)) return fit;

  const JointCounts counts = all_counts(data);
  const std::optional<Eigen::VectorXd> top = maximise_joint(fit.model, counts);
  if (!top) {
    conclude(fit, NoThreshold::not_converged, "No maximum of the likelihood was found.");
    return fit;
  }
  fit.theta = *top;
  const Evaluation at = joint_objective(fit.model, counts, fit.theta);
  fit.penalised = at.value;
  fit.log_likelihood = joint_log_likelihood(fit.model, counts, fit.theta);
  fit.hessian = at.hessian;
  const Eigen::LLT<Eigen::MatrixXd> factor(-fit.hessian);
  if (factor.info() != Eigen::Success) {
    conclude(fit, NoThreshold::not_converged, "The likelihood is flat at its maximum.");
    return fit;
  }
  mark_steps(fit, counts);
  if (!any_estimated(fit))
    conclude(fit, NoThreshold::separated,
             "A step between two levels fits, so the answers do not say how steeply noticeability falls.");
  else if (fit.people < 2)
    conclude(fit, NoThreshold::one_participant,
             "One participant says nothing of how people differ, so no interval over people can be given.");
  else
    fit.verdict.reset();
  return fit;
}

}  // namespace seamline::analysis
