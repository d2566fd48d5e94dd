#include "analysis/report_html.h"

#include <fmt/format.h>

#include "analysis/report_text.h"
#include "stimuli/support/assets.h"
#include "stimuli/support/html.h"

namespace seamline {

namespace {

std::string fact(const std::string& name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html_escape(value));
}

std::string participants_text(const ParticipantCounts& counts) {
  std::string text = fmt::format("{} used of {} in the log", counts.used, counts.in_log);
  if (counts.excluded > 0) text += fmt::format(", {} excluded", counts.excluded);
  if (counts.pilot > 0) text += fmt::format(", {} pilot left out", counts.pilot);
  if (counts.incomplete > 0) text += fmt::format(", {} did not finish", counts.incomplete);
  if (counts.screened > 0) text += fmt::format(", {} named by a screen", counts.screened);
  return text;
}

std::string header(const Analysis& analysis) {
  std::string html =
      fmt::format("<header>\n<h1>How much depth resolution: {}</h1>\n", html_escape(analysis.log.study_name));
  if (analysis.counts.simulated > 0)
    html += fmt::format("<div class=\"badge\">{}</div>\n", html_escape(source_text(analysis)));
  html += "<dl class=\"facts\">\n" +
          fact("study", analysis.log.study_name + ", hash " + analysis.log.study_hash) +
          fact("stimulus set", "hash " + analysis.log.set_hash) +
          fact("participants", participants_text(analysis.counts)) +
          fact("log", analysis.log.file.filename().string()) +
          fact("software", "Seamline " + program_version()) + "</dl>\n";
  if (!analysis.notes.empty()) {
    html += "<ul class=\"notes\">\n";
    for (const std::string& note : analysis.notes) html += "<li>" + html_escape(note) + "</li>\n";
    html += "</ul>\n";
  }
  return html + "</header>\n";
}

std::string thresholds_section(const Analysis& analysis) {
  std::string html = "<h2>Thresholds</h2>\n" + threshold_table_html(analysis);
  html +=
      "<p class=\"soft\">PT: perceptual threshold, mean noticeability 0.5. SN: slightly noticeable, 1.0. IP: "
      "inflection point. Width × "
      "height of the equirectangular depth map in px. “–” under paper: the paper gives no value. Above or "
      "below at every width: the curve "
      "does not cross the level within the widths tested.</p>\n";
  if (!analysis.planted.empty())
    html +=
        "<p>Planted values are PT, SN and IP of the expected answers that the simulated observers were "
        "given. They check the "
        "analysis; they are <strong>not</strong> Table 1’s values and say nothing about people.</p>\n";
  return html;
}

std::string figure_html(const Figure& figure) {
  return fmt::format("<figure role=\"img\" aria-label=\"{}\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
                     html_escape(figure.title), inline_svg(figure), html_escape(figure.caption));
}

std::string methods_section(const Analysis& analysis) {
  std::string html = "<h2>Method</h2>\n";
  for (const std::string& paragraph : method_paragraphs(analysis))
    html += "<p>" + html_escape(paragraph) + "</p>\n";
  return html +
         "<p class=\"soft\">The paper: “Visual Perception of Real World Depth Map Resolution for Mixed "
         "Reality Rendering”.</p>\n";
}

}  // namespace

std::string report_html(const Analysis& analysis, const std::vector<Figure>& figures,
                        const StimulusSamples& samples) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Seamline: "
      "{}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n",
      html_escape(analysis.log.study_name), report_style());
  html += header(analysis) + thresholds_section(analysis) + "<h2>Noticeability</h2>\n";
  for (const Figure& figure : figures) html += figure_html(figure);
  html += checks_html(analysis);
  html += "<h2>Stimuli</h2>\n" + samples_html(samples) + methods_section(analysis);
  html += "<h2>Participants</h2>\n" + participant_table_html(analysis);
  html +=
      "<h2>Data</h2>\n<p>Every number of this page is also beside it: <code>thresholds.json</code>, "
      "<code>thresholds.csv</code>, "
      "<code>curves.csv</code>, <code>cells.csv</code>, <code>participants.csv</code>, "
      "<code>answers.csv</code>, <code>thresholds_beside.csv</code>, <code>curves_corrected.csv</code>, "
      "<code>guessers.csv</code>, <code>screening.csv</code>, <code>thresholds_screened.csv</code>, "
      "<code>opinion_scores.csv</code>; "
      "<code>data_dictionary.csv</code> explains their columns. <code>figures</code> holds the figures as "
      "SVG and as gnuplot scripts.</p>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace seamline
