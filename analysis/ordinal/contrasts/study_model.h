#pragma once
#include <span>
#include <string>
#include <vector>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/ordinal/contrasts/study_design.h"
#include "analysis/ordinal/likelihood/ordinal_fit.h"

namespace seamline::analysis {

struct OrdinalStudyRequest {
  OrdinalRequest fit = {};
  LevelAxis axis = {};
  std::vector<std::string> conditions = {};  ///< in the study's order
  double reference_level = 0;  ///< where artifacts are compared; 0: the geometric centre of those tested
  Correction correction = Correction::single_step;
};

/// Where standard errors come from.
enum class ErrorSource {
  participants,  ///< leaving out each participant in turn (mixed_fit.cpp)
  model          ///< the likelihood's curvature: only right when participants differ in their level alone
};

struct CoefficientRow {
  std::string name;
  double estimate = 0;
  double standard_error = 0;
  double ci95_low = 0, ci95_high = 0;  ///< of this coefficient alone
  double p = 0;                        ///< NaN for cuts and the standard deviation, which have no null value
};

/// The ordinal mixed model of a study:
///
///     P(score <= k) = F(cut_k - level_artifact - slope_artifact log2(W / W0) - object - group - u),
///     u ~ Normal(0, sd^2) a participant
struct OrdinalStudy {
  StudyDesign design;
  OrdinalFit fit;
  ErrorSource errors = ErrorSource::participants;
  std::vector<CoefficientRow>
      coefficients;  ///< cuts, effects, then the participants' sd; empty without estimates
  std::vector<ContrastTable> contrasts;  ///< a table a question; empty without estimates
  std::vector<std::string> notes;        ///< what a reader must know, a sentence each; the verdict first
};

/// Fits the model to answers and tests its contrasts. The correction is within each question. Throws
/// InputError as study_design; anything that is wrong with the data as data is a verdict in `fit`.
[[nodiscard]] OrdinalStudy fit_ordinal_study(std::span<const study::Answer> answers,
                                             const ParticipantGroups& groups,
                                             const OrdinalStudyRequest& request);

/// The study as text for a terminal: verdict, coefficients, a table a question.
[[nodiscard]] std::string text_of(const OrdinalStudy& study);

}  // namespace seamline::analysis
