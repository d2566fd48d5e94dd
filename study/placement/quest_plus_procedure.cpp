#include "study/placement/quest_plus_procedure.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "study/placement/quest_plus_model.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// One of the items, each as likely.
template <class Item>
Item draw(const std::vector<Item>& items, Random& random) {
  return items[random.below(items.size())];
}

/// The images of a level that may be shown again and have been shown least.
std::vector<int> freshest_images(const QuestPlusProcedure& procedure, const std::vector<int>& images) {
  std::vector<int> freshest;
  int fewest = procedure.design->definition.max_shows_per_image - 1;
  for (const int image : images) {
    const int shows = procedure.shows[image];
    if (shows > fewest) continue;
    if (shows < fewest) freshest.clear();
    fewest = shows;
    freshest.push_back(image);
  }
  return freshest;
}

std::optional<std::size_t> best_level(const QuestPlusProcedure& procedure, std::size_t track) {
  const TrackDesign& design = procedure.design->tracks[track];
  const std::vector<double> expected =
      expected_entropies_nats(*design.tables, procedure.tracks[track].posterior);
  std::optional<std::size_t> best;
  for (std::size_t level = 0; level < expected.size(); ++level)
    if ((!best || expected[level] < expected[*best]) &&
        !freshest_images(procedure, design.images[level]).empty())
      best = level;
  return best;
}

/// Unfinished tracks with the fewest answers.
std::vector<std::size_t> tracks_in_turn(const std::vector<QuestPlusTrack>& tracks) {
  std::vector<std::size_t> turn;
  int fewest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (tracks[i].stopped || tracks[i].answered > fewest) continue;
    if (tracks[i].answered < fewest) turn.clear();
    fewest = tracks[i].answered;
    turn.push_back(i);
  }
  return turn;
}

std::optional<int> next_stimulus(const QuestPlusProcedure& procedure) {
  const std::vector<std::size_t> turn = tracks_in_turn(procedure.tracks);
  if (turn.empty()) return std::nullopt;
  Random random(procedure.seed, procedure.answered);
  const std::size_t track = draw(turn, random);
  const std::size_t level = best_level(procedure, track).value();
  return draw(freshest_images(procedure, procedure.design->tracks[track].images[level]), random);
}

bool has_image_left(const QuestPlusProcedure& procedure, const TrackDesign& track) {
  return std::any_of(track.images.begin(), track.images.end(), [&](const std::vector<int>& images) {
    return !freshest_images(procedure, images).empty();
  });
}

std::optional<StopReason> stop_reason(const QuestPlusProcedure& procedure, const TrackDesign& design,
                                      const QuestPlusTrack& track) {
  const QuestPlusDefinition& definition = procedure.design->definition;
  if (track.answered >= definition.min_trials) {
    const CredibleInterval interval =
        interval95(procedure.design->grid, track.posterior, Parameter::threshold);
    if (definition.stop_interval && interval.high - interval.low <= *definition.stop_interval)
      return StopReason::interval;
    if (definition.stop_entropy_nats && entropy_nats(track.posterior.mass) <= *definition.stop_entropy_nats)
      return StopReason::entropy;
  }
  if (track.answered >= definition.max_trials) return StopReason::trials;
  if (!has_image_left(procedure, design)) return StopReason::images_used;
  return std::nullopt;
}

/// Learns from the answer to a stimulus, without looking for the next.
void take_in(QuestPlusProcedure& procedure, int stimulus, const TrialAnswer& answer) {
  const QuestPlusDesign& design = *procedure.design;
  const TrackPlace& place = design.places[stimulus];
  QuestPlusTrack& track = procedure.tracks[place.track];
  const TrackDesign& track_design = design.tracks[place.track];
  learn(track.posterior, *track_design.tables, place.level,
        outcome_of(design.definition, answer, place.object_index));
  ++track.answered;
  ++procedure.shows[stimulus];
  ++procedure.answered;
  track.stopped = stop_reason(procedure, track_design, track);
}

}  // namespace

std::string_view word(StopReason reason) {
  switch (reason) {
    case StopReason::interval:
      return "interval";
    case StopReason::entropy:
      return "entropy";
    case StopReason::trials:
      return "trials";
    case StopReason::images_used:
      return "images used";
  }
  return {};
}

QuestPlusProcedure begin_quest_plus(std::shared_ptr<const QuestPlusDesign> design, std::uint64_t seed) {
  const QuestPlusTrack fresh{.posterior = prior_posterior(design->grid)};
  QuestPlusProcedure procedure{.design = design,
                               .seed = seed,
                               .tracks = std::vector<QuestPlusTrack>(design->tracks.size(), fresh),
                               .shows = std::vector<int>(design->places.size(), 0),
                               .answered = 0,
                               .due = {}};
  procedure.due = next_stimulus(procedure);
  return procedure;
}

QuestPlusProcedure resume_quest_plus(QuestPlusProcedure procedure, const std::vector<int>& decided,
                                     const std::vector<TrialAnswer>& answers) {
  assert(decided.size() >= answers.size());
  for (std::size_t trial = 0; trial < answers.size(); ++trial)
    take_in(procedure, decided[trial], answers[trial]);
  procedure.due = decided.size() > answers.size() ? decided[answers.size()] : next_stimulus(procedure);
  return procedure;
}

QuestPlusProcedure after_answer(QuestPlusProcedure procedure, const TrialAnswer& answer) {
  assert(procedure.due);
  take_in(procedure, *procedure.due, answer);
  procedure.due = next_stimulus(procedure);
  return procedure;
}

int most_trials(const QuestPlusProcedure& procedure) {
  const QuestPlusDefinition& definition = procedure.design->definition;
  int trials = 0;
  for (std::size_t t = 0; t < procedure.tracks.size(); ++t) {
    const QuestPlusTrack& track = procedure.tracks[t];
    std::size_t images = 0;
    for (const std::vector<int>& at_level : procedure.design->tracks[t].images) images += at_level.size();
    const std::size_t shows = images * static_cast<std::size_t>(definition.max_shows_per_image);
    trials += track.stopped
                  ? track.answered
                  : std::min(definition.max_trials,
                             static_cast<int>(std::min<std::size_t>(shows, std::numeric_limits<int>::max())));
  }
  return trials;
}

}  // namespace seamline::study
