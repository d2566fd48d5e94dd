#pragma once
#include <string>

#include "analysis/log_analysis/session_order.h"
#include "analysis/scores/level_axis.h"

namespace seamline::analysis {

/// For the methods: how order was looked at, what its trends say, and what thresholds from the first half of
/// the session to the second do, with the change of all curves together and its interval.
[[nodiscard]] std::string order_text(const SessionOrder& order, const SessionHalves& halves,
                                     const LevelAxis& axis);

}  // namespace seamline::analysis
