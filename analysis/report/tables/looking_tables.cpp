#include "analysis/report/tables/looking_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "analysis/report/tables/table_columns.h"
#include "analysis/statistics/distributions.h"

namespace seamline::analysis {
namespace {

/// Values of trials, by participant.
using ValuesOfPeople = std::map<std::string, std::vector<double>>;

double mean_of_values(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / values.size();
}

PeopleMean mean_over_people(const ValuesOfPeople& values) {
  std::vector<double> means;
  means.reserve(values.size());
  for (const auto& [participant, of_trials] : values) means.push_back(mean_of_values(of_trials));
  const double mean = mean_of_values(means);
  if (means.size() < 2)
    return {mean, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const double n = means.size();
  double squares = 0;
  for (const double one : means) squares += (one - mean) * (one - mean);
  const double half = student_quantile(n - 1, 0.975) * std::sqrt(squares / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

double median_of_values(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

struct LooksOfCurve {
  ValuesOfPeople turned, facing, seen;
  std::vector<double> first_s;
  int answers = 0;
};

LookingRow row_of_curve(const ArtifactScores& curve, const LooksOfCurve& looks) {
  LookingRow row{.artifact = curve.artifact,
                 .condition = curve.condition,
                 .people = static_cast<int>(looks.turned.size()),
                 .answers = looks.answers,
                 .degrees_turned = mean_over_people(looks.turned),
                 .share_facing = mean_over_people(looks.facing),
                 .share_seen = mean_over_people(looks.seen)};
  if (!looks.first_s.empty()) row.first_look_s = median_of_values(looks.first_s);
  return row;
}

}  // namespace

std::vector<LookingRow> looking_rows(const Analysis& analysis,
                                     const std::vector<study::MeasuredLook>& looks) {
  std::set<std::string> used;
  for (const ParticipantUse& one : analysis.people)
    if (one.use == Use::used) used.insert(one.record.code);
  std::map<std::pair<Artifact, std::string>, LooksOfCurve> curves;
  for (const study::MeasuredLook& look : looks) {
    const study::Answer& answer = analysis.log.answers[look.answer];
    if (!used.contains(answer.participant)) continue;
    LooksOfCurve& curve = curves[{answer.artifact, answer.condition}];
    ++curve.answers;
    curve.turned[answer.participant].push_back(look.measures.degrees_turned);
    curve.facing[answer.participant].push_back(look.measures.share_facing);
    curve.seen[answer.participant].push_back(look.measures.first_look_s ? 1 : 0);
    if (look.measures.first_look_s) curve.first_s.push_back(*look.measures.first_look_s);
  }
  std::vector<LookingRow> rows;
  for (const ArtifactScores& curve : analysis.data.artifacts)
    if (const auto found = curves.find({curve.artifact, curve.condition}); found != curves.end())
      rows.push_back(row_of_curve(curve, found->second));
  return rows;
}

CsvTable looking_table(const Analysis& analysis, const std::vector<LookingRow>& rows) {
  CsvTable table{.name = "looking",
                 .columns = {artifact_column,
                             {"participants", "count", "with poses in the log"},
                             {"answers", "count", "trials with poses"},
                             {"degrees_turned", "degrees",
                              "that the view turned in a trial: mean over participants of their means"},
                             {"degrees_turned_low", "degrees", "lower end of its 95 % interval"},
                             {"degrees_turned_high", "degrees", "upper end of it"},
                             {"share_facing", "share 0 to 1",
                              "of a trial's time with the view within 15 degrees of the inserted object"},
                             {"share_facing_low", "share 0 to 1", "lower end of its 95 % interval"},
                             {"share_facing_high", "share 0 to 1", "upper end of it"},
                             {"share_seen", "share 0 to 1", "of trials in which the view ever was"},
                             {"share_seen_low", "share 0 to 1", "lower end of its 95 % interval"},
                             {"share_seen_high", "share 0 to 1", "upper end of it"},
                             {"first_look_s", "s",
                              "from the picture's onset until it first was: median over trials in which it "
                              "was"},
                             source_column},
                 .rows = {}};
  std::vector<std::string> conditions;
  for (const LookingRow& row : rows) {
    conditions.push_back(row.condition);
    std::vector<CsvValue> cells = {std::string(word(row.artifact)), whole(row.people), whole(row.answers)};
    for (const PeopleMean& of : {row.degrees_turned, row.share_facing, row.share_seen})
      for (const double value : {of.mean, of.low, of.high}) cells.push_back(finite(value));
    cells.push_back(number(row.first_look_s));
    cells.emplace_back(source_text(analysis));
    table.rows.push_back(std::move(cells));
  }
  add_conditions(table, analysis.data.conditions.size() > 1, conditions);
  return table;
}

}  // namespace seamline::analysis
