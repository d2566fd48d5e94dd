#include "analysis/analysis.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "stimuli/study_file.h"
#include "stimuli/support/atomic_file.h"
#include "stimuli/support/error.h"
#include "stimuli/support/hash.h"
#include "study/observer.h"

namespace seamline {

namespace {

/// A file that lives as long as this object: studies are read from files only.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("seamline-study-" + sha256(text).substr(0, 16) + ".toml")) {
    write_file_atomically(path_, text);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::vector<std::string> notes_on_people(const Analysis& analysis) {
  std::vector<std::string> notes;
  const ParticipantCounts& counts = analysis.counts;
  if (counts.used < counts.in_log)
    notes.push_back(fmt::format(
        "Of {} participants in the log {} are used; left out: {} excluded, {} pilot, {} who did not finish.",
        counts.in_log, counts.used, counts.excluded, counts.pilot, counts.incomplete));
  if (analysis.log.forgotten_participants > 0)
    notes.push_back(fmt::format("{} participants were deleted from the log at their request.",
                                analysis.log.forgotten_participants));
  if (counts.simulated > 0 && counts.simulated < counts.used)
    notes.push_back(fmt::format("{} of the {} participants used are simulated observers.", counts.simulated,
                                counts.used));
  if (counts.used < 2)
    notes.emplace_back("With one participant there are no standard errors and no intervals.");
  for (const ArtifactScores& scores : analysis.data.artifacts)
    if (scores.width_px.size() == 4)
      notes.push_back(fmt::format(
          "'{}' was tested at four widths only: the logistic has as many parameters, so its inflection "
          "point rests on no spare data.",
          word(scores.artifact)));
  for (const ArtifactScores& scores : analysis.data.artifacts)
    if (!scores.left_out.empty())
      notes.push_back(
          fmt::format("{} of the participants used have no answer at one of the widths of '{}' and are left "
                      "out of its curve.",
                      scores.left_out.size(), word(scores.artifact)));
  return notes;
}

/// Adaptive placement asks each person at widths that depend on their answers, and how often too: a mean at a
/// width is then over people who differ from those of the next width, and is biased. No curve is made of such
/// means. Returns whether the log is of an adaptive study.
bool set_aside_adaptive(Analysis& analysis) {
  std::vector<std::string> unused;
  const std::optional<StudyDefinition> study = study_of_log(analysis.log, unused);
  if (!study || !std::holds_alternative<QuestPlusDefinition>(study->procedure)) return false;
  for (ArtifactScores& scores : analysis.data.artifacts)
    scores = {.artifact = scores.artifact,
              .width_px = scores.width_px,
              .people = {},
              .noticeability = {},
              .cells = {},
              .left_out = {}};
  return true;
}

constexpr const char* adaptive_note =
    "Widths were placed by the answers (QUEST+), so PT, SN and IP of mean noticeability cannot be computed; "
    "means of objects are over different people at different widths and only describe the answers. "
    "'seamline log LOG --tracks' prints the thresholds that the posteriors give.";

void give_reason(CurveThresholds& estimates, const char* reason) {
  for (WidthEstimate* width : {&estimates.perceptual, &estimates.slightly_noticeable, &estimates.inflection})
    width->reason = reason;
}

}  // namespace

Analysis analyze(LogContents log, bool include_pilot, const ResamplingRequest& resampling) {
  Analysis analysis{.log = std::move(log),
                    .include_pilot = include_pilot,
                    .resampling = resampling,
                    .people = {},
                    .counts = {},
                    .data = {},
                    .thresholds = {},
                    .planted = {},
                    .notes = {}};
  analysis.people = select_participants(analysis.log, include_pilot);
  analysis.counts = count_participants(analysis.people);
  analysis.data = average_answers(analysis.log, analysis.people);
  const bool adaptive = set_aside_adaptive(analysis);
  analysis.notes = notes_on_people(analysis);
  if (adaptive) analysis.notes.emplace_back(adaptive_note);
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    analysis.thresholds.push_back(estimate_thresholds(scores, resampling));
    if (adaptive) give_reason(analysis.thresholds.back().estimates, "widths were placed by the answers");
  }
  if (common_observer(analysis.people) == word(ObserverKind::threshold))
    if (const std::optional<StudyDefinition> study = study_of_log(analysis.log, analysis.notes))
      analysis.planted = planted_values(study->observer, analysis.data);
  return analysis;
}

std::string source_text(const Analysis& analysis) {
  const ParticipantCounts& counts = analysis.counts;
  if (counts.simulated == 0) return fmt::format("{} participant{}", counts.used, counts.used == 1 ? "" : "s");
  if (counts.simulated < counts.used)
    return fmt::format("{} participants, {} of them simulated observers", counts.used, counts.simulated);
  const std::string_view kind = common_observer(analysis.people);
  return fmt::format("{} simulated observer{} ({})", counts.used, counts.used == 1 ? "" : "s",
                     kind.empty() ? "several kinds" : kind);
}

PlantedValues planted_values(const ObserverDefinition& observer, const NoticeabilityData& data) {
  PlantedValues planted;
  for (const ArtifactScores& scores : data.artifacts) {
    if (!observer.midpoint_width_px.contains(scores.artifact)) continue;
    std::vector<double> expected;
    for (int width_px : scores.width_px)
      expected.push_back(expected_noticeability(observer, scores.artifact, width_px));
    planted[scores.artifact] = thresholds_of_means(log2_widths(scores.width_px), expected);
  }
  return planted;
}

std::optional<StudyDefinition> study_of_log(const LogContents& log, std::vector<std::string>& notes) {
  if (log.study_text.empty()) {
    notes.emplace_back("The log keeps no study text, so planted values are not known.");
    return std::nullopt;
  }
  const TemporaryFile file(log.study_text);
  try {
    return read_study(file.path(), AssetCheck::not_needed);
  } catch (const InputError& error) {
    std::string said = error.what();
    if (const auto at = said.find(file.path().string()); at != std::string::npos)
      said.replace(at, file.path().string().size(), "study text of the log");
    notes.push_back("Planted values are not known, because the study cannot be read: " + said);
    return std::nullopt;
  }
}

}  // namespace seamline
