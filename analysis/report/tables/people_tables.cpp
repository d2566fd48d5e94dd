#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/tables/table_columns.h"
#include "study/running/staircase_results.h"

namespace seamline::analysis {

CsvTable response_times_table(const ReportNumbers& numbers) {
  CsvTable table{
      .name = "response_times",
      .columns = {{"artifact", "word", "as elsewhere, or all of them together"},
                  level_column(numbers.axis),
                  {"which", "word", "answers counted: all, right choices, or wrong choices"},
                  {"answers", "count", "answers of people; simulated observers have no times"},
                  {"participants", "count", "participants among whose answers they are"},
                  {"choice_lower_s", "s",
                   "lower quartile over answers, from the image's onset to the choice"},
                  {"choice_median_s", "s", "median of the same"},
                  {"choice_upper_s", "s", "upper quartile of the same"},
                  {"rating_lower_s", "s", "lower quartile over answers, from the choice to the rating"},
                  {"rating_median_s", "s", "median of the same"},
                  {"rating_upper_s", "s", "upper quartile of the same"}},
      .rows = {}};
  std::vector<std::string> conditions;
  for (const ResponseTime& row : numbers.times.rows) {
    conditions.push_back(row.artifact ? row.condition : "all");
    table.rows.push_back({std::string(row.artifact ? word(*row.artifact) : "all"),
                          level_value(numbers.axis, row.level), std::string(word(row.which)),
                          whole(row.answers), whole(row.people), row.choice.lower_s, row.choice.median_s,
                          row.choice.upper_s, row.rating.lower_s, row.rating.median_s, row.rating.upper_s});
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable participants_table(const ReportNumbers& numbers) {
  CsvTable table{
      .name = "participants",
      .columns =
          {participant_column,
           {"kind", "word", "person, or the kind of simulated observer"},
           {"use", "word",
            "used, excluded, pilot (left out), incomplete (left out), screened (left out) or vision "
            "(neither normal nor corrected, left out)"},
           {"why", "text", "why their answers are not used; empty when they are"},
           {"pilot", "0 or 1", "pilot data"},
           {"answers", "count", "answers in the log"},
           {"planned_trials", "count",
            "trials of stimuli that were decided for them, answered or not; 0 when the log does not say"},
           {"correct", "share 0 to 1", "share of right choices; empty without answers"},
           {"mean_rating", "1 to 4", "mean rating of all answers; empty without answers"},
           {"screened", "0 or 1", "whether the screens judged them; only those who would be used are"},
           {"screens", "text", "screens that name them; empty when none does"},
           {"median_choice_s", "s", "median time from the image to the choice; empty when simulated"}},
      .rows = {}};
  for (const std::string& question : numbers.questions)
    table.columns.push_back({"form_" + question, "text", "what they answered in the form; empty: nothing"});
  const bool displays = std::any_of(numbers.participants.begin(), numbers.participants.end(),
                                    [](const ParticipantRow& row) { return row.display.has_value(); });
  if (displays)
    for (const CsvColumn& column :
         {CsvColumn{"screen_width_px", "px", "of the screen's mode; empty: not known"},
          CsvColumn{"screen_height_px", "px", "the same"},
          CsvColumn{"viewing_distance_mm", "mm", "as entered; empty: not known"},
          CsvColumn{"pixels_per_degree", "1/degree", "at the middle of the screen; empty: not known"}})
      table.columns.push_back(column);
  const auto known = [](double value) { return value > 0 ? CsvValue(value) : CsvValue(std::monostate{}); };
  for (const ParticipantRow& row : numbers.participants) {
    table.rows.push_back({row.code, row.kind, std::string(word(row.use)), row.why, whole(row.pilot),
                          whole(row.answers), whole(row.stimulus_trials), row.correct, row.mean_rating,
                          whole(row.screened), row.screens, row.median_choice_s});
    std::vector<CsvValue>& values = table.rows.back();
    values.insert(values.end(), row.form.begin(), row.form.end());
    if (!displays) continue;
    const study::ShownOn display = row.display.value_or(study::ShownOn{});
    for (const double value :
         {static_cast<double>(display.mode_width_px), static_cast<double>(display.mode_height_px),
          display.viewing_distance_mm, display.pixels_per_degree})
      values.push_back(known(value));
  }
  return table;
}

CsvTable tracks_table(const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  const Axis along = numbers.tracks.empty() ? facts(axis.quantity).axis : numbers.tracks.front().axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  const std::string length = "_" + study::length_key(along, axis.quantity),
                    lengths = study::length_unit(along, axis.quantity);
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "tracks",
      .columns = {participant_column,
                  artifact_column,
                  {"track", "text",
                   numbers.conditions
                       ? "what the track is about: an artifact, or one of its objects, in a condition"
                       : "what the track is about: an artifact, or one of its objects"},
                  {"used", "0 or 1", "completed, not excluded and not a pilot"},
                  {"trials", "count", "answers to the track"},
                  {"threshold" + suffix, unit,
                   fmt::format("posterior mean{} of the {} seen half of the time",
                               along == Axis::linear ? "" : ", on log2,", level_word(axis))},
                  {"threshold_low" + suffix, unit, "lower end of the equal-tailed 95 % credible interval"},
                  {"threshold_high" + suffix, unit, "upper end of it"},
                  {"threshold_sd" + length, lengths, "posterior standard deviation of the threshold"},
                  {"scale" + length, lengths, "posterior mean of the function's scale"},
                  {"lapse", "share 0 to 1", "posterior mean of the lapse rate"},
                  {"alarms", "text", "where the posterior runs into the edge of its grid"}},
      .rows = {}};
  for (const study::TrackEstimate& track : numbers.tracks) {
    std::string alarms;
    for (const study::EdgeAlarm& alarm : track.alarms) alarms += (alarms.empty() ? "" : "; ") + text(alarm);
    table.rows.push_back({track.participant, std::string(word(track.artifact)), track.track,
                          whole(track.used), whole(track.trials), track.threshold, track.low, track.high,
                          track.threshold_sd, track.scale, track.lapse, alarms});
    conditions.push_back(track.condition);
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable staircases_table(const Analysis& analysis, const ReportNumbers& numbers) {
  const std::string suffix = unit_suffix(numbers.axis), unit(facts(numbers.axis.quantity).unit);
  std::vector<std::string> conditions;
  CsvTable table{.name = "staircases",
                 .columns = {participant_column,
                             artifact_column,
                             {"staircase", "text", "what it is about, and where it began"},
                             {"used", "0 or 1", "completed, not excluded and not a pilot"},
                             {"trials", "count", "answers to it"},
                             {"reversals", "count", "how often it turned"},
                             {"level" + suffix, unit,
                              "mean level of its reversals on the axis, without the first two; empty when it "
                              "turned too seldom"},
                             {"target", "share 0 to 1", "share of right answers that the level stands for"}},
                 .rows = {}};
  for (const study::StaircaseEstimate& one : study::staircase_estimates(analysis.log)) {
    table.rows.push_back({one.participant, std::string(word(one.artifact)), one.track, whole(one.used),
                          whole(one.trials), whole(one.reversals), number(one.level), one.target});
    conditions.push_back(one.condition);
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

}  // namespace seamline::analysis
