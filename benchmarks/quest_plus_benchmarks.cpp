// The next choice of QUEST+ on 41 stimuli and a grid of 41 thresholds, 9 scales and 5 lapses. The questplus
// package needs 22.8 ms for it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "study/placement/quest_plus_model.h"

namespace seamline {
using namespace study;
namespace {

struct Track {
  QuestPlusDefinition definition;
  QuestPlusGrid grid;
  QuestPlusTables tables;
  QuestPlusPosterior posterior;
};

Track make_track(PlacementOutcome outcome, int rating_steps) {
  QuestPlusDefinition definition;
  definition.outcome = outcome;
  definition.threshold = {32, 8192, 41};
  definition.scale = {0.125, 2, 9};
  definition.lapse = {0, 0.08, 5};
  definition.rating_step = {0.25, rating_steps == 1 ? 0.25 : 1, rating_steps};
  std::vector<int> width_px;
  for (int i = 0; i < 41; ++i)
    width_px.push_back(2 * static_cast<int>(std::lround(32 * std::exp2(i * 0.15))));
  const QuestPlusGrid grid = make_grid(definition);
  Track track{.definition = definition,
              .grid = grid,
              .tables = make_level_tables(definition, grid, {width_px.begin(), width_px.end()}),
              .posterior = uniform_posterior(grid.points())};
  for (int trial = 0; trial < 10; ++trial) learn(track.posterior, track.tables, 15 + trial, trial % 2);
  return track;
}

int choice(const Track& track) {
  const std::vector<double> expected = expected_entropies_nats(track.tables, track.posterior);
  return static_cast<int>(std::min_element(expected.begin(), expected.end()) - expected.begin());
}

void choose(benchmark::State& state, PlacementOutcome outcome, int rating_steps) {
  const Track track = make_track(outcome, rating_steps);
  for (auto _ : state) benchmark::DoNotOptimize(choice(track));
}

void quest_plus_choice(benchmark::State& state) {
  choose(state, PlacementOutcome::correct, 1);
}
BENCHMARK(quest_plus_choice)->Unit(benchmark::kMicrosecond);

/// Five outcomes on the same grid, and on one four times as large, with an unknown rating step.
void quest_plus_choice_ordinal(benchmark::State& state) {
  choose(state, PlacementOutcome::noticeability, static_cast<int>(state.range(0)));
}
BENCHMARK(quest_plus_choice_ordinal)->Arg(1)->Arg(4)->Unit(benchmark::kMicrosecond);

/// What a trial costs: the answer is learnt, and the next stimulus chosen.
void quest_plus_trial(benchmark::State& state) {
  Track track = make_track(PlacementOutcome::correct, 1);
  for (auto _ : state) {
    const int stimulus = choice(track);
    learn(track.posterior, track.tables, stimulus, stimulus % 2);
  }
}
BENCHMARK(quest_plus_trial)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace seamline
