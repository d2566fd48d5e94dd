#include "analysis/report/tables/number_tables.h"

#include "analysis/report/tables/section_tables.h"

namespace seamline::analysis {

std::vector<CsvTable> number_tables(const Analysis& analysis, const ReportNumbers& numbers) {
  return {psychometric_table(analysis, numbers),
          psychometric_levels_table(analysis, numbers),
          psychometric_band_table(numbers),
          coefficients_table(numbers),
          contrasts_table(numbers),
          response_times_table(numbers),
          participants_table(numbers),
          tracks_table(numbers)};
}

}  // namespace seamline::analysis
