#include "analysis/ordinal/likelihood/marginal_likelihood.h"

#include <algorithm>

#include "analysis/ordinal/likelihood/participant_integral.h"
#include "support/running/parallel.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Participants that are summed together. Fixed, so that sums do not depend on threads.
constexpr int chunk_participants = 16;
constexpr int fewest_hessian_nodes = 9;

ParticipantPart part_of(const ParticipantIntegral& integral, const Quadrature& quadrature) {
  ParticipantPart result;
  if (!integral.valid()) {
    result.part.value = -infinity;
    return result;
  }
  result.part.value = integral.value_and_gradient(quadrature.likelihood, result.part.gradient);
  result.part.hessian = integral.hessian(quadrature.hessian);
  result.mode = integral.mode();
  return result;
}

Eigen::VectorXd x_beta_of(const OrdinalProblem& problem, const Eigen::VectorXd& parameters) {
  return problem.x * parameters.segment(problem.cuts(), problem.x.cols());
}

RowRange rows_of(const OrdinalProblem& problem, int participant) {
  const std::size_t p = participant;
  return {.begin = problem.first_row[p], .end = problem.first_row[p + 1]};
}

}  // namespace

Quadrature::Quadrature(int nodes)
    : likelihood(gauss_hermite(nodes)), hessian(gauss_hermite(std::max(nodes, fewest_hessian_nodes))) {}

Evaluation marginal_likelihood(const OrdinalProblem& problem, Link link, const Quadrature& quadrature,
                               const Eigen::VectorXd& parameters, int threads) {
  const Eigen::VectorXd x_beta = x_beta_of(problem, parameters);
  const Eigen::Index size = parameters.size();
  const int chunks = (problem.participants() + chunk_participants - 1) / chunk_participants;
  const Evaluation nothing{
      .value = 0, .gradient = Eigen::VectorXd::Zero(size), .hessian = Eigen::MatrixXd::Zero(size, size)};
  std::vector<Evaluation> parts(chunks, nothing);
  run_parallel(chunks, threads, [&](int chunk) {
    Evaluation& sum = parts[chunk];
    const int first = chunk * chunk_participants;
    for (int p = first; p < std::min(problem.participants(), first + chunk_participants); ++p) {
      const ParticipantPart of_one =
          part_of({problem, link, parameters, x_beta, rows_of(problem, p)}, quadrature);
      sum.value += of_one.part.value;
      if (of_one.part.gradient.size() == 0) return;
      sum.gradient += of_one.part.gradient;
      sum.hessian += of_one.part.hessian;
    }
  });
  Evaluation sum = nothing;
  for (const Evaluation& part : parts) {
    sum.value += part.value;
    sum.gradient += part.gradient;
    sum.hessian += part.hessian;
  }
  return sum;
}

std::vector<ParticipantPart> participant_parts(const OrdinalProblem& problem, Link link,
                                               const Quadrature& quadrature,
                                               const Eigen::VectorXd& parameters, int threads) {
  const Eigen::VectorXd x_beta = x_beta_of(problem, parameters);
  std::vector<ParticipantPart> parts(problem.participants());
  run_parallel(problem.participants(), threads, [&](int p) {
    parts[p] = part_of({problem, link, parameters, x_beta, rows_of(problem, p)}, quadrature);
  });
  return parts;
}

}  // namespace seamline::analysis
