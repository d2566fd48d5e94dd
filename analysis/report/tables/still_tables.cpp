#include "analysis/report/tables/still_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "analysis/report/tables/table_columns.h"
#include "analysis/scores/level_words.h"
#include "stimuli/definition/clip_frames.h"

namespace seamline::analysis {
namespace {

/// Conditions all of whose clips show one picture.
std::set<std::string> still_conditions(const Analysis& analysis) {
  std::vector<std::string> notes;  // `analyze` has said them
  const std::optional<StudyDefinition> study = study_of_log(analysis.log, notes);
  if (!study || !study->clip || study->conditions.size() < 2) return {};
  std::set<std::string> stills, moving;
  for (const Clip& clip : list_clips(*study)) {
    const std::string first = stimulus_id(clip.frames.front());
    const bool is_still = std::all_of(clip.frames.begin(), clip.frames.end(),
                                      [&](const Stimulus& frame) { return stimulus_id(frame) == first; });
    (is_still ? stills : moving).insert(clip.shown.condition);
  }
  std::erase_if(stills, [&](const std::string& name) { return moving.contains(name); });
  return stills;
}

ContrastRow turned_round(ContrastRow row) {
  row.estimate = -row.estimate;
  std::swap(row.ci95_low, row.ci95_high);
  row.ci95_low = -row.ci95_low;
  row.ci95_high = -row.ci95_high;
  return row;
}

/// As the joint model names a curve of a condition.
std::string contrast_name(const ArtifactScores& scores) {
  return std::string(word(scores.artifact)) + in_condition(scores.condition);
}

const ContrastRow* row_named(const Analysis& analysis, const std::string& name) {
  for (const ContrastTable& table : analysis.joint->contrasts.tables) {
    if (table.question != "Do thresholds differ between conditions?") continue;
    for (const ContrastRow& row : table.rows)
      if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace

std::vector<ClipAgainstStill> clips_against_stills(const Analysis& analysis) {
  std::vector<ClipAgainstStill> compared;
  if (!analysis.joint) return compared;
  const std::set<std::string> stills = still_conditions(analysis);
  for (const ArtifactScores& clip : analysis.data.artifacts)
    for (const ArtifactScores& still : analysis.data.artifacts) {
      if (clip.artifact != still.artifact || stills.contains(clip.condition) ||
          !stills.contains(still.condition))
        continue;
      const std::string a = contrast_name(clip), b = contrast_name(still);
      std::optional<ContrastRow> row;
      if (const ContrastRow* found = row_named(analysis, a + " - " + b)) row = *found;
      if (const ContrastRow* found = row_named(analysis, b + " - " + a)) row = turned_round(*found);
      if (row)
        compared.push_back({.artifact = std::string(word(clip.artifact)),
                            .clip = clip.condition,
                            .still = still.condition,
                            .difference = *std::move(row)});
    }
  return compared;
}

std::vector<std::string> sentences_of(const Analysis& analysis,
                                      const std::vector<ClipAgainstStill>& compared) {
  std::vector<std::string> sentences;
  for (const ClipAgainstStill& one : compared) {
    const ContrastRow& row = one.difference;
    const std::string numbers = row.verdict == ContrastVerdict::not_estimable
                                    ? "cannot be estimated"
                                    : fmt::format("is {:+.2f} {} ({:+.2f} to {:+.2f}, {})", row.estimate,
                                                  length_unit(analysis.data.axis), row.ci95_low,
                                                  row.ci95_high, p_text(row.adjusted_p));
    sentences.push_back(fmt::format(
        "Clip against still, '{}': the threshold of '{}' less that of '{}', whose clips are stills, {}. {}.",
        one.artifact, one.clip, one.still, numbers,
        row.verdict == ContrastVerdict::differs ? "They differ" : "No difference was shown"));
  }
  return sentences;
}

CsvTable still_table(const Analysis& analysis, const std::vector<ClipAgainstStill>& compared) {
  const std::string unit = length_unit(analysis.data.axis), ending = "_" + length_key(analysis.data.axis);
  CsvTable table{.name = "clip_against_still",
                 .columns = {artifact_column,
                             {"clip", "word", "condition whose clips move"},
                             {"still", "word", "condition whose clips are one picture each"},
                             {"difference" + ending, unit, "threshold of the clip less that of the still"},
                             {"ci95_low" + ending, unit, "lower end of its simultaneous 95 % interval"},
                             {"ci95_high" + ending, unit, "upper end of it"},
                             {"p_adjusted", "probability", "of no difference, adjusted for all conditions"},
                             source_column},
                 .rows = {}};
  for (const ClipAgainstStill& one : compared)
    table.rows.push_back({one.artifact, one.clip, one.still, finite(one.difference.estimate),
                          finite(one.difference.ci95_low), finite(one.difference.ci95_high),
                          finite(one.difference.adjusted_p), source_text(analysis)});
  return table;
}

}  // namespace seamline::analysis
