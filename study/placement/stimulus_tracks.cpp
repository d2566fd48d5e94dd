#include "study/placement/stimulus_tracks.h"

#include <map>
#include <tuple>
#include <utility>

namespace seamline::study {
namespace {

/// Tracks without levels and images, and the track of each stimulus.
void find_tracks(StimulusTracks& found_tracks, const std::vector<Stimulus>& stimuli, bool by_object) {
  std::map<std::tuple<Artifact, std::string, std::string, std::string>, int> track_of;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i];
    const std::string scene = by_object ? stimulus.scene : "", object = by_object ? stimulus.object : "";
    const auto [found, is_new] = track_of.try_emplace({stimulus.artifact, scene, object, stimulus.condition},
                                                      static_cast<int>(found_tracks.tracks.size()));
    if (is_new)
      found_tracks.tracks.push_back({.artifact = stimulus.artifact,
                                     .scene = scene,
                                     .object = object,
                                     .condition = stimulus.condition,
                                     .levels = {},
                                     .images = {}});
    found_tracks.places[i] = {.track = found->second, .level = 0, .object_index = stimulus.object_index};
  }
}

/// Sorts the stimuli of each track by their level.
void find_levels(StimulusTracks& found, const std::vector<Stimulus>& stimuli) {
  std::vector<std::map<double, std::vector<int>>> images(found.tracks.size());  // of each track, by level
  for (std::size_t i = 0; i < stimuli.size(); ++i)
    images[found.places[i].track][stimuli[i].level].push_back(static_cast<int>(i));
  for (std::size_t t = 0; t < images.size(); ++t)
    for (auto& [level, at_level] : images[t]) {
      StimulusTrack& track = found.tracks[t];
      for (const int i : at_level) found.places[i].level = static_cast<int>(track.levels.size());
      track.levels.push_back(level);
      track.images.push_back(std::move(at_level));
    }
}

}  // namespace

StimulusTracks tracks_of(const std::vector<Stimulus>& stimuli, bool by_object) {
  StimulusTracks found{.tracks = {}, .places = std::vector<TrackPlace>(stimuli.size())};
  find_tracks(found, stimuli, by_object);
  find_levels(found, stimuli);
  return found;
}

std::string name_of(const StimulusTrack& track) {
  std::string name(word(track.artifact));
  for (const std::string& part : {track.scene, track.object, track.condition})
    if (!part.empty()) name += " " + part;
  return name;
}

}  // namespace seamline::study
