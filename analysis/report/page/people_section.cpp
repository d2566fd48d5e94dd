#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/log_analysis/participant_facts.h"
#include "analysis/report/page/html_parts.h"

namespace seamline::analysis {

namespace {

/// Tenths, and two digits of what is shorter.
std::string short_text(double seconds) {
  return std::abs(seconds) < 0.1 ? fmt::format("{:.2g}", seconds) : fmt::format("{:.1f}", seconds);
}

std::string quartiles_text(const Quartiles& times) {
  if (!std::isfinite(times.median_s)) return "–";
  return fmt::format("{} ({} to {})", short_text(times.median_s), short_text(times.lower_s),
                     short_text(times.upper_s));
}

/// "1920 × 1080 px, 600 mm, 38.2 px a degree".
std::string display_text(const std::optional<study::ShownOn>& display) {
  if (!display) return "–";
  std::string text = fmt::format("{} × {} px", display->mode_width_px, display->mode_height_px);
  if (display->viewing_distance_mm > 0) text += fmt::format(", {:.0f} mm", display->viewing_distance_mm);
  if (display->pixels_per_degree > 0) text += fmt::format(", {:.1f} px a degree", display->pixels_per_degree);
  return text;
}

}  // namespace

std::string times_html(const ReportNumbers& numbers, const std::vector<Figure>& figures) {
  std::string html = "<h2 id=\"times\">Response times</h2>\n";
  if (!numbers.times.missing.empty()) return html + html_paragraph(numbers.times.missing);
  std::vector<std::vector<std::string>> lines;
  for (const ResponseTime& row : numbers.times.rows)
    if (!row.artifact)
      lines.push_back({row.which == TimedAnswers::all ? tested_text(numbers.axis, row.level) : "",
                       std::string(word(row.which)), std::to_string(row.answers), std::to_string(row.people),
                       quartiles_text(row.choice), quartiles_text(row.rating)});
  return html + figure_html(figures, "response_times") +
         html_table({{of_depth_widths(numbers.axis) ? std::string("W, px") : axis_title(numbers.axis)},
                     {"choices"},
                     {"answers", true},
                     {"participants", true},
                     {"to the choice, s", true},
                     {"from choice to rating, s", true}},
                    lines) +
         "<p class=\"soft\">Median over answers, quartiles in brackets; nothing is cut off. Each artifact’s "
         "times are in <code>response_times.csv</code>.</p>\n";
}

std::string participant_table_html(const Analysis& analysis, const ReportNumbers& numbers) {
  std::string described;
  for (const std::string& sentence : participants_described(analysis))
    described += (described.empty() ? "" : " ") + sentence;
  const bool displays = std::any_of(numbers.participants.begin(), numbers.participants.end(),
                                    [](const ParticipantRow& row) { return row.display.has_value(); });
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
    for (const std::string& answer : row.form) lines.back().push_back(answer.empty() ? "–" : answer);
    if (displays) lines.back().push_back(display_text(row.display));
  }
  std::vector<HtmlColumn> columns = {{"participant"},
                                     {"kind"},
                                     {"use"},
                                     {"trials", true},
                                     {"right choices", true},
                                     {"mean rating", true},
                                     {"named by screens"},
                                     {"median time to choose", true}};
  for (std::string question : numbers.questions) {
    std::replace(question.begin(), question.end(), '_', ' ');
    columns.push_back({question});
  }
  if (displays) columns.push_back({"screen"});
  return (described.empty() ? "" : html_paragraph("Of those used. " + described)) +
         html_table(columns, lines) +
         "<p class=\"soft\">Chance is 33 % right. The mean rating is over all answers, right or wrong. "
         "Simulated observers take no time.</p>\n";
}

}  // namespace seamline::analysis
