#include "study/placement/quest_plus_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "study/placement/psychometric_function.h"

namespace seamline::study {

double level_of(Axis axis, double on_axis) {
  return axis == Axis::log2 ? std::exp2(on_axis) : on_axis;
}

int outcome_count(const QuestPlusDefinition& definition) {
  switch (definition.outcome) {
    case PlacementOutcome::correct:
      return 2;
    case PlacementOutcome::noticeability:
    case PlacementOutcome::joint:
      return highest_rating + 1;
  }
  return {};
}

int outcome_of(const QuestPlusDefinition& definition, const TrialAnswer& answer, int object_index) {
  const bool correct = answer.chosen_index == object_index;
  switch (definition.outcome) {
    case PlacementOutcome::correct:
      return correct ? 1 : 0;
    case PlacementOutcome::noticeability:
    case PlacementOutcome::joint:
      return correct ? answer.rating : 0;
  }
  return {};
}

namespace {

/// The place on the axis moved by `distance` to where more is noticed.
double moved_level(const QuestPlusDefinition& definition, double threshold_level, double distance) {
  const double step = definition.direction == Direction::decreasing ? -distance : distance;
  return definition.axis == Axis::log2 ? threshold_level * std::exp2(step) : threshold_level + step;
}

std::vector<double> joint_probabilities(const QuestPlusDefinition& definition, const QuestPlusGrid& grid,
                                        int point, double level) {
  PsychometricFunction person{.sigmoid = definition.sigmoid,
                              .axis = definition.axis,
                              .direction = definition.direction,
                              .threshold = level_of(definition.axis, grid.value(Parameter::threshold, point)),
                              .scale = grid.value(Parameter::scale, point),
                              .guess = 0,
                              .lapse = grid.value(Parameter::lapse, point)};
  const double guess = grid.value(Parameter::guess, point);
  const double seen = response_probability(person, level), guessed = (1 - seen) * guess;
  std::vector<double> probability = {(1 - seen) * (1 - guess)};
  const double rarer = grid.value(Parameter::guess_rating, point);
  double share = 1, sum = 0;
  for (int rating = 1; rating <= highest_rating; ++rating, share *= rarer) sum += share;
  person.lapse = 0;
  const double threshold = person.threshold;
  double above = 1;  // P(R >= rating | seen)
  share = 1 / sum;
  for (int rating = 1; rating <= highest_rating; ++rating, share *= rarer) {
    person.threshold = moved_level(definition, threshold,
                                   grid.value(Parameter::first_rating, point) * person.scale +
                                       (rating - 1) * grid.value(Parameter::rating_step, point));
    const double next = rating == highest_rating ? 0 : response_probability(person, level);
    probability.push_back(seen * std::max(0.0, above - next) + guessed * share);
    above = next;
  }
  return probability;
}

}  // namespace

std::vector<double> outcome_probabilities(const QuestPlusDefinition& definition, const QuestPlusGrid& grid,
                                          int point, double level) {
  if (definition.outcome == PlacementOutcome::joint)
    return joint_probabilities(definition, grid, point, level);
  PsychometricFunction person{.sigmoid = definition.sigmoid,
                              .axis = definition.axis,
                              .direction = definition.direction,
                              .threshold = level_of(definition.axis, grid.value(Parameter::threshold, point)),
                              .scale = grid.value(Parameter::scale, point),
                              .guess = grid.value(Parameter::guess, point),
                              .lapse = grid.value(Parameter::lapse, point)};
  const double seen = response_probability(person, level);
  if (definition.outcome == PlacementOutcome::correct) return {1 - seen, seen};

  std::vector<double> at_least = {1, seen};  // k = 0, 1, ..., 4 and, at the end, 0
  person.lapse /= 1 - person.guess;
  person.guess = 0;
  const double threshold = person.threshold;
  const double step = grid.value(Parameter::rating_step, point);
  for (int rating = 2; rating <= highest_rating; ++rating) {
    person.threshold = moved_level(definition, threshold, (rating - 1) * step);
    at_least.push_back(response_probability(person, level));
  }
  at_least.push_back(0);
  std::vector<double> probability;
  for (std::size_t k = 0; k + 1 < at_least.size(); ++k)
    probability.push_back(std::max(0.0, at_least[k] - at_least[k + 1]));
  return probability;
}

QuestPlusTables make_level_tables(const QuestPlusDefinition& definition, const QuestPlusGrid& grid,
                                  const std::vector<double>& levels) {
  return make_quest_plus_tables(static_cast<int>(levels.size()), outcome_count(definition), grid.points(),
                                [&](int stimulus, int point) {
                                  return outcome_probabilities(definition, grid, point, levels[stimulus]);
                                });
}

}  // namespace seamline::study
