#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/tables/table_columns.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/angular_resolution.h"

namespace seamline::analysis {

namespace {

/// The columns of an estimate: name_px (or the unit of another quantity), its interval and the reason why
/// there is none.
void add_columns(CsvTable& table, const LevelAxis& axis, const std::string& name,
                 const std::string& meaning) {
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  table.columns.push_back(
      {name + suffix, unit, meaning + "; empty when there is none, see " + name + "_reason"});
  table.columns.push_back({name + "_low" + suffix, unit, "lower end of its 95 % interval; empty when open"});
  table.columns.push_back({name + "_high" + suffix, unit, "upper end of its 95 % interval; empty when open"});
  table.columns.push_back({name + "_reason", "text", "why there is no estimate"});
}

void add_values(std::vector<CsvValue>& row, const LevelAxis& axis, const ThresholdEstimate& estimate) {
  const LevelRange ci95 = range_at(axis, estimate.ci95);
  row.push_back(number(level_of(estimate, axis)));
  row.push_back(number(closed(ci95.low)));
  row.push_back(number(closed(ci95.high)));
  row.emplace_back(reason_text(estimate, axis));
}

CsvTable beside_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "thresholds_beside", .columns = {artifact_column, quantity_column}, .rows = {}};
  add_columns(table, axis, "isotonic",
              "PT and SN of the isotonic fit, as in thresholds.csv; IP of the logistic");
  add_columns(table, axis, "logistic", "read off the least-squares four-parameter logistic");
  add_columns(table, axis, "corrected", "of the curve corrected for guessing");
  table.columns.push_back(
      {"one_object_out_text", "text",
       "range of the estimates when each object in turn is left out; no confidence interval"});
  table.columns.push_back({"texels_per_degree", "1/degree", "W / 360 of isotonic_px"});
  table.columns.push_back(
      {"field_of_view_deg", "degree", "horizontal field of view of the next two columns"});
  table.columns.push_back(
      {"field_of_view_px", "px", "width of an equirectangular cut of that field of view"});
  table.columns.push_back(
      {"pinhole_px", "px", "width of a pinhole depth map of that field of view, as fine at its centre"});
  table.columns.push_back(source_column);
  const double view_deg = analysis.options.field_of_view_deg;
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    std::vector<CsvValue> values = {std::string(word(row.artifact)), row.quantity};
    add_values(values, axis, row.here);
    add_values(values, axis, row.logistic ? *row.logistic : row.here);
    add_values(values, axis, row.corrected);
    values.emplace_back(row.object_range ? interval_text(*row.object_range, row.tested) : "");
    const auto of_width = [&](auto convert) {
      return row.here.level_x ? CsvValue(convert(*level_of(row.here, axis))) : CsvValue(std::monostate{});
    };
    values.push_back(of_width([](double width_px) { return texels_per_degree(width_px); }));
    values.emplace_back(view_deg);
    values.push_back(
        of_width([&](double width_px) { return width_in_field_of_view_px(width_px, view_deg); }));
    values.push_back(of_width([&](double width_px) { return pinhole_width_px(width_px, view_deg); }));
    values.emplace_back(source_text(analysis));
    table.rows.push_back(values);
    conditions.push_back(row.condition);
  }
  if (!of_depth_widths(axis))
    for (const char* name : {"texels_per_degree", "field_of_view_deg", "field_of_view_px", "pinhole_px"})
      drop_column(table, name);
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable corrected_curves_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "curves_corrected",
      .columns = {artifact_column,
                  level_column(axis),
                  {"uncorrected", "noticeability 0 to 4", "mean noticeability as in curves.csv"},
                  {"saw", "probability", "P(saw the insertion) by the latent-class model"},
                  {"rating_of_seen", "1 to 4", "mean rating of those who saw; empty when nobody did"},
                  {"corrected", "noticeability 0 to 4", "saw times rating_of_seen"},
                  source_column},
      .rows = {}};
  for (std::size_t i = 0; i < analysis.guessing.curves.size(); ++i) {
    const CorrectedCurve& curve = analysis.guessing.curves[i];
    for (std::size_t w = 0; w < curve.cells.size(); ++w) {
      conditions.push_back(curve.condition);
      table.rows.push_back({std::string(word(curve.artifact)), level_value(axis, curve.level[w]),
                            analysis.data.artifacts[i].cells[w].mean, curve.cells[w].saw,
                            curve.cells[w].mean_rating_of_seen(), curve.cells[w].noticeability,
                            source_text(analysis)});
    }
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable guessers_table(const Analysis& analysis) {
  CsvTable table{.name = "guessers",
                 .columns = {{"what", "text", "what the probability is of, given that the answer is a guess"},
                             {"probability", "0 to 1", "estimated from wrong choices and reference trials"},
                             source_column},
                 .rows = {}};
  const Guessers& guessers = analysis.guessing.guessers;
  if (!guessers.known()) return table;
  for (std::size_t position = 0; position < guessers.position.size(); ++position)
    table.rows.push_back({fmt::format("chooses position {}", position + 1), guessers.position[position],
                          source_text(analysis)});
  for (int rating = 1; rating <= study::highest_rating; ++rating)
    table.rows.push_back(
        {fmt::format("rates {}", rating), guessers.rating[rating - 1], source_text(analysis)});
  return table;
}

CsvTable screening_table(const Analysis& analysis) {
  const std::string screened_cells = "the same over artifacts and " + level_words(analysis.data.axis).levels +
                                     (has_conditions(analysis.data) ? ", conditions apart" : "");
  CsvTable table{
      .name = "screening",
      .columns = {participant_column,
                  {"catch_trials", "count", "catch trials answered"},
                  {"catch_right", "count", "of these right"},
                  {"attention_named", "0 or 1",
                   std::string(rule_of(ScreeningRule::attention)) + "; empty when not judged"},
                  {"extreme_high", "count", "P of ITU-R BT.500: scores far above the mean of all"},
                  {"extreme_low", "count", "Q of ITU-R BT.500: scores far below it"},
                  {"stimuli", "count", "stimuli with a score"},
                  {"kurtosis_named", "0 or 1",
                   std::string(rule_of(ScreeningRule::kurtosis)) + "; empty when not judged"},
                  {"correlation_stimuli", "between -1 and 1",
                   "Pearson correlation with the mean of the others, over stimuli"},
                  {"correlation_conditions", "between -1 and 1", screened_cells},
                  {"correlation_limit", "between -1 and 1", "what it has to exceed, for so many stimuli"},
                  {"correlation_named", "0 or 1",
                   std::string(rule_of(ScreeningRule::correlation)) + "; empty when not judged"},
                  {"below_p913", "0 or 1",
                   "correlations under 0.75 over stimuli and 0.80 over conditions, as in ITU-T "
                   "P.913; reported only"}},
      .rows = {}};
  const auto named = [&](const ScreenedPerson& person, ScreeningRule rule) {
    return analysis.screening.judged(rule) ? CsvValue(whole(person.named_by(rule)))
                                           : CsvValue(std::monostate{});
  };
  for (const ScreenedPerson& person : analysis.screening.people)
    table.rows.push_back({person.code, whole(person.attention.shown), whole(person.attention.right),
                          named(person, ScreeningRule::attention), whole(person.kurtosis.above),
                          whole(person.kurtosis.below), whole(person.kurtosis.stimuli),
                          named(person, ScreeningRule::kurtosis), person.correlation.stimuli,
                          person.correlation.conditions, person.correlation.critical,
                          named(person, ScreeningRule::correlation), whole(person.correlation.below_p913)});
  return table;
}

CsvTable screened_thresholds_table(const Analysis& analysis) {
  CsvTable table{.name = "thresholds_screened",
                 .columns = {{"who", "text", "everybody, or without those whom a screen names"},
                             {"left_out", "participants", "how many are left out"},
                             artifact_column,
                             quantity_column},
                 .rows = {}};
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  add_columns(table, axis, "estimate", level_words(axis).symbol);
  for (const ScreenedThresholds& result : analysis.screened)
    for (const ArtifactThresholds& thresholds : result.thresholds) {
      const CurveThresholds& found = thresholds.estimates;
      const auto add = [&](const char* quantity, const ThresholdEstimate& estimate) {
        std::vector<CsvValue> row = {result.who, whole(result.left_out.size()),
                                     std::string(word(thresholds.artifact)), std::string(quantity)};
        add_values(row, axis, estimate);
        table.rows.push_back(row);
        conditions.push_back(thresholds.condition);
      };
      add("PT", found.perceptual);
      add("SN", found.slightly_noticeable);
      add("IP", found.inflection);
    }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

/// Present where people came by both ways.
CsvTable origins_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "lab_and_web",
                 .columns = {artifact_column,
                             quantity_column,
                             {"lab", "participants", "on the curve, who took part in the window"},
                             {"web", "participants", "on the curve, who took part in a browser"}},
                 .rows = {}};
  add_columns(table, axis, "lab_estimate", "of those in the lab alone");
  add_columns(table, axis, "web_estimate", "of those in browsers alone");
  table.columns.push_back(
      {"difference", length_unit(axis), "web less lab along the axis; empty without both"});
  table.columns.push_back(
      {"p", "probability", "of no difference, by permuting participants; empty under two in a group"});
  table.columns.push_back({"p_holm", "probability", "adjusted for all tests of the table (Holm)"});
  for (const OriginDifference& found : analysis.origins->differences) {
    std::vector<CsvValue> row = {std::string(word(found.artifact)), found.quantity, whole(found.lab),
                                 whole(found.web)};
    for (const OriginGroup* group : {&analysis.origins->lab, &analysis.origins->web}) {
      ThresholdEstimate estimate{.level_x = {}, .reason = NoThreshold::nobody_on_curve, .ci95 = {}};
      for (const ArtifactThresholds& one : group->thresholds)
        if (one.artifact == found.artifact && one.condition == found.condition)
          estimate = found.quantity == "PT" ? one.estimates.perceptual : one.estimates.slightly_noticeable;
      add_values(row, axis, estimate);
    }
    row.push_back(number(found.difference));
    row.push_back(number(found.p));
    row.push_back(number(found.p_holm));
    table.rows.push_back(row);
    conditions.push_back(found.condition);
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable opinion_scores_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "opinion_scores",
                 .columns = {artifact_column,
                             level_column(axis),
                             {"scene", "text", "name of the scene in the study file"},
                             {"object", "text", "name of the inserted object"},
                             index_column,
                             {"n", "participants", "participants with a score"},
                             {"mos", "noticeability 0 to 4", "mean opinion score"},
                             {"sd", "noticeability", "standard deviation over participants (n - 1)"},
                             {"ci95_low", "noticeability", "mos - t(n - 1) sd / sqrt(n)"},
                             {"ci95_high", "noticeability", "mos + t(n - 1) sd / sqrt(n)"},
                             source_column},
                 .rows = {}};
  for (std::size_t s = 0; s < analysis.opinion.size(); ++s) {
    const ScoredStimulus& stimulus = analysis.scores.stimuli[s];
    const OpinionScore& mos = analysis.opinion[s];
    table.rows.push_back({std::string(word(stimulus.artifact)), level_value(axis, stimulus.level),
                          stimulus.scene, stimulus.object, whole(stimulus.object_index), whole(mos.n),
                          mos.mean, mos.sd, mos.ci95_low, mos.ci95_high, source_text(analysis)});
    conditions.push_back(stimulus.condition);
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable differences_table(const Analysis& analysis) {
  const std::string length = "_" + length_key(analysis.data.axis), unit = length_unit(analysis.data.axis);
  CsvTable table{.name = "threshold_differences",
                 .columns = {artifact_column,
                             quantity_column,
                             {"condition", "word", "whose threshold is compared"},
                             {"to", "word", "condition that it is compared to: the study's first"},
                             {"participants", "count", "participants on the curves of all conditions"},
                             {"estimate" + length, unit,
                              "threshold of the condition less that of the first, along the axis; empty "
                              "unless its interval is closed"},
                             {"bound_low" + length, unit,
                              "what the difference is above when a threshold lies beyond the levels tested; "
                              "empty when nothing is known"},
                             {"bound_high" + length, unit, "what it is below"},
                             {"ci95_low" + length, unit,
                              "lower end of its 95 % interval over participants; empty when open"},
                             {"ci95_high" + length, unit, "upper end of it; empty when open"},
                             {"text", "text", "the same in words"},
                             source_column},
                 .rows = {}};
  for (const ThresholdDifference& found : analysis.differences)
    table.rows.push_back({std::string(word(found.artifact)), found.quantity, found.condition, found.to,
                          whole(found.participants), number(found.estimate), finite(found.bounds.low),
                          finite(found.bounds.high), finite(found.ci95.low), finite(found.ci95.high),
                          found.text, source_text(analysis)});
  return table;
}

}  // namespace

std::vector<CsvTable> checks_tables(const Analysis& analysis) {
  std::vector<CsvTable> tables = {
      beside_table(analysis),    corrected_curves_table(analysis),    guessers_table(analysis),
      screening_table(analysis), screened_thresholds_table(analysis), opinion_scores_table(analysis)};
  if (has_conditions(analysis.data)) tables.push_back(differences_table(analysis));
  if (analysis.origins) tables.push_back(origins_table(analysis));
  return tables;
}

}  // namespace seamline::analysis
