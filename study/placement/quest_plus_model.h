#pragma once
#include <vector>

#include "study/placement/quest_plus.h"
#include "study/placement/quest_plus_grid.h"
#include "study/placement/trial.h"

namespace seamline::study {

/// How many outcomes the definition tells apart: 2 (wrong, right) or 5 (noticeability 0 to 4).
[[nodiscard]] int outcome_count(const QuestPlusDefinition& definition);

/// The outcome of an answer whose right choice was `object_index` (from 1).
[[nodiscard]] int outcome_of(const QuestPlusDefinition& definition, const TrialAnswer& answer,
                             int object_index);

/// The level that stands for a place on the axis.
[[nodiscard]] double level_of(Axis axis, double on_axis);

/// Probability of each outcome at a level x, for one point of the grid: threshold t and scale s on the axis
/// a(x) = log2 x or x, lapse l, guess g, rating step r, with a sigmoid F that is 0.5 at 0, and d = -1 where
/// noticeability falls with the level, 1 where it rises.
///
///     P(noticeability >= 1) = g + (1 - g - l) F(d (a(x) - t) / s)
///     P(noticeability >= k) = (1 - l / (1 - g)) F(d (a(x) - t) / s - (k - 1) r / s),   k = 2, 3, 4
///
/// The first line is the psychometric function of study/placement/psychometric_function.h, and all there is
/// when the outcome is binary. The lines below it say of the same person: in a share l / (1 - g) of the
/// trials they do not look, and who guesses right without having seen rates 1.
///
/// With outcome `joint` they are those of the joint model (documentation/explanation/joint_model.md): seen
/// with psi, rated by a cumulative link whose first criterion lies f scales and further ones steps r beyond
/// the threshold, or guessed and rated by g(k), proportional to the (k - 1)th power of the guess rating:
///
///     psi = (1 - l) F(d (a(x) - t) / s),     Q(k) = F((d (a(x) - t) - (k - 2) r) / s - f),   k = 2, 3, 4
///     P(0) = (1 - psi) (1 - g),    P(k) = psi (Q(k) - Q(k + 1)) + (1 - psi) g g(k),   Q(1) = 1, Q(5) = 0
[[nodiscard]] std::vector<double> outcome_probabilities(const QuestPlusDefinition& definition,
                                                        const QuestPlusGrid& grid, int point, double level);

/// The tables of a track whose stimuli have these levels, above 0 on the log2 axis.
[[nodiscard]] QuestPlusTables make_level_tables(const QuestPlusDefinition& definition,
                                                const QuestPlusGrid& grid, const std::vector<double>& levels);

}  // namespace seamline::study
