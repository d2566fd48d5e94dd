#include "analysis/ordinal/likelihood/gauss_hermite.h"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>
#include <numbers>

namespace seamline::analysis {

GaussHermite gauss_hermite(int nodes) {
  assert(nodes >= 1 && nodes <= 100);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(nodes);
  Eigen::VectorXd off(nodes - 1);
  for (int i = 1; i < nodes; ++i) off[i - 1] = std::sqrt(i / 2.0);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, off);
  GaussHermite rule{
      .node = solver.eigenvalues(),
      .weight = solver.eigenvectors().row(0).transpose().cwiseAbs2() * std::sqrt(std::numbers::pi)};
  for (int i = 0; i < nodes; ++i) {  // rounding breaks the symmetry that the integral has
    const int j = nodes - 1 - i;
    if (i > j) break;
    const double node = (rule.node[j] - rule.node[i]) / 2;
    const double weight = (rule.weight[i] + rule.weight[j]) / 2;
    rule.node[i] = -node;
    rule.node[j] = node;
    rule.weight[i] = rule.weight[j] = weight;
  }
  return rule;
}

}  // namespace seamline::analysis
