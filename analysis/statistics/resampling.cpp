#include "analysis/statistics/resampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/statistics/many_people.h"
#include "support/arithmetic/random.h"

namespace seamline::analysis {

namespace {

/// Replicates that are computed together as one matrix product. Fixed, so that sums do not depend on threads.
constexpr int batch_size = 64;

/// Keeps the bootstrap's numbers apart from those of simulated observers that were given the same seed.
constexpr std::uint64_t bootstrap_domain = 0x626f6f7473747261ULL;

/// How often each person was drawn, one row a replicate.
Eigen::MatrixXd draw_counts(int first_replicate, int replicates, Eigen::Index people, std::uint64_t seed) {
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(replicates, people);
  for (int row = 0; row < replicates; ++row) {
    Random random(seed ^ bootstrap_domain, static_cast<std::uint64_t>(first_replicate + row));
    for (Eigen::Index draw = 0; draw < people; ++draw)
      counts(row, static_cast<Eigen::Index>(random.below(people))) += 1;
  }
  return counts;
}

/// The same with 0 where there is no score, and 1 and 0 for who has one.
struct Answered {
  Eigen::MatrixXd score, has;
};

Answered split_missing(const Eigen::MatrixXd& noticeability) {
  const auto has = (noticeability.array() == noticeability.array()).eval();  // NaN is not
  return {has.select(noticeability, 0.0), has.cast<double>()};
}

/// Sums and numbers of scores of blocks of people: person p is of block p modulo `many_people`.
Answered blocks_of(const Eigen::MatrixXd& noticeability) {
  const Eigen::Index columns = noticeability.cols();
  Answered blocks{.score = Eigen::MatrixXd::Zero(many_people, columns),
                  .has = Eigen::MatrixXd::Zero(many_people, columns)};
  for (Eigen::Index column = 0; column < columns; ++column)
    for (Eigen::Index p = 0; p < noticeability.rows(); ++p) {
      if (std::isnan(noticeability(p, column))) continue;
      blocks.score(p % many_people, column) += noticeability(p, column);
      blocks.has(p % many_people, column) += 1;
    }
  return blocks;
}

MeanVector mean_of_incomplete(const Eigen::MatrixXd& noticeability) {
  const auto [score, has] = split_missing(noticeability);
  const Eigen::VectorXd n = has.colwise().sum().transpose();
  MeanVector means{.mean = score.colwise().sum().transpose().array() / n.array(),
                   .covariance = Eigen::MatrixXd::Zero(score.cols(), score.cols()),
                   .fewest = static_cast<int>(n.minCoeff())};
  for (Eigen::Index j = 0; j < score.cols(); ++j)
    for (Eigen::Index k = 0; k < score.cols(); ++k) {
      const Eigen::VectorXd both = has.col(j).cwiseProduct(has.col(k));
      const double people = both.sum();
      if (people < 2) continue;
      const double mean_j = both.dot(score.col(j)) / people, mean_k = both.dot(score.col(k)) / people;
      const Eigen::VectorXd off_j = score.col(j).array() - mean_j, off_k = score.col(k).array() - mean_k;
      const double s = both.dot(off_j.cwiseProduct(off_k)) / (people - 1);
      means.covariance(j, k) = people / (n[j] * n[k]) * s;
    }
  const Eigen::VectorXd sd = means.covariance.diagonal().cwiseSqrt();
  const Eigen::MatrixXd most =
      sd * sd.transpose();  // of others than the variances, it might correlate over 1
  means.covariance = means.covariance.cwiseMin(most).cwiseMax(-most);
  return means;
}

}  // namespace

MeanVector mean_and_covariance(const Eigen::MatrixXd& noticeability) {
  assert(noticeability.rows() > 0);
  if (noticeability.hasNaN()) return mean_of_incomplete(noticeability);
  const double n = noticeability.rows();
  const Eigen::VectorXd mean = noticeability.colwise().mean().transpose();
  const Eigen::MatrixXd centred = noticeability.rowwise() - mean.transpose();
  return {.mean = mean,
          .covariance = centred.transpose() * centred / (std::max(1.0, n - 1) * n),
          .fewest = static_cast<int>(noticeability.rows())};
}

void for_each_replicate(const Eigen::MatrixXd& noticeability, const ResamplingRequest& request,
                        const std::function<void(int, const Eigen::VectorXd&)>& use) {
  assert(noticeability.rows() > 0);
  const bool complete = !noticeability.hasNaN(), many = noticeability.rows() > many_people;
  Answered answered;
  if (many) answered = blocks_of(noticeability);
  if (!many && !complete) answered = split_missing(noticeability);
  const Eigen::MatrixXd& score = many || !complete ? answered.score : noticeability;
  Eigen::VectorXd of_everybody;
  if (!complete)
    of_everybody =
        answered.score.colwise().sum().transpose().array() / answered.has.colwise().sum().transpose().array();
  const int batches = (request.replicates + batch_size - 1) / batch_size;
  run_parallel(batches, request.threads, [&](int batch) {
    const int first = batch * batch_size;
    const int size = std::min(batch_size, request.replicates - first);
    const Eigen::MatrixXd drawn = draw_counts(first, size, score.rows(), request.seed);
    const Eigen::MatrixXd sums = drawn * score;
    if (!complete) {
      const Eigen::MatrixXd n = drawn * answered.has;
      for (int row = 0; row < size; ++row)
        use(first + row,
            (n.row(row).array() > 0)
                .select(sums.row(row).array() / n.row(row).array(), of_everybody.transpose().array())
                .matrix()
                .transpose());
      return;
    }
    const Eigen::VectorXd people = many ? Eigen::VectorXd(drawn * answered.has.col(0))
                                        : Eigen::VectorXd::Constant(size, static_cast<double>(score.rows()));
    for (int row = 0; row < size; ++row) use(first + row, sums.row(row).transpose() / people[row]);
  });
}

}  // namespace seamline::analysis
