#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/joint_text.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string group_html(const GroupComparison& groups, const std::string& unit) {
  std::string counts;
  for (std::size_t g = 0; g < groups.groups.size(); ++g)
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", groups.people[g], groups.groups[g]);
  if (groups.silent > 0) counts += fmt::format("; {} did not say", groups.silent);
  std::string html;
  if (!groups.verdict.empty())
    html = "<h3>" + html_escape(groups.field) + "</h3>\n" + html_paragraph(groups.verdict);
  else
    html = contrast_table_html(groups.shifts, unit);
  if (!counts.empty()) html += html_paragraph("Participants: " + counts + ".");
  for (const std::string& note : groups.notes) html += html_paragraph(note);
  return html;
}

}  // namespace

std::string contrast_table_html(const ContrastTable& contrasts, const std::string& unit) {
  Lines lines;
  for (const ContrastRow& row : contrasts.rows)
    lines.push_back({as_sentence(row.conclusion), decimal_text(row.estimate, 2),
                     std::isfinite(row.ci95_low) && std::isfinite(row.ci95_high)
                         ? decimal_text(row.ci95_low, 2) + " to " + decimal_text(row.ci95_high, 2)
                         : "–"});
  return "<h3>" + html_escape(contrasts.question) + "</h3>\n" +
         html_table({{.title = "finding", .sentence = true},
                     {.title = unit, .number = true},
                     {.title = "95 % interval", .number = true}},
                    lines);
}

std::string joint_model_html(const Analysis& analysis, const std::vector<Figure>& figures) {
  if (!analysis.joint) return "";
  std::string html = "<h2 id=\"model\">The joint model and its checks</h2>\n";
  const JointAnalysis& joint = *analysis.joint;
  if (!joint.fit.estimated()) return html + html_paragraph(joint.fit.explanation);
  html += figure_html(figures, "joint_curves") + figure_html(figures, "joint_scores");
  for (const std::string& sentence : joint_check_sentences(analysis)) html += html_paragraph(sentence);
  Lines lines;
  for (const SharingTest& test : joint.sharing)
    lines.push_back({test.shared, std::to_string(test.parameters), decimal_text(test.statistic, 2),
                     std::isfinite(test.p) ? p_text(test.p) : test.note});
  if (!lines.empty())
    html += html_table({{"shared by all curves"}, {"parameters", true}, {"F", true}, {"against one a curve"}},
                       lines);
  if (analysis.adaptive) return html;
  return html +
         "<p class=\"soft\">Cells are in <code>joint_cells.csv</code>, every participant’s thresholds in "
         "<code>thresholds_people.csv</code>, the model’s parameters in "
         "<code>joint_parameters.csv</code>.</p>\n";
}

std::string joint_contrasts_html(const Analysis& analysis, const ReportNumbers& numbers) {
  if (!analysis.joint || analysis.adaptive) return "";
  const JointContrasts& contrasts = analysis.joint->contrasts;
  if (contrasts.tables.empty() && contrasts.notes.empty() && numbers.groups.empty())
    return html_paragraph("The joint model has one curve, and nothing to compare it with.");
  const std::string unit = length_unit(analysis.data.axis);
  std::string html = fmt::format(
      "<p>Thresholds and slopes of the joint model. Thresholds differ by {}{}; slopes by a log ratio, 0.7 "
      "being "
      "twice as steep. Verdicts and intervals are adjusted for all contrasts of a question. “Not shown” is "
      "not the "
      "same as “no difference”.</p>\n",
      html_escape(unit), is_linear(analysis.data.axis) ? "" : " (1: twice the level)");
  for (const std::string& note : contrasts.notes) html += html_paragraph(note);
  for (const ContrastTable& table : contrasts.tables)
    html +=
        contrast_table_html(table, table.question.find("lopes") != std::string::npos ? "log ratio" : unit);
  for (const GroupComparison& groups : numbers.groups) html += group_html(groups, unit);
  return html;
}

}  // namespace seamline::analysis
