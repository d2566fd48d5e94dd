#include "study/placement/quest_plus_design.h"

#include <map>
#include <tuple>

#include "study/placement/quest_plus_model.h"

namespace seamline::study {
namespace {

/// Tracks without levels and images, and the track of each stimulus.
void find_tracks(QuestPlusDesign& design, const std::vector<Stimulus>& stimuli) {
  const bool by_object = design.definition.track == PlacementTrack::object;
  std::map<std::tuple<Artifact, std::string, std::string, std::string>, int> track_of;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i];
    const std::string scene = by_object ? stimulus.scene : "", object = by_object ? stimulus.object : "";
    const auto [found, is_new] = track_of.try_emplace({stimulus.artifact, scene, object, stimulus.condition},
                                                      static_cast<int>(design.tracks.size()));
    if (is_new)
      design.tracks.push_back({.artifact = stimulus.artifact,
                               .scene = scene,
                               .object = object,
                               .condition = stimulus.condition,
                               .levels = {},
                               .images = {},
                               .tables = {}});
    design.places[i] = {.track = found->second, .level = 0, .object_index = stimulus.object_index};
  }
}

/// Sorts the stimuli of each track by their level.
void find_levels(QuestPlusDesign& design, const std::vector<Stimulus>& stimuli) {
  std::vector<std::map<double, std::vector<int>>> images(design.tracks.size());  // of each track, by level
  for (std::size_t i = 0; i < stimuli.size(); ++i)
    images[static_cast<std::size_t>(design.places[i].track)][stimuli[i].level].push_back(static_cast<int>(i));
  for (std::size_t t = 0; t < images.size(); ++t)
    for (auto& [level, at_level] : images[t]) {
      TrackDesign& track = design.tracks[t];
      for (const int i : at_level)
        design.places[static_cast<std::size_t>(i)].level = static_cast<int>(track.levels.size());
      track.levels.push_back(level);
      track.images.push_back(std::move(at_level));
    }
}

void make_tables(QuestPlusDesign& design) {
  std::map<std::vector<double>, std::shared_ptr<const QuestPlusTables>> tables_of;
  for (TrackDesign& track : design.tracks) {
    std::shared_ptr<const QuestPlusTables>& tables = tables_of[track.levels];
    if (!tables)
      tables =
          std::make_shared<QuestPlusTables>(make_level_tables(design.definition, design.grid, track.levels));
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
  find_levels(design, stimuli);
  make_tables(design);
  return design;
}

std::string name_of(const TrackDesign& track) {
  std::string name(word(track.artifact));
  for (const std::string& part : {track.scene, track.object, track.condition})
    if (!part.empty()) name += " " + part;
  return name;
}

}  // namespace seamline::study
