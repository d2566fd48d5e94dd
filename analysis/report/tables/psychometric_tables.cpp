#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/matching/slider_means.h"
#include "analysis/report/tables/table_columns.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

const CsvColumn people_column{"participants", "count", "participants whose answers are fitted"};

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

}  // namespace

CsvTable psychometric_table(const Analysis& analysis, const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  const LevelWords words = level_words(axis);
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  const std::string length = "_" + length_key(axis), lengths = length_unit(axis);
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "psychometric",
      .columns =
          {artifact_column,
           people_column,
           {"answers", "count", "answers that are fitted"},
           {"threshold" + suffix, unit,
            words.symbol +
                " where the function, before guess and lapse, is 0.5; empty unless its interval is closed"},
           {"threshold_low" + suffix, unit,
            "lower end of its 95 % interval over participants (scaled profile likelihood); empty when open"},
           {"threshold_high" + suffix, unit, "upper end of it; empty when open"},
           {"width" + length, lengths,
            "distance between 0.05 and 0.95 of the function, before guess and lapse; empty unless it is "
            "identified"},
           {"width_low" + length, lengths, "lower end of its 95 % percentile interval over participants"},
           {"width_high" + length, lengths, "upper end of it"},
           {"lapse", "share 0 to 1",
            fmt::format("wrong choices that have nothing to do with the {}; bound 0.1", words.level)},
           {"lapse_low", "share 0 to 1", "lower end of its 95 % percentile interval over participants"},
           {"lapse_high", "share 0 to 1", "upper end of it"},
           {"guess", "share 0 to 1", "right choices of those who see nothing; fixed"},
           {"deviance", "", "twice the log likelihood that a function through every point would gain"},
           {"degrees_of_freedom", "count",
            fmt::format("{} (neighbours of few answers together) less free parameters", words.levels)},
           {"deviance_p", "0 to 1",
            "share of data sets simulated from the fit that fit as badly, as if answers were independent; "
            "empty: not tested"},
           {"design_effect", "ratio",
            "variance of the threshold over participants over that of independent answers"},
           {"verdict", "text", "what the data say of the threshold"},
           {"warnings", "text", "what a reader of the fit must know"},
           {"missing", "text", "why there is no fit"},
           source_column},
      .rows = {}};
  for (const ChoiceCurve& curve : numbers.choices) {
    conditions.push_back(curve.condition);
    std::vector<CsvValue> row = {std::string(word(curve.artifact)), whole(curve.people)};
    if (!curve.pooled) {
      row.resize(table.columns.size() - 2);
      row.emplace_back(curve.missing);
      row.emplace_back(source_text(analysis));
      table.rows.push_back(row);
      continue;
    }
    const PooledFit& pooled = *curve.pooled;
    const PsychometricFit& fit = pooled.fit;
    std::int64_t answers = 0;
    for (const LevelCounts& level : fit.levels) answers += level.trials;
    const bool identified = has_threshold(curve);
    const auto known = [&](double value) { return identified ? finite(value) : CsvValue(std::monostate{}); };
    row.insert(row.end(), {answers, number(pooled.threshold), finite(pooled.threshold_ci95.low),
                           finite(pooled.threshold_ci95.high), known(fit.width), known(curve.width_ci95.low),
                           known(curve.width_ci95.high), known(fit.function.lapse),
                           known(curve.lapse_ci95.low), known(curve.lapse_ci95.high), fit.function.guess,
                           finite(curve.goodness.deviance), whole(curve.goodness.degrees_of_freedom),
                           finite(curve.deviance_p), finite(pooled.design_effect), pooled.verdict.text,
                           joined(curve.warnings), curve.missing, source_text(analysis)});
    table.rows.push_back(row);
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable psychometric_levels_table(const Analysis& analysis, const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "psychometric_levels",
                 .columns = {artifact_column,
                             level_column(axis),
                             {"correct", "count", "right choices"},
                             {"trials", "count", "answers"},
                             {"share", "share 0 to 1", "correct / trials"},
                             {"fitted", "share 0 to 1", "what the fitted function expects"},
                             {"deviance_residual", "",
                              fmt::format("signed root of the {}'s part of the deviance", level_word(axis)) +
                                  "; about standard normal when the fit is right"},
                             source_column},
                 .rows = {}};
  for (const ChoiceCurve& curve : numbers.choices) {
    for (const LevelResidual& level : curve.goodness.residuals) {
      conditions.push_back(curve.condition);
      table.rows.push_back({std::string(word(curve.artifact)), level_value(axis, level.counts.level),
                            level.counts.correct, level.counts.trials, level.counts.share(), level.fitted,
                            level.deviance_residual, source_text(analysis)});
    }
    if (!curve.apart) continue;
    conditions.push_back(curve.condition);
    table.rows.push_back({std::string(word(curve.artifact)), level_value(axis, 0),
                          std::llround(curve.apart->k), std::llround(curve.apart->n),
                          curve.apart->k / curve.apart->n, CsvValue(std::monostate{}),
                          CsvValue(std::monostate{}), source_text(analysis)});
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable psychometric_band_table(const ReportNumbers& numbers) {
  CsvTable table{
      .name = "psychometric_band",
      .columns = {artifact_column,
                  {level_key(numbers.axis), std::string(facts(numbers.axis.quantity).unit),
                   of_depth_widths(numbers.axis) ? "width W of the depth map where the curve is read"
                                                 : "level where the curve is read"},
                  {"fitted", "share 0 to 1", "expected share of right choices"},
                  {"low", "share 0 to 1",
                   fmt::format("2.5 % point over bootstrap replicates of participants, {0} by {0}",
                               level_word(numbers.axis))},
                  {"high", "share 0 to 1", "97.5 % point of the same"}},
      .rows = {}};
  std::vector<std::string> conditions;
  for (const ChoiceCurve& curve : numbers.choices)
    for (const BandPoint& point : curve.band) {
      conditions.push_back(curve.condition);
      table.rows.push_back(
          {std::string(word(curve.artifact)), point.level, point.fitted, point.low, point.high});
    }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable signal_detection_table(const ReportNumbers& numbers) {
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "signal_detection",
      .columns = {artifact_column,
                  level_column(numbers.axis),
                  {"participants", "count", "with an answer at the level and a reference trial"},
                  {"hits", "share 0 to 1", "mean share of yes to stimuli"},
                  {"false_alarms", "share 0 to 1", "mean share of yes to reference trials"},
                  {"d_prime", "",
                   "mean over participants of z(hits) - z(false alarms), half an answer added to each"},
                  {"d_prime_low", "", "lower end of its 95 % interval over participants"},
                  {"d_prime_high", "", "upper end of it"},
                  {"criterion", "", "mean over participants of -(z(hits) + z(false alarms)) / 2"},
                  {"criterion_low", "", "lower end of its 95 % interval over participants"},
                  {"criterion_high", "", "upper end of it"}},
      .rows = {}};
  for (const DetectionRow& row : numbers.detection.rows) {
    conditions.push_back(row.condition);
    table.rows.push_back({std::string(word(row.artifact)), level_value(numbers.axis, row.level),
                          whole(row.people), row.hits, numbers.detection.false_alarms, row.d_prime,
                          finite(row.d_prime_ci95.low), finite(row.d_prime_ci95.high), row.criterion,
                          finite(row.criterion_ci95.low), finite(row.criterion_ci95.high)});
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable slider_table(const Analysis& analysis, const ReportNumbers& numbers) {
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "slider",
      .columns = {artifact_column,
                  level_column(numbers.axis),
                  {"participants", "count", "with an answer at the level"},
                  {"answers", "count", "theirs"},
                  {"place", "0 to 100", "mean over participants of their mean place of the slider"},
                  {"low", "0 to 100", "lower end of its 95 % interval over participants"},
                  {"high", "0 to 100", "upper end of it"},
                  source_column},
      .rows = {}};
  for (const SliderMean& row : slider_means(analysis)) {
    conditions.push_back(row.condition);
    table.rows.push_back({std::string(word(row.artifact)), level_value(numbers.axis, row.level),
                          whole(row.people), whole(row.answers), row.place.mean, finite(row.place.ci95.low),
                          finite(row.place.ci95.high), source_text(analysis)});
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

}  // namespace seamline::analysis
