#include "analysis/log_analysis/adaptive_log.h"

#include "analysis/scores/level_words.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

void give_reason(CurveThresholds& estimates, const std::string& reason) {
  for (ThresholdEstimate* width :
       {&estimates.perceptual, &estimates.slightly_noticeable, &estimates.inflection})
    width->reason = reason;
}

}  // namespace

bool is_adaptive(const std::optional<StudyDefinition>& study) {
  return study && std::holds_alternative<QuestPlusDefinition>(study->procedure);
}

void set_aside_adaptive(Analysis& analysis) {
  for (ArtifactScores& scores : analysis.data.artifacts) {
    scores = {.artifact = scores.artifact,
              .condition = scores.condition,
              .axis = scores.axis,
              .level = scores.level,
              .people = {},
              .noticeability = {},
              .cells = {},
              .incomplete = {}};
    analysis.thresholds.push_back(estimate_thresholds(scores, analysis.resampling));
    give_reason(analysis.thresholds.back().estimates,
                level_words(scores.axis).levels + " were placed by the answers");
  }
  analysis.sos = {.a = nan, .ci95_low = nan, .ci95_high = nan, .stimuli = 0};
}

}  // namespace seamline::analysis
