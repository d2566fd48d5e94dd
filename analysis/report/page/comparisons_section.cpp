#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/page/html_parts.h"
#include "analysis/scores/level_words.h"
#include "support/text/counted.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string p_of(double p) {
  if (!std::isfinite(p)) return "–";
  return p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string range_text(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return "–";
  return decimal_text(low, 2) + " to " + decimal_text(high, 2);
}

std::string contrast_html(const ContrastTable& contrasts) {
  std::string html = "<h3>" + html_escape(contrasts.question) + "</h3>\n";
  Lines lines;
  for (const ContrastRow& row : contrasts.rows)
    lines.push_back({row.name, decimal_text(row.estimate, 2), range_text(row.ci95_low, row.ci95_high),
                     p_of(row.adjusted_p)});
  html += html_table({{.title = "contrast", .sentence = true},
                      {.title = "log odds", .number = true},
                      {.title = "95 % interval", .number = true},
                      {.title = "adjusted p", .number = true}},
                     lines);
  if (contrasts.joint_p && contrasts.joint_contrasts > 1)
    html += fmt::format("<p class=\"soft\">All {} independent contrasts together: {}.</p>\n",
                        contrasts.joint_contrasts, html_escape(p_text(*contrasts.joint_p)));
  return html;
}

std::string coefficients_html(const OrdinalStudy& study) {
  Lines lines;
  for (const CoefficientRow& row : study.coefficients)
    lines.push_back({row.name, decimal_text(row.estimate, 3), decimal_text(row.standard_error, 3),
                     range_text(row.ci95_low, row.ci95_high), p_of(row.p)});
  return std::string("<details><summary>Coefficients of the model</summary>\n") +
         "<p class=\"soft\">Each p and each interval here is of its coefficient alone: adjusted for "
         "nothing.</p>\n" +
         html_table({{"coefficient"},
                     {"estimate", true},
                     {"standard error", true},
                     {"95 % interval", true},
                     {"p", true}},
                    lines) +
         "</details>\n";
}

}  // namespace

std::string comparisons_html(const Analysis& analysis, const ReportNumbers& numbers) {
  std::string html = "<h2 id=\"comparisons\">Comparisons</h2>\n" + joint_contrasts_html(analysis, numbers);
  if (!numbers.comparisons) return html + html_paragraph(numbers.comparisons_missing);
  const OrdinalStudy& study = *numbers.comparisons;
  html += "<details><summary>An ordinal mixed model of the same scores</summary>\n";
  html += fmt::format(
      "<p>Noticeability (0 to 4): a {} and a slope over {} for each "
      "artifact{}, objects within artifacts, and a random level for each participant; {} of {}. "
      "Log odds are of a higher score: 0 is no difference, 0.7 doubles the odds. The model "
      "knows no "
      "guesses, so its slopes are too shallow where scores come near the guess floor: read thresholds and "
      "slopes "
      "above.</p>\n",
      of_depth_widths(numbers.axis) ? "level" : "mean", level_words(numbers.axis).axis,
      numbers.conditions ? " in each condition" : "", counted(study.fit.observations, "answer"),
      counted(study.fit.participants, "participant"));
  for (const std::string& note : study.notes) html += html_paragraph(note);
  if (!has_estimates(study.fit.verdict))
    return html + html_paragraph("No comparison is made: " + std::string(word(study.fit.verdict)) + ".") +
           "</details>\n";
  for (const ContrastTable& contrasts : study.contrasts) html += contrast_html(contrasts);
  return html +
         "<p class=\"soft\">p and intervals of these tables are adjusted for all contrasts of a question; "
         "standard "
         "errors are over participants.</p>\n" +
         coefficients_html(study) + "</details>\n";
}

}  // namespace seamline::analysis
