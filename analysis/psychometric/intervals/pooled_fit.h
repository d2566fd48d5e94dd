#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/fit_intervals.h"
#include "analysis/psychometric/intervals/verdict.h"
#include "stimuli/definition/artifact.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Choices of several participants at the same levels.
struct PooledChoices {
  std::vector<double> level;        ///< rising, e.g. depth widths in px
  std::vector<std::string> people;  ///< codes
  Eigen::MatrixXd correct, trials;  ///< people x levels; whole numbers
};

/// The choices of the named participants under one artifact and condition, all objects together, in the order
/// of `codes`;
/// participants without an answer are left out.
[[nodiscard]] PooledChoices pooled_choices(const study::LogContents& log,
                                           const std::vector<std::string>& codes, Artifact artifact,
                                           const std::string& condition = "");

/// A psychometric function of a group, whose members differ.
struct PooledFit {
  PsychometricFit fit;              ///< to the sums over people
  Interval threshold_ci95;          ///< for the group's function, over participants as well as trials
  Verdict verdict;                  ///< from that interval
  std::optional<double> threshold;  ///< exactly where the interval is closed; of a step the middle
  /// Variance of the threshold over participants (delete-one jackknife) over the one that independent
  /// binomial answers would give: how much too short the plain interval is, squared.
  double design_effect = 1;
};

/// Fits the sums over people. The interval is that of the profile likelihood at
///
///     2 (ln L_max - ln L_profile) <= c t^2,   c = V_jackknife / V_information
///
/// with the 0.975 quantile t of Student's distribution with people - 1 degrees of freedom and V the variances
/// of the threshold on the axis: the shape (skew, open ends) of the likelihood with the size that
/// participants give it. Measured coverage: documentation/evidence/statistics.md. Throws InputError
/// with fewer than two people, and as `fit_psychometric` does.
[[nodiscard]] PooledFit fit_pooled_choices(const PooledChoices& choices, const FitOptions& options,
                                           const std::string& unit = "px");

}  // namespace seamline::analysis
