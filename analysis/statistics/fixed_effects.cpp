#include "analysis/statistics/fixed_effects.h"

#include <Eigen/Eigenvalues>

namespace seamline::analysis {

namespace {

/// Subtracts each group's mean; the largest change.
double subtract_means(const std::vector<int>& group, int groups, Eigen::MatrixXd& columns) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(groups, columns.cols());
  Eigen::VectorXd count = Eigen::VectorXd::Zero(groups);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const int g = group[i];
    sums.row(g) += columns.row(i);
    count[g] += 1;
  }
  for (Eigen::Index g = 0; g < groups; ++g)
    if (count[g] > 0) sums.row(g) /= count[g];
  for (Eigen::Index i = 0; i < columns.rows(); ++i) columns.row(i) -= sums.row(group[i]);
  return sums.cwiseAbs().maxCoeff();
}

/// Least squares of S b = s in the directions in which S is not flat; `rank` of them.
Eigen::VectorXd solved(const Eigen::MatrixXd& s_xx, const Eigen::VectorXd& s_xy, double flat, int* rank) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(s_xx);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(s_xy.size());
  *rank = 0;
  for (Eigen::Index i = 0; i < s_xy.size(); ++i) {
    if (!(parts.eigenvalues()[i] > flat)) continue;
    const Eigen::VectorXd direction = parts.eigenvectors().col(i);
    b += direction * (direction.dot(s_xy) / parts.eigenvalues()[i]);
    ++*rank;
  }
  return b;
}

}  // namespace

Eigen::MatrixXd without_effects(const TwoWayData& data, Eigen::MatrixXd columns) {
  constexpr int most_turns = 200;
  constexpr double small = 1e-10;
  for (int turn = 0; turn < most_turns; ++turn) {
    const double by_stimulus = subtract_means(data.stimulus, data.stimuli, columns);
    if (by_stimulus < small && turn > 0) break;
    (void)subtract_means(data.person, data.people, columns);
  }
  return columns;
}

TwoWayFit fit_two_way(TwoWayData data) {
  constexpr double flat_share = 1e-6;  // of what X varies before the effects are taken out
  TwoWayFit fit;
  const Eigen::Index k = data.x.cols(), n = data.people;
  if (data.y.size() == 0 || n < 2) return fit;
  const double before = (data.x.rowwise() - data.x.colwise().mean()).squaredNorm();
  Eigen::MatrixXd columns(data.y.size(), k + 1);
  columns << data.x, data.y;
  columns = without_effects(data, std::move(columns));
  std::vector<Eigen::MatrixXd> of_person(n, Eigen::MatrixXd::Zero(k, k + 1));
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(k, k + 1);
  for (Eigen::Index i = 0; i < columns.rows(); ++i)
    of_person[data.person[i]] += columns.row(i).head(k).transpose() * columns.row(i);
  for (const Eigen::MatrixXd& one : of_person) all += one;
  int rank = 0;
  fit.b = solved(all.leftCols(k), all.col(k), flat_share * before, &rank);
  if (rank == 0) return fit;
  fit.without.resize(n, k);
  for (Eigen::Index person = 0; person < n; ++person) {
    const Eigen::MatrixXd rest = all - of_person[person];
    int rank_without = 0;
    fit.without.row(person) =
        solved(rest.leftCols(k), rest.col(k), flat_share * before, &rank_without).transpose();
    if (rank_without != rank) return fit;
  }
  const Eigen::MatrixXd centred = fit.without.rowwise() - fit.without.colwise().mean();
  // A person is also in the means that were taken out: from the mean of the others they are n / (n - 1) as
  // far.
  const double people = n;
  fit.covariance = centred.transpose() * centred * (people / (people - 1));
  fit.determined = true;
  return fit;
}

}  // namespace seamline::analysis
