#include "study/trials/catch_trials.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps the draws of catch trials apart from those of the order, which has the same key.
constexpr std::uint64_t catch_salt = 0x6361746368;  // "catch"

/// One stimulus for each thing that a catch trial of a kind can show, in a random order.
std::vector<int> subjects(TrialKind kind, std::span<const Stimulus> set, Random& random) {
  std::set<std::pair<std::string, int>> seen;
  std::vector<int> found;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const int object = kind == TrialKind::attention ? set[i].object_index : 0;
    if (seen.insert({truth_of(set[i]), object}).second) found.push_back(static_cast<int>(i));
  }
  shuffle(std::span<int>(found), random);
  return found;
}

/// A place in each of `count` equal stretches of 1 .. `last`.
std::vector<int> places(int count, int last, Random& random) {
  std::vector<int> places;
  for (int i = 0; i < count; ++i) {
    const int from = i * last / count;
    const int to = std::max(from + 1, (i + 1) * last / count);
    places.push_back(1 + from + static_cast<int>(random.below(to - from)));
  }
  return places;
}

}  // namespace

std::vector<CatchTrial> draw_catch_trials(const CatchDefinition& definition, std::span<const Stimulus> set,
                                          int stimulus_trials, const OrderKey& key) {
  const int count = definition.attention + definition.reference;
  if (count == 0 || stimulus_trials == 0 || set.empty()) return {};
  Random random(mix_bits(key.study_seed ^ catch_salt), key.slot);
  std::vector<TrialKind> kinds(count, TrialKind::attention);
  std::fill(kinds.begin() + definition.attention, kinds.end(), TrialKind::reference);
  shuffle(std::span<TrialKind>(kinds), random);
  const std::vector<int> attention = subjects(TrialKind::attention, set, random);
  const std::vector<int> reference = subjects(TrialKind::reference, set, random);
  const std::vector<int> after = places(count, std::max(1, stimulus_trials - 1), random);
  std::vector<CatchTrial> catches;
  std::size_t attentions = 0, references = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const int stimulus = kinds[i] == TrialKind::attention ? attention[attentions++ % attention.size()]
                                                          : reference[references++ % reference.size()];
    catches.push_back({.after_stimulus_trials = after[i], .trial = {.kind = kinds[i], .stimulus = stimulus}});
  }
  return catches;
}

std::vector<Trial> interleave(std::span<const int> order, std::span<const CatchTrial> catches) {
  std::vector<Trial> trials;
  auto next = catches.begin();
  for (std::size_t i = 0; i <= order.size(); ++i) {
    for (; next != catches.end() && next->after_stimulus_trials <= static_cast<int>(i); ++next)
      trials.push_back(next->trial);
    if (i < order.size()) trials.push_back({.kind = TrialKind::stimulus, .stimulus = order[i]});
  }
  return trials;
}

std::vector<CatchTrial> catch_trials_of(std::span<const Trial> trials) {
  std::vector<CatchTrial> catches;
  int stimuli = 0;
  for (const Trial& trial : trials) {
    if (trial.kind == TrialKind::stimulus)
      ++stimuli;
    else
      catches.push_back({.after_stimulus_trials = stimuli, .trial = trial});
  }
  return catches;
}

}  // namespace seamline::study
