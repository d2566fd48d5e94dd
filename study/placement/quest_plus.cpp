#include "study/placement/quest_plus.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace seamline::study {
namespace {

constexpr int lane_count = 8;  // stimuli that are summed side by side: four registers of SSE2, two of AVX
using Lanes = Eigen::Array<double, lane_count, 1>;

constexpr double least_probability = 1e-300;

double p_log_p(double p) {
  return p > 0 ? p * std::log(p) : 0;
}

int block_count(const QuestPlusTables& tables) {
  return (tables.stimuli + lane_count - 1) / lane_count;
}

std::size_t block_begin(const QuestPlusTables& tables, int row, int block) {
  return static_cast<std::size_t>(row * block_count(tables) + block) *
         static_cast<std::size_t>(tables.points) * lane_count;
}

void enter(QuestPlusTables& tables, int stimulus, int point, const std::vector<double>& probability) {
  const auto set = [&](int row, double value) {
    tables.choice_rows[block_begin(tables, row, stimulus / lane_count) +
                       static_cast<std::size_t>(point * lane_count + stimulus % lane_count)] = value;
  };
  double entropy = 0;
  for (int outcome = 0; outcome < tables.outcomes; ++outcome) {
    const double p = probability[outcome];
    assert(p >= 0 && p <= 1);
    entropy -= p_log_p(p);
    if (outcome + 1 < tables.outcomes) set(outcome, p);
    tables.log_probability[static_cast<std::size_t>((stimulus * tables.outcomes + outcome) * tables.points +
                                                    point)] = std::log(std::max(p, least_probability));
  }
  set(tables.outcomes - 1, entropy);
}

/// Sum over the points of mass times the eight stimuli of a block.
Lanes weighted_sum(const double* block, const std::vector<double>& mass) {
  Lanes sum = Lanes::Zero();
  for (const double m : mass) {
    sum += m * Eigen::Map<const Lanes>(block);
    block += lane_count;
  }
  return sum;
}

}  // namespace

QuestPlusTables make_quest_plus_tables(int stimuli, int outcomes, int points,
                                       const OutcomeProbabilities& probabilities) {
  assert(stimuli > 0 && outcomes > 0 && points > 0);
  QuestPlusTables tables{
      .stimuli = stimuli, .outcomes = outcomes, .points = points, .log_probability = {}, .choice_rows = {}};
  tables.log_probability.resize(stimuli * static_cast<std::size_t>(outcomes) *
                                static_cast<std::size_t>(points));
  tables.choice_rows.assign(block_begin(tables, outcomes, 0), 0.0);
  for (int stimulus = 0; stimulus < stimuli; ++stimulus)
    for (int point = 0; point < points; ++point)
      enter(tables, stimulus, point, probabilities(stimulus, point));
  return tables;
}

QuestPlusPosterior uniform_posterior(int points) {
  assert(points > 0);
  const std::size_t count = points;
  return {.log_mass = std::vector<double>(count, -std::log(points)),
          .mass = std::vector<double>(count, 1.0 / points)};
}

void learn(QuestPlusPosterior& posterior, const QuestPlusTables& tables, int stimulus, int outcome) {
  assert(stimulus >= 0 && stimulus < tables.stimuli && outcome >= 0 && outcome < tables.outcomes);
  const std::size_t points = tables.points;
  const double* log_probability =
      &tables.log_probability[static_cast<std::size_t>((stimulus * tables.outcomes + outcome)) * points];
  for (std::size_t i = 0; i < points; ++i) posterior.log_mass[i] += log_probability[i];
  normalise(posterior);
}

void normalise(QuestPlusPosterior& posterior) {
  const std::size_t points = posterior.log_mass.size();
  const double highest = *std::max_element(posterior.log_mass.begin(), posterior.log_mass.end());
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i)
    sum += posterior.mass[i] = std::exp(posterior.log_mass[i] - highest);
  const double log_total = highest + std::log(sum);
  for (std::size_t i = 0; i < points; ++i) {
    posterior.log_mass[i] -= log_total;
    posterior.mass[i] /= sum;
  }
}

double entropy_nats(std::span<const double> mass) {
  double entropy = 0;
  for (const double p : mass) entropy -= p_log_p(p);
  return entropy;
}

std::vector<double> expected_entropies_nats(const QuestPlusTables& tables,
                                            const QuestPlusPosterior& posterior) {
  const double now = entropy_nats(posterior.mass);
  std::vector<double> expected(tables.stimuli);
  const auto sum_of = [&](int row, int block) {
    return weighted_sum(&tables.choice_rows[block_begin(tables, row, block)], posterior.mass);
  };
  for (int block = 0; block < block_count(tables); ++block) {
    Lanes known = sum_of(tables.outcomes - 1, block);  // entropy of the answer when theta is known
    Lanes last = Lanes::Ones();                        // probability of the last outcome
    for (int outcome = 0; outcome + 1 < tables.outcomes; ++outcome) {
      const Lanes p = sum_of(outcome, block);
      last -= p;
      known += p.unaryExpr([](double value) { return p_log_p(value); });
    }
    known += last.unaryExpr([](double value) { return p_log_p(value); });
    for (int lane = 0; lane < lane_count && block * lane_count + lane < tables.stimuli; ++lane)
      expected[static_cast<std::size_t>(block * lane_count + lane)] = now + known[lane];
  }
  return expected;
}

}  // namespace seamline::study
