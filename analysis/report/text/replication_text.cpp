#include "analysis/report/text/replication_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {
namespace {

std::string published_text(const LevelAxis& axis, const PublishedThreshold& published) {
  if (!published.level) return "–";
  std::string text = estimated_text(axis, *published.level);
  if (published.low)
    text += fmt::format(" ({} to {})", estimated_text(axis, *published.low),
                        estimated_text(axis, *published.high));
  return text;
}

std::string difference_text(const ReplicatedThreshold& row) {
  if (!row.difference) return "–";
  return fmt::format("{:+.2f} ({} to {})", *row.difference,
                     row.low95 ? fmt::format("{:+.2f}", *row.low95) : "open",
                     row.high95 ? fmt::format("{:+.2f}", *row.high95) : "open");
}

std::string here_text(const LevelAxis& axis, const ReplicatedThreshold& row) {
  if (row.verdict == ReplicationVerdict::not_tested) return "–";
  if (!row.here.level_x) return reason_text(row.here, axis);
  const LevelRange ci95 = range_at(axis, row.here.ci95);
  return fmt::format("{} ({} to {})", estimated_text(axis, level_at(axis, *row.here.level_x)),
                     estimated_text(axis, ci95.low), estimated_text(axis, ci95.high));
}

std::string share_text(double share) {
  if (share < 0.005) return "in less than 0.5 %";
  if (share > 0.995) return "in more than 99.5 %";
  return fmt::format("in {:.0f} %", 100 * share);
}

std::string order_sentence(const ReplicatedOrder& order) {
  const std::string of = order.quantity + in_condition(order.condition);
  std::string text = fmt::format("{}: the published order is {}. ", of, fmt::join(order.artifacts, " < "));
  text += order.found == order.artifacts
              ? "The order here is the same."
              : fmt::format("The order here is {}.", fmt::join(order.found, " < "));
  return text + fmt::format(" People drawn anew from those of this study have the published order {}.",
                            share_text(order.probability));
}

}  // namespace

std::vector<std::string> replication_titles(const Analysis& analysis) {
  const std::string unit = length_unit(analysis.data.axis);
  return {"artifact",        "threshold", "published", "here (95 %)", "difference, " + unit + " (95 %)",
          "published value", "verdict"};
}

std::vector<std::vector<std::string>> replication_lines(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines;
  const LevelAxis& axis = analysis.data.axis;
  for (const ReplicatedThreshold& row : analysis.replication->thresholds)
    lines.push_back({std::string(word(row.published.artifact)) + in_condition(row.published.condition),
                     row.published.quantity, published_text(axis, row.published), here_text(axis, row),
                     difference_text(row),
                     !row.difference ? "–"
                     : row.inside    ? "inside the interval"
                                     : "outside the interval",
                     std::string(word(row.verdict))});
  return lines;
}

std::vector<std::string> replication_sentences(const Analysis& analysis) {
  const Replication& found = *analysis.replication;
  const LevelAxis& axis = analysis.data.axis;
  using enum ReplicationVerdict;
  const int compared = found.count(agrees) + found.count(differs) + found.count(undecided);
  std::vector<std::string> sentences = {fmt::format(
      "Of {} published thresholds that could be compared, {} agree within {:g} {}, {} differ, and {} are "
      "undecided.",
      compared, found.count(agrees), found.margin, length_unit(axis), found.count(differs),
      found.count(undecided))};
  const int silent = found.count(no_estimate) + found.count(not_reported) + found.count(not_tested);
  if (silent > 0)
    sentences.push_back(fmt::format(
        "{} could not be compared: {} without a published number, {} without a number here, {} not tested here.",
        silent, found.count(not_reported), found.count(no_estimate), found.count(not_tested)));
  for (const ReplicatedOrder& order : found.orders) sentences.push_back(order_sentence(order));
  return sentences;
}

std::string replication_method(const Analysis& analysis) {
  if (!analysis.replication) return {};
  const Replication& found = *analysis.replication;
  return fmt::format(
      "Thresholds were compared with those of {}{}. A threshold agrees where the 90 % interval of its difference from "
      "the published one lies within {:g} {} (two one-sided tests at 5 % each); it differs where the 95 % interval "
      "excludes zero and it does not agree; else it is undecided. Intervals of differences join those of both studies "
      "(MOVER); a published value without an interval was taken as exact. The comparison is not adjusted for "
      "the number of thresholds. Orders were computed for participants drawn with replacement from their jackknife "
      "pseudo-values.",
      found.name, found.sha256.empty() ? "" : " (SHA-256 " + found.sha256.substr(0, 12) + ")", found.margin,
      length_unit(analysis.data.axis));
}

std::string replication_text(const Analysis& analysis) {
  if (!analysis.replication) return {};
  std::vector<std::vector<std::string>> lines = {replication_titles(analysis)};
  for (std::vector<std::string>& line : replication_lines(analysis)) lines.push_back(std::move(line));
  std::string text = "Beside " + analysis.replication->name + ":\n" + aligned(lines);
  for (const std::string& sentence : replication_sentences(analysis)) text += sentence + "\n";
  return text + "\n";
}

}  // namespace seamline::analysis
