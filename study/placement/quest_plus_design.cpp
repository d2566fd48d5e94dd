#include "study/placement/quest_plus_design.h"

#include <map>
#include <tuple>

#include "study/placement/quest_plus_model.h"

namespace seamline::study {
namespace {

/// Tracks without widths and images, and the track of each stimulus.
void find_tracks(QuestPlusDesign& design, const std::vector<Stimulus>& stimuli) {
  const bool by_object = design.definition.track == PlacementTrack::object;
  std::map<std::tuple<Artifact, std::string, std::string>, int> track_of;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i];
    const std::string scene = by_object ? stimulus.scene : "", object = by_object ? stimulus.object : "";
    const auto [found, is_new] =
        track_of.try_emplace({stimulus.artifact, scene, object}, static_cast<int>(design.tracks.size()));
    if (is_new)
      design.tracks.push_back({.artifact = stimulus.artifact,
                               .scene = scene,
                               .object = object,
                               .width_px = {},
                               .images = {},
                               .tables = {}});
    design.places[i] = {.track = found->second, .width = 0, .object_index = stimulus.object_index};
  }
}

/// Sorts the stimuli of each track by their width.
void find_widths(QuestPlusDesign& design, const std::vector<Stimulus>& stimuli) {
  std::vector<std::map<int, std::vector<int>>> images(design.tracks.size());  // of each track, by width
  for (std::size_t i = 0; i < stimuli.size(); ++i)
    images[static_cast<std::size_t>(design.places[i].track)][stimuli[i].depth.width_px].push_back(
        static_cast<int>(i));
  for (std::size_t t = 0; t < images.size(); ++t)
    for (auto& [width_px, at_width] : images[t]) {
      TrackDesign& track = design.tracks[t];
      for (const int i : at_width)
        design.places[static_cast<std::size_t>(i)].width = static_cast<int>(track.width_px.size());
      track.width_px.push_back(width_px);
      track.images.push_back(std::move(at_width));
    }
}

void make_tables(QuestPlusDesign& design) {
  std::map<std::vector<int>, std::shared_ptr<const QuestPlusTables>> tables_of;
  for (TrackDesign& track : design.tracks) {
    std::shared_ptr<const QuestPlusTables>& tables = tables_of[track.width_px];
    if (!tables)
      tables = std::make_shared<QuestPlusTables>(
          make_width_tables(design.definition, design.grid, track.width_px));
    track.tables = tables;
  }
}

}  // namespace

QuestPlusDesign make_quest_plus_design(const QuestPlusDefinition& definition,
                                       const std::vector<Stimulus>& stimuli) {
  QuestPlusDesign design{.definition = definition,
                         .grid = make_grid(definition),
                         .tracks = {},
                         .places = std::vector<QuestPlusDesign::Place>(stimuli.size())};
  find_tracks(design, stimuli);
  find_widths(design, stimuli);
  make_tables(design);
  return design;
}

std::string name_of(const TrackDesign& track) {
  std::string name(word(track.artifact));
  for (const std::string& part : {track.scene, track.object})
    if (!part.empty()) name += " " + part;
  return name;
}

}  // namespace seamline::study
