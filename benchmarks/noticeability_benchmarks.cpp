// The analysis of a study of the paper's size: 20 people, 7 widths, 4 artifacts x 3 objects. The time to keep
// under 2 s on two cores is `ten_thousand_replicates` (real time).
#include <benchmark/benchmark.h>

#include "analysis/log_analysis/analysis.h"
#include "analysis/thresholds/guess_correction.h"
#include "study/observers/observer.h"

namespace seamline {
using namespace study;
using namespace analysis;
namespace {

/// Answers of 20 `threshold` observers.
LogContents paper_sized_log() {
  LogContents log;
  for (int p = 0; p < 20; ++p) {
    Random random(1, static_cast<std::uint64_t>(p));
    const Observer observer = make_observer(ObserverKind::threshold, {}, random);
    ParticipantRecord record;
    record.code = "p" + std::to_string(p);
    record.completed = true;
    log.participants.push_back(record);
    for (Artifact artifact : paper_artifacts)
      for (int object = 1; object <= 3; ++object)
        for (int width_px = 64; width_px <= 4096; width_px *= 2) {
          Stimulus stimulus;
          stimulus.artifact = artifact;
          stimulus.object_index = object;
          stimulus.depth.width_px = width_px;
          const Response response = respond(observer, stimulus, random);
          Answer answer;
          answer.participant = record.code;
          answer.artifact = artifact;
          answer.object = "object" + std::to_string(object);
          answer.object_index = object;
          answer.depth_width_px = width_px;
          answer.chosen_index = response.chosen_index;
          answer.rating = response.rating;
          log.answers.push_back(answer);
        }
  }
  return log;
}

/// Thresholds of the four curves with all their intervals, 10,000 replicates each.
void ten_thousand_replicates(benchmark::State& state) {
  const LogContents log = paper_sized_log();
  const NoticeabilityData data = average_answers(log, select_participants(log, false));
  for (auto _ : state)
    for (const ArtifactScores& scores : data.artifacts)
      benchmark::DoNotOptimize(estimate_thresholds(
          scores, {.replicates = 10000, .seed = 1, .threads = static_cast<int>(state.range(0))}));
}
BENCHMARK(ten_thousand_replicates)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The same for the curves corrected for guessing: the latent-class model is fitted to every replicate.
void ten_thousand_corrected_replicates(benchmark::State& state) {
  const LogContents log = paper_sized_log();
  const NoticeabilityData data = average_answers(log, select_participants(log, false));
  const GuessTrials trials = count_guess_trials(log, data, {});
  for (auto _ : state)
    benchmark::DoNotOptimize(correct_for_guessing(
        trials, data, {.replicates = 10000, .seed = 1, .threads = static_cast<int>(state.range(0))}));
}
BENCHMARK(ten_thousand_corrected_replicates)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Everything that `seamline analyze` computes.
void whole_analysis(benchmark::State& state) {
  const LogContents log = paper_sized_log();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        analyze(log, false, {.replicates = 10000, .seed = 1, .threads = static_cast<int>(state.range(0))}));
}
BENCHMARK(whole_analysis)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamline
