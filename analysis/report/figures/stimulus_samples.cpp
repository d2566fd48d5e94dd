#include "analysis/report/figures/stimulus_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>

#include "stimuli/set/depth_errors.h"
#include "stimuli/set/level_notes.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/atomic_file.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

constexpr double smallest_crop_share = 200.0 / 960;  ///< of the picture's width

ByteImage cut(const ByteImage& image, const Rectangle& area) {
  assert(area.x >= 0 && area.y >= 0 && area.x + area.width_px <= image.width_px &&
         area.y + area.height_px <= image.height_px);
  ByteImage cutout{
      .width_px = area.width_px, .height_px = area.height_px, .channels = image.channels, .values = {}};
  const auto row_bytes = static_cast<std::ptrdiff_t>(area.width_px) * image.channels;
  for (int y = area.y; y < area.y + area.height_px; ++y) {
    const auto begin =
        image.values.begin() + (static_cast<std::ptrdiff_t>(y) * image.width_px + area.x) * image.channels;
    cutout.values.insert(cutout.values.end(), begin, begin + row_bytes);
  }
  return cutout;
}

/// Cuts samples of one artifact out of a set's pictures.
class Scissors {
 public:
  /// `png` is a file of passage.
  Scissors(const std::filesystem::path& set, std::filesystem::path png) : set_(set), png_(std::move(png)) {}

  /// Around the pixels of object `id`; false when there is no click map to say where that is.
  bool look_at(const ManifestPicture& click_map, int id, std::string& trouble) {
    const std::optional<ByteImage> ids = read(click_map, trouble);
    if (ids) area_ = crop_around(*ids, id);
    return ids.has_value();
  }

  SampleImage sample(const ManifestPicture& file, const std::string& label,
                     const std::string& stimulus_id) const {
    SampleImage image{.label = label, .stimulus_id = stimulus_id, .png = {}, .trouble = {}};
    const std::optional<ByteImage> picture = read(file, image.trouble);
    if (!picture) return image;
    const ByteImage cutout = cut(*picture, area_);
    write_png(png_, cutout);
    image.png = read_file(png_);
    image.width_px = cutout.width_px;
    image.height_px = cutout.height_px;
    std::filesystem::remove(png_);
    return image;
  }

 private:
  /// Nothing and a sentence when the picture is not what the manifest says.
  std::optional<ByteImage> read(const ManifestPicture& file, std::string& trouble) const {
    try {
      return read_manifest_picture(set_, file);
    } catch (const InputError& error) {
      trouble = error.what();
      return std::nullopt;
    }
  }

  const std::filesystem::path& set_;
  std::filesystem::path png_;
  Rectangle area_;
};

SampleRow sample_row(const std::filesystem::path& set, const Manifest& manifest,
                     std::vector<const ManifestStimulus*> stimuli, const LevelAxis& axis,
                     const std::filesystem::path& scratch) {
  Scissors scissors(set, scratch / fmt::format("sample-{}-{}.png", word(stimuli.front()->stimulus.artifact),
                                               stimuli.front()->stimulus.condition));
  std::sort(stimuli.begin(), stimuli.end(), [&](const ManifestStimulus* a, const ManifestStimulus* b) {
    return comes_before(axis, b->stimulus.level, a->stimulus.level);
  });
  const Stimulus& first = stimuli.front()->stimulus;
  const ManifestReference& reference = reference_of(set, manifest, first);
  SampleRow row{.artifact = first.artifact,
                .condition = first.condition,
                .scene = first.scene,
                .object = first.object,
                .images = {},
                .trouble = {}};
  if (!scissors.look_at(click_map_picture(manifest, reference), first.object_index, row.trouble)) return row;
  row.images.push_back(scissors.sample(reference_picture(manifest, reference), "reference", ""));
  for (const ManifestStimulus* stimulus : stimuli)
    row.images.push_back(scissors.sample(stimulus_picture(manifest, *stimulus),
                                         tested_text(axis, stimulus->stimulus.level), stimulus->id));
  return row;
}

/// The stimuli of an artifact that show its first scene's leftmost object.
std::vector<const ManifestStimulus*> of_first_object(const Manifest& manifest, Artifact artifact,
                                                     const std::string& condition) {
  const ManifestStimulus* first = nullptr;
  std::vector<const ManifestStimulus*> found;
  for (const ManifestStimulus& stimulus : manifest.stimuli)
    if (stimulus.stimulus.artifact == artifact && stimulus.stimulus.condition == condition &&
        (first == nullptr || (stimulus.stimulus.scene == first->stimulus.scene &&
                              stimulus.stimulus.object_index < first->stimulus.object_index)))
      first = &stimulus;
  for (const ManifestStimulus& stimulus : manifest.stimuli)
    if (first != nullptr && stimulus.stimulus.artifact == artifact &&
        stimulus.stimulus.condition == condition && stimulus.stimulus.scene == first->stimulus.scene &&
        stimulus.stimulus.object_index == first->stimulus.object_index)
      found.push_back(&stimulus);
  return found;
}

}  // namespace

Rectangle crop_around(const ByteImage& object_ids, int id) {
  int left = object_ids.width_px, right = -1, top = object_ids.height_px, bottom = -1;
  for (int y = 0; y < object_ids.height_px; ++y)
    for (int x = 0; x < object_ids.width_px; ++x) {
      const auto at = static_cast<std::size_t>((y * object_ids.width_px + x) * object_ids.channels);
      if (object_ids.values[at] != id) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  if (right < 0) return {.x = 0, .y = 0, .width_px = object_ids.width_px, .height_px = object_ids.height_px};
  const int wanted = std::max(static_cast<int>(smallest_crop_share * object_ids.width_px),
                              2 * std::max(right - left + 1, bottom - top + 1));
  const int side = std::min({wanted, object_ids.width_px, object_ids.height_px});
  return {.x = std::clamp((left + right + 1 - side) / 2, 0, object_ids.width_px - side),
          .y = std::clamp((top + bottom + 1 - side) / 2, 0, object_ids.height_px - side),
          .width_px = side,
          .height_px = side};
}

StimulusSamples sample_stimuli(const Analysis& analysis, const std::filesystem::path& scratch) {
  const std::filesystem::path& set = analysis.log.set_folder;
  std::error_code ignored;
  if (set.empty() || !std::filesystem::is_directory(set, ignored))
    return "The stimulus set was not found where it was during the sessions, so no stimuli are shown.";
  try {
    if (set_hash(set) != analysis.log.set_hash)
      return "The stimulus set now at the place of the sessions' set is another one, so no stimuli are "
             "shown.";
    const Manifest manifest = read_manifest(set);
    std::vector<std::vector<const ManifestStimulus*>> shown;
    for (const ArtifactScores& scores : analysis.data.artifacts)
      if (auto stimuli = of_first_object(manifest, scores.artifact, scores.condition); !stimuli.empty())
        shown.push_back(std::move(stimuli));
    std::vector<SampleRow> rows(shown.size());
    run_parallel(static_cast<int>(rows.size()), analysis.resampling.threads, [&](int index) {
      const std::size_t i = index;
      rows[i] = sample_row(set, manifest, shown[i], analysis.data.axis, scratch);
    });
    return rows;
  } catch (const InputError& error) {
    return std::string("The stimulus set cannot be read, so no stimuli are shown: ") + error.what();
  }
}

std::vector<std::string> notes_on_depth(const study::LogContents& log) {
  try {
    if (log.set_folder.empty() || set_hash(log.set_folder) != log.set_hash) return {};
    const Manifest manifest = read_manifest(log.set_folder);
    std::vector<std::string> notes = sentences(holes_of_set(manifest));
    for (std::string& said : sentences(depth_errors_of_set(manifest))) notes.push_back(std::move(said));
    return notes;
  } catch (const InputError&) {
    return {};  // `sample_stimuli` says so
  }
}

std::vector<std::string> notes_on(const StimulusSamples& samples) {
  const auto* rows = std::get_if<std::vector<SampleRow>>(&samples);
  if (rows == nullptr) return {};
  int missing = 0;
  std::string first;
  const auto count = [&](const std::string& trouble) {
    if (trouble.empty()) return;
    if (missing++ == 0) first = trouble;
  };
  for (const SampleRow& row : *rows) {
    count(row.trouble);
    for (const SampleImage& image : row.images) count(image.trouble);
  }
  if (missing == 0) return {};
  return {fmt::format("{} of the set's pictures {} not shown, because {} not what the sessions showed: {}",
                      missing, missing == 1 ? "is" : "are", missing == 1 ? "it is" : "they are", first)};
}

}  // namespace seamline::analysis
