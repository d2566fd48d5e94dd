#include "study/placement/quest_plus_design.h"

#include <map>
#include <utility>

#include "study/placement/quest_plus_model.h"

namespace seamline::study {
namespace {

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
  StimulusTracks found = tracks_of(stimuli, definition.track == PlacementTrack::object);
  QuestPlusDesign design{.definition = definition,
                         .grid = make_grid(definition),
                         .tracks = {},
                         .places = std::move(found.places)};
  for (StimulusTrack& track : found.tracks) design.tracks.push_back({std::move(track)});
  make_tables(design);
  return design;
}

}  // namespace seamline::study
