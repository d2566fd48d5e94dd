#include "sets/set_seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "stimuli/pictures/set_seams.h"
#include "stimuli/set/set_study.h"
#include "support/running/progress.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

std::vector<SeamMeasure> measure_with_progress(const std::filesystem::path& set_folder,
                                               const Manifest& manifest) {
  Progress progress("seams of " + manifest.study_name, manifest.stimuli.size());
  int told = 0;
  return measure_seams(set_folder, manifest, 0, [&](int finished) {
    if (finished == told) return;
    progress.advance(finished - told, fmt::format("{} of {} stimuli", finished, manifest.stimuli.size()));
    told = finished;
  });
}

/// Where artifacts and conditions stand in a study file, which is where their stimuli stand in the manifest.
template <class Key>
std::size_t place_in(std::vector<Key>& known, const Key& key) {
  const auto found = std::find(known.begin(), known.end(), key);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  known.push_back(key);
  return known.size() - 1;
}

std::vector<SeamCell> cells_of(const std::vector<SeamRow>& rows) {
  std::map<std::tuple<std::size_t, std::size_t, double>, std::pair<SeamCell, int>> sums;
  std::vector<Artifact> artifacts;
  std::vector<std::string> conditions;
  for (const SeamRow& row : rows) {
    const Stimulus& stimulus = row.stimulus;
    auto& [cell, count] = sums[{place_in(artifacts, stimulus.artifact),
                                place_in(conditions, stimulus.condition), stimulus.level}];
    cell.artifact = stimulus.artifact;
    cell.condition = stimulus.condition;
    cell.level = stimulus.level;
    for (std::size_t i = 0; i < seam_steps.size(); ++i) {
      cell.area_px[i] += row.seam.beyond[i].area_px;
      cell.widest_band_px[i] += row.seam.beyond[i].widest_band_px;
    }
    ++count;
  }
  std::vector<SeamCell> cells;
  for (auto& [key, sum] : sums) {
    auto& [cell, count] = sum;
    for (double& value : cell.area_px) value /= count;
    for (double& value : cell.widest_band_px) value /= count;
    cells.push_back(std::move(cell));
  }
  return cells;
}

CsvValue level_value(Quantity quantity, double level) {
  return facts(quantity).whole ? CsvValue(static_cast<std::int64_t>(level)) : CsvValue(level);
}

}  // namespace

SetSeams read_set_seams(const std::filesystem::path& set_folder) {
  const Manifest manifest = read_manifest(set_folder);
  const StudyDefinition study = study_of_set(set_folder, manifest);
  if (manifest.stimuli.empty())
    throw input_error({.file = (set_folder / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "at least one stimulus",
                       .found = "none"});
  const std::vector<SeamMeasure> measures = measure_with_progress(set_folder, manifest);
  SetSeams seams{.study_name = manifest.study_name,
                 .width_px = manifest.width_px,
                 .height_px = manifest.height_px,
                 .pixels_per_degree = study.observer.pixels_per_degree,
                 .quantity = level_quantity(manifest),
                 .several_conditions = study.conditions.size() > 1,
                 .rows = {},
                 .cells = {}};
  for (std::size_t i = 0; i < measures.size(); ++i)
    seams.rows.push_back({manifest.stimuli[i].id, manifest.stimuli[i].stimulus, measures[i]});
  seams.cells = cells_of(seams.rows);
  return seams;
}

CsvTable seams_table(const SetSeams& seams) {
  const QuantityFacts& level = facts(seams.quantity);
  CsvTable table{
      .name = "seams",
      .columns = {{"stimulus", "text", "its id"},
                  {"scene", "text", "name of the scene in the study file"},
                  {"artifact", "word", "which seam the stimulus shows"},
                  {"condition", "word", "of the study file; empty where there is one"},
                  {"object", "text", "name of the inserted object"},
                  {"object_index", "from 1", "its place from the left: of three, 1 left, 2 middle, 3 right"},
                  {std::string(level.key), std::string(level.unit), std::string(level.name)},
                  {"pixels_per_degree", "px", "of the study's observer"},
                  {"noise_sd_steps", "steps of 255",
                   "standard deviation of the noise in the noisiest tile of 32 x 32 pixels"}},
      .rows = {}};
  for (const int step : seam_steps)
    for (const auto& [name, unit, meaning] :
         {std::tuple{"area_over_{}_px", "px", "pixels that differ by more than {} steps beyond noise"},
          std::tuple{"area_over_{}_deg2", "square degrees", "the same"},
          std::tuple{"band_over_{}_px", "px", "diameter of the largest disc of such pixels"},
          std::tuple{"band_over_{}_deg", "degrees", "the same"}})
      table.columns.push_back(
          {fmt::format(fmt::runtime(name), step), unit, fmt::format(fmt::runtime(meaning), step)});
  for (const SeamRow& row : seams.rows) {
    const Stimulus& stimulus = row.stimulus;
    std::vector<CsvValue> values = {row.id,
                                    stimulus.scene,
                                    std::string(word(stimulus.artifact)),
                                    stimulus.condition,
                                    stimulus.object,
                                    std::int64_t{stimulus.object_index},
                                    level_value(seams.quantity, stimulus.level),
                                    seams.pixels_per_degree,
                                    row.seam.largest_noise_steps};
    for (const SeamExtent& extent : row.seam.beyond) {
      values.emplace_back(extent.area_px);
      values.emplace_back(seams.square_degrees(extent.area_px));
      values.emplace_back(extent.widest_band_px);
      values.emplace_back(seams.degrees(extent.widest_band_px));
    }
    table.rows.push_back(std::move(values));
  }
  return table;
}

CsvTable seam_cells_table(const SetSeams& seams) {
  CsvTable table{.name = "cells", .columns = {{"artifact", "", ""}}, .rows = {}};
  if (seams.several_conditions) table.columns.push_back({"condition", "", ""});
  table.columns.push_back({std::string(facts(seams.quantity).name), "", ""});
  for (const char* what : {"area", "band"})
    for (const int step : seam_steps) table.columns.push_back({fmt::format("{} > {}", what, step), "", ""});
  for (const SeamCell& cell : seams.cells) {
    std::vector<CsvValue> row{std::string(word(cell.artifact))};
    if (seams.several_conditions) row.emplace_back(cell.condition);
    row.emplace_back(level_text(seams.quantity, cell.level));
    for (const double area : cell.area_px)
      row.emplace_back(fmt::format("{:.0f} ({:.4f})", area, seams.square_degrees(area)));
    for (const double band : cell.widest_band_px)
      row.emplace_back(fmt::format("{:.1f} ({:.3f})", band, seams.degrees(band)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string seams_meaning(const SetSeams& seams) {
  return fmt::format(
      "Where stimuli differ from their references by more than {}, {} and {} steps of 255 beyond noise: "
      "area in px (square degrees), and widest band, the diameter of the largest disc inside, in px "
      "(degrees). Means over {}, at {:g} pixels per degree.",
      seam_steps[0], seam_steps[1], seam_steps[2],
      std::all_of(seams.rows.begin(), seams.rows.end(),
                  [&](const SeamRow& row) { return row.stimulus.scene == seams.rows.front().stimulus.scene; })
          ? "objects"
          : "scenes and objects",
      seams.pixels_per_degree);
}

}  // namespace seamline::renderer
