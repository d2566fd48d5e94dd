#include "analysis/foresight/assumed_people.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "analysis/thresholds/planted_noticeability.h"
#include "study/placement/psychometric_function.h"
#include "study/placement/sigmoid_shape.h"
#include "study/placement/trial.h"

namespace seamline::analysis {
namespace {

using study::highest_rating;

/// Lengths in x of LevelAxis, which octaves are, and the unit of a linear axis is not.
struct SpreadInX {
  double scale = 0, people = 0, criteria = 0;
};

SpreadInX spread_in_x(const PlannedPopulation& population) {
  const ObserverDefinition& observer = population.observer;
  const AssumedPeople& assumed = population.assumed;
  const bool linear = is_linear(population.axis);
  const double unit = linear ? population.axis.unit : 1;
  const double people = linear ? observer.people_sd_linear : observer.people_sd_octaves;
  return {.scale = (linear ? observer.scale_linear : observer.scale_octaves) / unit,
          .people = std::hypot(people, assumed.artifact_sd) / unit,
          .criteria = assumed.criteria_sd / unit};
}

/// The mean of a function of a normal deviate, which varies over `narrowest` or more: a trapezoidal sum,
/// whose error is exp(-2 pi^2 / step) of what is analytic in a strip of half width pi.
template <class Value>
Value normal_mean(double sd, double narrowest, Value zero,
                  const std::function<Value(double deviation)>& value) {
  if (sd <= 0) return value(0);
  constexpr double reach = 7;
  const double step = 0.5 * std::min(1.0, narrowest / sd);
  const int half = static_cast<int>(std::ceil(reach / step));
  Value sum = std::move(zero);
  double weights = 0;
  for (int i = -half; i <= half; ++i) {
    const double z = step * i, weight = std::exp(-0.5 * z * z);
    sum += weight * value(sd * z);
    weights += weight;
  }
  return sum / weights;
}

double falling(double past) {
  return study::sigmoid_value(Sigmoid::logistic, -past);
}

/// What one person's answers are worth on average.
double person_mean(const PlannedPopulation& population, double seen, double rated, JointMean mean) {
  const AssumedPeople& assumed = population.assumed;
  const double looks_and_sees = (1 - assumed.lapse) * seen;
  const bool rates = population.task.facts.rates && mean != JointMean::detected;
  const double by_sight = looks_and_sees * (rates ? 1 + (highest_rating - 1) * rated : 1);
  if (mean != JointMean::as_counted) return by_sight;
  return by_sight + (1 - looks_and_sees) * (1 + assumed.high_guesses) * population.task.chance();
}

using Shares = Eigen::Vector<double, 2 * highest_rating>;

/// Of one person: 1 + Binomial(3, rated) of what is seen, and guesses.
Shares person_shares(const PlannedPopulation& population, double seen, double rated) {
  const AssumedPeople& assumed = population.assumed;
  const double sees = (1 - assumed.lapse) * seen, not_rated = 1 - rated;
  Shares shares = Shares::Zero();
  shares[0] = not_rated * not_rated * not_rated;
  shares[1] = 3 * rated * not_rated * not_rated;
  shares[2] = 3 * rated * rated * not_rated;
  shares[3] = rated * rated * rated;
  shares *= sees;
  const double guesses = 1 - sees, right = population.task.chance();
  // "No" has no rating.
  const double wrong_high = population.task.facts.right_is_yes ? 0 : assumed.high_guesses;
  shares[0] += guesses * right * (1 - assumed.high_guesses);
  shares[1] += guesses * right * assumed.high_guesses;
  shares[highest_rating] = guesses * (1 - right) * (1 - wrong_high);
  shares[highest_rating + 1] = guesses * (1 - right) * wrong_high;
  return shares;
}

std::string midpoints_text(const LevelAxis& axis, const std::vector<PlannedCurve>& curves) {
  std::vector<std::string> midpoints;
  for (const PlannedCurve& curve : curves)
    midpoints.push_back(fmt::format("{} {}", name_of(curve), estimated_text(axis, curve.midpoint)));
  return fmt::format("{}", fmt::join(midpoints, ", "));
}

/// What people do who see the seam, and who do not.
std::string answers_text(const PlannedTask& task) {
  const TaskFacts& facts = task.facts;
  const std::string rates = facts.rates ? " and rates 1 + Binomial(3, P(seen))" : "";
  if (!facts.right_is_yes) {
    return fmt::format("who sees chooses right{}; who does not guesses one of {}{}", rates,
                       number_word(facts.alternatives), facts.rates ? " and rates 1" : "");
  }
  const std::string not_seen = facts.chooses ? "no" : "the lowest label";
  return fmt::format("who sees {}{}; who does not answers {}{}",
                     facts.chooses ? "says yes" : "chooses a higher label", rates, not_seen,
                     task.false_alarms > 0
                         ? fmt::format(", but in {:g} % of the trials {}", 100 * task.false_alarms,
                                       facts.chooses ? "yes" : "the next one")
                         : "");
}

}  // namespace

std::string name_of(const PlannedCurve& curve) {
  return std::string(word(curve.artifact)) + (curve.condition.empty() ? "" : " in " + curve.condition);
}

PlannedPerson draw_person(const PlannedPopulation& population, std::size_t curves, Random& random) {
  const ObserverDefinition& observer = population.observer;
  const AssumedPeople& assumed = population.assumed;
  const bool linear = is_linear(population.axis);
  PlannedPerson person{
      .shift = (linear ? observer.people_sd_linear : observer.people_sd_octaves) * random.normal(),
      .scale = linear ? observer.scale_linear : observer.scale_octaves,
      .curve_shift = {}};
  if (assumed.slope_sd > 0) person.scale *= std::exp(assumed.slope_sd * random.normal());
  if (assumed.criteria_sd > 0) person.rating_shift = assumed.criteria_sd * random.normal();
  if (assumed.artifact_sd > 0)
    for (std::size_t curve = 0; curve < curves; ++curve)
      person.curve_shift.push_back(assumed.artifact_sd * random.normal());
  return person;
}

PlannedAnswer guess_of(const PlannedPopulation& population, std::uint64_t place, Random& random) {
  const AssumedPeople& assumed = population.assumed;
  const TaskFacts& task = population.task.facts;
  const bool right = task.right_is_yes ? random.uniform() < population.task.false_alarms
                                       : random.below(task.alternatives) == place;
  const bool high = assumed.high_guesses > 0 && random.uniform() < assumed.high_guesses;
  return {.right = right, .rating = high && (right || !task.right_is_yes) ? 2 : 1};
}

PlannedAnswer answer_of(const PlannedPopulation& population, const PlannedPerson& person,
                        const std::vector<PlannedCurve>& curves, std::size_t curve, double level,
                        std::uint64_t place, Random& random) {
  const AssumedPeople& assumed = population.assumed;
  const Axis axis = facts(population.axis.quantity).axis;
  const double own = person.shift + (person.curve_shift.empty() ? 0 : person.curve_shift[curve]);
  const auto probability = [&](double shift) {
    study::PsychometricFunction function{.sigmoid = Sigmoid::logistic,
                                         .axis = axis,
                                         .direction = population.observer.direction,
                                         .threshold = curves[curve].midpoint,
                                         .scale = person.scale};
    function.threshold =
        axis == Axis::log2 ? function.threshold * std::exp2(shift) : function.threshold + shift;
    return study::response_probability(function, level);
  };
  const bool looks = assumed.lapse <= 0 || random.uniform() >= assumed.lapse;
  const double seen = probability(own);
  if (!looks || random.uniform() >= seen) return guess_of(population, place, random);
  const double rated = assumed.criteria_sd > 0 ? probability(own + person.rating_shift) : seen;
  const int rating = 1 + random.binomial(highest_rating - 1, rated);
  return {.right = true, .rating = population.task.facts.rates ? rating : 1};
}

double mean_noticeability(const PlannedPopulation& population, const PlannedCurve& curve, double x,
                          JointMean mean) {
  const AssumedPeople& assumed = population.assumed;
  const SpreadInX spread = spread_in_x(population);
  const double past_x = x - x_of(population.axis, curve.midpoint);
  return normal_mean<double>(assumed.slope_sd, 1, 0, [&](double log_ratio) {
    const double scale = spread.scale * std::exp(log_ratio);
    return normal_mean<double>(spread.people, scale, 0, [&](double shift) {
      const double seen = falling((past_x - shift) / scale);
      if (spread.criteria <= 0) return person_mean(population, seen, seen, mean);
      const double rated = normal_mean<double>(spread.criteria, scale, 0, [&](double rating_shift) {
        return falling((past_x - shift - rating_shift) / scale);
      });
      return person_mean(population, seen, rated, mean);
    });
  });
}

Eigen::VectorXd answer_shares(const PlannedPopulation& population, const PlannedCurve& curve, double x) {
  const AssumedPeople& assumed = population.assumed;
  const SpreadInX spread = spread_in_x(population);
  const double past_x = x - x_of(population.axis, curve.midpoint);
  const Shares none = Shares::Zero();
  const Shares shares = normal_mean<Shares>(assumed.slope_sd, 1, none, [&](double log_ratio) {
    const double scale = spread.scale * std::exp(log_ratio);
    return normal_mean<Shares>(spread.people, scale, none, [&](double shift) {
      const double seen = falling((past_x - shift) / scale);
      if (spread.criteria <= 0) return person_shares(population, seen, seen);
      return normal_mean<Shares>(spread.criteria, scale, none, [&](double rating_shift) {
        return person_shares(population, seen, falling((past_x - shift - rating_shift) / scale));
      });
    });
  });
  if (population.task.facts.rates) return shares;
  return Eigen::Vector2d(shares.head(highest_rating).sum(), shares.tail(highest_rating).sum());
}

double true_crossing(const PlannedPopulation& population, const PlannedCurve& curve, double level,
                     JointMean mean) {
  const SpreadInX spread = spread_in_x(population);
  const double reach_x = 40 * spread.scale * std::exp(3 * population.assumed.slope_sd) +
                         10 * std::hypot(spread.people, spread.criteria);
  const double middle_x = x_of(population.axis, curve.midpoint);
  return falling_crossing([&](double x) { return mean_noticeability(population, curve, x, mean); }, level,
                          middle_x - reach_x, middle_x + reach_x);
}

std::string assumptions_text(const PlannedPopulation& population, const std::vector<PlannedCurve>& curves) {
  const ObserverDefinition& observer = population.observer;
  const AssumedPeople& assumed = population.assumed;
  const LevelAxis& axis = population.axis;
  const PlannedTask& task = population.task;
  const bool linear = is_linear(axis);
  const std::string unit = length_unit(axis);
  std::string text = fmt::format(
      "Assumed of people: half is seen at a {} of a person's own, about {} with a standard deviation of {:g} "
      "{}; "
      "seeing is logistic with a scale of {:g} {}{}; {}",
      level_word(axis), midpoints_text(axis, curves),
      linear ? observer.people_sd_linear : observer.people_sd_octaves, unit,
      linear ? observer.scale_linear : observer.scale_octaves, unit,
      assumed.slope_sd > 0 ? fmt::format(", which differs between people (ln SD {:g})", assumed.slope_sd)
                           : "",
      answers_text(task));
  text +=
      assumed.high_guesses > 0 ? fmt::format(", {:g} % of the time 2. ", 100 * assumed.high_guesses) : ". ";
  if (!task.asks_as_paper() || task.repetitions > 1)
    text += fmt::format("The task is {}, each stimulus {}. {} ", word(task.facts.kind),
                        task.repetitions == 1 ? "once" : fmt::format("{} times", task.repetitions),
                        chance_sentence(task));
  text += assumed.lapse > 0
              ? fmt::format("In {:g} % of the trials a person does not look. ", 100 * assumed.lapse)
              : "There are no lapses. ";
  if (task.facts.rates)
    text += assumed.criteria_sd > 0
                ? fmt::format("Where people begin to rate high differs from where they see (SD {:g} {}). ",
                              assumed.criteria_sd, unit)
                : "Everybody rates by the same criteria. ";
  text += assumed.artifact_sd > 0
              ? fmt::format("Each person has a shift of their own for each curve (SD {:g} {}). ",
                            assumed.artifact_sd, unit)
              : "A person who sees one artifact better sees all better by as much. ";
  return text + "Objects of an artifact are alike, and nobody learns or tires.";
}

}  // namespace seamline::analysis
