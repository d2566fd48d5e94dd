#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/joint/joint_likelihood.h"
#include "stimuli/definition/methods/no_threshold.h"

namespace seamline::analysis {

/// What may be believed of a fit or of one of its curves. None: it is estimated (a maximum was found, and the
/// answers say more of the scale than the penalty does). Else why there are no numbers:
///
///   - `no_answers`: of anybody at any level
///   - `one_participant`: nothing is known of how people differ
///   - `too_few_levels`: a scale of its own asks for three levels, a shared one for one curve with three
///   - `only_guesses` (a fit), `at_chance` (a curve): right no more often than by chance
///   - `never_wrong`: nothing is known of not seeing
///   - `separated`: a step fits, and the answers do not say how steep
///   - `not_converged`: no maximum was found
using JointVerdict = std::optional<NoThreshold>;

/// "estimated", or why it is not.
[[nodiscard]] std::string_view verdict_text(JointVerdict verdict);

struct JointFit {
  JointVerdict verdict = NoThreshold::no_answers;
  std::string explanation;           ///< a sentence for every verdict
  std::vector<JointVerdict> curves;  ///< one a curve, also where the fit has one
  JointModel model;
  int people = 0;
  double answers = 0;  ///< counted in `data.answers`
  // Empty or NaN unless estimated (`one_participant` and `separated` have theta, for the curious only):
  Eigen::VectorXd theta;
  double log_likelihood = 0;  ///< at theta, without penalty
  double penalised = 0;       ///< what is greatest at theta
  Eigen::MatrixXd hessian;    ///< of `penalised`, exact

  [[nodiscard]] bool estimated() const { return !verdict; }
  [[nodiscard]] bool estimated(int curve) const { return !curves[static_cast<std::size_t>(curve)]; }
};

/// The maximum of likelihood and penalty: thresholds from a grid for each of a few scales and rating
/// criteria, Newton's method from each of these: the best start need not lead to the highest top. Where they
/// end at different tops, the search goes on around the highest, by random moves of a fixed seed. The same
/// bits for any number of threads. Throws InputError as check_joint_data.
[[nodiscard]] JointFit fit_joint(const JointData& data, const JointSharing& sharing = {});

/// What is maximised: likelihood and penalty, with exact derivatives.
[[nodiscard]] Evaluation joint_objective(const JointModel& model, const JointCounts& counts,
                                         const Eigen::VectorXd& theta);

/// Newton's method from a place near the maximum: for replicates and people left out. No verdicts. Empty
/// where it does not converge.
[[nodiscard]] std::optional<Eigen::VectorXd> climb_joint(const JointModel& model, const JointCounts& counts,
                                                         const Eigen::VectorXd& start);

/// The global maximum without verdicts.
[[nodiscard]] std::optional<Eigen::VectorXd> maximise_joint(const JointModel& model,
                                                            const JointCounts& counts);

}  // namespace seamline::analysis
