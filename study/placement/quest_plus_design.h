#pragma once
#include <memory>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "study/placement/quest_plus_grid.h"
#include "study/placement/stimulus_tracks.h"

namespace seamline::study {

struct TrackDesign : StimulusTrack {
  std::shared_ptr<const QuestPlusTables> tables = {};  ///< shared by tracks of the same levels
};

/// Everything about a set that does not change in a session; made once and shared by all participants.
struct QuestPlusDesign {
  QuestPlusDefinition definition;
  QuestPlusGrid grid;
  std::vector<TrackDesign> tracks;  ///< in the order of their first stimulus
  std::vector<TrackPlace> places;   ///< of each stimulus
};

[[nodiscard]] QuestPlusDesign make_quest_plus_design(const QuestPlusDefinition& definition,
                                                     const std::vector<Stimulus>& stimuli);

}  // namespace seamline::study
