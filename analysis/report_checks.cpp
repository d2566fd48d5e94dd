#include <fmt/format.h>

#include <cmath>

#include "analysis/angular_resolution.h"
#include "analysis/checks_text.h"
#include "analysis/report_html.h"
#include "analysis/report_parts.h"
#include "analysis/threshold_rows.h"
#include "stimuli/support/html.h"

namespace seamline {

namespace {

using Cells = std::vector<std::string>;

std::string beside_html(const Analysis& analysis) {
  const double view_deg = analysis.options.field_of_view_deg;
  std::vector<Cells> lines;
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    const auto text = [&](const WidthEstimate& estimate) {
      return estimate_text(estimate, row.smallest_px, row.largest_px);
    };
    const bool inflection = row.quantity == "IP";
    const double width_px = row.here.log2_px ? std::exp2(*row.here.log2_px) : std::nan("");
    lines.push_back(
        {row.quantity == "PT" ? artifact_title(row.artifact) : "", row.quantity,
         inflection ? "" : text(row.here),
         inflection     ? text(row.here)
         : row.logistic ? text(*row.logistic)
                        : "",
         text(row.corrected),
         row.object_range ? interval_text(*row.object_range, row.smallest_px, row.largest_px) : "–",
         row.here.log2_px ? fmt::format("{:.0f} / {:.0f}", width_in_field_of_view_px(width_px, view_deg),
                                        pinhole_width_px(width_px, view_deg))
                          : "–"});
  }
  return html_table({{"artifact"},
                     {""},
                     {"isotonic"},
                     {"logistic"},
                     {"corrected for guessing"},
                     {"one object left out"},
                     {fmt::format("px for {:.3g}°, equirectangular / pinhole", view_deg)}},
                    lines);
}

std::string screened_html(const Analysis& analysis) {
  std::vector<Cells> lines;
  for (const ScreenedThresholds& result : analysis.screened)
    for (const ArtifactThresholds& thresholds : result.thresholds)
      for (const ArtifactScores& scores : analysis.data.artifacts) {
        if (scores.artifact != thresholds.artifact) continue;
        const auto text = [&](const WidthEstimate& estimate) {
          return estimate_text(estimate, scores.width_px.front(), scores.width_px.back());
        };
        const bool first = &thresholds == &result.thresholds.front();
        lines.push_back({first ? who_text(result, analysis) : "", std::string(word(thresholds.artifact)),
                         text(thresholds.estimates.perceptual),
                         text(thresholds.estimates.slightly_noticeable),
                         text(thresholds.estimates.inflection)});
      }
  return html_table({{"thresholds"}, {"artifact"}, {"PT"}, {"SN"}, {"IP"}}, lines);
}

}  // namespace

std::string checks_html(const Analysis& analysis, const std::vector<Figure>& figures) {
  std::string html = "<h2 id=\"checks\">Checks</h2>\n";
  if (analysis.guessing.curves.empty())
    html +=
        "<p>Thresholds are not estimated otherwise, nor corrected for guessing: there are no curves of "
        "mean noticeability.</p>\n";
  else
    html += "<p>The thresholds otherwise estimated: width W in px, 95 % interval in brackets.</p>\n" +
            beside_html(analysis) + html_paragraph(guessers_text(analysis.guessing)) +
            figure_html(figures, "corrected_for_guessing");
  html += html_paragraph(screening_sentence(analysis.screening));
  if (analysis.screened.size() > 1) html += screened_html(analysis);
  html += "<p class=\"soft\">Rules of the screens:";
  for (Screen screen : every_screen) html += " " + html_escape(std::string(rule_of(screen))) + ".";
  html += "</p>\n";
  if (!std::isnan(analysis.sos.a))
    html += fmt::format(
        "<p>Standard deviation of opinion scores (SOS): a = {:.3f} ({:.3f} to {:.3f}) over {} stimuli.</p>\n",
        analysis.sos.a, analysis.sos.ci95_low, analysis.sos.ci95_high, analysis.sos.stimuli);
  return html;
}

}  // namespace seamline
