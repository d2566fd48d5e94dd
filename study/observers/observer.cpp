#include "study/observers/observer.h"

#include <fmt/core.h>

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "study/placement/psychometric_function.h"
#include "study/placement/sigmoid_shape.h"
#include "study/placement/trial.h"
#include "support/running/overloaded.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

/// The study file's key of a midpoint.
std::string midpoint_key(const LevelPlace& place, bool of_condition) {
  std::string table = place.quantity == Quantity::depth_width_px ? "midpoint_width_px" : "midpoint";
  if (of_condition) table = "condition_midpoint." + place.condition;
  return "observer." + table + "." + std::string(word(place.artifact));
}

double midpoint_of(const ObserverDefinition& definition, const LevelPlace& place) {
  const auto own = definition.condition_midpoint.find(place.condition);
  const bool of_condition = own != definition.condition_midpoint.end();
  const std::map<Artifact, double>& midpoints = of_condition ? own->second : definition.midpoint;
  if (const auto found = midpoints.find(place.artifact); found != midpoints.end()) return found->second;
  const std::string unit(facts(place.quantity).unit);
  throw input_error({.field = midpoint_key(place, of_condition),
                     .wanted = fmt::format("the {} at which the artifact {} is seen half of the time{}",
                                           facts(place.quantity).name, word(place.artifact),
                                           unit.empty() ? "" : ", in " + unit),
                     .found = "none"});
}

double gain_of(const ObserverDefinition& definition) {
  if (definition.image_gain) return *definition.image_gain;
  throw input_error({.field = "observer.image_gain",
                     .wanted = "a gain for the observer image (seamline predict SET prints one)",
                     .found = "none"});
}

/// P(seen) of the person whose shift is 0.
PsychometricFunction average_person(const ObserverDefinition& definition, const LevelPlace& place) {
  const Axis axis = facts(place.quantity).axis;
  return {.sigmoid = Sigmoid::logistic,
          .axis = axis,
          .direction = definition.direction,
          .threshold = midpoint_of(definition, place),
          .scale = axis == Axis::log2 ? definition.scale_octaves : definition.scale_linear};
}

/// P(seen) of everybody at a level that stands apart, at minus infinity.
double seen_apart(const ObserverDefinition& definition) {
  return definition.direction == Direction::decreasing ? 1 : 0;
}

Response guess(const Alternatives& alternatives, Random& random) {
  if (alternatives.false_alarms)
    return {.chosen_index = random.uniform() < *alternatives.false_alarms ? 1 : 2, .rating = 1};
  return {.chosen_index = 1 + static_cast<int>(random.below(alternatives.count)), .rating = 1};
}

/// The answer of a person who sees the seam of this stimulus with probability `seen`.
Response seeing_response(double seen, const Alternatives& alternatives, Random& random) {
  if (random.uniform() >= seen) return guess(alternatives, random);
  return {.chosen_index = alternatives.right, .rating = 1 + random.binomial(highest_rating - 1, seen)};
}

double seen_by(const ThresholdObserver& observer, const Stimulus& stimulus) {
  const LevelPlace place = place_of(stimulus);
  PsychometricFunction person = average_person(observer.definition, place);
  if (stands_apart(person.axis, place.level)) return seen_apart(observer.definition);
  if (person.axis == Axis::log2)
    person.threshold *= std::exp2(observer.shift_octaves);
  else
    person.threshold += observer.shift_linear;
  return response_probability(person, place.level);
}

double seen_by(const ImageObserver& observer, const Stimulus& stimulus) {
  const std::string id = stimulus_id(stimulus);
  const auto found = observer.differences->find(id);
  if (found == observer.differences->end())
    throw input_error({.field = id, .wanted = "a picture to look at", .found = "none in the set"});
  const double visible_octaves = std::log2(gain_of(observer.definition) * found->second.above_floor);
  const double z = (visible_octaves + observer.shift_octaves) / observer.definition.scale_octaves;
  return sigmoid_value(Sigmoid::logistic, z);
}

double log_odds(double probability) {
  return std::log(probability) - std::log1p(-probability);
}

/// Mean noticeability of a person who sees with probability P.
double expected_score(double seen) {
  return seen * (1 + (highest_rating - 1) * seen) + (1 - seen) / objects_per_stimulus;
}

/// Its derivative with respect to u, where P = 1 / (1 + exp(-u)).
double expected_score_slope(double seen) {
  return (1 + 2 * (highest_rating - 1) * seen - 1.0 / objects_per_stimulus) * seen * (1 - seen);
}

// The mean over people, two ways. A person at z standard deviations sees with P = logistic(u), u = (z - z0) /
// r, where z0 is the person whose threshold is the width in question and r = scale / sd. Both are trapezoidal
// sums of functions that are analytic in a strip of half width pi and die off at both ends, so their error
// falls as exp(-2 pi^2 / step).

/// Smooth in z when r >= 1: integral of phi(z) G(P(z)) dz.
double mean_over_people_direct(double z0, double r) {
  constexpr double step = 0.125, cut = 9;
  double sum = 0;
  for (double z = -cut; z <= cut; z += step)
    sum += std::exp(-0.5 * z * z) * expected_score(sigmoid_value(Sigmoid::logistic, (z - z0) / r));
  return sum * step / std::sqrt(2 * std::numbers::pi);
}

/// For steep observers, r <= 1, integrated by parts: G(1) - integral of Phi(z0 + r u) G'(u) du.
double mean_over_people_by_parts(double z0, double r) {
  constexpr double step = 0.25, cut = 45;
  double sum = 0;
  for (double u = -cut; u <= cut; u += step)
    sum += sigmoid_value(Sigmoid::normal, z0 + r * u) *
           expected_score_slope(sigmoid_value(Sigmoid::logistic, u));
  return expected_score(1) - sum * step;
}

/// How people differ, on one axis.
struct Spread {
  double scale = 0, sd = 0;
};

Spread spread_on(const ObserverDefinition& definition, Axis axis) {
  return axis == Axis::log2 ? Spread{definition.scale_octaves, definition.people_sd_octaves}
                            : Spread{definition.scale_linear, definition.people_sd_linear};
}

/// The mean over people of whom the average one sees with P = logistic(-distance / scale), and the others
/// differ by a shift of the distance.
double mean_over_people(const Spread& spread, double past_midpoint) {
  const auto [scale, sd] = spread;
  if (sd <= 0) return expected_score(sigmoid_value(Sigmoid::logistic, -past_midpoint / scale));
  const double threshold_z = past_midpoint / sd;
  const double relative_scale = scale / sd;
  return relative_scale > 1 ? mean_over_people_direct(threshold_z, relative_scale)
                            : mean_over_people_by_parts(threshold_z, relative_scale);
}

}  // namespace

std::string_view word(ObserverKind kind) {
  switch (kind) {
    case ObserverKind::threshold:
      return "threshold";
    case ObserverKind::image:
      return "image";
    case ObserverKind::guesser:
      return "guesser";
    case ObserverKind::perfect:
      return "perfect";
  }
  return {};
}

std::optional<ObserverKind> observer_kind_from_word(std::string_view text) {
  for (const ObserverKind kind : every_observer_kind)
    if (word(kind) == text) return kind;
  return std::nullopt;
}

Observer make_observer(ObserverKind kind, const ObserverDefinition& definition, Random& random,
                       std::shared_ptr<const VisibleDifferences> differences) {
  switch (kind) {
    case ObserverKind::threshold: {
      const double shift_sd = random.normal();
      return ThresholdObserver{.definition = definition,
                               .shift_octaves = definition.people_sd_octaves * shift_sd,
                               .shift_linear = definition.people_sd_linear * shift_sd};
    }
    case ObserverKind::image:
      assert(differences != nullptr);
      return ImageObserver{.definition = definition,
                           .differences = std::move(differences),
                           .shift_octaves = definition.people_sd_octaves * random.normal()};
    case ObserverKind::guesser:
      return GuessingObserver{};
    case ObserverKind::perfect:
      return PerfectObserver{};
  }
  return {};
}

Alternatives alternatives_of(const TaskFacts& task, const Trial& trial, int object_index) {
  const int right = trial.kind == TrialKind::reference ? 0 : object_index;
  if (task.right_is_yes)
    return {
        .count = 2, .right = trial.right_index, .false_alarms = task.chooses ? simulated_false_alarms : 0.0};
  return {.count = task.alternatives, .right = trial.right_index != 0 ? trial.right_index : right};
}

Response respond(const Observer& observer, const Stimulus& stimulus, Random& random) {
  return respond(observer, stimulus, Alternatives{.right = stimulus.object_index}, random);
}

Response respond(const Observer& observer, const Stimulus& stimulus, const Alternatives& alternatives,
                 Random& random) {
  return std::visit(Overloaded{[&](const ThresholdObserver& person) {
                                 return seeing_response(seen_by(person, stimulus), alternatives, random);
                               },
                               [&](const ImageObserver& person) {
                                 return seeing_response(seen_by(person, stimulus), alternatives, random);
                               },
                               [&](const GuessingObserver&) { return guess(alternatives, random); },
                               [&](const PerfectObserver&) {
                                 return Response{.chosen_index = alternatives.right,
                                                 .rating = highest_rating};
                               }},
                    observer);
}

double seen_probability(const Observer& observer, const Stimulus& stimulus) {
  return std::visit(
      Overloaded{[&](const ThresholdObserver& person) { return seen_by(person, stimulus); },
                 [&](const ImageObserver& person) { return seen_by(person, stimulus); },
                 [](const GuessingObserver&) { return 0.0; }, [](const PerfectObserver&) { return 1.0; }},
      observer);
}

std::size_t matched_rung(const Observer& observer, const std::vector<Stimulus>& ladder, Random& random) {
  if (std::holds_alternative<GuessingObserver>(observer)) return random.below(ladder.size());
  const double z = log_odds(random.uniform());
  std::size_t seen = 0;  // the faintest rung of those from the first on at which the seam is seen
  std::vector<double> odds;
  for (const Stimulus& stimulus : ladder) odds.push_back(log_odds(seen_probability(observer, stimulus)));
  if (odds.front() < z) return 0;
  while (seen + 1 < odds.size() && odds[seen + 1] >= z) ++seen;
  if (seen + 1 == odds.size()) return seen;
  return z - odds[seen + 1] < odds[seen] - z ? seen + 1 : seen;
}

Response respond_to_attention(const Observer& observer, int right_index, Random& random) {
  return respond_to_attention(observer, Alternatives{.right = right_index}, random);
}

Response respond_to_attention(const Observer& observer, const Alternatives& alternatives, Random& random) {
  const Response seen{.chosen_index = alternatives.right, .rating = highest_rating};
  return std::visit(
      Overloaded{[&](const ThresholdObserver&) { return seen; }, [&](const ImageObserver&) { return seen; },
                 [&](const GuessingObserver&) { return guess(alternatives, random); },
                 [&](const PerfectObserver&) { return seen; }},
      observer);
}

Response respond_to_reference(Random& random) {
  return guess({}, random);
}

Response respond_to_reference(const Alternatives& alternatives, Random& random) {
  return guess(alternatives, random);
}

LevelPlace place_of(const Stimulus& stimulus) {
  return {.artifact = stimulus.artifact,
          .condition = stimulus.condition,
          .quantity = stimulus.quantity,
          .level = stimulus.level};
}

double expected_noticeability(const ObserverDefinition& definition, const LevelPlace& place) {
  const double midpoint = midpoint_of(definition, place);
  const Axis axis = facts(place.quantity).axis;
  if (stands_apart(axis, place.level)) return expected_score(seen_apart(definition));
  const double past_midpoint =
      axis == Axis::log2 ? std::log2(place.level) - std::log2(midpoint) : place.level - midpoint;
  // Shifts to either side are as likely, so who sees more with the level is the mirror image.
  return mean_over_people(spread_on(definition, axis),
                          definition.direction == Direction::decreasing ? past_midpoint : -past_midpoint);
}

double expected_noticeability(const ObserverDefinition& definition, Artifact artifact, double width_px) {
  return expected_noticeability(definition, LevelPlace{.artifact = artifact, .level = width_px});
}

void require_image_gain(const ObserverDefinition& definition) {
  static_cast<void>(gain_of(definition));
}

double expected_noticeability_of_difference(const ObserverDefinition& definition, double visible_difference) {
  return mean_over_people(spread_on(definition, Axis::log2),
                          -std::log2(gain_of(definition) * visible_difference));
}

}  // namespace seamline::study
