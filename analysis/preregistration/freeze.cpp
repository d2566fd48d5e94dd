#include "analysis/preregistration/freeze.h"

#include <algorithm>

#include "analysis/scores/participants.h"
#include "analysis/thresholds/threshold_rules.h"
#include "stimuli/set/manifest.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

void require_thresholds(const std::vector<std::string>& thresholds) {
  if (thresholds.empty())
    throw input_error(
        {.field = request_name("thresholds"), .wanted = "at least one of PT, SN and IP", .found = "none"});
  std::string known;
  for (const ThresholdRule& rule : threshold_rules)
    known += (known.empty() ? "" : ", ") + std::string(rule.name);
  for (const std::string& name : thresholds)
    if (std::none_of(threshold_rules.begin(), threshold_rules.end(),
                     [&](const ThresholdRule& rule) { return name == rule.name; }))
      throw input_error(
          {.field = request_name("thresholds"), .wanted = known + ", with commas", .found = name});
}

void require_text(const std::string& field, const std::string& text) {
  if (!is_utf8(text)) throw input_error({.field = field, .wanted = "UTF-8", .found = "other bytes"});
}

/// A rule that can never name anybody is a slip.
void require_what_rules_need(const StudyDefinition& study, const FrozenAnalysis& analysis,
                             const std::filesystem::path& file) {
  if (analysis.exclude_inattentive && study.catches.attention == 0)
    throw input_error({.file = file.string(),
                       .field = "catch.attention",
                       .wanted = "attention trials, for " + request_name("exclude_inattentive"),
                       .found = "none"});
  const bool asks = std::any_of(study.form.begin(), study.form.end(),
                                [](const FormField& field) { return field.name == vision_question; });
  if (analysis.exclude_uncorrected && !asks)
    throw input_error({.file = file.string(),
                       .field = "form",
                       .wanted = "a question 'vision', for " + request_name("exclude_uncorrected"),
                       .found = "none"});
}

FrozenSet frozen_set(const std::filesystem::path& folder, const StudyDefinition& study) {
  const Manifest manifest = read_manifest(folder);
  const std::string hash = study_hash(study);
  if (manifest.study_hash != hash && !same_but_observer(study_of_set(folder, manifest), study))
    throw input_error({.file = folder.string(),
                       .field = "study.sha256",
                       .wanted = "a set of the study that is frozen (" + hash.substr(0, 12) + ")",
                       .found = manifest.study_hash.substr(0, 12)});
  return {.set_hash = set_hash(folder), .stimuli = static_cast<int>(manifest.stimuli.size())};
}

}  // namespace

Preregistration freeze_study(const std::filesystem::path& study_file,
                             const std::vector<std::filesystem::path>& sets, FrozenAnalysis analysis) {
  require_thresholds(analysis.thresholds);
  require_text(request_name("by_hand"), analysis.by_hand);
  // Sets that an earlier version rendered may have idle settings, and are frozen with them.
  const StudyDefinition study = read_study(study_file, AssetCheck::not_needed, {},
                                           sets.empty() ? IdleSettings::refused : IdleSettings::kept);
  require_what_rules_need(study, analysis, study_file);
  Preregistration content{.program_version = program_version(),
                          .study_name = study.name,
                          .study_hash = study_hash(study),
                          .study_text = read_file(study_file),
                          .sets = {},
                          .analysis = std::move(analysis),
                          .participants = 0,
                          .why_so_many = {},
                          .plan = {}};
  require_text(study_file.string(), content.study_text);
  content.analysis.rules = rules_of_analysis();
  const AnalysisDefinition asked = read_analysis_text(content.study_text, study_file);
  for (const std::string& sentence : sentences_of(asked)) content.analysis.rules.push_back(sentence);
  const auto late = read_late_frames_text(content.study_text, study_file);
  if (late && *late != LateFrames{}) content.analysis.rules.push_back(sentence_of(*late));
  if (content.analysis.compare.empty()) content.analysis.compare = asked.compare;
  for (const std::filesystem::path& folder : sets) {
    const FrozenSet set = frozen_set(folder, study);
    if (std::find(content.sets.begin(), content.sets.end(), set) != content.sets.end())
      throw input_error({.file = folder.string(), .wanted = "each set once", .found = "it twice"});
    content.sets.push_back(set);
  }
  return content;
}

}  // namespace seamline::analysis
