#include "sets/set_errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "renderer/picture/rare_light.h"
#include "sets/clips/frame_changes.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/set_study.h"
#include "support/files/atomic_file.h"
#include "support/text/request_name.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace {

using Json = nlohmann::ordered_json;

struct Piece {
  double seconds = 0;
  std::int64_t rays = 0;
  std::optional<double> worst_tile = {}, rare_light = {};
  std::map<std::string, double> changes = {};
};
using Pieces = std::map<std::string, Piece>;

/// `timings.json` and those of shards; a damaged one says nothing.
Pieces read_timings(const std::filesystem::path& set_folder, SetErrors& errors) {
  Pieces pieces;
  for (const auto& entry : std::filesystem::directory_iterator(set_folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("timings") || !name.ends_with(".json")) continue;
    try {
      const std::string text = read_file(entry.path());
      require_bounded_json(text, entry.path().string());
      const Json json = Json::parse(text);
      errors.threads = std::max(errors.threads, json.value("threads", 0));
      errors.machine = json.value("machine", errors.machine);
      const Json lines = json.value("pieces", Json::object());
      for (const auto& [piece, line] : lines.items()) {
        Piece& read = pieces[piece] = {line.at("seconds").get<double>(), line.at("rays").get<std::int64_t>()};
        if (line.contains("worst_tile")) read.worst_tile = line["worst_tile"].get<double>();
        if (line.contains("rare_light")) read.rare_light = line["rare_light"].get<double>();
        if (line.contains("changes")) read.changes = line["changes"].get<std::map<std::string, double>>();
      }
    } catch (const Json::exception&) {
      continue;
    }
  }
  return pieces;
}

/// Stimuli whose true error exceeds the estimate by more than some of its own standard errors.
int count_above(const std::vector<StimulusErrorRow>& rows, double standard_errors) {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const StimulusErrorRow& row) {
    return row.measured && row.estimated &&
           row.measured->rmse - standard_errors * row.measured->standard_error > *row.estimated;
  }));
}

void raise(const std::optional<double>& value, std::optional<double>& most) {
  if (value) most = std::max(most.value_or(*value), *value);
}

/// The clips' frames, by the clips' ids; none of a set of stills.
std::map<std::string, std::vector<std::string>> frames_of_set(const std::filesystem::path& set_folder,
                                                              const Manifest& manifest) {
  std::map<std::string, std::vector<std::string>> frames;
  if (!read_clip_set(set_folder)) return frames;
  for (const Clip& clip : list_clips(study_of_set(set_folder, manifest)))
    for (const Stimulus& frame : clip.frames) frames[stimulus_id(clip.shown)].push_back(stimulus_id(frame));
  return frames;
}

/// What the frames of a clip say of it: seconds of all, the worst of any, and the error of its changes.
void add_frames(const std::vector<std::string>& frames, const Pieces& pieces, StimulusErrorRow& row) {
  FrameChangeErrors changes;
  for (const std::string& frame : std::set(frames.begin(), frames.end())) {
    const auto found = pieces.find(frame);
    if (found == pieces.end()) continue;
    row.seconds = row.seconds.value_or(0) + found->second.seconds;
    raise(found->second.worst_tile, row.estimated_worst_tile);
    raise(found->second.rare_light, row.rare_light);
    for (const auto& [before, squared] : found->second.changes) changes[{frame, before}] = squared;
  }
  const ClipChangeError error = clip_change_error(frames, changes);
  row.changes = error.changes;
  if (changes.empty() && error.known < error.changes) return;  // no error was asked for
  row.changes_known = error.known;
  if (error.known > 0) row.change = std::sqrt(error.squared);
}

CsvValue cell(const std::optional<double>& value) {
  return value ? CsvValue(*value) : CsvValue();
}

}  // namespace

int SetErrors::measured() const {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.measured.has_value(); }));
}

int SetErrors::above_estimate() const {
  return count_above(rows, 0);
}

int SetErrors::clearly_above_estimate() const {
  return count_above(rows, 2);
}

SetErrors read_set_errors(const std::filesystem::path& set_folder) {
  const Manifest manifest = read_manifest(set_folder);
  SetErrors errors{.study_name = manifest.study_name,
                   .width_px = manifest.width_px,
                   .height_px = manifest.height_px,
                   .threads = 0,
                   .machine = "unknown",
                   .seconds = {},
                   .rays = 0,
                   .rows = {}};
  const Pieces pieces = read_timings(set_folder, errors);
  for (const auto& [name, piece] : pieces) {
    if (name.starts_with("reference-")) errors.seconds.references += piece.seconds;
    if (name.starts_with("truth-")) errors.seconds.truth += piece.seconds;
    if (name.starts_with("mesh-")) errors.seconds.meshes += piece.seconds;
    if (name.starts_with("reference-") || name.starts_with("truth-")) errors.rays += piece.rays;
  }
  const TrueErrors measured = read_true_errors(set_folder);
  const auto frames = frames_of_set(set_folder, manifest);
  errors.of_clips = !frames.empty();
  for (const ManifestStimulus& record : manifest.stimuli) {
    StimulusErrorRow row{.id = record.id,
                         .artifact = record.stimulus.artifact,
                         .seconds = {},
                         .rays = record.rays,
                         .spp = record.spp,
                         .estimated = record.rmse,
                         .estimated_worst_tile = {},
                         .rare_light = {},
                         .measured = {}};
    if (const auto found = pieces.find(record.id); found != pieces.end()) {
      row.seconds = found->second.seconds;
      row.estimated_worst_tile = found->second.worst_tile;
      row.rare_light = found->second.rare_light;
    }
    if (const auto found = frames.find(record.id); found != frames.end())
      add_frames(found->second, pieces, row);
    errors.seconds.stimuli += row.seconds.value_or(0);
    if (const auto found = measured.find(record.id);
        found != measured.end() && found->second.picture_sha256 == record.sha256)
      row.measured = found->second;
    errors.rays += record.rays;
    errors.rows.push_back(std::move(row));
  }
  return errors;
}

/// Why a stimulus ended above the error that was asked for.
static std::string_view reason(const StimulusErrorRow& row) {
  constexpr int most_spp = 1 << 14;
  if (row.changes > 0) return "frames between the four that decided need more samples";
  return row.spp >= most_spp ? "its pixels have all the samples that they may have"
                             : "more samples of the depth mesh did not lower it";
}

static constexpr double rounded_in_files = 1e-3;  ///< relative, of errors in manifest and timings

std::vector<std::string> sentences_on_missed(const SetErrors& errors, double asked) {
  std::string examples;
  int missed = 0;
  for (const StimulusErrorRow& row : errors.rows) {
    const double reached = row.estimated.value_or(0), worst_tile = row.estimated_worst_tile.value_or(0);
    if (std::max(reached, worst_tile / 3) <= asked * (1 + rounded_in_files)) continue;
    if (++missed <= 3)
      examples += fmt::format("{}{} ({:.4f}, worst tile {:.4f}; {})", missed > 1 ? ", " : "", row.id, reached,
                              worst_tile, reason(row));
  }
  if (missed == 0) return {};
  return {fmt::format(
      "The error that was asked for, {:g} (worst tile {:g}), was not reached by {} of {} stimuli: {}{}. "
      "errors.html lists all.",
      asked, 3 * asked, missed, errors.rows.size(), examples, missed > 3 ? " ..." : "")};
}

std::vector<std::string> sentences_on_rare_light(const SetErrors& errors) {
  std::string examples;
  int rare = 0;
  for (const StimulusErrorRow& row : errors.rows)
    if (row.rare_light.value_or(0) > much_rare_light && ++rare <= 3)
      examples += fmt::format("{}{} ({:.0f} %)", rare > 1 ? ", " : "", row.id, 100 * *row.rare_light);
  if (rare == 0) return {};
  return {fmt::format(
      "Rare bright light: a fifth or more of the estimated error of {} of {} stimuli is in one pixel of 500: {}{}. "
      "Other pixels may not have met that light yet, so these errors may be too low; {} measures them.",
      rare, errors.rows.size(), examples, rare > 3 ? " ..." : "", request_name("true_error"))};
}

std::vector<std::string> sentences_on_noisy_references(const SetErrors& errors) {
  std::string examples;
  int noisy = 0, spp = 0;
  for (const StimulusErrorRow& row : errors.rows)
    if (row.measured && row.measured->noisy_reference) {
      if (++noisy <= 3) examples += fmt::format("{}{}", noisy > 1 ? ", " : "", row.id);
      spp = std::max(spp, row.measured->reference_spp);
    }
  if (noisy == 0) return {};
  return {fmt::format(
      "Noisy references: the true errors of {} of {} measured stimuli are more the references' own: {}{}. "
      "They are too large. Measure them again with {} {}.",
      noisy, errors.measured(), examples, noisy > 3 ? " ..." : "", request_name("true_error_spp"), 4 * spp)};
}

std::vector<std::string> sentences_on_changes(const SetErrors& errors) {
  const StimulusErrorRow* worst = nullptr;
  int known = 0, changes = 0;
  for (const StimulusErrorRow& row : errors.rows) {
    changes += row.changes;
    known += row.changes_known;
    if (row.change && (worst == nullptr || *row.change > *worst->change)) worst = &row;
  }
  if (worst == nullptr) return {};
  return {fmt::format(
      "Error of the change from frame to frame, estimated from the samples of {} of {} changes: at most {:.4f} "
      "over a clip ({}).",
      known, changes, *worst->change, worst->id)};
}

CsvTable errors_table(const SetErrors& errors) {
  CsvTable table{
      .name = "errors",
      .columns = {{"stimulus", "", "id"},
                  {"seconds", "s", "of the stimulus' own pass; what stimuli share is not in it"},
                  {"rays", "millions", "traced for the stimulus"},
                  {"samples", "per pixel", "sub-pixel samples"},
                  {"estimated_error", "display units", "estimated RMSE, noise and bias"},
                  {"estimated_worst_tile", "display units", "the same in the worst 32 x 32 tile"},
                  {"rare_light", "share",
                   "of the estimated noise in one pixel of 500; above 0.2 it may be too low"},
                  {"true_error", "display units", "RMSE against the path estimator, without its noise"},
                  {"true_standard_error", "display units", "of the true error as measured"},
                  {"true_worst_tile", "display units", "true error in the worst 32 x 32 tile"},
                  {"reference_samples", "per pixel", "of the path reference"}},
      .rows = {}};
  if (errors.of_clips)
    for (CsvColumn column :
         {CsvColumn{"change_error", "display units", "estimated RMSE of the change from frame to frame"},
          CsvColumn{"changes_known", "", "changes that it is known of"},
          CsvColumn{"changes", "", "of the clip"}})
      table.columns.push_back(std::move(column));
  for (const StimulusErrorRow& row : errors.rows) {
    std::vector<CsvValue> cells = {row.id,
                                   cell(row.seconds),
                                   row.rays * 1e-6,
                                   std::int64_t{row.spp},
                                   cell(row.estimated),
                                   cell(row.estimated_worst_tile),
                                   cell(row.rare_light)};
    if (const auto& m = row.measured)
      for (CsvValue value : {CsvValue(m->rmse), CsvValue(m->standard_error), CsvValue(m->worst_tile),
                             CsvValue(std::int64_t{m->reference_spp})})
        cells.push_back(std::move(value));
    cells.resize(11);
    if (errors.of_clips)
      for (CsvValue value :
           {cell(row.change), CsvValue(std::int64_t{row.changes_known}), CsvValue(std::int64_t{row.changes})})
        cells.push_back(std::move(value));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace seamline::renderer
