#include "analysis/matching/slider_means.h"

#include <map>
#include <set>
#include <tuple>

#include "study/exchange/slider_records.h"

namespace seamline::analysis {
namespace {

struct Places {
  double sum = 0;
  int answers = 0;
};

}  // namespace

std::vector<SliderMean> slider_means(const Analysis& analysis) {
  std::vector<SliderMean> means;
  const std::map<study::TrialOfPerson, int> places = study::slider_places(analysis.log);
  if (places.empty()) return means;
  std::set<std::string> used;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) used.insert(person.record.code);
  std::map<std::tuple<Artifact, std::string, double>, std::map<std::string, Places>> cells;
  for (const study::Answer& answer : analysis.log.answers) {
    const auto found = places.find({answer.participant, answer.trial_index});
    if (found == places.end() || !used.contains(answer.participant)) continue;
    Places& own = cells[{answer.artifact, answer.condition, answer.level}][answer.participant];
    own.sum += found->second;
    ++own.answers;
  }
  for (const ArtifactScores& scores : analysis.data.artifacts)
    for (const double level : scores.level) {
      const auto cell = cells.find({scores.artifact, scores.condition, level});
      if (cell == cells.end()) continue;
      SliderMean mean{.artifact = scores.artifact, .condition = scores.condition, .level = level};
      std::vector<double> of_people;
      for (const auto& [code, own] : cell->second) {
        of_people.push_back(own.sum / own.answers);
        mean.answers += own.answers;
      }
      mean.people = static_cast<int>(of_people.size());
      mean.place = mean_of_observers(of_people);
      means.push_back(std::move(mean));
    }
  return means;
}

}  // namespace seamline::analysis
