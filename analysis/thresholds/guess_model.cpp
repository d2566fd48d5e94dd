#include "analysis/thresholds/guess_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/scores/guess_trials.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int position_steps = 500;
constexpr int seeing_steps = 3000;
constexpr double position_tolerance = 1e-12;

using Positions = std::vector<double>;
using Ratings = std::array<double, study::highest_rating>;

/// Wrong choices by right and by chosen position, and choices where nothing was right.
struct GuessChoices {
  explicit GuessChoices(std::size_t positions)
      : wrong(positions, Positions(positions)), reference(positions) {}
  std::vector<Positions> wrong;  ///< [right][chosen]
  Positions reference;
};

double sum_of(const Positions& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

/// One step of EM: the guesses that were right by chance are as many as b says for the wrong ones seen.
Positions next_positions(const GuessChoices& choices, const Positions& b) {
  Positions expected = choices.reference;
  for (std::size_t right = 0; right < b.size(); ++right) {
    double wrong = 0;
    for (std::size_t chosen = 0; chosen < b.size(); ++chosen) {
      wrong += choices.wrong[right][chosen];
      expected[chosen] += choices.wrong[right][chosen];
    }
    if (b[right] < 1) expected[right] += wrong * b[right] / (1 - b[right]);
  }
  const double total = sum_of(expected);
  for (double& share : expected) share /= total;
  return expected;
}

/// Whether wrong choices compare every position with the others: with one right position only, nothing says
/// how often guesses fall on it.
bool positions_are_comparable(const GuessChoices& choices) {
  int right_positions = 0;
  double references = 0;
  for (std::size_t right = 0; right < choices.wrong.size(); ++right) {
    right_positions += sum_of(choices.wrong[right]) > 0 ? 1 : 0;
    references += choices.reference[right];
  }
  return references > 0 || right_positions >= 2;
}

/// What right choices (o, r) and wrong ones are made of.
struct CellCounts {
  std::vector<Ratings> right = {};
  double all_right = 0, all_wrong = 0;
  double wrong_log_likelihood = 0;  ///< sum of n ln(b(c) g(r)) over wrong choices
};

CellCounts sort_counts(const double* counts, const Guessers& guessers) {
  const CellShape shape = cell_shape(guessers.task);
  CellCounts sorted{.right = std::vector<Ratings>(static_cast<std::size_t>(shape.positions))};
  for (int right = 0; right < shape.positions; ++right)
    for (int chosen = 0; chosen < shape.positions; ++chosen)
      for (int rating = 0; rating < study::highest_rating; ++rating) {
        const double n = counts[shape.place(right + 1, chosen + 1, rating + 1)];
        const auto c = static_cast<std::size_t>(chosen), r = static_cast<std::size_t>(rating);
        if (chosen == right) {
          sorted.right[c][r] = n;
          sorted.all_right += n;
        } else if (n > 0) {
          sorted.all_wrong += n;
          sorted.wrong_log_likelihood += n * std::log(guessers.position[c] * guessers.rating[r]);
        }
      }
  return sorted;
}

/// v(r) = s q(r). The share of wrong choices says s, the right choices beyond chance say q.
Ratings moment_start(const CellCounts& counts, const Guessers& guessers) {
  const double n = counts.all_right + counts.all_wrong;
  const double chance = 1.0 / counts.right.size();
  Ratings v{};
  const double guessing = std::clamp(counts.all_wrong / n / (1 - chance), 0.0, 0.98);
  double seen = 0;
  for (std::size_t r = 0; r < v.size(); ++r) {
    for (const Ratings& of_position : counts.right) v[r] += of_position[r] / n;
    v[r] = v[r] > 0 ? std::max(v[r] - guessing * chance * guessers.rating[r], 0.02 * v[r]) : 0;
    seen += v[r];
  }
  if (counts.all_wrong > 0 && seen > 0)  // not at a bound, where EM would stay
    for (double& part : v) part *= std::clamp(1 - guessing, 0.02, 0.98) / seen;
  return v;
}

double log_likelihood(const CellCounts& counts, const Guessers& guessers, const Ratings& v) {
  const double unseen = std::max(0.0, 1 - (v[0] + v[1] + v[2] + v[3]));
  double sum = counts.wrong_log_likelihood;
  if (counts.all_wrong > 0) sum += counts.all_wrong * std::log(unseen);
  for (std::size_t o = 0; o < counts.right.size(); ++o)
    for (std::size_t r = 0; r < v.size(); ++r)
      if (counts.right[o][r] > 0)
        sum += counts.right[o][r] * std::log(v[r] + unseen * guessers.position[o] * guessers.rating[r]);
  return sum;
}

/// One step of EM: each right choice was seen with its posterior probability.
Ratings next_seen(const CellCounts& counts, const Guessers& guessers, const Ratings& v) {
  const double n = counts.all_right + counts.all_wrong;
  const double unseen = std::max(0.0, 1 - (v[0] + v[1] + v[2] + v[3]));
  Ratings next{};
  for (std::size_t o = 0; o < counts.right.size(); ++o)
    for (std::size_t r = 0; r < v.size(); ++r) {
      if (counts.right[o][r] == 0 || v[r] == 0) continue;
      const double guessed = unseen * guessers.position[o] * guessers.rating[r];
      next[r] += counts.right[o][r] * v[r] / (v[r] + guessed);
    }
  for (double& part : next) part /= n;
  return next;
}

Positions equal_positions(const TaskFacts& task) {
  Positions equal(static_cast<std::size_t>(cell_shape(task).positions));
  std::fill_n(equal.begin(), task.alternatives, 1.0 / task.alternatives);
  return equal;
}

/// Choice 1 is yes, choice 2 no.
Guessers guessers_of_false_alarms(const Eigen::VectorXd& references) {
  Guessers found;
  found.reference_answers = references.sum();
  const auto alarms = references.head(study::highest_rating);
  const double yes = (alarms.sum() + 0.5) / (found.reference_answers + 1);
  found.position = {yes, 1 - yes, 0};
  for (std::size_t r = 0; r < found.rating.size(); ++r)
    found.rating[r] = (alarms[static_cast<Eigen::Index>(r)] + (r == 0 ? 0.5 : 0)) / (alarms.sum() + 0.5);
  found.position_estimated = found.reference_answers > 0;
  return found;
}

double mean_of(const Ratings& v) {
  return v[0] + 2 * v[1] + 3 * v[2] + 4 * v[3];
}

}  // namespace

double Guessers::mean_rating() const {
  return mean_of(rating);
}

Guessers estimate_guessers(const Eigen::VectorXd& cells, const Eigen::VectorXd& references,
                           const TaskFacts& task) {
  if (task.right_is_yes) {
    Guessers yes = guessers_of_false_alarms(references);
    yes.task = task;
    return yes;
  }
  const CellShape shape = cell_shape(task);
  GuessChoices choices(static_cast<std::size_t>(shape.positions));
  Guessers found;
  found.position = equal_positions(task);
  found.task = task;
  found.rating = {};
  for (Eigen::Index begin = 0; begin < cells.size(); begin += shape.of_cell())
    for (int place = 0; place < shape.of_cell(); ++place) {
      const auto right = static_cast<std::size_t>(place / shape.of_trial());
      const auto chosen = static_cast<std::size_t>(place % shape.of_trial() / study::highest_rating);
      if (right == chosen) continue;
      const double n = cells[begin + place];
      choices.wrong[right][chosen] += n;
      found.rating[static_cast<std::size_t>(place % study::highest_rating)] += n;
      found.wrong_answers += n;
    }
  for (int place = 0; place < shape.of_trial(); ++place) {
    const double n = references[place];
    choices.reference[static_cast<std::size_t>(place / study::highest_rating)] += n;
    found.rating[static_cast<std::size_t>(place % study::highest_rating)] += n;
    found.reference_answers += n;
  }
  if (!found.known()) return {.position = equal_positions(task), .task = task};
  for (double& share : found.rating) share /= found.wrong_answers + found.reference_answers;
  found.position_estimated = positions_are_comparable(choices);
  for (int step = 0; found.position_estimated && step < position_steps; ++step) {
    const Positions next = next_positions(choices, found.position);
    double moved = 0;
    for (std::size_t c = 0; c < next.size(); ++c)
      moved = std::max(moved, std::abs(next[c] - found.position[c]));
    found.position = next;
    if (moved < position_tolerance) break;
  }
  return found;
}

SeeingCell fit_seeing(const double* counts, const Guessers& guessers, double tolerance,
                      std::vector<double>* trace) {
  const CellCounts sorted = sort_counts(counts, guessers);
  SeeingCell cell;
  if (sorted.all_right + sorted.all_wrong == 0) {
    cell.saw = cell.noticeability = nan;
    cell.rating_of_seen.fill(cell.saw);
    return cell;
  }
  Ratings v = moment_start(sorted, guessers);
  while (!cell.converged && cell.steps < seeing_steps) {
    if (trace != nullptr) trace->push_back(log_likelihood(sorted, guessers, v));
    const Ratings next = next_seen(sorted, guessers, v);
    double moved = 0;
    for (std::size_t r = 0; r < v.size(); ++r) moved += std::abs(next[r] - v[r]);
    v = next;
    ++cell.steps;
    cell.converged = moved < tolerance;
  }
  cell.log_likelihood = log_likelihood(sorted, guessers, v);
  if (trace != nullptr) trace->push_back(cell.log_likelihood);
  cell.noticeability = mean_of(v);
  for (double part : v) cell.saw += part;
  for (std::size_t r = 0; r < v.size(); ++r) cell.rating_of_seen[r] = cell.saw > 0 ? v[r] / cell.saw : nan;
  return cell;
}

}  // namespace seamline::analysis
