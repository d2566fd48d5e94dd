#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "support/running/parallel.h"

namespace seamline::analysis {

/// How participants are resampled. The same request gives the same bits for any number of threads.
struct ResamplingRequest {
  int replicates = 10000;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as the machine has
};

/// Means over participants and the covariance of those means.
struct MeanVector {
  Eigen::VectorXd mean;        ///< one a width
  Eigen::MatrixXd covariance;  ///< of `mean`: S / n with S of n - 1; zero when n is 1
};

/// `noticeability` is people x widths, at least one person.
[[nodiscard]] MeanVector mean_and_covariance(const Eigen::MatrixXd& noticeability);

/// Calls `use(replicate, mean)` with the means at the widths for every bootstrap replicate: people drawn with
/// replacement, as many as there are. Replicate r draws from stream r of the seed, whatever thread it runs
/// on, so artifacts that share people also share replicates. `use` is called from several threads, never
/// twice for one replicate.
void for_each_replicate(const Eigen::MatrixXd& noticeability, const ResamplingRequest& request,
                        const std::function<void(int replicate, const Eigen::VectorXd& mean)>& use);

}  // namespace seamline::analysis
