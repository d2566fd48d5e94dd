#include "analysis/report/tables/preregistration_table.h"

#include <fmt/core.h>

#include "support/text/printable.h"

namespace seamline::analysis {

CsvTable deviations_table(const FrozenComparison& frozen) {
  CsvTable table{.name = "deviations",
                 .columns = {{"what", "text", "what is not as it was frozen"},
                             {"frozen", "text", "as the archive has it"},
                             {"found", "text", "as it is in the log or was done"}},
                 .rows = {}};
  for (const Deviation& deviation : frozen.deviations)
    table.rows.push_back({deviation.what, deviation.frozen, deviation.found});
  return table;
}

std::string frozen_text(const Analysis& analysis) {
  if (!analysis.frozen) return "";
  std::string text = printable(verdict_of(*analysis.frozen)) + "\n";
  for (const Deviation& deviation : analysis.frozen->deviations)
    text += fmt::format("  {}: frozen {}, found {}\n", deviation.what, printable(deviation.frozen),
                        printable(deviation.found));
  for (const std::string& remark : analysis.frozen->remarks) text += "  " + printable(remark) + "\n";
  return text + "\n";
}

}  // namespace seamline::analysis
