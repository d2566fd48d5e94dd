#include "sets/pages/clip_seams.h"

#include <fmt/format.h>

#include <map>
#include <tuple>
#include <utility>

#include "stimuli/set/clip_file.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/running/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

using ClipPaths = std::map<std::string, std::filesystem::path>;

ClipPaths paths_of(const std::filesystem::path& set_folder, const std::vector<ClipRecord>& records) {
  ClipPaths paths;
  for (const ClipRecord& one : records) paths[one.name] = path_in_set(set_folder, one.file);
  return paths;
}

const std::filesystem::path& path_of(const ClipPaths& paths, const std::string& name) {
  const auto found = paths.find(name);
  if (found == paths.end())
    throw input_error({.file = clip_set_file, .wanted = "a clip of " + name, .found = "none"});
  return found->second;
}

ClipSeam seam_of_clip(const std::filesystem::path& stimulus, const std::filesystem::path& reference) {
  ClipReader shown(stimulus), truth(reference);
  if (shown.shape() != truth.shape() || shown.frames() != truth.frames())
    throw input_error(
        {.file = stimulus.string(), .wanted = "the size and length of its reference", .found = "others"});
  ClipSeamMeter meter;
  for (int frame = 0; frame < shown.frames(); ++frame) meter.add(shown.decode(), truth.decode());
  return meter.result();
}

/// The mean over the clips of one cell; flicker over those that have a seam.
struct ClipCell {
  std::array<ClipSeamExtent, seam_steps.size()> sum;
  double flicker = 0, change_steps = 0;
  int clips = 0, with_seam = 0;
};

void add_to_cell(ClipCell& cell, const ClipSeam& clip) {
  for (std::size_t i = 0; i < seam_steps.size(); ++i) {
    cell.sum[i].mean_area_px += clip.beyond[i].mean_area_px;
    cell.sum[i].mean_band_px += clip.beyond[i].mean_band_px;
    cell.sum[i].largest_area_px += clip.beyond[i].largest_area_px;
    cell.sum[i].largest_band_px += clip.beyond[i].largest_band_px;
  }
  cell.change_steps += clip.change_steps;
  cell.flicker += clip.flicker.value_or(0);
  cell.with_seam += clip.flicker ? 1 : 0;
  ++cell.clips;
}

std::vector<CsvValue> cell_values(const ClipCell& cell) {
  std::vector<CsvValue> values = {
      cell.with_seam > 0 ? fmt::format("{:.2f}", cell.flicker / cell.with_seam) : std::string("no seam"),
      fmt::format("{:.1f}", cell.change_steps / cell.clips)};
  for (const ClipSeamExtent& sum : cell.sum)
    values.emplace_back(
        fmt::format("{:.0f}, {:.0f}", sum.mean_area_px / cell.clips, sum.largest_area_px / cell.clips));
  for (const ClipSeamExtent& sum : cell.sum)
    values.emplace_back(
        fmt::format("{:.1f}, {:.1f}", sum.mean_band_px / cell.clips, sum.largest_band_px / cell.clips));
  return values;
}

}  // namespace

std::vector<ClipSeam> read_clip_seams(const std::filesystem::path& set_folder, const SetSeams& seams) {
  const std::optional<ClipSet> set = read_clip_set(set_folder);
  if (!set) return {};
  check_clips(set_folder);
  const ClipPaths stimuli = paths_of(set_folder, set->stimuli);
  const ClipPaths references = paths_of(set_folder, set->references);
  std::vector<ClipSeam> clips(seams.rows.size());
  Progress progress("clips of " + seams.study_name, clips.size());
  int told = 0;
  run_parallel(static_cast<int>(clips.size()), 0,
               [&](int index) {
                 const SeamRow& row = seams.rows[index];
                 clips[index] =
                     seam_of_clip(path_of(stimuli, row.id), path_of(references, truth_of(row.stimulus)));
               },
               {.tick = [&](int finished) {
                 if (finished == told) return;
                 progress.advance(finished - told, fmt::format("{} of {} clips", finished, clips.size()));
                 told = finished;
               }});
  return clips;
}

CsvTable clip_seams_table(const SetSeams& seams, const std::vector<ClipSeam>& clips) {
  const QuantityFacts& level = facts(seams.quantity);
  CsvTable table{.name = "clip_seams",
                 .columns = {{"stimulus", "text", "its id"},
                             {std::string(level.key), std::string(level.unit), std::string(level.name)},
                             {"flicker", "share of the seam",
                              "change of the difference from frame to frame, beside the difference; empty: "
                              "no seam"},
                             {"change_steps", "steps of 255", "root of the mean square of that change"}},
                 .rows = {}};
  for (const int step : seam_steps)
    for (const auto& [name, meaning] :
         {std::pair{"mean_area_over_{}_px", "pixels that differ by more than {} steps, mean over the frames"},
          std::pair{"largest_area_over_{}_px", "more than {} steps, of the frame that has most"},
          std::pair{"mean_band_over_{}_px", "more than {} steps, largest disc, mean over the frames"},
          std::pair{"largest_band_over_{}_px", "more than {} steps, of the frame that has the largest"}})
      table.columns.push_back(
          {fmt::format(fmt::runtime(name), step), "px", fmt::format(fmt::runtime(meaning), step)});
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const ClipSeam& clip = clips[i];
    std::vector<CsvValue> row = {seams.rows[i].id, seams.rows[i].stimulus.level,
                                 clip.flicker ? CsvValue(*clip.flicker) : CsvValue(), clip.change_steps};
    for (const ClipSeamExtent& extent : clip.beyond)
      for (const double value :
           {extent.mean_area_px, extent.largest_area_px, extent.mean_band_px, extent.largest_band_px})
        row.emplace_back(value);
    table.rows.push_back(std::move(row));
  }
  return table;
}

CsvTable clip_cells_table(const SetSeams& seams, const std::vector<ClipSeam>& clips) {
  CsvTable table{.name = "clip_cells", .columns = {{"artifact", "", ""}}, .rows = {}};
  if (seams.several_conditions) table.columns.push_back({"condition", "", ""});
  table.columns.push_back({std::string(facts(seams.quantity).name), "", ""});
  table.columns.push_back({"flicker", "", ""});
  table.columns.push_back({"change", "", ""});
  for (const char* what : {"area", "band"})
    for (const int step : seam_steps) table.columns.push_back({fmt::format("{} > {}", what, step), "", ""});
  for (const SeamCell& cell : seams.cells) {
    ClipCell mean;
    for (std::size_t i = 0; i < clips.size(); ++i) {
      const Stimulus& stimulus = seams.rows[i].stimulus;
      if (stimulus.artifact == cell.artifact && stimulus.condition == cell.condition &&
          stimulus.level == cell.level)
        add_to_cell(mean, clips[i]);
    }
    std::vector<CsvValue> row{std::string(word(cell.artifact))};
    if (seams.several_conditions) row.emplace_back(cell.condition);
    row.emplace_back(level_text(seams.quantity, cell.level));
    for (CsvValue& value : cell_values(mean)) row.push_back(std::move(value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string clip_seams_meaning() {
  return fmt::format(
      "Whole clips. Flicker is how much the difference from the reference changes from frame to frame, where "
      "it is more than {} steps of 255, beside the difference itself: 0 stands still, 1.41 is elsewhere in "
      "every frame. Change is the same in steps. Areas and bands in px are the mean over the frames, and the "
      "largest of one frame.",
      seam_steps[0]);
}

}  // namespace seamline::renderer
