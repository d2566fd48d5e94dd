#include "analysis/report/matching/match_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "analysis/report/json/json_values.h"
#include "analysis/report/matching/match_figure.h"
#include "analysis/report/page/html_parts.h"
#include "analysis/report/page/page_style.h"
#include "analysis/scores/level_axis.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/text/counted.h"
#include "support/text/html.h"

namespace seamline::analysis {
namespace {

using Json = nlohmann::ordered_json;

LevelAxis axis_of(const MatchAnalysis& analysis) {
  return level_axis(analysis.log);
}

std::string curve_name(Artifact artifact, const std::string& condition) {
  return std::string(word(artifact)) + (condition.empty() ? "" : ", " + condition);
}

std::string level_of_mean(const MatchAnalysis& analysis, std::optional<double> along) {
  return along ? estimated_text(axis_of(analysis), level_along(analysis.log.quantity, *along)) : "–";
}

std::string interval_of_mean(const MatchAnalysis& analysis, const MatchMean& mean) {
  if (!mean.low) return "–";
  return level_of_mean(analysis, mean.low) + " to " + level_of_mean(analysis, mean.high);
}

std::string length_or_dash(std::optional<double> length) {
  constexpr int digits = 2;
  return length ? decimal_text(*length, digits) : "–";
}

std::string effect_with_interval(const std::optional<MatchMean>& effect) {
  if (!effect) return "–";
  if (!effect->low) return length_or_dash(effect->mean);
  return length_or_dash(effect->mean) + " (" + length_or_dash(effect->low) + " to " +
         length_or_dash(effect->high) + ")";
}

CsvValue level_cell(const MatchAnalysis& analysis, std::optional<double> along) {
  return along ? CsvValue(level_along(analysis.log.quantity, *along)) : CsvValue();
}

CsvValue length_cell(std::optional<double> length) {
  return length ? CsvValue(*length) : CsvValue();
}

CsvTable thresholds_of_matches(const MatchAnalysis& analysis) {
  const LevelAxis axis = axis_of(analysis);
  const std::string unit(facts(axis.quantity).unit), suffix = unit_suffix(axis);
  const std::string length = length_unit(axis), key = "_" + length_key(axis);
  CsvTable table{
      .name = "thresholds",
      .columns = {{"artifact", "word", "receiver, shadow, occlusion or overlap (types 1 to 4 of the paper)"},
                  {"condition", "word", "of the study file; empty where it has one"},
                  {"threshold" + suffix, unit, "mean over participants of their mean matched level"},
                  {"low" + suffix, unit, "lower end of its 95 % interval over participants"},
                  {"high" + suffix, unit, "upper end"},
                  {"participants", "count", "used"},
                  {"matches", "count", "of them all"},
                  {"at_end", "count", "matches that stopped at the first or the last level"},
                  {"between_sd" + key, length, "standard deviation of the participants' means"},
                  {"within_sd" + key, length,
                   "standard deviation of single matches of a participant, pooled"},
                  {"start_effect" + key, length,
                   "mean of matches that began clear less that of those that began faint"},
                  {"start_effect_low" + key, length, "lower end of its 95 % interval over participants"},
                  {"start_effect_high" + key, length, "upper end"},
                  {"planted" + suffix, unit, "where simulated observers see half; empty of people"}},
      .rows = {}};
  for (const CurveMatches& c : analysis.curves) {
    const MatchMean effect = c.start_effect.value_or(MatchMean{});
    table.rows.push_back({std::string(word(c.artifact)), c.condition, level_cell(analysis, c.threshold.mean),
                          level_cell(analysis, c.threshold.low), level_cell(analysis, c.threshold.high),
                          std::int64_t{c.people}, std::int64_t{c.matches}, std::int64_t{c.at_end},
                          length_cell(c.between_sd), length_cell(c.within_sd),
                          c.start_effect ? CsvValue(effect.mean) : CsvValue(), length_cell(effect.low),
                          length_cell(effect.high), length_cell(c.planted)});
  }
  return table;
}

CsvTable table_of_persons(const MatchAnalysis& analysis) {
  const LevelAxis axis = axis_of(analysis);
  const std::string unit(facts(axis.quantity).unit), suffix = unit_suffix(axis);
  const std::string length = length_unit(axis), key = "_" + length_key(axis);
  CsvTable table{.name = "thresholds_people",
                 .columns = {{"participant", "text", "code"},
                             {"artifact", "word", "as in thresholds.csv"},
                             {"condition", "word", "of the study file; empty where it has one"},
                             {"matched" + suffix, unit, "mean matched level"},
                             {"sd" + key, length, "standard deviation of single matches; empty of one"},
                             {"matches", "count", "of this participant in this curve"},
                             {"at_end", "count", "of them that stopped at the first or the last level"},
                             {"start_effect" + key, length,
                              "mean of matches that began clear less that of those that began faint"}},
                 .rows = {}};
  for (const PersonMatches& p : analysis.of_people)
    table.rows.push_back({p.participant, std::string(word(p.artifact)), p.condition,
                          level_cell(analysis, p.mean), length_cell(p.sd), std::int64_t{p.matches},
                          std::int64_t{p.at_end}, length_cell(p.start_effect)});
  return table;
}

Json mean_json(const MatchMean& mean, const std::function<Json(std::optional<double>)>& number) {
  return {{"estimate", number(mean.mean)}, {"ci95", {number(mean.low), number(mean.high)}}};
}

std::string threshold_lines_html(const MatchAnalysis& analysis) {
  const LevelAxis axis = axis_of(analysis);
  std::vector<std::vector<std::string>> lines;
  bool planted = false;
  for (const CurveMatches& c : analysis.curves) planted = planted || c.planted;
  for (const CurveMatches& c : analysis.curves) {
    lines.push_back({curve_name(c.artifact, c.condition), level_of_mean(analysis, c.threshold.mean),
                     interval_of_mean(analysis, c.threshold), std::to_string(c.people),
                     std::to_string(c.matches), std::to_string(c.at_end), length_or_dash(c.between_sd),
                     length_or_dash(c.within_sd), effect_with_interval(c.start_effect)});
    if (planted) lines.back().push_back(c.planted ? estimated_text(axis, *c.planted) : "–");
  }
  std::vector<HtmlColumn> columns = {{"curve"},
                                     {"just seen", true},
                                     {"95 % interval", true},
                                     {"people", true},
                                     {"matches", true},
                                     {"at an end", true},
                                     {"SD of people", true},
                                     {"SD of a match", true},
                                     {"start effect", true}};
  if (planted) columns.push_back({"planted", true});
  return html_table(columns, lines, "tight");
}

std::string person_lines_html(const MatchAnalysis& analysis) {
  std::vector<std::vector<std::string>> lines;
  for (const PersonMatches& p : analysis.of_people)
    lines.push_back({p.participant, curve_name(p.artifact, p.condition), level_of_mean(analysis, p.mean),
                     length_or_dash(p.sd), std::to_string(p.matches), std::to_string(p.at_end),
                     length_or_dash(p.start_effect)});
  return html_table({{"participant"},
                     {"curve"},
                     {"just seen", true},
                     {"SD of a match", true},
                     {"matches", true},
                     {"at an end", true},
                     {"start effect", true}},
                    lines);
}

std::string who_answered(const MatchAnalysis& analysis) {
  const ParticipantCounts counts = count_participants(analysis.people);
  std::string text = fmt::format("{} used of {} in the log", counts.used, counts.in_log);
  if (counts.simulated > 0) text += fmt::format(", {} of them simulated observers", counts.simulated);
  if (counts.excluded > 0) text += fmt::format(", {} excluded", counts.excluded);
  if (counts.pilot > 0) text += fmt::format(", {} pilot left out", counts.pilot);
  if (counts.incomplete > 0) text += fmt::format(", {} did not finish", counts.incomplete);
  if (counts.vision > 0) text += fmt::format(", {} without normal or corrected vision", counts.vision);
  return text;
}

std::string match_page(const MatchAnalysis& analysis, const std::vector<Figure>& figures) {
  const study::LogContents& log = analysis.log;
  const auto fact = [](const std::string& name, const std::string& value) {
    return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html_escape(value));
  };
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Seamline: {}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n<header>\n<h1>Where the seam is just seen: {}</h1>\n",
      html_escape(log.study_name), page_style(), html_escape(log.study_name));
  const ParticipantCounts counts = count_participants(analysis.people);
  if (counts.simulated > 0)
    html += fmt::format("<div class=\"badge\">{}</div>\n", counted(counts.simulated, "simulated observer"));
  html += "<dl class=\"facts\">\n" + fact("study", log.study_name + ", hash " + log.study_hash) +
          fact("stimulus set", "hash " + log.set_hash) + fact("participants", who_answered(analysis)) +
          fact("levels", axis_title(axis_of(analysis))) + fact("log", log.file.filename().string()) +
          fact("software", "Seamline " + program_version()) + "</dl>\n";
  if (!analysis.notes.empty()) {
    html += "<ul class=\"notes\">\n";
    for (const std::string& note : analysis.notes) html += "<li>" + html_escape(note) + "</li>\n";
    html += "</ul>\n";
  }
  html += "</header>\n<h2 id=\"thresholds\">Matched levels</h2>\n" + threshold_lines_html(analysis) +
          html_paragraph("Standard deviations (SD) and the start effect are in " +
                         length_unit(axis_of(analysis)) +
                         ". A start effect over 0 says that matches which began with a clear seam ended "
                         "at larger levels than those which began with a faint one.") +
          figure_html(figures, "matches") + "<h2 id=\"participants\">Each participant</h2>\n" +
          person_lines_html(analysis) + "<h2 id=\"methods\">Methods</h2>\n<div class=\"quote\">\n" +
          html_paragraph(match_methods(analysis)) + "</div>\n<h2 id=\"data\">Data</h2>\n" +
          "<p>Every number of this page is beside it: <code>thresholds.json</code>, "
          "<code>thresholds.csv</code>, <code>thresholds_people.csv</code>, and every single match in "
          "<code>matches.csv</code>; <code>data_dictionary.csv</code> explains the columns.</p>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace

std::string match_text(const MatchAnalysis& analysis) {
  const std::string length = length_unit(axis_of(analysis));
  std::string text = fmt::format("{} at which the seam is just seen (means over participants)\n",
                                 axis_title(axis_of(analysis)));
  for (const CurveMatches& c : analysis.curves)
    text += fmt::format(
        "{:<20} {:>10}  95 % interval {}; {}, {} ({} at an end); SD of people {}, of a "
        "match {} {}{}\n",
        curve_name(c.artifact, c.condition), level_of_mean(analysis, c.threshold.mean),
        interval_of_mean(analysis, c.threshold), counted(c.people, "participant"),
        counted(c.matches, "match", "matches"), c.at_end, length_or_dash(c.between_sd),
        length_or_dash(c.within_sd), length,
        c.planted ? "; planted " + estimated_text(axis_of(analysis), *c.planted) : "");
  return text;
}

std::vector<CsvTable> match_tables(const MatchAnalysis& analysis) {
  std::vector<CsvTable> tables = {thresholds_of_matches(analysis), table_of_persons(analysis)};
  if (std::optional<CsvTable> matches = study::match_table(analysis.log))
    tables.push_back(*std::move(matches));
  return tables;
}

std::string matches_json(const MatchAnalysis& analysis) {
  const std::string key = "_" + length_key(axis_of(analysis));
  const auto level = [&](std::optional<double> along) {
    return json_number(along ? std::optional(level_along(analysis.log.quantity, *along)) : std::nullopt);
  };
  const auto length = [](std::optional<double> value) { return json_number(value); };
  Json thresholds = Json::array();
  for (const CurveMatches& c : analysis.curves) {
    Json curve = {{"artifact", word(c.artifact)}};
    if (!c.condition.empty()) curve["condition"] = c.condition;
    curve["just_seen"] = mean_json(c.threshold, level);
    curve["participants"] = c.people;
    curve["matches"] = c.matches;
    curve["matches_at_end"] = c.at_end;
    curve["between_sd" + key] = length(c.between_sd);
    curve["within_sd" + key] = length(c.within_sd);
    curve["start_effect" + key] = c.start_effect ? mean_json(*c.start_effect, length) : Json(nullptr);
    curve["planted"] = json_number(c.planted);
    thresholds.push_back(std::move(curve));
  }
  const ParticipantCounts counts = count_participants(analysis.people);
  Json json = {
      {"study_name", analysis.log.study_name},
      {"study_hash", analysis.log.study_hash},
      {"set_hash", analysis.log.set_hash},
      {"software", "Seamline " + program_version()},
      {"task", "match"},
      {"level", facts(analysis.log.quantity).name},
      {"participants", {{"used", counts.used}, {"in_log", counts.in_log}, {"simulated", counts.simulated}}},
      {"notes", analysis.notes},
      {"thresholds", std::move(thresholds)}};
  return json.dump(1) + "\n";
}

std::string match_methods(const MatchAnalysis& analysis) {
  const LevelAxis axis = axis_of(analysis);
  const ParticipantCounts counts = count_participants(analysis.people);
  return fmt::format(
      "Thresholds were measured by adjustment. Participants moved the {} among the rendered levels until the "
      "seam was just seen. Trials began at a random level: half of them where more is seen, half where less is, "
      "balanced within objects, over objects and over participants. {} made {}. A participant's "
      "threshold is the mean of the matched levels{}; the threshold is the mean over participants, with a 95 % "
      "interval of Student's t over participants. No interval was bootstrapped.",
      facts(axis.quantity).name,
      counted(counts.used, counts.simulated == counts.used ? "simulated observer" : "participant"),
      counted(analysis.matches.size(), "match", "matches"), is_linear(axis) ? "" : " on their log2");
}

std::filesystem::path write_match_report(const MatchAnalysis& analysis, const std::filesystem::path& folder) {
  prepare_output_folder(folder);
  prepare_output_folder(folder / "figures");
  const std::vector<Figure> figures = {draw_matches(analysis, folder / "figures")};
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file_atomically(folder / name, text, Readers::owner);  // it is what people answered
  };
  const std::vector<CsvTable> tables = match_tables(analysis);
  for (const CsvTable& table : tables) write(table.name + ".csv", csv_text(table));
  write("data_dictionary.csv", csv_text(data_dictionary(tables)));
  write("thresholds.json", matches_json(analysis));
  write("methods.txt", match_methods(analysis) + "\n");
  write("report.html", match_page(analysis, figures));
  return folder / "report.html";
}

}  // namespace seamline::analysis
