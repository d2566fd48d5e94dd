#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/people_choices.h"
#include "analysis/report/tables/table_columns.h"
#include "analysis/report/text/joint_text.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {

namespace {

CsvTable thresholds_joint_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "thresholds_joint",
      .columns = {artifact_column,
                  {"quantity", "word",
                   "PT, SN, IP; PT and SN corrected: of what is seen, without lucky guesses; detection: half "
                   "is seen"},
                  {"estimate" + suffix, unit, "by the joint model; empty when there is none, see reason"},
                  {"ci95_low" + suffix, unit,
                   "lower end of its 95 % interval over participants; empty when open"},
                  {"ci95_high" + suffix, unit, "upper end of it; empty when open"},
                  {"simultaneous_low" + suffix, unit,
                   "lower end of the interval that holds together with those of all curves; empty when open"},
                  {"simultaneous_high" + suffix, unit, "upper end of it; empty when open"},
                  {"ci95_text", "text", "the 95 % interval in words"},
                  {"reason", "text", "why there is no estimate"},
                  {"beyond_levels", "0 or 1",
                   "whether the estimate is outside the levels tested, by the model alone"},
                  {"paper_way" + suffix, unit,
                   "the same by straight lines or the logistic; empty when there is none"},
                  {"differs", "text",
                   "why the paper's way lies outside the interval; empty when it does not"},
                  source_column},
      .rows = {}};
  for (const HeadlineRow& row : headline_rows(analysis)) {
    const LevelRange ci95 = range_at(axis, row.here.ci95), together = range_at(axis, row.simultaneous);
    table.rows.push_back(
        {std::string(word(row.artifact)), std::string(row.rule->name), number(level_of(row.here, axis)),
         number(closed(ci95.low)), number(closed(ci95.high)), number(closed(together.low)),
         number(closed(together.high)), interval_text(row.here.ci95, row.tested), reason_text(row.here, axis),
         whole(row.beyond_levels ? 1 : 0), number(row.paper_way, axis), row.differs, source_text(analysis)});
    conditions.push_back(row.condition);
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

/// Columns of each participant's own function, behind those of the joint model.
void add_own(CsvTable& table, const std::vector<OwnThreshold>& people, const LevelAxis& axis,
             std::vector<std::string>& conditions) {
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  for (CsvColumn& column : std::vector<CsvColumn>{
           {"own_threshold" + suffix, unit,
            "where the participant sees half, from this participant's answers alone; empty when "
            "they do not say, see own_verdict"},
           {"own_low" + suffix, unit, "lower end of its 95 % interval (profile likelihood)"},
           {"own_high" + suffix, unit, "upper end of it"},
           {"own_verdict", "text", "what these answers say of the threshold"}})
    table.columns.push_back(std::move(column));
  std::vector<std::vector<CsvValue>> rows;
  std::vector<std::string> of_rows;
  for (const OwnThreshold& own : people) {
    std::vector<CsvValue> row = {own.participant,
                                 std::string(word(own.artifact)),
                                 CsvValue(std::monostate{}),
                                 CsvValue(std::monostate{}),
                                 CsvValue(std::monostate{}),
                                 whole(own.answers)};
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      if (table.rows[i][0] == row[0] && table.rows[i][1] == row[1] && conditions[i] == own.condition)
        row = table.rows[i];
    row.push_back(own.threshold ? CsvValue(*own.threshold) : CsvValue(std::monostate{}));
    row.push_back(number(closed(own.ci95.low)));
    row.push_back(number(closed(own.ci95.high)));
    row.emplace_back(own.verdict.text);
    rows.push_back(std::move(row));
    of_rows.push_back(own.condition);
  }
  table.rows = std::move(rows);
  conditions = std::move(of_rows);
}

CsvTable thresholds_people_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  std::vector<std::string> conditions;
  CsvTable table{.name = "thresholds_people",
                 .columns = {participant_column,
                             artifact_column,
                             {"threshold" + suffix, unit,
                              level_words(axis).symbol +
                                  " where the participant sees half, partially pooled with the others"},
                             {"low" + suffix, unit, "lower end of its 95 % interval"},
                             {"high" + suffix, unit, "upper end of it"},
                             {"answers", "count",
                              "the participant's on the curve; 0: known from the other curves and people"}},
                 .rows = {}};
  if (analysis.joint)
    for (const PersonThreshold& one : analysis.joint->people.thresholds) {
      const CurveLabel& label = analysis.joint->labels[one.curve];
      const LevelRange ci95 = range_at(axis, one.ci95);
      table.rows.push_back({analysis.joint->data.people[one.person], label.artifact,
                            finite(level_at(axis, one.x)), number(closed(ci95.low)),
                            number(closed(ci95.high)), one.answers});
      conditions.push_back(label.condition);
    }
  if (const std::vector<OwnThreshold> own = own_thresholds(analysis); !own.empty())
    add_own(table, own, axis, conditions);
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable joint_cells_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "joint_cells",
                 .columns = {artifact_column,
                             level_column(axis),
                             {"score", "0 to 4", "0: the wrong object; else right with this rating"},
                             {"observed", "count", "answers with this score"},
                             {"expected", "count", "the same by the joint model"}},
                 .rows = {}};
  if (analysis.joint && analysis.joint->goodness)
    for (const ScoreCell& cell : analysis.joint->goodness->cells) {
      const CurveLabel& label = analysis.joint->labels[cell.curve];
      table.rows.push_back({label.artifact,
                            level_value(axis, std::isfinite(cell.x) ? level_at(axis, cell.x) : 0.0),
                            whole(cell.score), cell.observed, cell.expected});
      conditions.push_back(label.condition);
    }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable joint_contrasts_table(const Analysis& analysis, const ReportNumbers& numbers) {
  CsvTable table{
      .name = "joint_contrasts",
      .columns = {{"question", "text", "the question that the contrasts answer together"},
                  {"contrast", "text", "the difference of interest"},
                  {"estimate", length_unit(analysis.data.axis) + " or log ratio",
                   "difference of thresholds along the axis, or log of how many times steeper"},
                  {"standard_error", "the same", "over participants, by leaving out each in turn"},
                  {"ci95_low", "the same", "lower end of the 95 % interval, simultaneous over the question"},
                  {"ci95_high", "the same", "upper end of it"},
                  {"p", "0 to 1", "two-sided, of this contrast alone"},
                  {"adjusted_p", "0 to 1", "adjusted for all contrasts of the question"},
                  {"verdict", "word", "differs (adjusted p under 0.05), not shown or not estimable"},
                  {"conclusion", "text", "the same as a sentence"}},
      .rows = {}};
  const auto add = [&](const std::string& question, const ContrastTable& contrasts) {
    for (const ContrastRow& row : contrasts.rows)
      table.rows.push_back({question, row.name, finite(row.estimate), finite(row.standard_error),
                            finite(row.ci95_low), finite(row.ci95_high), finite(row.p),
                            finite(row.adjusted_p), std::string(word(row.verdict)),
                            as_sentence(row.conclusion)});
  };
  if (analysis.joint)
    for (const ContrastTable& contrasts : analysis.joint->contrasts.tables)
      add(contrasts.question, contrasts);
  for (const GroupComparison& groups : numbers.groups) add(groups.shifts.question, groups.shifts);
  add(numbers.halves.shifts.question, numbers.halves.shifts);
  return table;
}

CsvTable joint_checks_table(const Analysis& analysis) {
  CsvTable table{
      .name = "joint_checks",
      .columns = {{"check", "text", "what is asked of the joint model"},
                  {"statistic", "", "likelihood ratio (G2) of answers, F of what is shared"},
                  {"parameters", "count", "how many more the richer model has; empty: one a cell"},
                  {"p", "0 to 1",
                   "of answers: parametric bootstrap over people; of what is shared: robust score test"},
                  {"note", "text", "why there is no p"}},
      .rows = {}};
  if (!analysis.joint) return table;
  if (const std::optional<JointGoodness>& goodness = analysis.joint->goodness) {
    const std::string note = goodness->replicates > 0 ? "" : "no data sets were simulated";
    const auto p = [&](double value) {
      return goodness->replicates > 0 ? finite(value) : CsvValue(std::monostate{});
    };
    table.rows.push_back({std::string("choices: right and wrong in every cell"), finite(goodness->choices_g2),
                          CsvValue(std::monostate{}), p(goodness->choices_p), note});
    table.rows.push_back({std::string("ratings of right choices in every cell"), finite(goodness->ratings_g2),
                          CsvValue(std::monostate{}), p(goodness->ratings_p), note});
  }
  for (const SharingTest& test : analysis.joint->sharing)
    table.rows.push_back({"shared by all curves: " + test.shared, finite(test.statistic),
                          whole(test.parameters), finite(test.p), test.note});
  return table;
}

CsvTable joint_parameters_table(const Analysis& analysis) {
  CsvTable table{
      .name = "joint_parameters",
      .columns = {{"parameter", "text",
                   "m: threshold on the axis; log s: scale; l: lapse; t, rho: rating criteria; h: guess "
                   "ratings (documentation/explanation/joint_model.md)"},
                  {"estimate", "", "unbounded coordinate"},
                  {"standard_error", "", "over participants, by the jackknife"}},
      .rows = {}};
  if (!analysis.joint || !analysis.joint->fit.estimated()) return table;
  const JointAnalysis& joint = *analysis.joint;
  const std::vector<std::string> names = parameter_names(joint.fit.model, joint.data.curves);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    table.rows.push_back(
        {names[i], finite(joint.fit.theta[at]), finite(std::sqrt(joint.left_out.covariance(at, at)))});
  }
  return table;
}

CsvTable groups_table(const ReportNumbers& numbers) {
  CsvTable table{.name = "groups",
                 .columns = {{"field", "text", "what people are grouped by"},
                             {"group", "text", "its value, or band"},
                             {"participants", "count", "in the group"},
                             {"verdict", "text", "why groups are not compared; empty when they are"}},
                 .rows = {}};
  for (const GroupComparison& comparison : numbers.groups) {
    if (comparison.groups.empty())
      table.rows.push_back({comparison.field, std::string(), whole(0), comparison.verdict});
    for (std::size_t g = 0; g < comparison.groups.size(); ++g)
      table.rows.push_back(
          {comparison.field, comparison.groups[g], whole(comparison.people[g]), comparison.verdict});
  }
  return table;
}

}  // namespace

std::vector<CsvTable> joint_tables(const Analysis& analysis, const ReportNumbers& numbers) {
  return {thresholds_joint_table(analysis),
          thresholds_people_table(analysis),
          joint_cells_table(analysis),
          joint_contrasts_table(analysis, numbers),
          joint_checks_table(analysis),
          joint_parameters_table(analysis),
          groups_table(numbers)};
}

}  // namespace seamline::analysis
