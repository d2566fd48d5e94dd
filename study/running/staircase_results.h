#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/log/log.h"
#include "study/placement/staircase.h"

namespace seamline::study {

/// What one staircase of one participant found.
struct StaircaseEstimate {
  std::string participant;
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::string track;      ///< "receiver", or "receiver bedroom statue"; behind it where it began: "from 64"
  bool used = true;       ///< completed, not excluded and not a pilot
  double start = 0;       ///< level at which it began
  int trials = 0, reversals = 0;
  bool by_reversals = false;    ///< it ended because it had turned often enough
  std::optional<double> level;  ///< `reversals_mean` as a level; none: it turned too seldom
  double target = 0;            ///< share of right answers that this level stands for
};

/// Of every participant of a study with procedure = "staircase", by going through its answers again. Throws
/// InputError when the study of the log has no staircases, or an answer is to a stimulus that it does not
/// list.
[[nodiscard]] std::vector<StaircaseEstimate> staircase_estimates(const LogContents& log);

/// The estimates as a table of text, a line a staircase.
[[nodiscard]] std::string staircases_text(const std::vector<StaircaseEstimate>& estimates);

/// Whether the study of a log has staircases.
[[nodiscard]] bool has_staircases(const LogContents& log);

}  // namespace seamline::study
