#include "analysis/report/tables/late_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/report/tables/table_columns.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "support/text/counted.h"

namespace seamline::analysis {
namespace {

struct NamedThreshold {
  Artifact artifact = Artifact::none;
  std::string condition, quantity;
  TestedLevels tested;
  ThresholdEstimate here;
};

/// The joint model's, or the paper's way where that is the study's.
std::vector<NamedThreshold> thresholds_of_record(const Analysis& analysis) {
  std::vector<NamedThreshold> named;
  for (const HeadlineRow& row : headline_rows(analysis))
    named.push_back({row.artifact, row.condition, row.rule->name, row.tested, row.here});
  if (!analysis.joint)
    for (const ThresholdRow& row : threshold_rows(analysis))
      named.push_back({row.artifact, row.condition, row.quantity, row.tested, row.here});
  return named;
}

void add_late_estimate(std::vector<CsvColumn>& columns, const LevelAxis& axis, const std::string& name,
                       const std::string& whose) {
  const std::string unit(facts(axis.quantity).unit);
  columns.push_back({name + unit_suffix(axis), unit, "threshold " + whose + "; empty: none"});
  columns.push_back({name + "_ci95_low" + unit_suffix(axis), unit, "lower end of its 95 % interval"});
  columns.push_back({name + "_ci95_high" + unit_suffix(axis), unit, "upper end of it"});
}

void add_late_values(std::vector<CsvValue>& row, const LevelAxis& axis, const ThresholdEstimate& estimate) {
  const LevelRange range = range_at(axis, estimate.ci95);
  row.push_back(number(estimate, axis));
  row.push_back(finite(range.low));
  row.push_back(finite(range.high));
}

CsvTable late_frames_table(const Analysis& analysis, const LateReport& late) {
  CsvTable table{
      .name = "late_frames",
      .columns = {artifact_column,
                  {"answers", "count", "trials of the people used whose frames were counted"},
                  {"marked", "count", "of these, with more late and dropped frames than the rule says"},
                  {"frames_due", "frames", "shown or dropped until the rating, of all these trials"},
                  {"frames_late", "frames", "that came more than two refreshes after their time"},
                  {"frames_dropped", "frames", "that never came"},
                  source_column},
      .rows = {}};
  std::vector<std::string> conditions;
  for (const LateRow& row : late.rows) {
    conditions.push_back(row.condition);
    table.rows.push_back({std::string(word(row.artifact)), whole(row.answers), whole(row.marked), row.due,
                          row.late, row.dropped, source_text(analysis)});
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable late_thresholds_table(const Analysis& analysis, const LateReport& late) {
  const LevelAxis& axis = analysis.data.axis;
  CsvTable table{
      .name = "late_thresholds",
      .columns = {artifact_column, {"quantity", "word", "which threshold, as in the table of thresholds"}},
      .rows = {}};
  add_late_estimate(table.columns, axis, "with_marked", "with all trials");
  add_late_estimate(table.columns, axis, "without_marked", "without the trials that are marked");
  table.columns.push_back(source_column);
  std::vector<std::string> conditions;
  for (const LateThreshold& one : late.thresholds) {
    conditions.push_back(one.condition);
    std::vector<CsvValue> row = {std::string(word(one.artifact)), one.quantity};
    add_late_values(row, axis, one.with);
    add_late_values(row, axis, one.without);
    row.emplace_back(source_text(analysis));
    table.rows.push_back(std::move(row));
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

/// What leaving the marked trials out changes most; empty where no threshold has a number both times.
std::string largest_change(const LateReport& late) {
  const LateThreshold* most = nullptr;
  const auto change = [](const LateThreshold& one) {
    return std::abs(*one.without.level_x - *one.with.level_x);
  };
  int lost = 0;
  for (const LateThreshold& one : late.thresholds) {
    if (one.with.level_x.has_value() != one.without.level_x.has_value()) ++lost;
    if (!one.with.level_x || !one.without.level_x) continue;
    if (most == nullptr || change(one) > change(*most)) most = &one;
  }
  std::string text;
  if (most != nullptr)
    text = fmt::format(" The threshold that differs most without them is {} of '{}'{}: {} with, {} without.",
                       most->quantity, word(most->artifact), in_condition(most->condition),
                       estimate_text(most->with, most->tested), estimate_text(most->without, most->tested));
  if (lost > 0)
    text += fmt::format(" {} a number only with or only without them.",
                        counted(lost, "threshold has", "thresholds have"));
  return text;
}

}  // namespace

LateRow LateReport::all() const {
  LateRow sum;
  for (const LateRow& row : rows) {
    sum.answers += row.answers;
    sum.marked += row.marked;
    sum.due += row.due;
    sum.late += row.late;
    sum.dropped += row.dropped;
  }
  return sum;
}

std::vector<LateRow> late_rows(const study::LogContents& log, const Analysis& analysis,
                               const LateMarks& marks) {
  std::set<std::string> used;
  for (const ParticipantUse& one : analysis.people)
    if (one.use == Use::used) used.insert(one.record.code);
  std::map<std::pair<Artifact, std::string>, LateRow> curves;
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    const study::Answer& answer = log.answers[i];
    const std::optional<study::ClipCounts>& counts = marks.counts.at(i);
    if (!counts || !used.contains(answer.participant)) continue;
    LateRow& row = curves[{answer.artifact, answer.condition}];
    row.artifact = answer.artifact;
    row.condition = answer.condition;
    ++row.answers;
    row.marked += marks.is_marked(i) ? 1 : 0;
    row.due += std::int64_t{counts->shown} + counts->dropped;
    row.late += counts->late;
    row.dropped += counts->dropped;
  }
  std::vector<LateRow> rows;
  for (const ArtifactScores& curve : analysis.data.artifacts)
    if (const auto found = curves.find({curve.artifact, curve.condition}); found != curves.end())
      rows.push_back(found->second);
  return rows;
}

std::vector<LateThreshold> thresholds_beside(const Analysis& with, const Analysis& without) {
  const std::vector<NamedThreshold> others = thresholds_of_record(without);
  std::vector<LateThreshold> beside;
  for (const NamedThreshold& one : thresholds_of_record(with)) {
    const auto other = std::find_if(others.begin(), others.end(), [&](const NamedThreshold& candidate) {
      return candidate.artifact == one.artifact && candidate.condition == one.condition &&
             candidate.quantity == one.quantity;
    });
    beside.push_back(
        {.artifact = one.artifact,
         .condition = one.condition,
         .quantity = one.quantity,
         .tested = one.tested,
         .with = one.here,
         .without = other == others.end()
                        ? ThresholdEstimate{.level_x = {}, .reason = NoThreshold::too_few_trials, .ci95 = {}}
                        : other->here});
  }
  return beside;
}

std::string late_sentence(const LateReport& late) {
  const LateRow all = late.all();
  return fmt::format(
      "Of {} frames of clips that were due {} came late and {} never. In {} of {} trials that was "
      "more than {:g} %: they are {}.{}",
      all.due, all.late, all.dropped, all.marked, all.answers, 100 * late.rule.most_share,
      late.rule.trials == LateTrials::left_out ? "left out" : "marked and used all the same",
      late.not_compared.empty() ? "" : " " + late.not_compared);
}

std::string late_method(const LateReport& late) {
  return "Stimuli were clips. A frame counts as late where it came more than two refreshes of the screen after its "
         "time, and as dropped where the next one's time had come. " +
         late_sentence(late) + largest_change(late);
}

std::vector<CsvTable> late_tables(const Analysis& analysis, const LateReport& late) {
  std::vector<CsvTable> tables = {late_frames_table(analysis, late)};
  if (!late.thresholds.empty()) tables.push_back(late_thresholds_table(analysis, late));
  return tables;
}

}  // namespace seamline::analysis
