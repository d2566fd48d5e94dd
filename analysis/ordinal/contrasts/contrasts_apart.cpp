#include "analysis/ordinal/contrasts/contrasts_apart.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/ordinal/contrasts/contrast_rows.h"
#include "analysis/ordinal/contrasts/max_t.h"

namespace seamline::analysis {

ContrastTable test_contrasts_apart(std::span<const EstimatedContrasts> parts) {
  assert(!parts.empty());
  ContrastTable table = empty_table(parts.front().family, Correction::holm);
  std::vector<double> p;
  for (const EstimatedContrasts& part : parts)
    for (ContrastRow& row : estimated_rows(part.family, part.coefficients, part.covariance)) {
      p.push_back(row.p);
      table.rows.push_back(std::move(row));
    }
  const std::vector<double> adjusted = holm_adjusted(p);
  const auto estimable = std::count_if(p.begin(), p.end(), [](double one) { return !std::isnan(one); });
  std::size_t i = 0;
  for (const EstimatedContrasts& part : parts)
    for (const Contrast& contrast : part.family.contrasts) {
      ContrastRow& row = table.rows[i];
      row.adjusted_p = adjusted[i++];
      if (std::isnan(row.p)) continue;
      const double factor = two_sided_critical(significance / estimable, part.family.degrees_of_freedom);
      row.ci95_low = row.estimate - factor * row.standard_error;
      row.ci95_high = row.estimate + factor * row.standard_error;
      conclude(contrast, part.family.odds_ratio, row);
    }
  return table;
}

}  // namespace seamline::analysis
