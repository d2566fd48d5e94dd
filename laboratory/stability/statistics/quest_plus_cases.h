#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "study/placement/quest_plus.h"

namespace seamline::stability {

/// How an answer is learnt from; the product's is `learn`, which keeps logarithms.
using LearnRule = std::function<void(QuestPlusPosterior& posterior, const QuestPlusTables& tables,
                                     int stimulus, int outcome)>;

/// 5,000 answers of a person on the grid: largest distance of the posterior's sum from 1, and NaN when the
/// person's point is lost.
[[nodiscard]] Finding try_many_trials(const LearnRule& rule = learn);

/// 1,000 answers of somebody who sees everything, then 6,000 of somebody who guesses: the estimate must
/// follow. Counts estimates on the wrong side.
[[nodiscard]] Finding try_point_comes_back(const LearnRule& rule = learn);

/// Right at the finest map and wrong at the coarsest, 500 times each: counts posteriors that do not sum to 1,
/// estimates off the grid, negative expected entropies.
[[nodiscard]] Finding try_contradictions(const LearnRule& rule = learn);

/// An answer that every point of the grid rules out: must teach nothing. Largest change of a mass.
[[nodiscard]] Finding try_impossible_answer(const LearnRule& rule = learn);

/// A person whose threshold lies far beyond the grid: the alarm of the posterior's edge must ring, and must
/// not for somebody in its middle. Counts what is otherwise. `edge_share` of 1 switches the alarm off.
[[nodiscard]] Finding try_edge(double edge_share = 0.1);

/// The same 300 answers in two orders: largest difference of a mass.
[[nodiscard]] Finding try_order_of_answers();

/// Expected entropies after an answer must not exceed the entropy now, along 200 trials: by how much they do.
[[nodiscard]] Finding try_expected_entropies();

}  // namespace seamline::stability
