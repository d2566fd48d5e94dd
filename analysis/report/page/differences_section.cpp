#include "analysis/report/page/differences_section.h"

#include <fmt/format.h>

#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "support/text/html.h"

namespace seamline::analysis {

std::string differences_html(const Analysis& analysis) {
  if (!has_conditions(analysis.data)) return "";
  std::string html = "<h2 id=\"differences\">Differences between conditions</h2>\n";
  if (analysis.differences.empty())
    return html + html_paragraph(analysis.adaptive
                                     ? "Conditions are not compared: levels were placed by the answers."
                                     : "Conditions are not compared: no artifact was shown in two of them.");
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::vector<std::string>> lines;
  const ThresholdDifference* last = nullptr;
  for (const ThresholdDifference& found : analysis.differences) {
    const bool same =
        last != nullptr && last->artifact == found.artifact && last->condition == found.condition;
    lines.push_back({same ? "" : artifact_title(found.artifact),
                     same ? "" : fmt::format("{} − {}", found.condition, found.to), found.quantity,
                     found.text});
    last = &found;
  }
  html += fmt::format(
      "<p>How far the thresholds of a condition lie from those of the first, along the axis of levels, in "
      "{}{}, "
      "with the 95 % interval over participants.</p>\n",
      length_unit(axis), is_linear(axis) ? "" : " (1: twice the level)");
  return html + html_table({{"artifact"}, {"condition"}, {""}, {"difference, " + length_unit(axis)}}, lines) +
         "<p class=\"soft\">Above, below: the answers exclude no value on the other side, so only a bound is "
         "known. Between: a curve is a step there, and all differences between are as likely.</p>\n";
}

}  // namespace seamline::analysis
