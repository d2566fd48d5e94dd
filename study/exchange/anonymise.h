#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/log/log.h"

namespace seamline::study {

/// Where the slider of a rating stood, 0 to 100, by answer and by catch answer; none: not asked on a line.
struct SliderPlaces {
  std::vector<std::optional<int>> of_answers = {}, of_catches = {};
};

/// What an anonymised log is, for the tables that are made of it.
struct Anonymity {
  int k = 5;                  ///< the smallest group of people who are alike
  bool keeps_origin = true;   ///< false: fewer than k came one of the ways
  int left_out_people = 0;    ///< with everything of theirs: fewer than k are in their state
  int unfinished_people = 0;  ///< whose answers are left out
  /// Of each answer to a clip: whether too many frames were late or dropped; none: not counted. Empty where
  /// the study has no clips.
  std::vector<std::optional<bool>> late_clips = {};
  SliderPlaces slider = {};  ///< empty where the study has no slider
};

/// One question of the form, as it leaves the house.
struct GroupedField {
  std::string field;
  int smallest_group =
      0;  ///< participants who share an answer, in the smallest group; empty ones count as one
  int withheld_answers = 0;  ///< which together with the other questions would have told who it is
  bool withheld = false;     ///< so few people that every answer is "other" or "withheld"
};

struct AnonymisedLog {
  LogContents log = {};
  Anonymity anonymity = {};
  std::vector<GroupedField> fields = {};
  int smallest_group = 0;  ///< people of whom the table of participants says the same; at least k
};

/// A log that can be given away: of every person at least `k` - 1 others have the same row in the table of
/// participants, but for the code (k-anonymity; Sweeney 2002), and nothing says who came when. Simulated
/// people are nobody and are not counted.
///
/// - Codes become `p001`, `p002`, ... in an order that says nothing of who came first; answers stand in the
///   order of the stimuli, `trial_index` counts them so; times are rounded to a tenth of a second.
/// - The tables leave out what follows from the order of trials, which follows from the order of arrival:
///   `slot`, `trial_index`, and of catch trials which they were; also `restarts` and `image_scale`. Of how
///   clips were shown they say which trials are marked, and no counts.
/// - Whoever did not finish keeps a row without answers, since the answers there are the first of their
/// order.
/// - People in a state (finished, excluded, trial run) that fewer than `k` share are left out.
/// - Numbers of the form become decades ("20-29"); an answer that fewer than `k` share becomes "other"
///   together with the next rarest, until `k` share that, too; then, where fewer than `k` share all that is
///   left, answers become "withheld", question by question, those with most different answers first.
///
/// Equal logs give equal results. Throws InputError when k is below 2, or nobody would be left.
[[nodiscard]] AnonymisedLog anonymise(LogContents log, int k);

}  // namespace seamline::study
