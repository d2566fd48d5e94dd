#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

namespace seamline::analysis {

/// A log-likelihood at one place. An invalid place (cuts out of order) has the value -infinity.
struct Evaluation {
  double value = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;  ///< or an approximation to it; only the place of the maximum must be right
};

struct NewtonResult {
  Eigen::VectorXd at;
  Evaluation evaluation;  ///< at `at`
  std::vector<Eigen::VectorXd>
      path;  ///< every place on the way, `at` last: it shows where a search without end was going
  bool converged = false;
  int iterations = 0;
};

/// Maximises by Newton steps, damped while the Hessian is not negative definite and halved while the value
/// falls. Goes on until the gradient is lost in rounding, not until some tolerance: that there is a maximum
/// at all is proved from a small gradient (separation.h).
[[nodiscard]] NewtonResult maximise(const std::function<Evaluation(const Eigen::VectorXd&)>& function,
                                    const Eigen::VectorXd& start, int most_iterations);

}  // namespace seamline::analysis
