#pragma once
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"

namespace seamline::study {

/// The stimuli that share a psychometric function. Only what is in the set is in it.
struct StimulusTrack {
  Artifact artifact = Artifact::none;
  std::string scene, object;             ///< empty for a track over all objects of an artifact
  std::string condition;                 ///< empty where the study has one condition
  std::vector<double> levels;            ///< rising, unless its user says otherwise
  std::vector<std::vector<int>> images;  ///< for each level, the stimuli (indices into the set) that show it
};

/// Where a stimulus stands.
struct TrackPlace {
  int track = 0, level = 0;  ///< indices
  int object_index = 0;      ///< the right choice
};

struct StimulusTracks {
  std::vector<StimulusTrack> tracks;  ///< in the order of their first stimulus
  std::vector<TrackPlace> places;     ///< of each stimulus
};

/// `by_object`: every object of every scene has a track of its own.
[[nodiscard]] StimulusTracks tracks_of(const std::vector<Stimulus>& stimuli, bool by_object);

/// "receiver" or "receiver bedroom statue"; in a study of several conditions with the condition's name behind
/// it.
[[nodiscard]] std::string name_of(const StimulusTrack& track);

}  // namespace seamline::study
