#include "study/running/quest_plus_results.h"

#include <fmt/core.h>

#include <map>

#include "stimuli/study_file/study_file.h"
#include "study/placement/placed_answer.h"
#include "study/placement/quest_plus_model.h"
#include "study/running/stimulus_numbers.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

QuestPlusDefinition definition_of(const StudyDefinition& study, const LogContents& log) {
  if (const auto* definition = std::get_if<QuestPlusDefinition>(&study.procedure)) return *definition;
  throw input_error({.file = log.file.string(),
                     .field = "procedure",
                     .wanted = "a study with procedure = \"quest_plus\"",
                     .found = "constant stimuli"});
}

std::vector<Parameter> informed_parameters(const QuestPlusGrid& grid) {
  std::vector<Parameter> informed;
  for (const Parameter parameter : every_parameter)
    if (!grid.log_prior[static_cast<std::size_t>(parameter)].empty()) informed.push_back(parameter);
  return informed;
}

TrackEstimate estimate_of(const QuestPlusDesign& design, std::size_t index, const QuestPlusTrack& track,
                          Quantity quantity) {
  const Moments threshold = moments(design.grid, track.posterior, Parameter::threshold);
  const Axis axis = design.definition.axis;
  const CredibleInterval interval = interval95(design.grid, track.posterior, Parameter::threshold);
  return {.participant = {},
          .artifact = design.tracks[index].artifact,
          .condition = design.tracks[index].condition,
          .track = name_of(design.tracks[index]),
          .used = false,
          .trials = track.answered,
          .threshold = level_of(axis, threshold.mean),
          .threshold_sd = threshold.sd,
          .low = level_of(axis, interval.low),
          .high = level_of(axis, interval.high),
          .scale = moments(design.grid, track.posterior, Parameter::scale).mean,
          .lapse = moments(design.grid, track.posterior, Parameter::lapse).mean,
          .axis = axis,
          .direction = design.definition.direction,
          .quantity = quantity,
          .informed = informed_parameters(design.grid),
          .alarms = edge_alarms(design.grid, track.posterior, design.definition.edge_share)};
}

/// Without its unit, which is in the column's name.
std::string level_number(Quantity quantity, double level) {
  return facts(quantity).whole ? fmt::format("{:.1f}", level) : fmt::format("{:.4g}", level);
}

}  // namespace

std::vector<TrackEstimate> quest_plus_estimates(const LogContents& log) {
  const StudyDefinition study = read_study_text(log.study_text, log.file);
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  const auto design =
      std::make_shared<QuestPlusDesign>(make_quest_plus_design(definition_of(study, log), stimuli));
  const StimulusNumbers number(stimuli, log.file);

  const QuestPlusProcedure fresh = begin_quest_plus(design, 0);
  std::map<std::string, std::pair<std::vector<int>, std::vector<TrialAnswer>>> trials_of;
  for (const Answer& answer : log.answers) {
    auto& [shown, answers] = trials_of[answer.participant];
    shown.push_back(number.of(answer.stimulus_id));
    answers.push_back(placed_answer(
        {.trial_index = answer.trial_index, .chosen_index = answer.chosen_index, .rating = answer.rating},
        answer.right_index, answer.object_index));
  }
  std::vector<TrackEstimate> estimates;
  for (const ParticipantRecord& participant : log.participants) {
    const auto& [shown, answers] = trials_of[participant.code];
    const QuestPlusProcedure procedure = resume_quest_plus(fresh, shown, answers);
    for (std::size_t t = 0; t < design->tracks.size(); ++t) {
      estimates.push_back(estimate_of(*design, t, procedure.tracks[t], study.level.quantity));
      estimates.back().participant = participant.code;
      estimates.back().used = participant.completed && !participant.excluded && !participant.pilot;
    }
  }
  return estimates;
}

std::string length_unit(Axis axis, Quantity quantity) {
  const std::string_view unit = facts(quantity).unit;
  return axis == Axis::log2 ? "octaves" : std::string(unit.empty() ? "levels" : unit);
}

std::string length_key(Axis axis, Quantity quantity) {
  const std::string_view key = facts(quantity).unit_key;
  return axis == Axis::log2 ? "octaves" : std::string(key.empty() ? "levels" : key);
}

std::string tracks_text(const std::vector<TrackEstimate>& estimates) {
  std::size_t code = 11, name = 5;
  for (const TrackEstimate& estimate : estimates) {
    code = std::max(code, estimate.participant.size());
    name = std::max(name, estimate.track.size());
  }
  const bool linear = !estimates.empty() && estimates.front().axis == Axis::linear;
  const bool rising = !estimates.empty() && estimates.front().direction == Direction::increasing;
  const Quantity quantity = estimates.empty() ? Quantity::depth_width_px : estimates.front().quantity;
  const auto in_unit = [&](const std::string& column) {
    const std::string unit(facts(quantity).unit_key);
    return unit.empty() ? column : column + "_" + unit;
  };
  const std::string scale = linear ? in_unit("scale") : "scale";
  const std::string threshold = in_unit("threshold"), interval = in_unit("ci95");
  const std::size_t threshold_width = std::max<std::size_t>(12, threshold.size());
  const std::size_t interval_width = std::max<std::size_t>(18, interval.size());
  const std::size_t scale_width = std::max<std::size_t>(7, scale.size());
  std::string text = rising ? fmt::format("Noticeability rises with the {}.\n",
                                          quantity == Quantity::depth_width_px ? "width of the depth map"
                                                                               : facts(quantity).name)
                            : "";
  text += fmt::format("{:<{}}  {:<{}}  {:<4}  {:>6}  {:>{}}  {:>{}}  {:>{}}  {:>6}  alarms\n", "participant",
                      code, "track", name, "used", "trials", threshold, threshold_width, interval,
                      interval_width, scale, scale_width, "lapse");
  for (const TrackEstimate& estimate : estimates) {
    std::string alarms;
    for (const EdgeAlarm& alarm : estimate.alarms)
      alarms += (alarms.empty() ? "" : "; ") + study::text(alarm);
    text += fmt::format(
        "{:<{}}  {:<{}}  {:<4}  {:>6}  {:>{}}  {:>{}}  {:>{}}  {:>6.3f}  {}\n", estimate.participant, code,
        estimate.track, name, estimate.used ? "yes" : "no", estimate.trials,
        level_number(quantity, estimate.threshold), threshold_width,
        fmt::format("{} to {}", level_number(quantity, estimate.low), level_number(quantity, estimate.high)),
        interval_width,
        quantity == Quantity::depth_width_px || !linear ? fmt::format("{:.2f}", estimate.scale)
                                                        : fmt::format("{:.3g}", estimate.scale),
        scale_width, estimate.lapse, alarms.empty() ? "-" : alarms);
  }
  return text;
}

}  // namespace seamline::study
