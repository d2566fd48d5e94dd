#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/log_analysis/task_words.h"
#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/checks_text.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/thresholds/angular_resolution.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

using Cells = std::vector<std::string>;

/// The estimate as resolution in a smaller field of view; a dash without an estimate.
std::string view_text(const ThresholdEstimate& estimate, double view_deg) {
  if (!estimate.level_x) return "–";
  const double width_px = std::exp2(*estimate.level_x);
  return fmt::format("{:.0f} / {:.0f}", width_in_field_of_view_px(width_px, view_deg),
                     pinhole_width_px(width_px, view_deg));
}

std::string beside_html(const Analysis& analysis) {
  const double view_deg = analysis.options.field_of_view_deg;
  std::vector<Cells> lines;
  const bool views = of_depth_widths(analysis.data.axis);
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    lines.push_back(otherwise_estimated_cells(row));
    if (views) lines.back().push_back(view_text(row.here, view_deg));
  }
  std::vector<HtmlColumn> columns = {
      {"artifact"}, {""}, {"isotonic"}, {"logistic"}, {"corrected for guessing"}, {"one object left out"}};
  if (views) columns.push_back({fmt::format("px for {:.3g}°", view_deg)});
  return html_table(columns, lines);
}

std::string screened_html(const Analysis& analysis) {
  return html_table({{"thresholds"}, {"artifact"}, {"PT"}, {"SN"}, {"IP"}}, screened_lines(analysis));
}

}  // namespace

std::string checks_html(const Analysis& analysis, const std::vector<Figure>& figures) {
  std::string html = "<h2 id=\"checks\">Checks</h2>\n";
  if (analysis.guessing.curves.empty())
    html +=
        "<p>Thresholds are not estimated otherwise, nor corrected for guessing: there are no curves of "
        "mean noticeability.</p>\n";
  else if (!asks_ratings(analysis.log))
    html += html_paragraph("Ratings were not asked, so there is nothing to estimate PT, SN and IP by.") +
            html_paragraph(guessers_text(analysis.guessing)) + figure_html(figures, "corrected_for_guessing");
  else if (!of_depth_widths(analysis.data.axis))
    html += html_paragraph("The thresholds otherwise estimated: " + axis_title(analysis.data.axis) +
                           ", 95 % interval in brackets.") +
            beside_html(analysis) + html_paragraph(guessers_text(analysis.guessing)) +
            figure_html(figures, "corrected_for_guessing");
  else
    html += fmt::format(
                "<p>The thresholds otherwise estimated: width W in px, 95 % interval in brackets. Last "
                "column: as fine for a camera of {:.3g}° horizontally, cut from an equirectangular map / "
                "through a pinhole.</p>\n",
                analysis.options.field_of_view_deg) +
            beside_html(analysis) + html_paragraph(guessers_text(analysis.guessing)) +
            figure_html(figures, "corrected_for_guessing");
  html += html_paragraph(screening_sentence(analysis.screening));
  if (analysis.screened.size() > 1) html += screened_html(analysis);
  html += "<p class=\"soft\">Rules of the screens:";
  for (ScreeningRule rule : every_screening_rule) html += " " + html_escape(std::string(rule_of(rule))) + ".";
  html += "</p>\n";
  if (!std::isnan(analysis.sos.a))
    html += html_paragraph("Standard deviation of opinion scores (SOS): " + sos_text(analysis.sos) + ".");
  return html;
}

}  // namespace seamline::analysis
