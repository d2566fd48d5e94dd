#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/exchange/anonymise.h"
#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// How the clip of an answered trial was shown: an event `clip`, "shown 48 late 0 dropped 0".
struct ClipCounts {
  int shown = 0;    ///< frames that stood on the screen
  int late = 0;     ///< of these, those that came more than two refreshes after their time
  int dropped = 0;  ///< frames that never stood there

  /// Of the frames that were due until the answer, those that came late or never.
  [[nodiscard]] double late_share() const;
};

/// None where the text is no such event's.
[[nodiscard]] std::optional<ClipCounts> clip_counts_of(const std::string& detail);

/// Of each of the log's answers, in their order; none where nothing was counted (simulated people). Empty
/// where the log's study has no clips. Throws InputError when the log cannot be read, or an event `clip` is
/// none.
[[nodiscard]] std::vector<std::optional<ClipCounts>> read_clip_counts(const LogContents& log);

/// How the clip of each answer was shown, as columns of a table of answers; no columns where the study has no
/// clips.
struct ClipColumns {
  std::vector<CsvColumn> columns = {};
  std::vector<std::vector<CsvValue>> rows = {};  ///< of the log's answers, in their order
};

/// Of an anonymised log only which trials are marked: how a computer shows clips may tell whose it is.
[[nodiscard]] ClipColumns clip_columns(const LogContents& log, const std::optional<Anonymity>& anonymity);

/// Adds them to the table of the log's answers.
void add_clip_columns(const LogContents& log, const std::optional<Anonymity>& anonymity, CsvTable& answers);

/// Which answers are marked, before a log forgets whose they are (`Anonymity::late_clips`).
[[nodiscard]] std::vector<std::optional<bool>> late_clips(const LogContents& log);

}  // namespace seamline::study
