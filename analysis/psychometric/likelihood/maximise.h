#pragma once
#include <array>
#include <optional>

#include "analysis/psychometric/likelihood/fit_problem.h"

namespace seamline::analysis {

/// The level that an interval is about: where F is a share (0.5: the threshold), or where psi is a
/// probability.
struct SoughtLevel {
  enum class Of { sigmoid, response } of = Of::sigmoid;
  double share = 0.5;
};

/// What is held while the rest is maximised. The first coordinate is the sought level's place on the unit
/// axis instead of the threshold: m = place - sign s z, F(z) = the share that psi or F has there.
struct Held {
  std::array<bool, 4> fixed{};
  SoughtLevel level = {};
};

struct Maximum {
  Theta theta = Theta::Zero();
  double eta = 0;
  double value = 0;  ///< of the objective
  bool converged = false;
};

/// Climbs from `start` by Newton's method where the curvature allows it, else by Fisher scoring, damped
/// (Levenberg), within the problem's box; a parameter at its bound stays there while the slope points
/// outward. With an overdispersed problem eta is maximised in turn with the rest. `coordinates` are theta
/// with the sought level's place first; held ones keep their value. Finds the local maximum of the start.
[[nodiscard]] Maximum maximise(const FitProblem& problem, const Held& held, const Theta& coordinates,
                               double eta);

/// The sought level's place on the unit axis under theta; none when psi never has that probability.
[[nodiscard]] std::optional<double> place_of(const FitProblem& problem, const Theta& theta,
                                             const SoughtLevel& level);

/// theta with the threshold moved so that the sought level is at `place`; none as above.
[[nodiscard]] std::optional<Theta> theta_with(const FitProblem& problem, const Theta& coordinates,
                                              const SoughtLevel& level);

/// eta in [0, 0.95] that maximises the beta-binomial likelihood at theta.
[[nodiscard]] double likeliest_eta(const FitProblem& problem, const Theta& theta);

}  // namespace seamline::analysis
