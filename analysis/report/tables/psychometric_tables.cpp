#include <cmath>

#include "analysis/report/tables/section_tables.h"
#include "analysis/report/tables/table_columns.h"

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
  CsvTable table{
      .name = "psychometric",
      .columns =
          {artifact_column,
           people_column,
           {"answers", "count", "answers that are fitted"},
           {"threshold_px", "px",
            "width W where the function, before guess and lapse, is 0.5; empty unless it is identified"},
           {"threshold_low_px", "px",
            "lower end of its 95 % interval over participants (scaled profile likelihood); empty when open"},
           {"threshold_high_px", "px", "upper end of it; empty when open"},
           {"width_octaves", "octaves",
            "distance between 0.05 and 0.95 of the function, before guess and lapse; empty unless it is "
            "identified"},
           {"width_low_octaves", "octaves", "lower end of its 95 % percentile interval over participants"},
           {"width_high_octaves", "octaves", "upper end of it"},
           {"lapse", "share 0 to 1", "wrong choices that have nothing to do with the width; bound 0.1"},
           {"lapse_low", "share 0 to 1", "lower end of its 95 % percentile interval over participants"},
           {"lapse_high", "share 0 to 1", "upper end of it"},
           {"guess", "share 0 to 1", "right choices of those who see nothing; fixed"},
           {"deviance", "", "twice the log likelihood that a function through every point would gain"},
           {"degrees_of_freedom", "count", "widths less free parameters"},
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
    row.insert(row.end(), {answers, known(fit.function.threshold), finite(pooled.threshold_ci95.low),
                           finite(pooled.threshold_ci95.high), known(fit.width), known(curve.width_ci95.low),
                           known(curve.width_ci95.high), known(fit.function.lapse),
                           known(curve.lapse_ci95.low), known(curve.lapse_ci95.high), fit.function.guess,
                           finite(curve.goodness.deviance), whole(curve.goodness.degrees_of_freedom),
                           finite(curve.deviance_p), finite(pooled.design_effect), pooled.verdict.text,
                           joined(curve.warnings), curve.missing, source_text(analysis)});
    table.rows.push_back(row);
  }
  return table;
}

CsvTable psychometric_levels_table(const Analysis& analysis, const ReportNumbers& numbers) {
  CsvTable table{.name = "psychometric_levels",
                 .columns = {artifact_column,
                             width_column,
                             {"correct", "count", "right choices"},
                             {"trials", "count", "answers"},
                             {"share", "share 0 to 1", "correct / trials"},
                             {"fitted", "share 0 to 1", "what the fitted function expects"},
                             {"deviance_residual", "",
                              "signed root of the width's part of the deviance; about standard normal when "
                              "the fit is right"},
                             source_column},
                 .rows = {}};
  for (const ChoiceCurve& curve : numbers.choices)
    for (const LevelResidual& level : curve.goodness.residuals)
      table.rows.push_back(
          {std::string(word(curve.artifact)), whole(level.counts.level), level.counts.correct,
           level.counts.trials,
           static_cast<double>(level.counts.correct) / static_cast<double>(level.counts.trials), level.fitted,
           level.deviance_residual, source_text(analysis)});
  return table;
}

CsvTable psychometric_band_table(const ReportNumbers& numbers) {
  CsvTable table{.name = "psychometric_band",
                 .columns = {artifact_column,
                             {"width_px", "px", "width W of the depth map where the curve is read"},
                             {"fitted", "share 0 to 1", "expected share of right choices"},
                             {"low", "share 0 to 1",
                              "2.5 % point over bootstrap replicates of participants, width by width"},
                             {"high", "share 0 to 1", "97.5 % point of the same"}},
                 .rows = {}};
  for (const ChoiceCurve& curve : numbers.choices)
    for (const BandPoint& point : curve.band)
      table.rows.push_back(
          {std::string(word(curve.artifact)), point.width_px, point.fitted, point.low, point.high});
  return table;
}

}  // namespace seamline::analysis
