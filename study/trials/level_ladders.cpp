#include "study/trials/level_ladders.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keep the draws of starts, and the orders of later repetitions, apart from other draws of the same key.
constexpr std::uint64_t start_salt = 0x6d61746368;  // "match"

bool is_on_a_ladder(const Stimulus& stimulus) {
  return facts(stimulus.quantity).axis == Axis::linear || stimulus.level > 0;
}

const std::vector<int>& ladder_of(const LevelLadders& ladders, int stimulus) {
  const LevelLadders::Place& place = ladders.places.at(stimulus);
  return ladders.ladders.at(place.ladder);
}

void sort_rungs(LevelLadders& ladders, const std::vector<Stimulus>& stimuli, Direction noticeability) {
  const double towards_less = noticeability == Direction::decreasing ? 1 : -1;
  const auto level = [&](int stimulus) { return towards_less * stimuli[stimulus].level; };
  for (std::vector<int>& ladder : ladders.ladders) {
    std::stable_sort(ladder.begin(), ladder.end(), [&](int a, int b) { return level(a) < level(b); });
    for (std::size_t rung = 0; rung < ladder.size(); ++rung)
      ladders.places[ladder[rung]].rung = static_cast<int>(rung);
  }
}

int drawn_start(const std::vector<int>& ladder, bool clear, Random& random) {
  const std::size_t half = std::max<std::size_t>(1, ladder.size() / 2);
  const auto rung = random.below(half);
  return clear ? ladder[rung] : ladder[ladder.size() - 1 - rung];
}

}  // namespace

LevelLadders make_level_ladders(const std::vector<Stimulus>& stimuli, Direction noticeability) {
  LevelLadders ladders{
      .ladders = {}, .curves = {}, .places = std::vector<LevelLadders::Place>(stimuli.size())};
  std::map<std::tuple<Artifact, std::string, std::string, std::string>, int> ladder_of;
  std::map<std::pair<Artifact, std::string>, int> curve_of;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i];
    if (!is_on_a_ladder(stimulus)) continue;
    const auto [found, is_new] =
        ladder_of.try_emplace({stimulus.artifact, stimulus.condition, stimulus.scene, stimulus.object},
                              static_cast<int>(ladders.ladders.size()));
    if (is_new) {
      ladders.ladders.emplace_back();
      ladders.curves.push_back(
          curve_of.try_emplace({stimulus.artifact, stimulus.condition}, static_cast<int>(curve_of.size()))
              .first->second);
    }
    ladders.ladders[found->second].push_back(static_cast<int>(i));
    ladders.places[i].ladder = found->second;
  }
  sort_rungs(ladders, stimuli, noticeability);
  return ladders;
}

std::optional<int> next_rung(const LevelLadders& ladders, int stimulus, int rungs) {
  const std::vector<int>& ladder = ladder_of(ladders, stimulus);
  const int rung = ladders.places[stimulus].rung + rungs;
  if (rung < 0 || rung >= std::ssize(ladder)) return std::nullopt;
  return ladder[rung];
}

std::vector<Trial> pictures_of_ladder(const LevelLadders& ladders, const Trial& trial) {
  std::vector<Trial> pictures;
  for (const int stimulus : ladder_of(ladders, trial.stimulus))
    pictures.push_back({.kind = trial.kind, .stimulus = stimulus});
  return pictures;
}

std::vector<int> match_starts(const LevelLadders& ladders, int repetitions, const OrderKey& key) {
  std::vector<int> number_in_curve, ladders_of_curve(ladders.ladders.size(), 0);
  for (const int curve : ladders.curves) number_in_curve.push_back(ladders_of_curve[curve]++);
  std::vector<int> starts;
  for (int r = 0; r < repetitions; ++r) {
    const std::uint64_t seed = mix_bits(key.study_seed ^ start_salt) + r;
    Random random(mix_bits(seed), key.slot);
    for (const int l :
         stimulus_order(static_cast<int>(ladders.ladders.size()), {.study_seed = seed, .slot = key.slot})) {
      const std::size_t ladder = l;
      const bool clear = (r + number_in_curve[ladder] + key.slot) % 2 == 0;
      starts.push_back(drawn_start(ladders.ladders[ladder], clear, random));
    }
  }
  return starts;
}

bool begins_clear(const LevelLadders& ladders, int stimulus) {
  const std::vector<int>& ladder = ladder_of(ladders, stimulus);
  return 2 * ladders.places[stimulus].rung + 1 < std::ssize(ladder);
}

}  // namespace seamline::study
