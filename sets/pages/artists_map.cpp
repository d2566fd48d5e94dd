#include "sets/pages/artists_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "stimuli/pictures/seam_measure.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/set/set_study.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

struct NeedColour {
  std::array<std::uint8_t, 3> codes;
};
/// Okabe and Ito's sky blue, yellow and vermilion ("Color Universal Design", 2008): they differ in lightness,
/// too.
constexpr NeedColour colour_of(GeometryNeed need) {
  switch (need) {
    case GeometryNeed::nothing:
      return {{255, 255, 255}};
    case GeometryNeed::coarse:
      return {{86, 180, 233}};
    case GeometryNeed::fine:
      return {{240, 228, 66}};
    case GeometryNeed::mask:
      return {{213, 94, 0}};
  }
  return {};
}

constexpr std::array needs_shown = {GeometryNeed::coarse, GeometryNeed::fine, GeometryNeed::mask};

std::string legend_text(GeometryNeed need, const ArtistsRule& rule) {
  switch (need) {
    case GeometryNeed::nothing:
      return "";
    case GeometryNeed::coarse:
      return fmt::format("coarse is enough: a depth map of {} px", rule.coarse_px);
    case GeometryNeed::fine:
      return fmt::format("fine: up to {} px", rule.fine_px);
    case GeometryNeed::mask:
      return "mask: finer still, or a mask or matte";
  }
  return "";
}

bool is_hatched(GeometryNeed need, int x, int y) {
  return need == GeometryNeed::mask && (x + y) % 8 < 2;
}

/// The set and all within so many pixels of it.
PixelSet grown(const PixelSet& set, int reach_px) {
  PixelSet rest = set;
  for (std::uint8_t& value : rest.values) value = value == 0 ? 1 : 0;
  const bool none =
      std::all_of(rest.values.begin(), rest.values.end(), [](auto value) { return value != 0; });
  if (none) return set;
  // Beyond the picture every pixel is left out, and would be near: there is no seam there.
  PixelSet padded{rest.width_px + 2 * (reach_px + 1), rest.height_px + 2 * (reach_px + 1), {}};
  padded.values.assign(padded.width_px * static_cast<std::size_t>(padded.height_px), 1);
  const auto place = [&](int x, int y) {
    return grid_index(y + reach_px + 1, x + reach_px + 1, padded.width_px);
  };
  PixelSet out = set;
  std::size_t i = 0;
  for (int y = 0; y < set.height_px; ++y)
    for (int x = 0; x < set.width_px; ++x) padded.values[place(x, y)] = rest.values[i++];
  const std::vector<std::int64_t> away = squared_distances(padded);
  i = 0;
  for (int y = 0; y < set.height_px; ++y)
    for (int x = 0; x < set.width_px; ++x)
      out.values[i++] = away[place(x, y)] <= std::int64_t{reach_px} * reach_px ? 1 : 0;
  return out;
}

/// Of one reference.
class TruthMap {
 public:
  TruthMap(const std::filesystem::path& set_folder, const Manifest& manifest,
           const ManifestReference& reference)
      : set_folder_(set_folder),
        manifest_(manifest),
        reference_(read_manifest_picture(set_folder, reference_picture(manifest, reference))),
        objects_{manifest.width_px, manifest.height_px,
                 read_manifest_picture(set_folder, click_map_picture(manifest, reference)).values} {}

  [[nodiscard]] std::vector<SeamAtWidth> seams(const std::vector<const ManifestStimulus*>& records,
                                               const ArtistsRule& rule,
                                               const std::function<void(int)>& tick) const {
    std::vector<SeamAtWidth> out(records.size());
    run_parallel(static_cast<int>(records.size()), 0,
                 [&](int index) {
                   const ManifestStimulus& record = *records[index];
                   const SignedDifference difference = signed_difference(
                       read_manifest_picture(set_folder_, stimulus_picture(manifest_, record)), reference_);
                   out[index] = {
                       record.stimulus.depth.width_px,
                       without_specks(seam_pixels(difference, noise_tiles(difference), rule.seam_step),
                                      rule.least_px)};
                 },
                 {.tick = tick});
    return out;
  }
  [[nodiscard]] const ByteImage& reference() const { return reference_; }
  [[nodiscard]] const PixelSet& objects() const { return objects_; }

 private:
  const std::filesystem::path& set_folder_;
  const Manifest& manifest_;
  ByteImage reference_;
  PixelSet objects_;
};

}  // namespace

PixelSet without_specks(const PixelSet& set, int least_px) {
  PixelSet out = set;
  std::vector<std::uint8_t> seen(set.values.size(), 0);
  std::vector<std::size_t> part;
  for (std::size_t start = 0; start < set.values.size(); ++start) {
    if (set.values[start] == 0 || seen[start] != 0) continue;
    part.assign(1, start);
    seen[start] = 1;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const int x = static_cast<int>(part[next]) % set.width_px,
                y = static_cast<int>(part[next]) / set.width_px;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, set.height_px - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, set.width_px - 1); ++u) {
          const std::size_t i = grid_index(v, u, set.width_px);
          if (set.values[i] == 0 || seen[i] != 0) continue;
          seen[i] = 1;
          part.push_back(i);
        }
    }
    if (part.size() < static_cast<std::size_t>(least_px))
      for (const std::size_t i : part) out.values[i] = 0;
  }
  return out;
}

std::vector<GeometryNeed> geometry_needs(const std::vector<SeamAtWidth>& seams, const PixelSet& objects,
                                         const ArtistsRule& rule, int reach_px) {
  std::map<int, PixelSet> at_width;
  for (const SeamAtWidth& one : seams) {
    PixelSet& all =
        at_width.try_emplace(one.width_px, PixelSet{one.seam.width_px, one.seam.height_px, {}}).first->second;
    all.values.resize(one.seam.values.size(), 0);
    for (std::size_t i = 0; i < all.values.size(); ++i) all.values[i] |= one.seam.values[i];
  }
  std::vector<GeometryNeed> needs(objects.values.size(), GeometryNeed::nothing);
  for (std::size_t i = 0; i < needs.size(); ++i)
    if (objects.values[i] != 0) needs[i] = GeometryNeed::coarse;
  // From the coarsest map on: where one still has a seam, the next wider one of the set is needed.
  for (auto width = at_width.begin(); width != at_width.end(); ++width) {
    const auto next = std::next(width);
    GeometryNeed need = GeometryNeed::mask;
    if (next != at_width.end() && next->first <= rule.fine_px) need = GeometryNeed::fine;
    if (next != at_width.end() && next->first <= rule.coarse_px) need = GeometryNeed::coarse;
    const PixelSet region = grown(width->second, reach_px);
    for (std::size_t i = 0; i < needs.size(); ++i)
      if (region.values[i] != 0) needs[i] = std::max(needs[i], need);
  }
  return needs;
}

ByteImage artists_picture(const ByteImage& reference, const std::vector<GeometryNeed>& needs,
                          const ArtistsRule& rule) {
  constexpr int row_px = 22, swatch_px = 14, text_px = 13;
  ByteImage out{
      reference.width_px, reference.height_px + row_px * static_cast<int>(needs_shown.size()) + 6, 3, {}};
  out.values.assign(out.width_px * static_cast<std::size_t>(out.height_px) * 3, paper_code);
  std::array<std::int64_t, 4> counts{};
  const auto paint = [&](int x, int y, const std::array<double, 3>& codes) {
    const std::size_t at = 3 * grid_index(y, x, out.width_px);
    for (std::size_t c = 0; c < 3; ++c)
      out.values[at + c] = static_cast<std::uint8_t>(std::lround(std::clamp(codes[c], 0.0, 255.0)));
  };
  for (int y = 0; y < reference.height_px; ++y)
    for (int x = 0; x < reference.width_px; ++x) {
      const std::size_t i = grid_index(y, x, reference.width_px);
      const double grey = 0.3 * reference.values[3 * i] + 0.59 * reference.values[3 * i + 1] +
                          0.11 * reference.values[3 * i + 2];
      const GeometryNeed need = needs[i];
      ++counts[static_cast<std::size_t>(need)];
      const NeedColour colour = colour_of(need);
      std::array<double, 3> codes{};
      for (std::size_t c = 0; c < 3; ++c)
        codes[c] = need == GeometryNeed::nothing ? 110 + 0.5 * grey
                                                 : 0.75 * colour.codes[c] + 0.25 * (40 + 0.84 * grey);
      if (is_hatched(need, x, y))
        for (double& code : codes) code *= 0.45;
      paint(x, y, codes);
    }
  int top = reference.height_px + 6;
  for (const GeometryNeed need : needs_shown) {
    for (int y = 0; y < swatch_px; ++y)
      for (int x = 0; x < 2 * swatch_px; ++x) {
        std::array<double, 3> codes{};
        for (std::size_t c = 0; c < 3; ++c)
          codes[c] = colour_of(need).codes[c] * (is_hatched(need, x, y) ? 0.45 : 1.0);
        paint(6 + x, top + y, codes);
      }
    draw_text(out, 12 + 2 * swatch_px, top + swatch_px - 2,
              fmt::format("{} ({:.1f} % of the picture)", legend_text(need, rule),
                          100.0 * counts[static_cast<std::size_t>(need)] / needs.size()),
              text_px, ink_code);
    top += row_px;
  }
  return out;
}

std::vector<std::filesystem::path> write_artists_maps(const std::filesystem::path& folder,
                                                      const std::filesystem::path& set_folder,
                                                      const ArtistsRule& rule) {
  const Manifest manifest = read_manifest(set_folder);
  const StudyDefinition study = study_of_set(set_folder, manifest);
  const std::string file = (set_folder / "manifest.json").string();
  if (level_quantity(manifest) != Quantity::depth_width_px)
    throw input_error({.file = file,
                       .field = request_name("artists"),
                       .wanted = "a set whose levels are widths of depth maps",
                       .found = std::string(facts(level_quantity(manifest)).key)});
  check_manifest_shapes(set_folder, manifest);
  std::set<std::string> mitigated;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (stimulus.depth.mitigation != Mitigation{}) mitigated.insert(stimulus_id(stimulus));
  std::map<std::string, std::vector<const ManifestStimulus*>> by_truth;
  std::set<int> widths;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (mitigated.contains(record.id)) continue;
    by_truth[truth_of(record.stimulus)].push_back(&record);
    widths.insert(record.stimulus.depth.width_px);
  }
  if (widths.empty() || *widths.begin() > rule.coarse_px || *widths.rbegin() < rule.fine_px)
    throw input_error(
        {.file = file,
         .field = request_name("artists"),
         .wanted = fmt::format("depth maps from {} px or less to {} px or more, without mitigation",
                               rule.coarse_px, rule.fine_px),
         .found = widths.empty() ? std::string("none")
                                 : fmt::format("{} to {} px", *widths.begin(), *widths.rbegin())});
  const int reach_px =
      std::max(1, static_cast<int>(std::lround(rule.reach_deg * study.observer.pixels_per_degree)));
  double stimuli = 0;
  for (const auto& [truth, records] : by_truth) stimuli += records.size();
  Progress progress("geometry needs of " + manifest.study_name, stimuli);
  std::vector<std::filesystem::path> written;
  for (const ManifestReference& reference : manifest.references) {
    const auto found = by_truth.find(reference.truth);
    if (found == by_truth.end()) continue;
    stop_if_interrupted();
    const TruthMap map(set_folder, manifest, reference);
    int told = 0;
    const auto seams = map.seams(found->second, rule, [&](int finished) {
      progress.advance(finished - told, reference.truth);
      told = finished;
    });
    written.push_back(folder / ("artists-" + reference.truth + ".png"));
    write_png(written.back(),
              artists_picture(map.reference(), geometry_needs(seams, map.objects(), rule, reach_px), rule));
  }
  return written;
}

}  // namespace seamline::renderer
