#include "study/running/staircase_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/study_file/study_file.h"
#include "study/running/stimulus_numbers.h"
#include "study/trials/participant_trials.h"
#include "support/text/error.h"

namespace seamline::study {
bool has_staircases(const LogContents& log) {
  return log.task && log.task->staircase;
}

std::vector<StaircaseEstimate> staircase_estimates(const LogContents& log) {
  if (!has_staircases(log))
    throw input_error({.file = log.file.string(),
                       .field = "procedure",
                       .wanted = "a study with procedure = \"staircase\"",
                       .found = "another one"});
  const StudyDefinition study = read_study_text(log.study_text, log.file);
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  const auto design = std::make_shared<const StaircaseDesign>(
      make_staircase_design(*log.task->staircase, study.level.noticeability, stimuli));
  const StimulusNumbers number(stimuli, log.file);
  std::map<std::string, std::vector<StaircaseAnswer>> answers_of;
  for (const Answer& answer : log.answers) {
    answers_of[answer.participant].push_back(
        {.stimulus = number.of(answer.stimulus_id), .correct = answer.correct()});
  }
  const double target = staircase_target(design->definition);
  const Axis axis = facts(study.level.quantity).axis;
  std::vector<StaircaseEstimate> estimates;
  for (const ParticipantRecord& participant : log.participants) {
    const StaircaseProcedure procedure =
        resume_staircases(begin_staircases(design, participant_seed(study.seed, participant.slot)),
                          answers_of[participant.code], std::nullopt);
    for (std::size_t i = 0; i < procedure.stairs.size(); ++i) {
      const StaircaseDesign::Start& start = design->starts[i];
      const StimulusTrack& curve = design->curves[start.curve];
      const Staircase& stairs = procedure.stairs[i];
      const double from = curve.levels[start.level];
      const std::optional<double> mean = reversals_mean(stairs, curve, axis);
      estimates.push_back(
          {.participant = participant.code,
           .artifact = curve.artifact,
           .condition = curve.condition,
           .track = fmt::format("{} from {:g}", name_of(curve), from),
           .used = participant.completed && !participant.excluded && !participant.pilot,
           .start = from,
           .trials = stairs.answered,
           .reversals = static_cast<int>(stairs.reversals.size()),
           .by_reversals = std::ssize(stairs.reversals) >= design->definition.reversals,
           .level = mean ? std::optional(axis == Axis::log2 ? std::exp2(*mean) : *mean) : std::nullopt,
           .target = target});
    }
  }
  return estimates;
}

std::string staircases_text(const std::vector<StaircaseEstimate>& estimates) {
  std::size_t code = 11, name = 9;
  for (const StaircaseEstimate& one : estimates) {
    code = std::max(code, one.participant.size());
    name = std::max(name, one.track.size());
  }
  std::string text =
      estimates.empty()
          ? ""
          : fmt::format(
                "Mean level of the reversals (without the first two): answered rightly in {:.1f} %.\n",
                100 * estimates.front().target);
  text += fmt::format("{:<{}}  {:<{}}  {:<4}  {:>6}  {:>9}  level\n", "participant", code, "staircase", name,
                      "used", "trials", "reversals");
  for (const StaircaseEstimate& one : estimates)
    text += fmt::format("{:<{}}  {:<{}}  {:<4}  {:>6}  {:>9}  {}\n", one.participant, code, one.track, name,
                        one.used ? "yes" : "no", one.trials, one.reversals,
                        one.level ? fmt::format("{:.4g}", *one.level) : "-");
  return text;
}

}  // namespace seamline::study
