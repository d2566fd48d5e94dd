#include "laboratory/stability/statistics/quest_plus_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/statistics/study_widths.h"
#include "study/placement/quest_plus_model.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

/// A track without images: grid and tables of a study's defaults.
struct Track {
  QuestPlusDefinition definition;
  QuestPlusGrid grid;
  QuestPlusTables tables;
};

Track make_track(PlacementOutcome outcome = PlacementOutcome::correct) {
  QuestPlusDefinition definition;
  definition.threshold = {32, 8192, 41};
  definition.outcome = outcome;
  const QuestPlusGrid grid = make_grid(definition);
  return {definition, grid, make_level_tables(definition, grid, {widths_px.begin(), widths_px.end()})};
}

double total(const QuestPlusPosterior& posterior) {
  return std::accumulate(posterior.mass.begin(), posterior.mass.end(), 0.0);
}

int best_stimulus(const Track& track, const QuestPlusPosterior& posterior) {
  const std::vector<double> expected = expected_entropies_nats(track.tables, posterior);
  return static_cast<int>(std::min_element(expected.begin(), expected.end()) - expected.begin());
}

double probability_right(const Track& track, int stimulus, int point) {
  return std::exp(
      track.tables
          .log_probability[static_cast<std::size_t>((stimulus * 2 + 1) * track.tables.points + point)]);
}

int point_at(const Track& track, int threshold, int scale, int lapse) {
  int point = 0;
  while (track.grid.index(Parameter::threshold, point) != threshold ||
         track.grid.index(Parameter::scale, point) != scale ||
         track.grid.index(Parameter::lapse, point) != lapse)
    ++point;
  return point;
}

}  // namespace

Finding try_many_trials(const LearnRule& rule) {
  const Track track = make_track();
  const int truth = point_at(track, 20, 4, 1);
  QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
  Random random(11);
  double error = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const int stimulus = best_stimulus(track, posterior);
    rule(posterior, track.tables, stimulus,
         random.uniform() < probability_right(track, stimulus, truth) ? 1 : 0);
    error = worse(error, std::abs(total(posterior) - 1));
  }
  const double mass = posterior.mass[truth];
  const double off = std::abs(moments(track.grid, posterior, Parameter::threshold).mean -
                              track.grid.value(Parameter::threshold, truth));
  return {mass > 1e-3 && off < 0.1 ? error : nan,
          fmt::format("sums within {:.1g} of 1, mass {:.2g} at the true point, threshold {:.2g} octaves off",
                      error, mass, off)};
}

Finding try_point_comes_back(const LearnRule& rule) {
  const Track track = make_track();
  QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
  const int finest = track.tables.stimuli - 1;
  for (int trial = 0; trial < 1000; ++trial) rule(posterior, track.tables, finest, 1);
  const double seeing = moments(track.grid, posterior, Parameter::threshold).mean;
  for (int trial = 0; trial < 6000; ++trial)
    rule(posterior, track.tables, trial < 3000 ? 0 : finest, trial % 3 == 0 ? 1 : 0);
  const double guessing = moments(track.grid, posterior, Parameter::threshold).mean;
  const int wrong =
      (seeing > 12 ? 0 : 1) + (guessing < 6 ? 0 : 1) + (std::abs(total(posterior) - 1) < 1e-12 ? 0 : 1);
  return {static_cast<double>(wrong),
          fmt::format("2^{:.2f} px while seeing, 2^{:.2f} px while guessing", seeing, guessing)};
}

Finding try_contradictions(const LearnRule& rule) {
  int wrong = 0;
  for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability}) {
    const Track track = make_track(outcome);
    QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
    for (int trial = 0; trial < 500; ++trial) {
      rule(posterior, track.tables, track.tables.stimuli - 1, track.tables.outcomes - 1);
      rule(posterior, track.tables, 0, 0);
      wrong += std::abs(total(posterior) - 1) < 1e-12 ? 0 : 1;
      if (trial % 50 == 0)
        for (const double value : expected_entropies_nats(track.tables, posterior))
          wrong += value >= -1e-9 ? 0 : 1;
    }
    for (const Parameter parameter : every_parameter) {
      const Moments belief = moments(track.grid, posterior, parameter);
      const std::vector<double>& values = track.grid.of(parameter);
      wrong += belief.mean >= values.front() - 1e-9 && belief.mean <= values.back() + 1e-9 &&
                       std::isfinite(belief.sd)
                   ? 0
                   : 1;
    }
  }
  return {static_cast<double>(wrong), fmt::format("{} wrong of 2,000 answers", wrong)};
}

Finding try_impossible_answer(const LearnRule& rule) {
  const QuestPlusTables tables =
      make_quest_plus_tables(2, 2, 4, [](int stimulus, int point) -> std::vector<double> {
        if (stimulus == 0) return {0, 1};  // nobody fails here
        return {0.1 + 0.2 * point, 0.9 - 0.2 * point};
      });
  QuestPlusPosterior posterior = uniform_posterior(4);
  rule(posterior, tables, 1, 0);
  const QuestPlusPosterior before = posterior;
  rule(posterior, tables, 0, 0);
  double error = 0;
  for (std::size_t point = 0; point < 4; ++point)
    error = worse(error, std::abs(posterior.mass[point] - before.mass[point]));
  return {error, fmt::format("masses changed by at most {:.2g}", error)};
}

Finding try_edge(double edge_share) {
  const Track track = make_track();
  const auto rings = [&](double threshold_log2_px) {
    QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
    Random random(21);
    for (int trial = 0; trial < 120; ++trial) {
      const int stimulus = best_stimulus(track, posterior);
      const double z = (threshold_log2_px - std::log2(widths_px[stimulus])) / 0.5;
      const double right = 1.0 / 3 + (2.0 / 3 - 0.02) / (1 + std::exp(-z));
      learn(posterior, track.tables, stimulus, random.uniform() < right ? 1 : 0);
    }
    const std::vector<EdgeAlarm> alarms = edge_alarms(track.grid, posterior, edge_share);
    return std::any_of(alarms.begin(), alarms.end(),
                       [](const EdgeAlarm& alarm) { return alarm.parameter == Parameter::threshold; });
  };
  const bool above = rings(17), below = rings(1), middle = rings(9);
  return {
      static_cast<double>((above ? 0 : 1) + (below ? 0 : 1) + (middle ? 1 : 0)),
      fmt::format("alarm beyond the upper end: {}, the lower: {}, in the middle: {}", above, below, middle)};
}

Finding try_order_of_answers() {
  const Track track = make_track(PlacementOutcome::noticeability);
  std::vector<std::pair<int, int>> answers;
  Random random(5);
  for (int i = 0; i < 300; ++i)
    answers.emplace_back(static_cast<int>(random.below(widths_px.size())), static_cast<int>(random.below(5)));
  const auto posterior_of = [&] {
    QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
    for (const auto& [stimulus, outcome] : answers) learn(posterior, track.tables, stimulus, outcome);
    return posterior.mass;
  };
  const std::vector<double> one = posterior_of();
  shuffle(std::span(answers), random);
  const std::vector<double> other = posterior_of();
  double error = 0;
  for (std::size_t i = 0; i < one.size(); ++i) error = worse(error, std::abs(one[i] - other[i]));
  return {error, fmt::format("{} points, largest difference {:.2g}", one.size(), error)};
}

Finding try_expected_entropies() {
  const Track track = make_track(PlacementOutcome::noticeability);
  QuestPlusPosterior posterior = uniform_posterior(track.grid.points());
  Random random(7);
  double error = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double now = entropy_nats(posterior.mass);
    for (const double expected : expected_entropies_nats(track.tables, posterior))
      error = worse(error, std::max(expected - now, -expected));
    learn(posterior, track.tables, best_stimulus(track, posterior), static_cast<int>(random.below(5)));
  }
  return {error, fmt::format("200 trials of random ratings, excess {:.2g}", error)};
}

StabilityCases quest_plus_cases() {
  const auto one = [](const std::string& name, const std::string& tried, const std::string& expected,
                      const std::string& unit, double tolerance, const std::string& reason,
                      Finding (*attempt)()) {
    return StabilityCase{.group = "quest_plus",
                         .name = name,
                         .tried = tried,
                         .expected = expected,
                         .unit = unit,
                         .tolerance = tolerance,
                         .reason = reason,
                         .run = [attempt](const StabilityOptions&) { return attempt(); }};
  };
  const std::string points = "sums over 1,845 points in double: 1,845 x 1.1e-16 at worst, five times that";
  return {
      one("5000-trials", "5,000 answers of a person on the grid",
          "masses that sum to 1, the person's point among them", "mass", 1e-12, points,
          [] { return try_many_trials(); }),
      counted_case("quest_plus", "point-comes-back",
                   "1,000 answers of somebody who sees everything, then 6,000 guesses",
                   "an estimate that follows", [] { return try_point_comes_back(); }),
      counted_case(
          "quest_plus", "contradictory-answers",
          "best answers at the finest map and wrong ones at the coarsest, 500 each, binary and ordinal",
          "a posterior that sums to 1, estimates on the grid", [] { return try_contradictions(); }),
      one("impossible-answer", "an answer that every point of the grid rules out", "nothing is learnt",
          "mass", 1e-12, "adding and taking away 690 nats costs 690 x 1.1e-16 in a logarithm; ten times that",
          [] { return try_impossible_answer(); }),
      counted_case("quest_plus", "posterior-at-edge",
                   "people whose thresholds lie beyond either end of the grid, and one in its middle",
                   "an alarm, an alarm, none", [] { return try_edge(); }),
      one("order-of-answers", "300 ordinal answers in two orders", "the same posterior", "mass", 1e-12,
          "300 logarithms of up to 690 nats added in another order: 300 x 690 x 1.1e-16 in the worst case is "
          "2e-11 of a mass; roundings go both ways",
          [] { return try_order_of_answers(); }),
      one("expected-entropies", "200 random ratings: the entropy that is expected after the next answer",
          "never above that before it, never below 0", "nats", 1e-11,
          "sums over 7,380 points in double: 7,380 x 1.1e-16 x 9 nats",
          [] { return try_expected_entropies(); }),
  };
}

}  // namespace seamline::stability
