#include <fmt/format.h>

#include <cmath>

#include "analysis/psychometric/report/fit_text.h"
#include "analysis/psychometric/report/grouped_fit.h"
#include "support/files/markdown_table.h"
#include "support/text/printable.h"

namespace seamline::analysis {

namespace {

CsvTable table_with(const char* name, std::initializer_list<const char*> columns) {
  CsvTable table{.name = name, .columns = {}, .rows = {}};
  for (const char* column : columns) table.columns.push_back({column, "", ""});
  return table;
}

std::string ends_text(const Interval& ci95) {
  const auto end = [](double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "open"; };
  return end(ci95.low) + " to " + end(ci95.high);
}

CsvValue value_or_empty(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? CsvValue(*value) : CsvValue(std::monostate{});
}

CsvValue p_value(double p) {
  if (std::isnan(p)) return std::monostate{};
  return p < 1e-6 ? CsvValue(std::string("< 1e-6")) : CsvValue(fmt::format("{:.3g}", p));
}

/// What is said of a group, of its people or of its answers together.
std::vector<CsvValue> group_row(const FittedGroup& group) {
  std::vector<CsvValue> row = {printable(group.name)};
  const JudgedFit& sums = group.sums;
  if (!group.mixed) {
    const bool width_is_known = sums.threshold && !sums.fit.is_step && std::isfinite(sums.width_ci95.high);
    row.insert(row.end(), {value_or_empty(sums.threshold), ends_text(sums.threshold_ci95),
                           width_is_known ? CsvValue(sums.fit.width) : CsvValue(std::monostate{}),
                           ends_text(sums.width_ci95), sums.fit.function.lapse, sums.fit.function.guess,
                           sums.goodness.aic, sums.verdict.text});
    return row;
  }
  const PeopleFit& mixed = *group.mixed;
  row.emplace_back(static_cast<std::int64_t>(mixed.people));
  if (!mixed.identified) {
    row.insert(row.end(), 8, CsvValue(std::monostate{}));
    row.emplace_back("not identified: " + mixed.why);
    return row;
  }
  row.insert(row.end(), {mixed.threshold, ends_text(mixed.threshold_ci95), mixed.threshold_sd, mixed.width,
                         ends_text(mixed.width_ci95), mixed.width_sd, mixed.lapse, mixed.guess,
                         std::string("identified")});
  return row;
}

std::string groups_text(const GroupedFit& fits) {
  const bool over_people = fits.groups.front().mixed.has_value();
  CsvTable table =
      over_people
          ? table_with("groups", {"group", "people", "mean threshold", "95 % interval", "SD between people",
                                  "width", "95 % interval", "SD of log2 width", "lapse", "guess", "verdict"})
          : table_with("groups", {"group", "threshold", "95 % interval", "width", "95 % interval", "lapse",
                                  "guess", "AIC", "verdict"});
  for (const FittedGroup& group : fits.groups) table.rows.push_back(group_row(group));
  if (fits.groups.front().name.empty()) {
    table.columns.erase(table.columns.begin());
    for (auto& row : table.rows) row.erase(row.begin());
  }
  return markdown_table(table, 4) + "\n";
}

std::string participants_text(const GroupedFit& fits, const FittedGroup& group) {
  CsvTable table =
      table_with("people", {"participant", "trials", "threshold", "95 % interval", "width", "95 % interval"});
  for (std::size_t p = 0; p < group.mixed->each.size(); ++p) {
    const PersonEstimate& one = group.mixed->each[p];
    table.rows.push_back({printable(fits.participants[group.people[p]]), one.trials, one.threshold,
                          ends_text(one.threshold_ci95), one.width, ends_text(one.width_ci95)});
  }
  return markdown_table(table, 4) + "\n";
}

std::string pairs_text(const GroupedFit& fits) {
  const bool log2 = fits.groups.front().sums.fit.options.axis == study::Axis::log2;
  const std::string& unit = fits.groups.front().sums.request.unit;
  const std::string difference = "threshold difference" + (log2           ? " (octaves)"
                                                           : unit.empty() ? std::string()
                                                                          : " (" + unit + ")");
  CsvTable table =
      table_with("differences", {"groups", difference.c_str(), "95 % interval", "p", "p of all pairs",
                                 "width ratio", "95 % interval", "p", "p of all pairs"});
  for (const GroupPair& pair : fits.pairs) {
    const auto exponential = [](double value) { return std::isfinite(value) ? std::exp2(value) : value; };
    const Interval& width = pair.log2_width.ci95;
    std::optional<double> ratio;
    if (pair.log2_width.estimate) ratio = std::exp2(*pair.log2_width.estimate);
    const Interval ratio_ci95{.low = exponential(width.low), .high = exponential(width.high)};
    table.rows.push_back(
        {printable(fits.groups[pair.second].name) + " - " + printable(fits.groups[pair.first].name),
         value_or_empty(pair.threshold.estimate), ends_text(pair.threshold.ci95), p_value(pair.threshold.p),
         p_value(pair.threshold.adjusted_p), value_or_empty(ratio), ends_text(ratio_ci95),
         p_value(pair.log2_width.p), p_value(pair.log2_width.adjusted_p)});
  }
  return markdown_table(table, 4) + "\n";
}

}  // namespace

std::string grouped_text(const GroupedFit& fits) {
  const bool named = !fits.groups.front().name.empty();
  const bool over_people = fits.groups.front().mixed.has_value();
  std::string text;
  if (!named)
    text += "All answers together, as if one person had given them:\n\n" +
            fit_text(fits.groups.front().sums) + "\n";
  if (over_people) text += "People who differ, intervals over participants:\n\n";
  text += groups_text(fits);
  for (const FittedGroup& group : fits.groups) {
    const std::string of = named ? " of group " + printable(group.name) : std::string();
    if (group.mixed && group.mixed->identified)
      text +=
          fmt::format("Participants{}, each drawn towards the mean by as much as the answers leave open:\n\n",
                      of) +
          participants_text(fits, group);
    if (group.mixed)
      for (const std::string& remark : group.mixed->remarks) text += fmt::format("Note{}: {}.\n", of, remark);
  }
  if (!fits.pairs.empty())
    text += "Differences, second group less first; p of all pairs by Holm:\n\n" + pairs_text(fits);
  if (named)
    for (const FittedGroup& group : fits.groups)
      for (const std::string& warning : group.sums.warnings)
        text += fmt::format("Warning: {}: {}.\n", printable(group.name), warning);
  return text;
}

}  // namespace seamline::analysis
