#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/scores/participants.h"
#include "stimuli/definition/quantity.h"
#include "study/exchange/match_records.h"

namespace seamline::analysis {

// Matches are averaged along the axis of the levels: a(level) = log2 level, or the level itself on linear
// axes. Lengths are in octaves, or in the level's unit.

/// A mean over participants with its 95 % interval, m ± t(n - 1) s / sqrt(n); none of fewer than two.
struct MatchMean {
  double mean = 0;
  std::optional<double> low = {}, high = {};
};

/// The matches of one participant in one curve.
struct PersonMatches {
  std::string participant;
  Artifact artifact = Artifact::none;
  std::string condition;
  int matches = 0;
  int at_end = 0;                           ///< that stopped at the first or the last level
  double mean = 0;                          ///< along the axis
  std::optional<double> sd = {};            ///< of single matches; none of one
  std::optional<double> start_effect = {};  ///< mean of those that began clear less that of the others
};

/// The matches of everybody in one curve: an artifact in a condition.
struct CurveMatches {
  Artifact artifact = Artifact::none;
  std::string condition;
  int people = 0, matches = 0, at_end = 0;
  MatchMean threshold;                    ///< of the participants' means, along the axis
  std::optional<double> between_sd = {};  ///< of the participants' means
  std::optional<double> within_sd = {};   ///< root mean square of the participants' own deviations
  std::optional<MatchMean> start_effect = {};
  std::optional<double> planted = {};  ///< level at which `threshold` observers see half; none of others
};

struct MatchAnalysis {
  study::LogContents log;
  std::vector<ParticipantUse> people;
  std::vector<study::MatchRecord> matches = {};  ///< of the people used
  std::vector<PersonMatches> of_people = {};
  std::vector<CurveMatches> curves = {};  ///< in the order of the log's answers
  std::vector<std::string> notes = {};    ///< what a reader must know, a sentence each
};

/// Of those whose `use` is used. Throws InputError when nobody is, or the log cannot be read.
[[nodiscard]] MatchAnalysis analyze_matches(study::LogContents log, std::vector<ParticipantUse> people);

/// a(level) and back.
[[nodiscard]] double along_axis(Quantity quantity, double level);
[[nodiscard]] double level_along(Quantity quantity, double along);

/// The mean of values that differ by person, with its interval. `values` is not empty.
[[nodiscard]] MatchMean mean_over_people(const std::vector<double>& values);

}  // namespace seamline::analysis
