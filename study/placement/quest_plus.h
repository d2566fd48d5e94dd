#pragma once
#include <functional>
#include <span>
#include <vector>

namespace seamline::study {

// QUEST+ (Watson 2017), whatever the task: stimuli, outcomes and points of a parameter grid are numbered from
// 0. Watson's letters: x stimulus, o outcome, theta a point of the grid.

/// p(o | x, theta) of each outcome: at least 0, and 1 in all.
using OutcomeProbabilities = std::function<std::vector<double>(int stimulus, int point)>;

/// All likelihoods of a task, laid out for the two things that are done with them. Never changes.
struct QuestPlusTables {
  int stimuli = 0, outcomes = 0, points = 0;
  /// ln p(o | x, theta), [stimulus][outcome][point]. Where the probability is 0 it is ln 1e-300: an answer
  /// that a point rules out costs it 690 nats, so answers that every point rules out leave all of them as
  /// they were to each other.
  std::vector<double> log_probability;
  /// [row][block][point][8 stimuli]. Row o is p(o | x, theta) for all outcomes but the last, and the last
  /// row is the entropy of the outcome, -sum over o of p ln p.
  std::vector<double> choice_rows;
};

/// Precondition: at least one stimulus, outcome and point. 16 to 24 bytes a likelihood.
[[nodiscard]] QuestPlusTables make_quest_plus_tables(int stimuli, int outcomes, int points,
                                                     const OutcomeProbabilities& probabilities);

/// What is believed about the parameters. The logarithm is what is kept, so that a point that 5,000 answers
/// made unlikely can come back; the mass is there to compute with.
struct QuestPlusPosterior {
  std::vector<double> log_mass;  ///< natural, of each point; the masses sum to 1
  std::vector<double> mass;      ///< exp(log_mass); far points are 0
  bool operator==(const QuestPlusPosterior&) const = default;
};

[[nodiscard]] QuestPlusPosterior uniform_posterior(int points);

/// Shifts `log_mass` so that the masses sum to 1, and sets `mass`. At least one mass is not 0.
void normalise(QuestPlusPosterior& posterior);

/// Bayes' rule for one answer: p(theta | o) is proportional to p(theta) p(o | x, theta).
void learn(QuestPlusPosterior& posterior, const QuestPlusTables& tables, int stimulus, int outcome);

/// -sum of p ln p over the grid, in nats.
[[nodiscard]] double entropy_nats(std::span<const double> mass);

/// For each stimulus, the entropy of the posterior that is expected after its answer (Watson 2017, eq. 6), in
/// nats, by the other side of the mutual information of answer and parameters:
///
///     E[H(theta | o)] = H(theta) - H(o | x) + sum over theta of p(theta) H(o | x, theta)
///
/// which needs one weighted sum for each outcome but the last and one for H(o | x, theta), and no logarithm
/// for each point. Each stimulus' sums are taken over the points in their order, so the result does not
/// depend on how wide the processor's vectors are.
[[nodiscard]] std::vector<double> expected_entropies_nats(const QuestPlusTables& tables,
                                                          const QuestPlusPosterior& posterior);

}  // namespace seamline::study
