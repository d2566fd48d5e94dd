#include "analysis/statistics/resampling.h"

#include <algorithm>
#include <cassert>

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
      counts(row, static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(people)))) += 1;
  }
  return counts;
}

}  // namespace

MeanVector mean_and_covariance(const Eigen::MatrixXd& noticeability) {
  assert(noticeability.rows() > 0);
  const auto n = static_cast<double>(noticeability.rows());
  const Eigen::VectorXd mean = noticeability.colwise().mean().transpose();
  const Eigen::MatrixXd centred = noticeability.rowwise() - mean.transpose();
  return {.mean = mean, .covariance = centred.transpose() * centred / (std::max(1.0, n - 1) * n)};
}

void for_each_replicate(const Eigen::MatrixXd& noticeability, const ResamplingRequest& request,
                        const std::function<void(int, const Eigen::VectorXd&)>& use) {
  assert(noticeability.rows() > 0);
  const auto people = static_cast<double>(noticeability.rows());
  const int batches = (request.replicates + batch_size - 1) / batch_size;
  run_parallel(batches, request.threads, [&](int batch) {
    const int first = batch * batch_size;
    const int size = std::min(batch_size, request.replicates - first);
    const Eigen::MatrixXd sums = draw_counts(first, size, noticeability.rows(), request.seed) * noticeability;
    for (int row = 0; row < size; ++row) use(first + row, sums.row(row).transpose() / people);
  });
}

}  // namespace seamline::analysis
