#include "analysis/joint/joint_sharing.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/joint/joint_cell.h"
#include "analysis/joint/joint_placed.h"
#include "analysis/joint/joint_thresholds.h"
#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Which coordinate of the poorer model stands for each of the richer one.
std::vector<Eigen::Index> poorer_of(const JointModel& rich, const JointModel& poor) {
  std::vector<Eigen::Index> map(rich.parameters());
  const auto to = [&](Eigen::Index from, Eigen::Index into) { map[from] = into; };
  for (int c = 0; c < rich.curves; ++c) {
    to(rich.threshold(c), poor.threshold(c));
    to(rich.log_scale(c), poor.log_scale(c));
    to(rich.lapse(c), poor.lapse(c));
    if (rich.ratings == 1) continue;
    for (Eigen::Index k = 0; k < rich.ratings; ++k) to(rich.first_cut(c) + k, poor.first_cut(c) + k);
    for (Eigen::Index r = 0; r < rich.ratings - 1; ++r) to(rich.first_guess(c) + r, poor.first_guess(c) + r);
  }
  if (rich.between_people) to(rich.log_between(), poor.log_between());
  return map;
}

/// Weights N (rich x q) with contrasts of each shared coordinate's copies against the first.
Eigen::MatrixXd differences_of_copies(const std::vector<Eigen::Index>& map, Eigen::Index poor) {
  const auto rich = static_cast<Eigen::Index>(map.size());
  std::vector<Eigen::Index> first(poor, -1);
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(rich, rich - poor);
  Eigen::Index column = 0;
  for (Eigen::Index i = 0; i < rich; ++i) {
    Eigen::Index& before = first[map[i]];
    if (before < 0) {
      before = i;
      continue;
    }
    weights(i, column) = 1;
    weights(before, column++) = -1;
  }
  return weights;
}

void write_hotelling(const Eigen::MatrixXd& scores, SharingTest& test) {
  const auto n = static_cast<double>(scores.rows()), q = static_cast<double>(scores.cols());
  const Eigen::RowVectorXd mean = scores.colwise().mean();
  const Eigen::MatrixXd away = scores.rowwise() - mean;
  const Eigen::MatrixXd covariance = away.transpose() * away / (n - 1);
  const Eigen::LDLT<Eigen::MatrixXd> factor(covariance);
  const Eigen::VectorXd diagonal = factor.vectorD();
  if (factor.info() != Eigen::Success || !(diagonal.minCoeff() > 1e-12 * diagonal.maxCoeff())) {
    test.note = "the answers say nothing about some of these differences";
    return;
  }
  const double squared = n * mean.dot(factor.solve(mean.transpose()));
  test.statistic = squared * (n - q) / (q * (n - 1));
  test.p = fisher_above(q, n - q, test.statistic);
}

/// The same of pooled answers and of levels that the answers placed.
PeopleScores scores_of_people(const JointModel& model, const JointData& data, const Eigen::VectorXd& theta) {
  if (model.between_people) return placed_scores(model, data, theta);
  return {.information = -joint_likelihood(model, all_counts(data), theta).hessian,
          .scores = person_scores(model, data, theta)};
}

SharingTest test_block(const std::string& name, const JointFit& fit, const JointData& data,
                       const JointSharing& richer) {
  SharingTest test{.shared = name, .parameters = 0, .statistic = nan, .p = nan, .note = {}};
  JointModel rich = fit.model;
  rich.sharing = richer;
  const std::vector<Eigen::Index> map = poorer_of(rich, fit.model);
  Eigen::VectorXd theta(rich.parameters());
  Eigen::MatrixXd embed = Eigen::MatrixXd::Zero(rich.parameters(), fit.model.parameters());
  for (Eigen::Index i = 0; i < rich.parameters(); ++i) {
    theta[i] = fit.theta[map[i]];
    embed(i, map[i]) = 1;
  }
  test.parameters = static_cast<int>(rich.parameters() - fit.model.parameters());
  if (fit.people <= test.parameters) {
    test.note = fmt::format("needs more than {} people", test.parameters);
    return test;
  }
  const auto [information, people] = scores_of_people(rich, data, theta);
  const Eigen::MatrixXd within = embed.transpose() * information * embed;
  // Scores whose weights g satisfy g' A L = 0 do not move with the poorer model's own estimates.
  const Eigen::MatrixXd weights = differences_of_copies(map, fit.model.parameters());
  const Eigen::MatrixXd efficient =
      weights - embed * within.ldlt().solve(embed.transpose() * information * weights);
  write_hotelling(people * efficient, test);
  return test;
}

/// Derivative of P(R >= k | seen) by the logarithm of its own spread, k from 2.
double by_own_spread(const JointCurve& curve, double x, int k) {
  const double u = ((curve.m - x) / curve.s - curve.t[k - 2]) / curve.rho;
  return -u * std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi);
}

/// Scores of every outcome by log rho_k of k = 3..K, which are 0 but for right answers rated k - 1 and k.
Eigen::MatrixXd spread_scores(const JointFit& fit, const Eigen::MatrixXd& probability) {
  const int ratings = fit.model.ratings;
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(ratings - 2, probability.size());
  for (std::size_t c = 0; c < fit.model.cells.size(); ++c) {
    const JointCell& cell = fit.model.cells[c];
    if (!std::isfinite(cell.x)) continue;
    const JointCurve curve = curve_at(fit.model, fit.theta, cell.curve);
    const double seen = seen_at(fit, cell.curve, cell.x);
    for (int k = 3; k <= ratings; ++k) {
      const double moved = seen * by_own_spread(curve, cell.x, k);
      const Eigen::Index at = static_cast<Eigen::Index>(c) * 2 * ratings + k - 1;
      scores(k - 3, at) += moved / std::max(least_probability, probability(at));
      scores(k - 3, at - 1) -= moved / std::max(least_probability, probability(at - 1));
    }
  }
  return scores;
}

/// Whether every rating's curve is as steep as the others' (proportional odds, here parallel normal curves).
SharingTest test_parallel_ratings(const JointFit& fit, const JointData& data) {
  const int ratings = fit.model.ratings;
  SharingTest test{
      .shared = "spread of every rating", .parameters = ratings - 2, .statistic = nan, .p = nan, .note = {}};
  if (fit.people <= test.parameters) {
    test.note = fmt::format("needs more than {} people", test.parameters);
    return test;
  }
  const Eigen::Index width = data.cell_counts();
  const Eigen::VectorXd counts = all_counts(data).cells;
  Eigen::VectorXd probability(counts.size()), expected(counts.size());
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(c) * width;
    probability.segment(first, width) = outcome_probabilities(
        curve_at(fit.model, fit.theta, data.cells[c].curve), data.cells[c].x, data.cells[c].chance);
    expected.segment(first, width) = counts.segment(first, width).sum() * probability.segment(first, width);
  }
  const Eigen::MatrixXd own = spread_scores(fit, probability), shared = outcome_scores(fit.model, fit.theta);
  // Expected information; what the shared coordinates explain of the scores is taken out.
  const Eigen::MatrixXd information = shared * expected.asDiagonal() * shared.transpose();
  const Eigen::MatrixXd mixed = shared * expected.asDiagonal() * own.transpose();
  const Eigen::MatrixXd penalty = -joint_penalty(fit.model, fit.theta).hessian;
  const Eigen::MatrixXd explained = (information + penalty).ldlt().solve(mixed);
  write_hotelling(data.answers * (own - explained.transpose() * shared).transpose(), test);
  return test;
}

/// The block that the answers refuse most; null where none is refused.
const SharingTest* most_refused(const std::vector<SharingTest>& tests) {
  const SharingTest* worst = nullptr;
  for (const SharingTest& test : tests)
    if (test.block != nullptr && std::isfinite(test.p) &&
        test.p < (worst == nullptr ? refused_sharing_p : worst->p))
      worst = &test;
  return worst;
}

/// How many curves have numbers.
std::ptrdiff_t numbers_of(const JointFit& fit) {
  return std::count(fit.curves.begin(), fit.curves.end(), std::nullopt);
}

}  // namespace

std::vector<SharingTest> test_sharing(const JointFit& fit, const JointData& data) {
  std::vector<SharingTest> tests;
  if (fit.model.ratings > 2 && !fit.model.between_people) tests.push_back(test_parallel_ratings(fit, data));
  if (fit.model.curves < 2) return tests;
  const auto add = [&](const char* name, bool JointSharing::*block) {
    if (!(fit.model.sharing.*block)) return;
    JointSharing richer = fit.model.sharing;
    richer.*block = false;
    tests.push_back(test_block(name, fit, data, richer));
    tests.back().block = block;
  };
  add("scale", &JointSharing::scale);
  if (fit.model.ratings > 1) add("rating criteria", &JointSharing::criteria);
  add("lapse rate", &JointSharing::lapse);
  if (fit.model.ratings > 1) add("guess ratings", &JointSharing::guess_ratings);
  return tests;
}

std::string sentence_of_sharing() {
  return fmt::format(
      "what curves of the joint model share, where the study does not say it: scale, rating criteria, lapse "
      "rate and guess ratings; the block that a robust score test refuses most (p below {}) becomes each "
      "curve's own, until none is refused",
      refused_sharing_p);
}

SharedFit fit_shared(const JointData& data, const JointSharing& sharing, bool decided, JointFitter fitter) {
  SharedFit found{.fit = fitter(data, sharing), .tests = {}, .refused = {}};
  if (!found.fit.estimated()) return found;
  found.tests = test_sharing(found.fit, data);
  std::vector<SharingTest> tests = found.tests;
  while (decided) {
    const SharingTest* worst = most_refused(tests);
    if (worst == nullptr) break;
    JointSharing richer = found.fit.model.sharing;
    richer.*worst->block = false;
    JointFit fit = fitter(data, richer);
    if (!fit.estimated() || numbers_of(fit) < numbers_of(found.fit)) break;
    found.refused.push_back(*worst);
    found.fit = std::move(fit);
    tests = test_sharing(found.fit, data);
  }
  return found;
}

}  // namespace seamline::analysis
