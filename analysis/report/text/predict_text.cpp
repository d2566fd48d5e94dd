#include "analysis/report/text/predict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/paper_values.h"
#include "support/files/markdown_table.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

CsvTable threshold_table(const Prediction& prediction) {
  const LevelAxis& axis = prediction.axis;
  const bool widths = of_depth_widths(axis), beside_paper = widths && prediction.task.asks_as_paper();
  CsvTable table{.name = "prediction",
                 .columns = {{"artifact", "", ""},
                             {"quantity", "", ""},
                             {widths ? "predicted" : level_key(axis), widths ? "px" : "", ""}},
                 .rows = {}};
  if (beside_paper) {
    table.columns.push_back({"paper", "px", ""});
    table.columns.push_back({"predicted / paper", "octaves", ""});
  }
  if (!prediction.depth_errors.empty()) table.columns.push_back({"depth there", "", ""});
  const auto add = [&](Artifact artifact, const char* quantity, const ThresholdEstimate& estimate,
                       std::optional<int> paper_px) {
    std::vector<CsvValue> row{std::string(artifact_title(artifact)), std::string(quantity)};
    const std::optional<double> level =
        estimate.level_x ? std::optional(level_at(axis, *estimate.level_x)) : std::nullopt;
    if (level)
      row.emplace_back(widths ? fmt::format("{:.0f}", *level) : estimated_text(axis, *level));
    else
      row.emplace_back(reason_text(estimate, axis));
    if (beside_paper) {
      row.emplace_back(paper_px ? CsvValue(std::int64_t{*paper_px}) : CsvValue());
      const bool both = level && paper_px;
      row.emplace_back(both ? CsvValue(fmt::format("{:+.2f}", *estimate.level_x - std::log2(*paper_px)))
                            : CsvValue());
    }
    const auto error =
        level ? depth_error_at(prediction.depth_errors, "", *level) : std::optional<DepthErrorRecord>();
    if (!prediction.depth_errors.empty())
      row.emplace_back(error ? CsvValue(depth_error_text(*error)) : CsvValue());
    table.rows.push_back(row);
  };
  for (const PredictedArtifact& predicted : prediction.artifacts) {
    const PaperThresholds paper = paper_thresholds(predicted.artifact).value_or(PaperThresholds{});
    if (!prediction.task.facts.rates) {
      add(predicted.artifact, "detection", predicted.thresholds.perceptual, std::nullopt);
      continue;
    }
    add(predicted.artifact, "PT", predicted.thresholds.perceptual, paper.perceptual_px);
    add(predicted.artifact, "SN", predicted.thresholds.slightly_noticeable, paper.slightly_noticeable_px);
    add(predicted.artifact, "IP", predicted.thresholds.inflection, paper.inflection_px);
  }
  return table;
}

CsvTable cell_table(const Prediction& prediction) {
  CsvTable table{.name = "cells", .columns = {{"artifact", "", ""}}, .rows = {}};
  for (const PredictedCell& cell : prediction.artifacts.front().cells)
    table.columns.push_back(
        {tested_text(prediction.axis, cell.level), std::string(facts(prediction.axis.quantity).unit), ""});
  for (const PredictedArtifact& predicted : prediction.artifacts) {
    std::vector<CsvValue> row{std::string(word(predicted.artifact))};
    for (const PredictedCell& cell : predicted.cells)
      row.emplace_back(fmt::format("{:.3f} → {:.2f}", cell.visible_difference, cell.expected_noticeability));
    row.resize(table.columns.size());
    table.rows.push_back(row);
  }
  return table;
}

/// The four artifacts of the paper by its Table 1: a dash of PT is above every width, a dash of SN below.
constexpr const char* paper_order = "overlap, occlusion, receiver, shadow";

std::string spread_mean(const LevelAxis& axis, double mean_x) {
  const double level = level_at(axis, mean_x);
  return of_depth_widths(axis) ? fmt::format("{:.0f} px", level) : estimated_text(axis, level);
}

/// What differs between scenes and between people, and what one scene says of others.
std::string spread_text(const Prediction& prediction) {
  if (prediction.spreads.empty())
    return "One scene an artifact: its threshold is that scene's. What another scene needs is not known from "
           "it.\n";
  std::string text;
  for (const SceneSpread& spread : prediction.spreads) {
    text += fmt::format("{} {}: {} of {} scenes within the {}s", artifact_title(spread.artifact),
                        spread.quantity, spread.with_value, spread.scenes, level_word(prediction.axis));
    if (spread.with_value > 1)
      text +=
          fmt::format(", mean {}, standard deviation between scenes {:.2f} {}",
                      spread_mean(prediction.axis, spread.mean_x),
                      std::abs(difference_at(prediction.axis, spread.sd_x)), length_unit(prediction.axis));
    text += ".\n";
  }
  return text + fmt::format(
                    "Between people {:.2f} {} are assumed. More people narrow one part, more scenes the "
                    "other.\n",
                    is_linear(prediction.axis) ? prediction.observer.people_sd_linear
                                               : prediction.observer.people_sd_octaves,
                    length_unit(prediction.axis));
}

/// On whose eyes the gain rests.
std::string gain_text(const Prediction& prediction) {
  switch (prediction.gain_source) {
    case GainSource::given:
      return "The gain was given with " + request_name("gain") + ".\n";
    case GainSource::study:
      return "The gain is the study's observer.image_gain.\n";
    case GainSource::paper:
      return "The gain was fixed so that the receiver's PT is the paper's: that number is no prediction.\n";
    case GainSource::detection:
      return "The gain rests on the eyes of ModelFest's 16 people, who looked for known patterns on a uniform "
             "field\n(`seamline observe` shows how well). People who search a picture" +
             std::string(prediction.task.facts.draws_right || prediction.task.facts.compares
                             ? ""
                             : " without its reference") +
             " see less:\nthe levels above are where a difference can be seen at all, not where a study "
             "finds it.\n";
  }
  return {};
}

std::string joined(const std::vector<Artifact>& artifacts) {
  std::string text;
  for (const Artifact artifact : artifacts) text += (text.empty() ? "" : ", ") + std::string(word(artifact));
  return text;
}

}  // namespace

std::string prediction_text(const Prediction& prediction) {
  std::string text = "Predicted from the pictures alone; nobody was asked.\n\n";
  if (!prediction.task.facts.rates) text += "Detection: half of the people see it, guesses taken out.\n\n";
  text += markdown_table(threshold_table(prediction)) + "\n";
  text += fmt::format("Visible difference → {}, mean over objects:\n\n",
                      prediction.task.facts.rates ? "expected noticeability (0 to 4)"
                                                  : "share of people who see it (0 to 1)");
  text += markdown_table(cell_table(prediction)) + "\n";
  text += fmt::format("Most to least demanding: {}{}.\n", joined(demanding_order(prediction.artifacts)),
                      of_depth_widths(prediction.axis) && prediction.task.asks_as_paper()
                          ? std::string("; in the paper: ") + paper_order
                          : "");
  for (const std::string& said : sentences(prediction.depth_errors)) text += said + "\n";
  text += fmt::format(
      "FLIP at {:g} pixels per degree, pooled with exponent {:g}; gain {:.6g} (seen half of the time: "
      "{:.4g}).\n",
      prediction.observer.pixels_per_degree, pooling_exponent, prediction.observer.image_gain.value(),
      1 / prediction.observer.image_gain.value());
  text += gain_text(prediction);
  text += spread_text(prediction);
  if (prediction.finest_is_floor)
    return text +
           fmt::format(
               "Floor: what the last level of each object still shows, at most {:.4g}, is taken for the grain "
               "of rendering.\nWhat is truly seen there is lost with it.\n",
               prediction.highest_floor);
  text += prediction.floor_known
              ? fmt::format("Floor: the difference of stimuli without a seam (none), at most {:.4g}.\n",
                            prediction.highest_floor)
              : "Floor: 0, because there are no stimuli without a seam (none) to measure it on.\n";
  if (!prediction.floor_known && prediction.gain_source == GainSource::detection)
    text += "Eyes of this gain see the grain of rendering as well: see " + request_name("finest_is_floor") +
            ".\n";
  return text;
}

}  // namespace seamline::analysis
