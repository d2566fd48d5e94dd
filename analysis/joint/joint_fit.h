#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/joint/joint_likelihood.h"

namespace seamline::analysis {

/// What may be believed of a fit. After all but the first there are no numbers.
enum class JointVerdict {
  estimated,        ///< a maximum was found, and the answers say more of the scale than the penalty does
  no_answers,       ///< of anybody at any level
  one_participant,  ///< nothing is known of how people differ
  too_few_levels,   ///< no curve with three levels: the scale would rest on the form assumed
  only_guesses,     ///< nobody is right more often than by chance on any curve
  never_wrong,      ///< all answers are right: nothing is known of not seeing
  separated,        ///< a step fits: the answers do not say how steep
  not_converged     ///< no maximum was found
};

[[nodiscard]] std::string_view word(JointVerdict verdict);

/// What is known of one curve of a fit that is `estimated`.
enum class CurveVerdict {
  estimated,
  at_chance,    ///< right no more often than by chance: nothing was seen
  never_wrong,  ///< always right: everything was seen
  no_answers,
  too_few_levels,  ///< a scale of its own asks for three levels, a shared one for two
  separated        ///< its own scale is not identified
};

[[nodiscard]] std::string_view word(CurveVerdict verdict);

struct JointFit {
  JointVerdict verdict = JointVerdict::no_answers;
  std::string explanation;           ///< a sentence for every verdict but `estimated`
  std::vector<CurveVerdict> curves;  ///< one a curve, also where the verdict is another
  JointModel model;
  int people = 0;
  double answers = 0;  ///< counted in `data.answers`
  // Empty or NaN unless `estimated` (`one_participant` and `separated` have theta, for the curious only):
  Eigen::VectorXd theta;
  double log_likelihood = 0;  ///< at theta, without penalty
  double penalised = 0;       ///< what is greatest at theta
  Eigen::MatrixXd hessian;    ///< of `penalised`, exact

  [[nodiscard]] bool estimated() const { return verdict == JointVerdict::estimated; }
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
