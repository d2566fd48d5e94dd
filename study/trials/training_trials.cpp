#include "study/trials/training_trials.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "stimuli/definition/looks/condition_tasks.h"
#include "study/trials/condition_blocks.h"
#include "support/text/error.h"
#include "support/text/suggest.h"

namespace seamline::study {
namespace {

/// The stimuli of each artifact, those whose level is noticed most first, and among equals another object
/// first for each artifact, so that practice does not teach that it is always the same one.
std::vector<std::vector<int>> most_noticeable_first(const RenderedSet& set) {
  const double towards_less = set.study.level.noticeability == Direction::decreasing ? 1 : -1;
  std::vector<std::vector<int>> by_artifact;
  std::map<Artifact, std::size_t> place;
  const int objects = objects_of(set.study);
  const auto stimulus = [&](int index) -> const Stimulus& { return set.manifest.stimuli[index].stimulus; };
  for (int i = 0; i < std::ssize(set.manifest.stimuli); ++i) {
    const auto [found, is_new] = place.insert({stimulus(i).artifact, by_artifact.size()});
    if (is_new) by_artifact.emplace_back();
    by_artifact[found->second].push_back(i);
  }
  for (std::size_t a = 0; a < by_artifact.size(); ++a)
    std::stable_sort(by_artifact[a].begin(), by_artifact[a].end(), [&](int one, int other) {
      const auto rank = [&](int index) {
        const int turn = stimulus(index).object_index + 2 * objects - 1 -
                         static_cast<int>(a % static_cast<std::size_t>(objects));
        return std::pair(towards_less * stimulus(index).level, turn % objects);
      };
      return rank(one) < rank(other);
    });
  return by_artifact;
}

std::vector<int> easiest(const RenderedSet& set, int wanted) {
  const std::vector<std::vector<int>> by_artifact = most_noticeable_first(set);
  std::vector<int> chosen;
  for (std::size_t round = 0;; ++round) {
    const std::size_t before = chosen.size();
    for (const std::vector<int>& stimuli : by_artifact)
      if (round < stimuli.size() && std::ssize(chosen) < wanted) chosen.push_back(stimuli[round]);
    if (chosen.size() == before) return chosen;
  }
}

/// The same of several tasks: as many of each, one task after another.
std::vector<int> shared_out(const RenderedSet& set, std::vector<int> chosen) {
  const std::vector<TaskGroup> groups = task_groups(set.study);
  std::vector<Stimulus> stimuli;
  for (const ManifestStimulus& record : set.manifest.stimuli) stimuli.push_back(record.stimulus);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = twin_in(stimuli, chosen[i], groups[i * groups.size() / chosen.size()].conditions.front());
  return chosen;
}

int index_of(const RenderedSet& set, const std::string& id) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < set.manifest.stimuli.size(); ++i) {
    if (set.manifest.stimuli[i].id == id) return static_cast<int>(i);
    known.push_back(set.manifest.stimuli[i].id);
  }
  const std::string nearest = nearest_word(id, known);
  throw input_error({.file = (set.folder / set.manifest.study_file).string(),
                     .field = "training.stimuli",
                     .wanted = "a stimulus of the set" +
                               (nearest.empty() ? std::string() : "; did you mean \"" + nearest + "\"?"),
                     .found = "\"" + id + "\""});
}

}  // namespace

std::vector<Trial> training_trials(const RenderedSet& set) {
  std::vector<int> stimuli;
  if (set.study.training.stimuli.empty()) stimuli = easiest(set, set.study.training.trials);
  for (const std::string& id : set.study.training.stimuli) stimuli.push_back(index_of(set, id));
  if (has_own_tasks(set.study) && set.study.training.stimuli.empty()) stimuli = shared_out(set, stimuli);
  std::vector<Trial> trials;
  for (const int stimulus : stimuli) trials.push_back({.kind = TrialKind::stimulus, .stimulus = stimulus});
  return trials;
}

}  // namespace seamline::study
