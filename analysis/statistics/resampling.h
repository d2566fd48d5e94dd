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

/// Means over participants and the covariance of those means. Where scores are missing (NaN) each mean is
/// over those who have one, and two means covary by the people who have both:
///
///     cov(m_j, m_k) = n_jk / (n_j n_k) S_jk,    S_jk of the n_jk people with n_jk - 1
struct MeanVector {
  Eigen::VectorXd mean;        ///< one a width
  Eigen::MatrixXd covariance;  ///< of `mean`: S / n with S of n - 1; zero when n is 1
  int fewest = 0;              ///< people in the mean with the fewest
};

/// `noticeability` is people x widths, at least one person; NaN where there is no answer. A mean of nobody is
/// NaN.
[[nodiscard]] MeanVector mean_and_covariance(const Eigen::MatrixXd& noticeability);

/// Calls `use(replicate, mean)` with the means at the widths for every bootstrap replicate: people drawn with
/// replacement, as many as there are; each mean is over those drawn who have a score (NaN: none), and that of
/// everybody where no one of them was drawn. Replicate r draws from stream r of the seed, whatever thread it
/// runs on, so artifacts that share people also share replicates. Of more than `many_people` that many blocks
/// of people are drawn, whose sums vary as the people's do. `use` is called from several threads, never
/// twice for one replicate.
void for_each_replicate(const Eigen::MatrixXd& noticeability, const ResamplingRequest& request,
                        const std::function<void(int replicate, const Eigen::VectorXd& mean)>& use);

}  // namespace seamline::analysis
