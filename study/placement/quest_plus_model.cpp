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
      return correct ? answer.rating : 0;
  }
  return {};
}

std::vector<double> outcome_probabilities(const QuestPlusDefinition& definition, const QuestPlusGrid& grid,
                                          int point, double level) {
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
  const double towards_more = definition.direction == Direction::decreasing ? -1 : 1;
  const double step = towards_more * grid.value(Parameter::rating_step, point);
  for (int rating = 2; rating <= highest_rating; ++rating) {
    person.threshold = definition.axis == Axis::log2 ? threshold * std::exp2((rating - 1) * step)
                                                     : threshold + (rating - 1) * step;
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
                                  return outcome_probabilities(definition, grid, point,
                                                               levels[static_cast<std::size_t>(stimulus)]);
                                });
}

}  // namespace seamline::study
