#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/joint/joint_analysis.h"
#include "analysis/log_analysis/origins.h"
#include "analysis/preregistration/deviations.h"
#include "analysis/replication/replication.h"
#include "analysis/scores/cells.h"
#include "analysis/scores/opinion_score.h"
#include "analysis/scores/participants.h"
#include "analysis/screening/screening.h"
#include "analysis/screening/screening_effect.h"
#include "analysis/statistics/resampling.h"
#include "analysis/thresholds/condition_differences.h"
#include "analysis/thresholds/guess_correction.h"
#include "analysis/thresholds/object_influence.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "analysis/thresholds/thresholds.h"
#include "stimuli/definition/methods/analysis_definition.h"
#include "stimuli/definition/study_definition.h"
#include "study/log/log.h"
#include "study/log/shown_on.h"

namespace seamline::analysis {

/// Where the expected means of a log's `threshold` observers truly cross (floor from guessing included), by
/// artifact and condition. Not the values of Table 1 of the paper.
using PlantedValues = std::map<std::pair<Artifact, std::string>, PlantedThresholds>;

/// What may be asked of an analysis besides.
struct AnalysisOptions {
  double field_of_view_deg = 90;     ///< horizontal, for which thresholds are also stated; over 0, under 180
  bool exclude_screened = false;     ///< leave out whom any screen names; else they are named and used
  bool exclude_inattentive = false;  ///< leave out whom catch trials name
  bool exclude_uncorrected = false;  ///< leave out whose vision is neither normal nor corrected
  /// What each curve of the joint model has of its own, beside what the study file says: words of
  /// `shared_blocks`.
  std::vector<std::string> own = {};
  std::vector<std::string> compare = {};                ///< what people are grouped by (`compare_groups`)
  std::map<std::string, study::ShownOn> displays = {};  ///< by participant (`read_displays`); may be empty
  std::vector<ReferenceAnswer> references;              ///< where nothing was inserted, besides the log's own
  std::vector<CatchAnswer> catches;  ///< where nobody who looks can be wrong, besides the log's own
};

/// Everything that is computed from a log; what tables, figures and report are written from.
struct Analysis {
  study::LogContents log;
  bool include_pilot = false;
  ResamplingRequest resampling;
  AnalysisOptions options;
  bool adaptive = false;  ///< levels were placed by the answers: no curve is made of means at a level
  std::vector<std::string> conditions;  ///< in the study's order; empty where it names none
  std::vector<ParticipantUse> people;
  ParticipantCounts counts;
  NoticeabilityData data;
  std::vector<ArtifactThresholds> thresholds;     ///< in the order of `data.artifacts`
  std::vector<ThresholdDifference> differences;   ///< between conditions; empty where the study has one
  std::vector<ObjectInfluence> object_influence;  ///< in the same order
  GuessCorrection guessing;                       ///< its curves in the same order
  Screening screening;                            ///< of everybody, also when those named are left out
  std::vector<ScreenedThresholds> screened;       ///< everybody first
  std::optional<OriginComparison> origins;        ///< none where all came by one way, and in adaptive logs
  std::optional<JointAnalysis> joint;             ///< what thresholds of record are read off
  ScoreMatrix scores;                             ///< of the people used
  std::vector<OpinionScore> opinion;              ///< one a stimulus of `scores`
  SosParameter sos;                               ///< of noticeability, 0 to 4
  PlantedValues planted;                   ///< empty unless every used participant is a `threshold` observer
  std::vector<std::string> notes;          ///< what a reader must know, a sentence each
  std::optional<Replication> replication;  ///< none where no published thresholds were given
  std::optional<FrozenComparison> frozen;  ///< none where nothing was frozen (`compare_with_archive`)
};

/// Computes everything. Throws InputError when no participant can be used.
[[nodiscard]] Analysis analyze(study::LogContents log, bool include_pilot,
                               const ResamplingRequest& resampling, const AnalysisOptions& options = {});

/// Sets `frozen`, and says its verdict in the first note.
void compare_with_archive(Analysis& analysis, const Archive& archive);

/// "20 participants", or "20 simulated observers (threshold)", or "20 participants, 3 of them simulated
/// observers": goes on every figure and table.
[[nodiscard]] std::string source_text(const Analysis& analysis);

/// How many participants are behind the means of each curve where not all of those used answered at every
/// level, a sentence; empty where everybody did.
[[nodiscard]] std::string answered_text(const Analysis& analysis);

/// `source_text` and `answered_text` as sentences, for captions of curves.
[[nodiscard]] std::string source_sentence(const Analysis& analysis);

/// The planted values of `threshold` observers on the curves of `data`.
[[nodiscard]] PlantedValues planted_values(const ObserverDefinition& observer, const NoticeabilityData& data);

/// The study that a log belongs to, from the text the log keeps; none (with a note) when it cannot be read.
[[nodiscard]] std::optional<StudyDefinition> study_of_log(const study::LogContents& log,
                                                          std::vector<std::string>& notes);

/// `[analysis]` of the study that a log keeps; what is usual where that cannot be read.
[[nodiscard]] AnalysisDefinition asked_of_log(const study::LogContents& log);

}  // namespace seamline::analysis
