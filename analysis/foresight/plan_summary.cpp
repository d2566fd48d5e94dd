#include "analysis/foresight/plan_summary.h"

#include <algorithm>
#include <cmath>

#include "analysis/scores/cells.h"
#include "analysis/statistics/distributions.h"
#include "analysis/statistics/interval.h"

namespace seamline::analysis {
namespace {

constexpr double no_difference_x = 1e-6;  ///< true differences under this are 0

bool holds_truth(const LevelInterval& interval, double truth_x) {
  return interval.low_x <= truth_x && truth_x <= interval.high_x;
}

/// In octaves, or the level's unit.
double length_in_units(const LevelAxis& axis, double length_x) {
  return is_linear(axis) ? length_x * axis.unit : length_x;
}

bool short_enough(const StudyPlan& plan, const LevelInterval& interval) {
  const std::optional<double> length = length_x(interval);
  return length && length_in_units(plan.axis, *length) <= plan.request.wanted_length;
}

bool lies_within(double x, const std::vector<double>& level_x) {
  return x >= level_x.front() && x <= level_x.back();
}

/// Whether the levels can show a target: the thresholds it is made of lie within them.
bool is_within(const StudyPlan& plan, const PlannedPopulation& population, const PlanTarget& target,
               const std::vector<double>& level_x) {
  if (!target.against) return lies_within(target.truth_x, level_x);
  const SoughtMean& sought = target.quantity.sought;
  const double other_x = true_crossing(population, plan.curves[*target.against], sought.level, sought.mean);
  return lies_within(other_x, level_x) && lies_within(other_x + target.truth_x, level_x);
}

/// Of one target over studies; `at` is the place of level set and participants in a simulated study.
PlannedInterval interval_of(const StudyPlan& plan, const std::vector<SimulatedStudy>& studies,
                            std::size_t target, std::size_t at) {
  PlannedInterval planned;
  std::vector<double> lengths;
  const double truth_x = plan.targets[target].truth_x;
  const double all = studies.size();
  for (const SimulatedStudy& study : studies) {
    const LevelInterval& interval = study.intervals[at][target];
    if (const std::optional<double> length = length_x(interval))
      lengths.push_back(length_in_units(plan.axis, *length));
    planned.holds_share += holds_truth(interval, truth_x) ? 1 / all : 0;
    if (!plan.targets[target].against) continue;
    const bool above = interval.low_x > 0, below = interval.high_x < 0;
    const bool found = std::abs(truth_x) < no_difference_x ? above || below : truth_x > 0 ? above : below;
    planned.power += found ? 1 / all : 0;
    const double farthest = length_in_units(plan.axis, std::max(-interval.low_x, interval.high_x));
    planned.equal_share += plan.request.equal_within && farthest <= *plan.request.equal_within ? 1 / all : 0;
  }
  require_ordered(lengths);
  std::sort(lengths.begin(), lengths.end());
  planned.open_share = 1 - static_cast<double>(lengths.size()) / all;
  if (studies.size() / 2 < lengths.size()) planned.median_length = lengths[studies.size() / 2];
  return planned;
}

/// The targets that a wish is about.
std::vector<std::size_t> wished_for(const StudyPlan& plan, std::size_t level_set) {
  std::vector<std::size_t> targets;
  for (const PlanRow& row : plan.rows)
    if (row.level_set == level_set && row.participants == plan.request.participants.front() &&
        row.interval.within)
      targets.push_back(row.target);
  return targets;
}

DesignRow design_of(const StudyPlan& plan, const std::vector<SimulatedStudy>& studies,
                    const std::vector<std::size_t>& wished, std::size_t at) {
  DesignRow design;
  const double all = studies.size();
  for (const SimulatedStudy& study : studies) {
    const auto every = [&](auto&& property) {
      return !wished.empty() && std::all_of(wished.begin(), wished.end(), [&](std::size_t target) {
        return property(study.intervals[at][target], target);
      });
    };
    const bool all_short =
        every([&](const LevelInterval& interval, std::size_t) { return short_enough(plan, interval); });
    const bool all_hold = every([&](const LevelInterval& interval, std::size_t target) {
      return holds_truth(interval, plan.targets[target].truth_x);
    });
    design.assurance += all_short ? 1 / all : 0;
    design.all_hold += all_hold ? 1 / all : 0;
    const std::vector<bool>& shown = study.no_seam[at];
    design.no_seam.resize(shown.size());
    for (std::size_t curve = 0; curve < shown.size(); ++curve)
      design.no_seam[curve] += shown[curve] ? 1 / all : 0;
  }
  return design;
}

SequentialRow sequential_of(const StudyPlan& plan, const std::vector<SimulatedStudy>& studies,
                            const std::vector<std::size_t>& wished, std::size_t level_set) {
  const std::vector<int>& looks = plan.request.participants;
  SequentialRow row{.level_set = level_set};
  const double all = studies.size();
  std::vector<double> hold_at(looks.size());  // of all studies: mean share of intervals that hold at a look
  std::vector<std::size_t> stop(studies.size());
  for (std::size_t study = 0; study < studies.size(); ++study) {
    stop[study] = looks.size();
    for (std::size_t look = 0; look < looks.size(); ++look) {
      const std::vector<LevelInterval>& intervals = studies[study].intervals[level_set * looks.size() + look];
      bool all_short = !wished.empty();
      double hold = 0;
      for (const std::size_t target : wished) {
        all_short = all_short && short_enough(plan, intervals[target]);
        if (holds_truth(intervals[target], plan.targets[target].truth_x))
          hold += 1 / static_cast<double>(wished.size());
      }
      hold_at[look] += hold / all;
      const bool stops = stop[study] == looks.size() && (all_short || look + 1 == looks.size());
      if (!stops) continue;
      stop[study] = look;
      row.stopped_share += all_short ? 1 / all : 0;
      row.holds += hold / all;
      row.mean_participants += looks[look] / all;
    }
  }
  for (const std::size_t look : stop) row.fixed_holds += hold_at[look] / all;
  return row;
}

}  // namespace

std::vector<bool> claims_shown(const PlanRequest& request, const StudyPlan& plan,
                               const SimulatedAnswers& answers, int people) {
  if (!request.no_seam) return {};
  const double claim_x = x_of(plan.axis, request.no_seam->level);
  const auto found = std::find(answers.level_x.begin(), answers.level_x.end(), claim_x);
  if (found == answers.level_x.end()) return {};
  const auto level = static_cast<Eigen::Index>(found - answers.level_x.begin());
  const double guess_rating = mean_guess_rating(answers, people);
  std::vector<bool> shown;
  for (std::size_t curve = 0; curve < plan.curves.size(); ++curve) {
    const Eigen::VectorXd scores = scores_of(answers, curve, people, guess_rating).col(level);
    const CellMean mean = mean_over_participants({scores.begin(), scores.end()});
    const double reach = mean.sem * student_quantile(people - 1, 0.95);
    shown.push_back(std::abs(mean.mean) + reach <= request.no_seam->margin);
  }
  return shown;
}

void summarise(const std::vector<SimulatedStudy>& studies, const PlannedPopulation& population,
               StudyPlan& plan) {
  const std::vector<int>& participants = plan.request.participants;
  for (std::size_t target = 0; target < plan.targets.size(); ++target)
    for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
      const bool within = is_within(plan, population, plan.targets[target],
                                    x_of_levels(plan.axis, plan.level_sets[set].levels));
      for (std::size_t n = 0; n < participants.size(); ++n) {
        PlannedInterval interval = interval_of(plan, studies, target, set * participants.size() + n);
        interval.within = within;
        plan.rows.push_back(
            {.target = target, .level_set = set, .participants = participants[n], .interval = interval});
      }
    }
  for (std::size_t set = 0; set < plan.level_sets.size(); ++set) {
    const std::vector<std::size_t> wished = wished_for(plan, set);
    for (std::size_t n = 0; n < participants.size(); ++n) {
      DesignRow design = design_of(plan, studies, wished, set * participants.size() + n);
      design.level_set = set;
      design.participants = participants[n];
      plan.designs.push_back(std::move(design));
    }
    if (plan.request.sequential) plan.sequential.push_back(sequential_of(plan, studies, wished, set));
  }
}

}  // namespace seamline::analysis
