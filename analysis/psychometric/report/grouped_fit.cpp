#include "analysis/psychometric/report/grouped_fit.h"

#include <map>

namespace seamline::analysis {

namespace {

FittedGroup fit_group(const FitTable& table, std::size_t group, const FitOptions& options,
                      const FitRequest& request) {
  FittedGroup fitted{.name = table.groups.empty() ? "" : table.groups[group],
                     .sums = judge_fit(counts_of(table, group), options, request),
                     .people = {},
                     .mixed = {}};
  if (table.participants.empty()) return fitted;
  std::map<std::size_t, std::vector<LevelCounts>> rows;
  for (const FitRow& row : table.rows)
    if (row.group == group && row.counts.trials > 0) rows[row.participant].push_back(row.counts);
  std::vector<std::vector<LevelCounts>> each;
  for (auto& [person, counts] : rows) {
    fitted.people.push_back(person);
    each.push_back(std::move(counts));
  }
  fitted.mixed = fit_people(fitted.sums.fit, each);
  return fitted;
}

}  // namespace

GroupedFit fit_groups(const FitTable& table, const FitOptions& options, const FitRequest& request) {
  GroupedFit fits;
  fits.participants = table.participants;
  const std::size_t groups = std::max<std::size_t>(1, table.groups.size());
  for (std::size_t group = 0; group < groups; ++group)
    fits.groups.push_back(fit_group(table, group, options, request));
  fits.pairs = group_pairs(fits.groups);
  return fits;
}

}  // namespace seamline::analysis
