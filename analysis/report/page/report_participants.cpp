#include "analysis/report/page/report_html.h"
#include "analysis/report/page/report_parts.h"

namespace seamline::analysis {

std::string participant_table_html(const ReportNumbers& numbers) {
  std::vector<std::vector<std::string>> lines;
  for (const ParticipantRow& row : numbers.participants) {
    std::string use(word(row.use));
    if (row.pilot && row.use == Use::used) use += " (pilot)";
    if (!row.why.empty()) use = "not used: " + row.why;
    lines.push_back({row.code, row.kind, use, std::to_string(row.answers), percent_text(row.correct),
                     decimal_text(row.mean_rating, 2),
                     !row.screened         ? "not judged"
                     : row.screens.empty() ? "none"
                                           : row.screens,
                     seconds_text(row.median_choice_s)});
  }
  return html_table({{"participant"},
                     {"kind"},
                     {"use"},
                     {"trials", true},
                     {"right choices", true},
                     {"mean rating", true},
                     {"named by screens"},
                     {"median time to choose", true}},
                    lines) +
         "<p class=\"soft\">Chance is 33 % right. The mean rating is over all answers, right or wrong. "
         "Simulated observers take no time.</p>\n";
}

}  // namespace seamline::analysis
