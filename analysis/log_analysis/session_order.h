#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/psychometric/likelihood/profile.h"

namespace seamline::analysis {

/// Mean noticeability in a part of the session, what was shown and who was asked being equal.
struct SessionPart {
  double from = 0, to = 1;  ///< share of the participant's answers, in their order
  int answers = 0;
  double mean = 0;  ///< noticeability, 0 to 4
  Interval ci95;    ///< over participants
};

/// How far one participant, or one object, lies from what is expected of it.
struct MeanResidual {
  std::string name;                    ///< the participant's code, or the object's name
  Artifact artifact = Artifact::none;  ///< of objects
  std::string condition, scene;        ///< of objects
  int object_index = 0;                ///< of objects
  int answers = 0;
  double mean = 0;  ///< noticeability
  Interval ci95;    ///< of objects: over participants, each of its own; open under two
};

/// Whether answers change while a session goes on, and who and what stands out.
///
/// The score of person p at stimulus s (artifact, condition, object, level) is y_ps = a_s + b_p + f(t_ps) +
/// error, t the place among the person's answers from 0 to 1: least squares with both sets of effects fixed,
/// so that orders may differ as they like. f is a straight line (`trend`), or a step function over thirds or
/// tenths. Intervals are of the jackknife over participants with Student's t, n - 1 degrees of freedom.
struct SessionOrder {
  std::string missing;  ///< a sentence: why there is nothing below but residuals
  int people = 0, answers = 0;
  double trend = 0;  ///< noticeability at the last answer less that at the first
  Interval trend_ci95;
  double last_less_first = 0;  ///< last third less first third
  Interval last_less_first_ci95;
  std::vector<SessionPart> thirds, tenths;
  std::vector<MeanResidual> people_residuals;  ///< less the mean over participants at the same stimuli
  std::vector<MeanResidual> object_residuals;  ///< less the mean over the curve's objects at the same levels
};

/// Thresholds of the second half of everybody's answers less those of the first half, along the axis: of all
/// curves together and of each. Each curve of the joint model becomes two with thresholds of their own; all
/// else is shared. Adjusted together by Holm's method, each with the degrees of freedom of its own jackknife
/// over people (`jackknife_degrees`), the least of all contrasts.
struct SessionHalves {
  std::string missing;  ///< a sentence: why there is no row
  ContrastTable shifts;
  std::vector<std::string> notes;  ///< curves that are left out
};

/// Of the answers that are used. Adaptive logs have residuals of nobody: their levels hang on the answers.
[[nodiscard]] SessionOrder session_order(const Analysis& analysis);

/// Of counts: `answers_of_half` are `whole.answers` of each half.
[[nodiscard]] SessionHalves contrast_halves(const JointData& whole,
                                            const std::vector<Eigen::MatrixXd>& answers_of_half,
                                            const JointSharing& sharing, const LevelAxis& axis, int threads);

/// Of a log's answers that are used, half of each person's in their order.
[[nodiscard]] SessionHalves session_halves(const Analysis& analysis);

/// What the trend says, a sentence: that there is one only where its interval excludes 0.
[[nodiscard]] std::string trend_sentence(const SessionOrder& order);

}  // namespace seamline::analysis
