#pragma once
#include <functional>

#include "analysis/ordinal/likelihood/mixed_fit.h"
#include "analysis/scores/cells.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "study/observers/observer.h"

namespace seamline::stability {

/// Noticeability of simulated `threshold` observers under one artifact, three objects at the seven widths of
/// the paper, as analysis averages it.
[[nodiscard]] ArtifactScores simulated_scores(int people, std::uint64_t seed);

/// One person: no standard error, no interval, no model of differences between people. Counts numbers that
/// nobody can know.
[[nodiscard]] Finding try_one_participant();

/// 10,000 people: distance of PT from the planted value in standard errors of its own interval.
[[nodiscard]] Finding try_ten_thousand_participants(int threads);

/// Everybody gives the same rating to everything: 0, 2 and 4. Counts widths and estimates that nothing says,
/// and people who are called odd.
[[nodiscard]] Finding try_constant_ratings();

/// How ordinal scores are fitted; the product's is `fit_cumulative_link`.
using OrdinalRule = std::function<OrdinalFit(const OrdinalData& data)>;
[[nodiscard]] OrdinalFit ordinal_as_product(const OrdinalData& data);

/// Completely and quasi-completely separated scores, constant scores, and one answer less than separated.
/// Counts fits that have numbers without a maximum, or none with one.
[[nodiscard]] Finding try_separation(const OrdinalRule& rule = ordinal_as_product);

/// A predictor that is a copy of another, constant, or the sum of two others: the information matrix is
/// singular. Counts fits that have numbers.
[[nodiscard]] Finding try_singular_design(const OrdinalRule& rule = ordinal_as_product);

/// A predictor given as 1e6 + 1e-4 x: relative difference of its coefficient, in the same units.
[[nodiscard]] Finding try_units(const OrdinalRule& rule = ordinal_as_product);

/// Curves of constant, straight, step-like and rising means: counts verdicts that are not as wanted.
[[nodiscard]] Finding try_stiff_curves();

/// Twelve people who answer exactly alike: the group's interval must hold the estimate and keep its width.
/// Counts what is otherwise.
[[nodiscard]] Finding try_identical_people();

}  // namespace seamline::stability
