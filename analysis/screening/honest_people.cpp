#include "analysis/screening/honest_people.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/screening/correlation_screening.h"
#include "analysis/screening/kurtosis_screening.h"
#include "study/placement/trial.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// From this probability of having looked at nothing a person's answers are no part of what honest people
/// see.
constexpr double most_surely_blind = 0.5;

using ScoreShares = std::array<double, study::highest_rating + 1>;  ///< of noticeability 0 to 4

double mean_of(const ScoreShares& shares) {
  double mean = 0;
  for (std::size_t score = 0; score < shares.size(); ++score)
    mean += static_cast<double>(score) * shares[score];
  return mean;
}

double variance_of(const ScoreShares& shares) {
  double squares = 0;
  for (std::size_t score = 0; score < shares.size(); ++score)
    squares += static_cast<double>(score * score) * shares[score];
  const double mean = mean_of(shares);
  return squares - mean * mean;
}

/// The scores of a stimulus, of a cell, or of all.
struct Scored {
  ScoreShares shares{};
  double answers = 0;
  int parent = 0;  ///< whose mean it is drawn to

  void add(int score) {
    shares[score] += 1;
    answers += 1;
  }
  void finish() {
    if (answers > 0)
      for (double& share : shares) share /= answers;
  }
};

/// Draws each child's shares towards its parent's by tau^2 / (tau^2 + its error^2), tau^2 the variance of the
/// children's mean scores beyond their errors.
void draw_together(std::vector<Scored>& children, const std::vector<Scored>& raw_parents,
                   const std::vector<Scored>& parents) {
  std::vector<double> error2(children.size());
  double beyond = 0, freedom = 0;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Scored& child = children[i];
    const Scored& parent = raw_parents[child.parent];
    if (child.answers == 0) continue;
    error2[i] = variance_of(parent.shares) / child.answers;  // not its own: all equal by chance has none
    const double part = 1 - child.answers / parent.answers,
                 off = mean_of(child.shares) - mean_of(parent.shares);
    beyond += off * off - part * error2[i];
    freedom += part;
  }
  const double tau2 = freedom > 0 ? std::max(beyond / freedom, 0.0) : 0;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const double own = tau2 > 0 && children[i].answers > 0 ? tau2 / (tau2 + error2[i]) : 0;
    const ScoreShares& drawn_to = parents[children[i].parent].shares;
    for (std::size_t score = 0; score < drawn_to.size(); ++score)
      children[i].shares[score] = own * children[i].shares[score] + (1 - own) * drawn_to[score];
  }
}

/// Shares of the scores of each stimulus, over the people who are `trusted`.
std::vector<Scored> fit_stimuli(const ScoreMatrix& scores, const std::vector<bool>& trusted) {
  const int cells = scores.cell.empty() ? 0 : scores.cell.back() + 1;
  std::vector<Scored> all(1), of_cell(static_cast<std::size_t>(cells)), of_stimulus(scores.stimuli.size());
  for (std::size_t i = 0; i < of_stimulus.size(); ++i) of_stimulus[i].parent = scores.cell[i];
  for (const ScoredAnswer& answer : scores.answers) {
    if (!trusted[answer.person]) continue;
    all.front().add(answer.score);
    of_cell[scores.cell[answer.stimulus]].add(answer.score);
    of_stimulus[answer.stimulus].add(answer.score);
  }
  for (std::vector<Scored>* level : {&all, &of_cell, &of_stimulus})
    for (Scored& one : *level) one.finish();
  const std::vector<Scored> raw_cells = of_cell;
  draw_together(of_cell, all, all);
  draw_together(of_stimulus, raw_cells, of_cell);
  return of_stimulus;
}

double logistic(double x) {
  return 1 / (1 + std::exp(-x));
}

/// Standard normal points and weights, evenly spaced.
struct NormalGrid {
  std::vector<double> z, weight;
  NormalGrid() {
    constexpr int quarters = 16;
    double sum = 0;
    for (int quarter = -quarters; quarter <= quarters; ++quarter) {
      const double at = 0.25 * quarter;
      z.push_back(at);
      weight.push_back(std::exp(-at * at / 2));
      sum += weight.back();
    }
    for (double& one : weight) one /= sum;
  }
};

/// The log odds l that a share of right choices needs over people of spread s, read off a table.
class LogOdds {
 public:
  LogOdds(double s, const NormalGrid& grid, double guess_rate)
      : guess_rate_(guess_rate), low_(-7 - 4 * s), step_((14 + 8 * s) / (places - 1)) {
    for (int place = 0; place < places; ++place) {
      double sum = 0;
      for (std::size_t g = 0; g < grid.z.size(); ++g)
        sum += grid.weight[g] * logistic(low_ + place * step_ + s * grid.z[g]);
      saw_.push_back(sum);
    }
  }

  [[nodiscard]] double of(double right) const {
    const double saw = std::clamp((right - guess_rate_) / (1 - guess_rate_), 1e-3, 1 - 1e-3);
    const auto above =
        std::clamp(std::lower_bound(saw_.begin(), saw_.end(), saw), saw_.begin() + 1, saw_.end() - 1);
    const double part = (saw - *(above - 1)) / (*above - *(above - 1));
    return low_ + step_ * (static_cast<double>(above - saw_.begin()) - 1 + part);
  }

 private:
  static constexpr int places = 101;
  double guess_rate_, low_, step_;
  std::vector<double> saw_;  ///< mean over people of the probability to see, rising
};

/// What the spread of people is fitted to: each person's answers and right choices a stimulus.
struct RightChoices {
  Eigen::MatrixXd right, answers;  ///< people x stimuli
  double guess_rate = 0;           ///< how often who sees nothing is right
};

RightChoices right_choices(const ScoreMatrix& scores) {
  RightChoices counts{Eigen::MatrixXd::Zero(scores.score.rows(), scores.score.cols()),
                      Eigen::MatrixXd::Zero(scores.score.rows(), scores.score.cols()), scores.guess_rate};
  for (const ScoredAnswer& answer : scores.answers) {
    counts.answers(answer.person, answer.stimulus) += 1;
    counts.right(answer.person, answer.stimulus) += answer.score > 0 ? 1 : 0;
  }
  return counts;
}

/// Log likelihood of each person's answers at each point of the grid, where the shares of right choices are
/// those of honest people and of a share `blind` who looked at nothing.
Eigen::MatrixXd likelihood_at_points(double s, double blind, const RightChoices& counts,
                                     const std::vector<Scored>& stimuli, const NormalGrid& grid) {
  const auto points = static_cast<Eigen::Index>(grid.z.size()), columns = counts.right.cols();
  Eigen::MatrixXd log_right(columns, points), log_wrong(columns, points);
  const LogOdds log_odds(s, grid, counts.guess_rate);
  const double guess_rate = counts.guess_rate;
  for (Eigen::Index i = 0; i < columns; ++i) {
    const double right = 1 - stimuli[i].shares[0];
    const double l = log_odds.of((right - blind * guess_rate) / (1 - blind));
    for (Eigen::Index g = 0; g < points; ++g) {
      const double p = guess_rate + (1 - guess_rate) * logistic(l + s * grid.z[g]);
      log_right(i, g) = std::log(p);
      log_wrong(i, g) = std::log1p(-p);
    }
  }
  return counts.right * log_right + (counts.answers - counts.right) * log_wrong;
}

/// A spread of people s, each being honest or, with a probability of its largest likelihood, somebody who
/// looked at nothing.
struct SpreadFit {
  double s = 0, log_likelihood = 0;
  std::vector<double> blind;  ///< probability of each person to have looked at nothing
};

SpreadFit fit_spread(double s, const RightChoices& counts, const std::vector<Scored>& stimuli,
                     const NormalGrid& grid) {
  SpreadFit fit{.s = s, .log_likelihood = 0, .blind = {}};
  const double guess_rate = counts.guess_rate;
  double blind = 0.05;
  for (int round = 0; round < 4; ++round) {
    const Eigen::MatrixXd at_point = likelihood_at_points(s, blind, counts, stimuli, grid);
    std::vector<double> ratio;  // of the likelihood of looking at nothing to that of being honest
    fit.log_likelihood = 0;
    for (Eigen::Index p = 0; p < at_point.rows(); ++p) {
      const double top = at_point.row(p).maxCoeff();
      double honest = 0;
      for (Eigen::Index g = 0; g < at_point.cols(); ++g)
        honest += grid.weight[g] * std::exp(at_point(p, g) - top);
      const double right = counts.right.row(p).sum(), wrong = counts.answers.row(p).sum() - right;
      const double log_honest = top + std::log(honest);
      const double log_blind = right * std::log(guess_rate) + wrong * std::log1p(-guess_rate);
      ratio.push_back(std::exp(std::min(log_blind - log_honest, 500.0)));
      fit.log_likelihood += log_honest;
    }
    const double blind_before = blind;
    for (int step = 0; step < 10; ++step) {
      double expected = 0;
      for (const double r : ratio) expected += blind * r / (blind * r + 1 - blind);
      blind = std::min(expected / ratio.size(), 0.5);
    }
    fit.blind.clear();
    for (const double r : ratio) {
      fit.log_likelihood += std::log(blind * r + 1 - blind);
      fit.blind.push_back(blind * r / (blind * r + 1 - blind));
    }
    if (std::abs(blind - blind_before) < 1e-3) break;
  }
  return fit;
}

/// Every so-manieth person, so that at most `most` stay: a spread needs no more.
RightChoices some_people(const RightChoices& counts, Eigen::Index most) {
  const Eigen::Index every = (counts.right.rows() + most - 1) / most;
  const auto rows = Eigen::seq(Eigen::Index{0}, counts.right.rows() - 1, every);
  return {counts.right(rows, Eigen::all), counts.answers(rows, Eigen::all), counts.guess_rate};
}

/// The largest spread whose likelihood is near the largest one.
SpreadFit spread_of_people(const RightChoices& counts, const std::vector<Scored>& stimuli,
                           const NormalGrid& grid) {
  constexpr int most_quarters = 16;
  constexpr double near = 2;
  const RightChoices some = some_people(counts, 200);
  std::vector<SpreadFit> fits;
  double top = -infinity;
  for (int quarters = 0; quarters <= most_quarters; ++quarters) {
    fits.push_back(fit_spread(0.25 * quarters, some, stimuli, grid));
    top = std::max(top, fits.back().log_likelihood);
  }
  while (fits.back().log_likelihood < top - near) fits.pop_back();
  return fit_spread(fits.back().s, counts, stimuli, grid);
}

int draw_rating(const ScoreShares& shares, Random& random) {
  double left = random.uniform() * (1 - shares[0]);
  for (int rating = 1; rating < study::highest_rating; ++rating) {
    left -= shares[rating];
    if (left < 0) return rating;
  }
  return study::highest_rating;
}

}  // namespace

HonestNaming simulate_honest_people(const ScoreMatrix& scores, int people, std::uint64_t seed) {
  HonestNaming naming;
  const Eigen::Index rows = scores.score.rows(), columns = scores.score.cols();
  if (rows < 3 || scores.answers.empty()) return naming;
  const NormalGrid grid;
  const RightChoices counts = right_choices(scores);
  std::vector<bool> trusted(rows, true);
  std::vector<Scored> stimuli;
  for (int round = 0; round < 3; ++round) {
    stimuli = fit_stimuli(scores, trusted);
    const SpreadFit fit = spread_of_people(counts, stimuli, grid);
    naming.people_sd = fit.s;
    const std::vector<bool> before = trusted;
    for (std::size_t p = 0; p < trusted.size(); ++p) trusted[p] = fit.blind[p] < most_surely_blind;
    if (trusted == before) break;
  }
  const LogOdds log_odds(naming.people_sd, grid, counts.guess_rate);
  const double guess_rate = counts.guess_rate;
  std::vector<double> l;
  l.reserve(stimuli.size());
  for (const Scored& stimulus : stimuli) l.push_back(log_odds.of(1 - stimulus.shares[0]));

  int by_kurtosis = 0, by_correlation = 0;
  for (std::uint64_t replicate = 0; naming.simulated < people; ++replicate) {
    Random random(mix_bits(seed ^ 0x686f6e657374ULL), replicate);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rows, columns);
    Eigen::VectorXd shift(rows);
    for (double& one : shift) one = naming.people_sd * random.normal();
    for (const ScoredAnswer& answer : scores.answers) {
      const std::size_t i = answer.stimulus;
      const bool right =
          random.uniform() < guess_rate + (1 - guess_rate) * logistic(l[i] + shift[answer.person]);
      if (right) sum(answer.person, answer.stimulus) += draw_rating(stimuli[i].shares, random);
    }
    const Eigen::MatrixXd score =
        (counts.answers.array() > 0).select(sum.array() / counts.answers.array().max(1.0), nan).matrix();
    for (const KurtosisCount& count : screen_by_kurtosis(score)) by_kurtosis += count.rejected ? 1 : 0;
    for (const CorrelationCheck& check : screen_by_correlation(score, scores.cell))
      by_correlation += check.rejected ? 1 : 0;
    naming.simulated += static_cast<int>(rows);
  }
  naming.kurtosis = by_kurtosis / static_cast<double>(naming.simulated);
  naming.correlation = by_correlation / static_cast<double>(naming.simulated);
  return naming;
}

}  // namespace seamline::analysis
