#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/task_words.h"
#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/scenes_text.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/angular_resolution.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

std::string planted_text(const ThresholdRow& row) {
  if (!row.planted_x) return "";
  return size_text({.level_x = row.planted_x, .reason = {}, .ci95 = {}}, row.tested.axis);
}

std::string texels_text(const ThresholdEstimate& estimate) {
  return estimate.level_x ? fmt::format("{:.3g}", texels_per_degree(std::exp2(*estimate.level_x))) : "–";
}

std::string threshold_line(const ThresholdRow& row, bool planted, bool beside) {
  const std::string paper = row.paper_px ? fmt::format("{} × {}", *row.paper_px, *row.paper_px / 2) : "–";
  std::string line =
      fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}</td>",
                  row.quantity == "PT" ? " class=\"group\"" : "",
                  row.quantity == "PT" ? html_escape(artifact_title(row.artifact, row.condition)) : "",
                  row.quantity, html_escape(size_text(row.here, row.tested.axis)),
                  html_escape(interval_text(row.here.ci95, row.tested)));
  if (of_depth_widths(row.tested.axis))
    line += fmt::format("<td class=\"number\">{}</td>", texels_text(row.here));
  if (beside) line += fmt::format("<td class=\"number\">{}</td>", paper);
  if (planted) line += fmt::format("<td class=\"number\">{}</td>", html_escape(planted_text(row)));
  return line + "</tr>\n";
}

/// Which columns the table of record has beside the joint model's.
struct ColumnsShown {
  bool planted = false, paper = false, papers_way = true;
};

/// A line of the table of record.
std::string headline_line(const HeadlineRow& row, bool first, const ColumnsShown& shown) {
  const bool widths = of_depth_widths(row.tested.axis);
  const auto cell = [](const std::string& text, bool number = true) {
    return fmt::format("<td{}>{}</td>", number ? " class=\"number\"" : "", html_escape(text));
  };
  std::string line = fmt::format("<tr{}><th scope=\"row\">{}</th>", first ? " class=\"group\"" : "",
                                 first ? html_escape(artifact_title(row.artifact, row.condition)) : "") +
                     cell(row.rule->name, false);
  if (row.here.level_x)
    line += cell(size_text(row.here, row.tested.axis)) +
            cell(interval_text(row.here.ci95, row.tested), false) +
            cell(interval_text(row.simultaneous, row.tested), false);
  else if (has_end(row.here.ci95))
    line += fmt::format("<td colspan=\"3\" class=\"verdict\">{}: {}</td>",
                        html_escape(interval_text(row.here.ci95, row.tested)),
                        html_escape(reason_text(row.here, row.tested.axis)));
  else
    line += fmt::format("<td colspan=\"3\" class=\"verdict\">{}</td>",
                        html_escape(reason_text(row.here, row.tested.axis)));
  if (widths) line += cell(texels_text(row.here));
  if (shown.papers_way)
    line += cell(row.paper_way ? (row.paper_way->level_x ? estimate_text(*row.paper_way, row.tested)
                                                         : reason_text(*row.paper_way, row.tested.axis))
                               : "–",
                 false);
  if (shown.paper)
    line += cell(row.paper_px ? fmt::format("{} × {}", *row.paper_px, *row.paper_px / 2) : "–");
  if (shown.planted) line += cell(row.planted ? size_text(*row.planted, row.tested.axis) : "");
  return line + "</tr>\n";
}

std::string headline_table(const Analysis& analysis) {
  const ColumnsShown shown{.planted = !analysis.planted.empty() || !planted_detection(analysis).empty(),
                           .paper = beside_the_paper(analysis),
                           .papers_way = asks_ratings(analysis.log)};
  const bool widths = of_depth_widths(analysis.data.axis);
  std::string table = fmt::format(
      "<div class=\"scroll\"><table class=\"tight\">\n<thead><tr><th>artifact</th><th></th><th "
      "class=\"number\">{}</th><th>95 "
      "% interval{}</th><th>simultaneous</th>{}{}{}{}</tr></thead>\n<tbody>\n",
      analysis.counts.simulated > 0 ? "simulated<br>observers" : "this study", widths ? "<br>of W" : "",
      widths ? "<th class=\"number\">texels per<br>degree</th>" : "",
      shown.papers_way ? "<th>paper’s way</th>" : "",
      shown.paper ? "<th class=\"number\">paper,<br>Table 1</th>" : "",
      shown.planted ? "<th class=\"number\">planted</th>" : "");
  const std::vector<HeadlineRow> rows = headline_rows(analysis);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool first =
        i == 0 || rows[i - 1].artifact != rows[i].artifact || rows[i - 1].condition != rows[i].condition;
    table += headline_line(rows[i], first, shown);
  }
  table += "</tbody></table></div>\n";
  if (!shown.papers_way)
    return table +
           html_paragraph(
               "This study’s numbers are of one joint model of seeing and guessing, fitted to all answers. "
               "Detection: half is seen, with chance taken out. Simultaneous: holds together with those of all "
               "curves.") +
           (shown.planted ? html_paragraph("Planted: where the simulated observers see half; they check the "
                                           "analysis and say nothing about people.")
                          : "") +
           html_paragraph(fixed_effects_text(analysis));
  return table +
         html_paragraph(
             "This study’s numbers are of one joint model of seeing, guessing and rating, fitted to all "
             "answers. "
             "PT: perceptual threshold, mean noticeability 0.5; SN: slightly noticeable, 1.0; corrected: the "
             "same "
             "without lucky guesses; IP: where noticeability is steepest; detection: half is seen. "
             "Simultaneous: "
             "holds together with those of all curves. Paper’s way: straight lines between the tested levels "
             "(PT, SN) and the centre of a logistic (IP), each with its own 95 % interval; for "
             "replications.") +
         html_paragraph(fixed_effects_text(analysis));
}

}  // namespace

std::string fixed_effects_text(const Analysis& analysis) {
  std::map<std::pair<Artifact, std::string>, std::set<std::string>> scenes;
  for (const ObjectCurve& object : analysis.data.objects)
    scenes[{object.artifact, object.condition}].insert(object.scene);
  const bool several =
      std::any_of(scenes.begin(), scenes.end(), [](const auto& one) { return one.second.size() > 1; });
  if (analysis.joint && !analysis.adaptive && has_random_scenes(analysis.data))
    return "Objects and scenes are fixed here: these intervals are over participants, and say nothing of other "
           "objects or scenes than those shown. Thresholds over scenes have intervals that do.";
  return std::string(
             "Objects and scenes are fixed: intervals are over participants, and say nothing of other "
             "objects or scenes than those shown.") +
         (several ? " Where an artifact was shown in several scenes, each participant’s objects weigh the "
                    "same, in "
                    "whichever scene they stand."
                  : "");
}

std::string scenes_html(const ReportNumbers& numbers) {
  if (numbers.over_scenes.empty()) return "";
  std::vector<HtmlColumn> columns;
  for (const std::string& title : scenes_titles(numbers.axis)) columns.push_back({title});
  std::string html =
      "<h2 id=\"scenes\">Thresholds over scenes</h2>\n" + html_table(columns, scenes_lines(numbers));
  for (const std::string& sentence : scenes_sentences(numbers)) html += html_paragraph(sentence);
  return html;
}

std::string threshold_table_html(const Analysis& analysis) {
  if (analysis.joint) return headline_table(analysis);
  const bool planted = !analysis.planted.empty(), beside = beside_the_paper(analysis);
  const bool widths = of_depth_widths(analysis.data.axis);
  std::string table = fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th>artifact</th><th></th><th "
      "class=\"number\">{}</th><th>95 % interval{}</th>{}{}{}</tr></thead>\n<tbody>\n",
      html_escape(analysis.counts.simulated > 0 ? "simulated observers" : "this study"),
      widths ? " of W" : "", widths ? "<th class=\"number\">texels per degree</th>" : "",
      beside ? "<th class=\"number\">paper,<br>Table 1</th>" : "",
      planted ? "<th class=\"number\">planted</th>" : "");
  for (const ThresholdRow& row : threshold_rows(analysis)) table += threshold_line(row, planted, beside);
  return table + "</tbody></table></div>\n";
}

}  // namespace seamline::analysis
