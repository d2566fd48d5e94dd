#pragma once
#include <memory>
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "study/placement/quest_plus_grid.h"

namespace seamline::study {

/// The stimuli that share a psychometric function. Only what is in the set is in it.
struct TrackDesign {
  Artifact artifact = Artifact::none;
  std::string scene, object;             ///< empty for a track over all objects of an artifact
  std::string condition;                 ///< empty where the study has one condition
  std::vector<double> levels;            ///< rising
  std::vector<std::vector<int>> images;  ///< for each level, the stimuli (indices into the set) that show it
  std::shared_ptr<const QuestPlusTables> tables;  ///< shared by tracks of the same levels
};

/// Everything about a set that does not change in a session; made once and shared by all participants.
struct QuestPlusDesign {
  struct Place {
    int track = 0, level = 0;  ///< indices
    int object_index = 0;      ///< the right choice
  };
  QuestPlusDefinition definition;
  QuestPlusGrid grid;
  std::vector<TrackDesign> tracks;  ///< in the order of their first stimulus
  std::vector<Place> places;        ///< of each stimulus
};

[[nodiscard]] QuestPlusDesign make_quest_plus_design(const QuestPlusDefinition& definition,
                                                     const std::vector<Stimulus>& stimuli);

/// "receiver" or "receiver bedroom statue"; in a study of several conditions with the condition's name behind
/// it.
[[nodiscard]] std::string name_of(const TrackDesign& track);

}  // namespace seamline::study
