#include "study/placement/quest_plus_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "study/placement/psychometric_function.h"

namespace seamline::study {

double width_px_of(Axis axis, double on_axis) {
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
                                          int point, double width_px) {
  PsychometricFunction person{
      .sigmoid = definition.sigmoid,
      .axis = definition.axis,
      .direction = definition.direction,
      .threshold = width_px_of(definition.axis, grid.value(Parameter::threshold, point)),
      .scale = grid.value(Parameter::scale, point),
      .guess = grid.value(Parameter::guess, point),
      .lapse = grid.value(Parameter::lapse, point)};
  const double seen = response_probability(person, width_px);
  if (definition.outcome == PlacementOutcome::correct) return {1 - seen, seen};

  std::vector<double> at_least = {1, seen};  // k = 0, 1, ..., 4 and, at the end, 0
  person.lapse /= 1 - person.guess;
  person.guess = 0;
  const double threshold_px = person.threshold;
  const double towards_more = definition.direction == Direction::decreasing ? -1 : 1;
  const double step = towards_more * grid.value(Parameter::rating_step, point);
  for (int rating = 2; rating <= highest_rating; ++rating) {
    person.threshold = definition.axis == Axis::log2 ? threshold_px * std::exp2((rating - 1) * step)
                                                     : threshold_px + (rating - 1) * step;
    at_least.push_back(response_probability(person, width_px));
  }
  at_least.push_back(0);
  std::vector<double> probability;
  for (std::size_t k = 0; k + 1 < at_least.size(); ++k)
    probability.push_back(std::max(0.0, at_least[k] - at_least[k + 1]));
  return probability;
}

QuestPlusTables make_width_tables(const QuestPlusDefinition& definition, const QuestPlusGrid& grid,
                                  const std::vector<int>& width_px) {
  return make_quest_plus_tables(static_cast<int>(width_px.size()), outcome_count(definition), grid.points(),
                                [&](int stimulus, int point) {
                                  return outcome_probabilities(definition, grid, point,
                                                               width_px[static_cast<std::size_t>(stimulus)]);
                                });
}

}  // namespace seamline::study
