#include "analysis/report/page/sections.h"

#include "analysis/report/page/html_parts.h"

namespace seamline::analysis {

std::string preregistration_html(const Analysis& analysis) {
  if (!analysis.frozen) return "";
  std::string html =
      "<h2 id=\"preregistration\">Preregistration</h2>\n" + html_paragraph(verdict_of(*analysis.frozen));
  std::vector<std::vector<std::string>> lines;
  for (const Deviation& deviation : analysis.frozen->deviations)
    lines.push_back({deviation.what, deviation.frozen, deviation.found});
  if (!lines.empty()) html += html_table({{"what"}, {"frozen", false, true}, {"found", false, true}}, lines);
  for (const std::string& remark : analysis.frozen->remarks) html += html_paragraph(remark);
  return html;
}

}  // namespace seamline::analysis
