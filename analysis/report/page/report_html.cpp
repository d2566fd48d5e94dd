#include "analysis/report/page/report_html.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/log_analysis/task_words.h"
#include "analysis/log_analysis/threshold_rows.h"
#include "analysis/report/page/html_parts.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/page_style.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/text/replication_text.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "support/files/assets.h"
#include "support/text/html.h"

namespace seamline::analysis {

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
  if (counts.vision > 0) text += fmt::format(", {} without normal or corrected vision", counts.vision);
  return text;
}

std::string header(const Analysis& analysis) {
  std::string html =
      fmt::format("<header>\n<h1>{}: {}</h1>\n",
                  of_depth_widths(analysis.data.axis)
                      ? std::string("How much depth resolution")
                      : "Thresholds of " + std::string(facts(analysis.data.axis.quantity).name),
                  html_escape(analysis.log.study_name));
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

std::string paper_way_legend(const Analysis& analysis) {
  return "<p class=\"soft\">PT: perceptual threshold, mean noticeability 0.5. SN: slightly noticeable, 1.0. "
         "IP: "
         "inflection point. " +
         (of_depth_widths(analysis.data.axis)
              ? std::string("Width × height of the equirectangular depth map in px. ")
              : html_escape("Levels: " + axis_title(analysis.data.axis) + ". ")) +
         (beside_the_paper(analysis) ? "“–” under paper: the paper gives no value. " : "") +
         (of_depth_widths(analysis.data.axis)
              ? "Above or below it at every width: the curve does not cross the level within the widths tested."
              : "Above or below it at every level: mean noticeability is, and does not cross within the levels "
                "tested.") +
         "</p>\n";
}

std::string thresholds_section(const Analysis& analysis) {
  std::string html = "<h2 id=\"thresholds\">Thresholds</h2>\n" + threshold_table_html(analysis);
  if (!analysis.joint && asks_ratings(analysis.log)) html += paper_way_legend(analysis);
  if (!analysis.planted.empty())
    html +=
        "<p>Planted values are where the simulated observers’ expected mean noticeability truly crosses 0.5 "
        "(PT) "
        "and 1 (SN), and falls most steeply (IP), between the tested levels too. They check the analysis; "
        "they "
        "are <strong>not</strong> Table 1’s values and say nothing about people. " +
        html_escape(design_bias_text(analysis)) + "</p>\n";
  return html;
}

std::string noticeability_section(const Analysis& analysis, const std::vector<Figure>& figures) {
  std::string html = "<h2 id=\"noticeability\">" + task_words(analysis).title + "</h2>\n";
  if (analysis.adaptive)
    html += fmt::format(
        "<p>There is no curve of everybody’s mean noticeability: {0} were placed by the answers. The means "
        "of "
        "objects below are over different people at different {0}.</p>\n",
        level_words(analysis.data.axis).levels);
  return html + figure_html(figures, "fig7_averages") + figure_html(figures, "fig6_objects") +
         figure_html(figures, "participants");
}

std::string methods_section(const Analysis& analysis, const ReportNumbers& numbers,
                            const std::optional<LateReport>& late) {
  const MethodsText methods = methods_text(analysis, numbers, late ? late_method(*late) : "");
  std::string html =
      "<h2 id=\"methods\">Methods</h2>\n<p class=\"soft\">Text for a paper; also in "
      "<code>methods.txt</code>.</p>\n<div class=\"quote\">\n";
  for (const std::string& paragraph : methods.paragraphs) html += html_paragraph(paragraph);
  html += "<h3>References</h3>\n<ul class=\"plain\">\n";
  for (const std::string& reference : methods.references) html += "<li>" + html_escape(reference) + "</li>\n";
  return html + "</ul>\n</div>\n";
}

std::string people_mean_text(const PeopleMean& of, double scale, int digits) {
  const std::string mean = decimal_text(scale * of.mean, digits);
  if (!std::isfinite(of.low)) return mean;
  return fmt::format("{} [{}, {}]", mean, decimal_text(scale * of.low, digits),
                     decimal_text(scale * of.high, digits));
}

std::string looking_html(const std::vector<LookingRow>& rows) {
  if (rows.empty()) return "";
  std::vector<std::vector<std::string>> lines;
  lines.reserve(rows.size());
  for (const LookingRow& row : rows)
    lines.push_back({artifact_title(row.artifact, row.condition), fmt::format("{}", row.people),
                     fmt::format("{}", row.answers), people_mean_text(row.degrees_turned, 1, 0),
                     people_mean_text(row.share_seen, 100, 0),
                     row.first_look_s ? decimal_text(*row.first_look_s, 1) : "never",
                     people_mean_text(row.share_facing, 100, 0)});
  return "<h2 id=\"looking\">Where people looked</h2>\n" +
         html_paragraph(
             "How people looked round the panoramas, from each picture's onset to its rating. The view faces "
             "the inserted object while its middle is within 15 degrees to the object's left or right. Means "
             "are over participants, of their means over trials, with 95 % intervals by Student's t; the "
             "first look is the median over the trials that had one.") +
         html_table({{"artifact"},
                     {"participants", true},
                     {"trials", true},
                     {"turned, degrees a trial", true},
                     {"trials that faced it, %", true},
                     {"first look, s", true},
                     {"time facing it, %", true}},
                    lines);
}

std::string late_html(const std::optional<LateReport>& late, const LevelAxis& axis) {
  if (!late) return "";
  std::vector<std::vector<std::string>> curves, thresholds;
  for (const LateRow& row : late->rows)
    curves.push_back({artifact_title(row.artifact, row.condition), fmt::format("{}", row.answers),
                      fmt::format("{}", row.marked), fmt::format("{}", row.due), fmt::format("{}", row.late),
                      fmt::format("{}", row.dropped)});
  for (const LateThreshold& one : late->thresholds)
    thresholds.push_back({artifact_title(one.artifact, one.condition), one.quantity,
                          estimate_text(one.with, one.tested), estimate_text(one.without, one.tested)});
  std::string html = "<h2 id=\"late\">Frames that came late</h2>\n" + html_paragraph(late_sentence(*late)) +
                     html_table({{"artifact"},
                                 {"trials", true},
                                 {"marked", true},
                                 {"frames due", true},
                                 {"late", true},
                                 {"dropped", true}},
                                curves);
  if (!thresholds.empty())
    html += html_paragraph("Thresholds of record, as " + level_word(axis) +
                           ", with the marked trials and without them:") +
            html_table({{"artifact"}, {""}, {"with", true}, {"without", true}}, thresholds);
  return html;
}

constexpr const char* contents =
    "<nav><a href=\"#thresholds\">Thresholds</a> <a href=\"#model\">Model</a> <a "
    "href=\"#noticeability\">Noticeability</a> <a "
    "href=\"#psychometric\">Psychometric functions</a> <a href=\"#comparisons\">Comparisons</a> <a "
    "href=\"#checks\">Checks</a> <a href=\"#order\">Order</a> <a href=\"#times\">Response times</a> <a "
    "href=\"#participants\">Participants</a> <a href=\"#stimuli\">Stimuli</a> <a "
    "href=\"#methods\">Methods</a> <a href=\"#data\">Data</a></nav>\n";

constexpr const char* data_section =
    "<h2 id=\"data\">Data</h2>\n<p>Every number of this page is also beside it, as CSV files and as JSON: "
    "<code>report.json</code> holds all the tables, <code>thresholds.json</code> the thresholds and what "
    "they rest on; <code>data_dictionary.csv</code> explains every column and field. <code>figures</code> "
    "holds the figures as SVG, as PDF for a column of 85 mm, and as gnuplot scripts.</p>\n";

/// What thresholds differ by between conditions; empty where the study has one.
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

/// Published thresholds beside those of the study; empty where none were given.
std::string replication_html(const Analysis& analysis) {
  if (!analysis.replication) return "";
  std::vector<HtmlColumn> columns;
  for (const std::string& title : replication_titles(analysis)) columns.push_back({title});
  columns.back().sentence = true;
  std::string html = "<h2 id=\"published\">Published thresholds</h2>\n" +
                     html_paragraph("Beside " + analysis.replication->name +
                                    ". Differences are this study’s threshold less the published one.") +
                     html_table(columns, replication_lines(analysis));
  for (const std::string& sentence : replication_sentences(analysis)) html += html_paragraph(sentence);
  return html;
}

}  // namespace

std::string report_html(const Analysis& analysis, const ReportNumbers& numbers,
                        const std::vector<Figure>& figures, const StimulusSamples& samples,
                        const std::vector<LookingRow>& looking, const std::optional<LateReport>& late) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Seamline: "
      "{}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n",
      html_escape(analysis.log.study_name), page_style());
  std::string links = contents;
  if (!analysis.joint)
    links.erase(links.find(" <a href=\"#model\">"), std::string(" <a href=\"#model\">Model</a>").size());
  if (const std::string title = task_words(analysis).title; title != "Noticeability")
    links.replace(links.find(">Noticeability<"), std::string(">Noticeability<").size(), ">" + title + "<");
  html += header(analysis) + links + preregistration_html(analysis) + thresholds_section(analysis) +
          scenes_html(numbers) + replication_html(analysis) + differences_html(analysis) +
          looking_html(looking) + late_html(late, analysis.data.axis) + origins_html(analysis) +
          joint_model_html(analysis, figures) + noticeability_section(analysis, figures) +
          psychometric_html(analysis, numbers, figures) + comparisons_html(analysis, numbers) +
          checks_html(analysis, figures) + order_html(numbers, figures) + times_html(numbers, figures);
  html += "<h2 id=\"participants\">Participants</h2>\n" + participant_table_html(analysis, numbers);
  html += "<h2 id=\"stimuli\">Stimuli</h2>\n" + samples_html(samples, analysis.data.axis) +
          methods_section(analysis, numbers, late) + data_section;
  return html + "</body>\n</html>\n";
}

}  // namespace seamline::analysis
