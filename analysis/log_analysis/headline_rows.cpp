#include "analysis/log_analysis/headline_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/log_analysis/task_words.h"
#include "analysis/scores/rows_of_curves.h"

namespace seamline::analysis {

namespace {

constexpr double wide_gap_octaves = 1.01;

const ThresholdRow* row_of(const std::vector<const ThresholdRow*>& rows, const std::string& quantity) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const ThresholdRow* row) { return row->quantity == quantity; });
  return found == rows.end() ? nullptr : *found;
}

/// The two tested levels around x.
std::pair<double, double> neighbours_of(const std::vector<double>& level_x, double x) {
  const auto after = std::lower_bound(level_x.begin(), level_x.end(), x);
  if (after == level_x.begin()) return {x, x};
  if (after == level_x.end()) return {x, x};
  return {*(after - 1), *after};
}

/// Why the paper's way lies outside the joint model's interval; empty where it does not, or has no number.
std::string why_different(const HeadlineRow& row, const ArtifactScores& scores) {
  if (!row.paper_way || !row.here.level_x || !row.paper_way->level_x) return "";
  const double x = *row.paper_way->level_x;
  if (x >= row.here.ci95.low_x && x <= row.here.ci95.high_x) return "";
  const LevelAxis& axis = scores.axis;
  std::string why = "the means around it scatter about the model's curve, which is fitted to all levels";
  const auto [low, high] = neighbours_of(levels_on_axis(scores), x);
  if (row.rule->level && high - low > wide_gap_octaves)
    why = fmt::format("a straight line between the tested levels {} and {} does not follow the curve",
                      estimated_text(axis, level_at(axis, low)), estimated_text(axis, level_at(axis, high)));
  if (!row.rule->level)
    why = "the centre of a logistic is the steepest place of a curve only where that is symmetric";
  return fmt::format(
      "{} of '{}'{} is {} by the joint model and {} by the paper's way, outside the interval: {}.",
      row.rule->name, word(row.artifact), in_condition(row.condition),
      estimated_text(axis, level_at(axis, *row.here.level_x)), estimated_text(axis, level_at(axis, x)), why);
}

std::vector<HeadlineRow> rows_of_curve(const Analysis& analysis, int curve,
                                       const RowsOfCurves<ThresholdRow>& paper_way,
                                       const PlantedDetection& known) {
  const ArtifactScores& scores = analysis.data.artifacts[curve];
  const std::vector<const ThresholdRow*> beside_rows = rows_of(paper_way, scores);
  const bool rated = asks_ratings(analysis.log);
  std::vector<HeadlineRow> rows;
  for (std::size_t q = 0; q < threshold_rules.size(); ++q) {
    const ThresholdRule& rule = threshold_rules[q];
    if (!rated && rule.name != word(JointQuantity::detection)) continue;
    const auto quantity = std::find_if(every_joint_quantity.begin(), every_joint_quantity.end(),
                                       [&](JointQuantity one) { return word(one) == rule.name; });
    if (quantity == every_joint_quantity.end()) continue;
    const JointThreshold& found = threshold_of(*analysis.joint, curve, *quantity);
    HeadlineRow row{.artifact = scores.artifact,
                    .condition = scores.condition,
                    .tested = tested_levels(scores),
                    .rule = &rule,
                    .here = found.here,
                    .simultaneous = found.simultaneous,
                    .beyond_levels = found.beyond_levels && found.here.level_x,
                    .paper_way = {},
                    .paper_px = {},
                    .planted = {},
                    .differs = {}};
    if (const ThresholdRow* beside = row_of(beside_rows, rule.name)) {
      row.paper_way = beside->here;
      row.paper_px = beside->paper_px;
      if (beside->planted_x)
        row.planted = ThresholdEstimate{.level_x = beside->planted_x, .reason = {}, .ci95 = {}};
    }
    if (const auto planted = known.find({row.artifact, row.condition}); planted != known.end())
      row.planted = ThresholdEstimate{.level_x = planted->second, .reason = {}, .ci95 = {}};
    row.differs = why_different(row, scores);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// A curve that falls between two tested levels; empty where the levels lie closely enough.
std::string note_on_gap(const Analysis& analysis, int curve) {
  const JointFit& fit = analysis.joint->fit;
  if (!fit.estimated(curve)) return "";
  const ArtifactScores& scores = analysis.data.artifacts[curve];
  const JointCurve at = curve_at(fit.model, fit.theta, curve);
  const auto [low, high] = neighbours_of(levels_on_axis(scores), at.m);
  const double error = place_error_of(fit, curve);
  if (!(error > 0)) return "";
  return fmt::format(
      "Seeing '{}'{} falls between the tested {}s {} and {}, so that nothing but the model's form places its "
      "thresholds. Their intervals count a standard error of {:.2f} {} for that. Test {}s between the two.",
      word(scores.artifact), in_condition(scores.condition), level_word(scores.axis),
      estimated_text(scores.axis, level_at(scores.axis, low)),
      estimated_text(scores.axis, level_at(scores.axis, high)), std::abs(difference_at(scores.axis, error)),
      length_unit(scores.axis), level_word(scores.axis));
}

}  // namespace

bool in_guess_floor(const ThresholdEstimate& estimate) {
  return estimate.reason == NoThreshold::guess_floor;
}

std::vector<HeadlineRow> headline_rows(const Analysis& analysis) {
  std::vector<HeadlineRow> rows;
  if (!analysis.joint) return rows;
  const std::vector<ThresholdRow> paper_rows = threshold_rows(analysis);
  const RowsOfCurves<ThresholdRow> paper_way = rows_of_curves(paper_rows);
  const PlantedDetection planted = planted_detection(analysis);
  for (int curve = 0; curve < std::ssize(analysis.data.artifacts); ++curve) {
    std::vector<HeadlineRow> of_curve = rows_of_curve(analysis, curve, paper_way, planted);
    const bool floor = std::any_of(of_curve.begin(), of_curve.end(),
                                   [](const HeadlineRow& row) { return in_guess_floor(row.here); });
    if (floor)
      std::stable_partition(of_curve.begin(), of_curve.end(), [](const HeadlineRow& row) {
        return std::string_view(row.rule->name).ends_with("corrected");
      });
    for (HeadlineRow& row : of_curve) rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> notes_on_headline(const Analysis& analysis) {
  std::vector<std::string> notes;
  if (!analysis.joint) return notes;
  if (!analysis.joint->fit.estimated()) {
    notes.push_back("The joint model has no numbers, so there are no thresholds of record: " +
                    analysis.joint->fit.explanation);
    return notes;
  }
  std::string floor, beyond;
  const auto name = [](std::string& list, const HeadlineRow& row) {
    list += fmt::format("{}{} of '{}'{}", list.empty() ? "" : ", ", row.rule->name, word(row.artifact),
                        in_condition(row.condition));
  };
  for (const HeadlineRow& row : headline_rows(analysis)) {
    if (in_guess_floor(row.here)) name(floor, row);
    if (row.beyond_levels) name(beyond, row);
    if (!row.differs.empty()) notes.push_back(row.differs);
  }
  for (int curve = 0; curve < std::ssize(analysis.data.artifacts); ++curve)
    if (std::string note = note_on_gap(analysis, curve); !note.empty()) notes.push_back(std::move(note));
  if (!floor.empty())
    notes.push_back(fmt::format(
        "Not identified, because the level lies in the guess floor (people who see nothing score {:.2f} on "
        "average): {}. Read the thresholds corrected for guessing instead.",
        analysis.guessing.floor, floor));
  if (!beyond.empty())
    notes.push_back(
        fmt::format("By the model's form alone, since the estimate is outside the {}s tested: {}.",
                    level_word(analysis.data.axis), beyond));
  return notes;
}

}  // namespace seamline::analysis
