#include "analysis/log_analysis/signal_detection.h"

#include <cmath>
#include <map>
#include <tuple>

#include "analysis/statistics/distributions.h"
#include "stimuli/definition/parts/task_definition.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

/// How often somebody said yes, and was asked.
struct YesCounts {
  double yes = 0, all = 0;
  void add(bool is_yes) {
    yes += is_yes ? 1 : 0;
    all += 1;
  }
  [[nodiscard]] double share() const { return yes / all; }
  [[nodiscard]] double z() const { return normal_quantile((yes + 0.5) / (all + 1)); }
};

}  // namespace

MeanOverPeople mean_of_observers(const std::vector<double>& values) {
  const double n = values.size();
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  MeanOverPeople found{.mean = mean};
  if (values.size() < 2) return found;
  const double reach = student_quantile(n - 1, 0.975) * std::sqrt(squares / (n - 1) / n);
  found.ci95 = {.low = mean - reach, .high = mean + reach};
  return found;
}

SignalDetection signal_detection(const Analysis& analysis) {
  SignalDetection found;
  if (!facts_of(analysis.log.task.get()).right_is_yes) return found;
  std::map<std::string, YesCounts> references;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) references[person.record.code] = {};
  for (const study::CatchTrialAnswer& answer : analysis.log.catches)
    if (const auto person = references.find(answer.participant);
        person != references.end() && answer.kind == study::TrialKind::reference)
      person->second.add(answer.chosen_index == 1);
  std::erase_if(references, [](const auto& person) { return person.second.all == 0; });
  for (const auto& [code, counts] : references) {
    found.false_alarms += counts.share() / static_cast<double>(references.size());
    found.reference_answers += static_cast<int>(counts.all);
  }
  std::map<std::tuple<Artifact, std::string, double>, std::map<std::string, YesCounts>> cells;
  for (const study::Answer& answer : analysis.log.answers)
    if (references.contains(answer.participant))
      cells[{answer.artifact, answer.condition, answer.level}][answer.participant].add(answer.chosen_index ==
                                                                                       1);
  for (const ArtifactScores& scores : analysis.data.artifacts)
    for (const double level : scores.level) {
      const auto cell = cells.find({scores.artifact, scores.condition, level});
      if (cell == cells.end()) continue;
      std::vector<double> d_primes, criteria;
      DetectionRow row{.artifact = scores.artifact, .condition = scores.condition, .level = level};
      for (const auto& [code, counts] : cell->second) {
        const double hit = counts.z(), alarm = references.at(code).z();
        d_primes.push_back(hit - alarm);
        criteria.push_back(-(hit + alarm) / 2);
        row.hits += counts.share() / static_cast<double>(cell->second.size());
      }
      row.people = static_cast<int>(d_primes.size());
      const MeanOverPeople d_prime = mean_of_observers(d_primes), criterion = mean_of_observers(criteria);
      row.d_prime = d_prime.mean;
      row.d_prime_ci95 = d_prime.ci95;
      row.criterion = criterion.mean;
      row.criterion_ci95 = criterion.ci95;
      found.rows.push_back(std::move(row));
    }
  return found;
}

}  // namespace seamline::analysis
