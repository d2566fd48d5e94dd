#include "analysis/log_analysis/report_numbers.h"

#include <fmt/format.h>

#include <set>

#include "analysis/log_analysis/participant_facts.h"
#include "analysis/scores/level_words.h"
#include "study/running/staircase_results.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

void add_comparisons(ReportNumbers& numbers, const Analysis& analysis) {
  if (analysis.adaptive) {
    numbers.comparisons_missing = fmt::format(
        "Artifacts are not compared by a model of ratings: {0} were placed by the answers, so ratings "
        "were not asked at the same {0} of everybody. Compare the thresholds of the tracks.",
        level_words(analysis.data.axis).levels);
    return;
  }
  OrdinalStudyRequest request;
  request.conditions = analysis.data.conditions;
  request.axis = analysis.data.axis;
  request.fit.threads = analysis.resampling.threads;
  try {
    numbers.comparisons = ordinal_study(analysis, technical_groups(analysis), request);
  } catch (const InputError& error) {
    numbers.comparisons_missing = std::string("Artifacts cannot be compared: ") + error.what();
  }
}

/// Each curve that has several scenes, with these as a sample of scenes.
std::vector<CurveOverScenes> curves_over_scenes(const Analysis& analysis) {
  std::vector<CurveOverScenes> curves;
  if (!analysis.joint || analysis.adaptive) return curves;
  for (const SceneCurves& of : curves_by_scene(analysis.log, analysis.people, analysis.data,
                                               analysis.guessing.guessers, analysis.options.references))
    curves.push_back(threshold_over_scenes(of, analysis.resampling.threads));
  return curves;
}

}  // namespace

ReportNumbers report_numbers(const Analysis& analysis) {
  ReportNumbers numbers;
  numbers.axis = analysis.data.axis;
  numbers.conditions = has_conditions(analysis.data);
  numbers.choices = choice_curves(analysis);
  add_comparisons(numbers, analysis);
  numbers.detection = signal_detection(analysis);
  numbers.guess_rate = analysis.scores.guess_rate;
  numbers.times = response_times(analysis);
  std::vector<std::string> fields = analysis.options.compare;
  if (fields.empty() && !technical_groups(analysis).empty()) fields = {technical_question};
  if (!analysis.adaptive || !analysis.options.compare.empty())
    numbers.groups = compare_groups(analysis, fields);
  numbers.order = session_order(analysis);
  numbers.halves = session_halves(analysis);
  numbers.participants = participant_rows(analysis);
  numbers.questions = answered_questions(analysis.log);
  if (analysis.adaptive && !study::has_staircases(analysis.log))
    numbers.tracks = study::quest_plus_estimates(analysis.log);
  numbers.over_scenes = curves_over_scenes(analysis);
  return numbers;
}

std::vector<study::Answer> used_answers(const study::LogContents& log,
                                        const std::vector<ParticipantUse>& people) {
  std::set<std::string> used;
  for (const ParticipantUse& person : people)
    if (person.use == Use::used) used.insert(person.record.code);
  std::vector<study::Answer> answers;
  for (const study::Answer& answer : log.answers)
    if (used.contains(answer.participant)) answers.push_back(answer);
  return answers;
}

OrdinalStudy ordinal_study(const Analysis& analysis, const ParticipantGroups& groups,
                           const OrdinalStudyRequest& request) {
  return fit_ordinal_study(used_answers(analysis.log, analysis.people), groups, request);
}

}  // namespace seamline::analysis
