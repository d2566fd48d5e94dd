#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/choice_curves.h"
#include "analysis/log_analysis/group_comparison.h"
#include "analysis/log_analysis/participant_rows.h"
#include "analysis/log_analysis/response_times.h"
#include "analysis/log_analysis/session_order.h"
#include "analysis/log_analysis/signal_detection.h"
#include "analysis/ordinal/contrasts/study_model.h"
#include "analysis/over_scenes/scene_thresholds.h"
#include "study/running/quest_plus_results.h"

namespace seamline::analysis {

/// What a report says beside the thresholds, computed once; HTML, CSV, JSON and figures are written from it.
struct ReportNumbers {
  LevelAxis axis;
  bool conditions = false;                  ///< whether the study has several, so that results name them
  std::vector<ChoiceCurve> choices;         ///< one an artifact, in the order of the analysis
  std::optional<OrdinalStudy> comparisons;  ///< none: see `comparisons_missing`
  std::string comparisons_missing;          ///< a sentence
  std::vector<GroupComparison> groups;      ///< one a field of `AnalysisOptions::compare`
  SignalDetection detection;                ///< rows of a task that asks for yes or no alone
  double guess_rate = 1.0 / 3;              ///< of the functions of right choices
  ResponseTimes times;
  SessionOrder order;
  SessionHalves halves;
  std::vector<ParticipantRow> participants;
  std::vector<std::string> questions;  ///< of the form, that somebody answered; columns of the participants
  std::vector<study::TrackEstimate> tracks;  ///< of adaptive logs
  std::vector<CurveOverScenes> over_scenes;  ///< of artifacts with `fewest_scenes` scenes, by the joint model
};

/// Never throws because of what the answers are: what cannot be computed is missing, with a sentence. Throws
/// InputError for a field of `compare` that nobody was asked.
[[nodiscard]] ReportNumbers report_numbers(const Analysis& analysis);

/// The answers of the participants marked `Use::used`, in the log's order.
[[nodiscard]] std::vector<study::Answer> used_answers(const study::LogContents& log,
                                                      const std::vector<ParticipantUse>& people);

/// The ordinal mixed model of a log's used answers. `groups` may be empty. Throws InputError as
/// fit_ordinal_study.
[[nodiscard]] OrdinalStudy ordinal_study(const Analysis& analysis, const ParticipantGroups& groups,
                                         const OrdinalStudyRequest& request);

}  // namespace seamline::analysis
