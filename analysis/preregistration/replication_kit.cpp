#include "analysis/preregistration/replication_kit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/replication/published_thresholds.h"
#include "stimuli/definition/study_definition.h"
#include "study/trials/participant_trials.h"
#include "support/files/atomic_file.h"
#include "support/text/csv.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

/// What a trial takes, from the grey before it to its rating; and the form, the instructions and the
/// practice.
constexpr double quick_trial_s = 8, slow_trial_s = 15, before_trials_min = 5;

int whole_minutes(int trials, double trial_s) {
  return static_cast<int>(std::lround(trials * trial_s / 60 + before_trials_min));
}

/// Trials of a participant with those that are about attention; of an adaptive study at most so many.
int trials_of_a_participant(const study::RenderedSet& set) {
  const study::TrialRules rules = study::make_trial_rules(set);
  if (!rules.quest_plus) return static_cast<int>(study::decided_trials(rules, 0, {}).size());
  return static_cast<int>(rules.quest_plus->tracks.size()) * rules.quest_plus->definition.max_trials +
         rules.catches.attention + rules.catches.reference;
}

std::string replaced(std::string text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// The words in square brackets that somebody has to fill in, each once.
std::string left_to_fill_in(const std::string& text) {
  std::set<std::string> words;
  for (std::size_t at = text.find('['); at != std::string::npos; at = text.find('[', at + 1))
    if (const std::size_t end = text.find(']', at); end != std::string::npos)
      words.insert(text.substr(at, end - at + 1));
  std::string list;
  for (const std::string& one : words) list += (list.empty() ? "" : ", ") + one;
  return list;
}

CsvTable published_table(const PublishedThresholds& published) {
  CsvTable table{.name = "published", .columns = {}, .rows = {}};
  for (const char* name : {"artifact", "condition", "quantity", "value", "low", "high", "n", "source"})
    table.columns.push_back({.name = name, .unit = {}, .meaning = {}});
  const auto number = [](const std::optional<double>& value) {
    return value ? CsvValue(*value) : CsvValue(std::monostate{});
  };
  for (const PublishedThreshold& one : published.values)
    table.rows.push_back(
        {std::string(word(one.artifact)), one.condition, one.quantity, number(one.level), number(one.low),
         number(one.high),
         one.participants ? CsvValue(std::int64_t{*one.participants}) : CsvValue(std::monostate{}),
         one.source});
  return table;
}

/// Files that the study names and the kit does not hold, as the study file writes them.
std::string files_of(const StudyDefinition& study) {
  std::set<std::string> files;
  for (const SceneDefinition& scene : study.scenes) {
    files.insert(scene.file);
    for (const ObjectDefinition& object : scene.objects) files.insert(object.file);
    if (scene.environment) files.insert(scene.environment->file);
  }
  files.insert(study.session.font);
  std::string list;
  for (const std::string& file : files)
    if (!file.empty() && !file.starts_with("builtin:")) list += (list.empty() ? "`" : ", `") + file + "`";
  return list;
}

/// What the page of steps says of the study besides what was frozen.
struct KitFacts {
  bool adaptive = false;
  int trials = 0;                 ///< of a participant
  std::string to_fill_in, files;  ///< listed; empty: none
};

std::string steps(const Archive& archive, const KitFacts& facts, const KitRequest& request) {
  const Preregistration& content = archive.content;
  const FrozenAnalysis& analysis = content.analysis;
  std::string text = fmt::format(
      "# {}: a study to repeat\n\n"
      "Frozen as SHA-256 `{}` (`frozen.json`) with Seamline {}. Publish this hash where a date is put to it, before anybody is "
      "asked.\n\n"
      "| | |\n| --- | --- |\n| people | {} |\n| why so many | {} |\n| trials of a participant | {}{} |\n"
      "| minutes of a participant | {} to {}: 8 to 15 s a trial and 5 minutes before the first, assumed |\n"
      "| thresholds that are confirmatory | {} |\n\n",
      content.study_name, archive.sha256, content.program_version, content.participants, content.why_so_many,
      facts.adaptive ? "at most " : "", facts.trials, whole_minutes(facts.trials, quick_trial_s),
      whole_minutes(facts.trials, slow_trial_s), fmt::join(analysis.thresholds, ", "));
  text += "## 1. Fill in the consent\n\n";
  text += facts.to_fill_in.empty()
              ? "`consent.txt` has nothing in square brackets left.\n"
              : fmt::format("In `consent.txt` replace {}. Show it to your ethics board.\n", facts.to_fill_in);
  text +=
      "Put the text into a copy of `study.toml`, as `[consent] text`. Texts do not change the study's hash.\n\n";
  if (!facts.files.empty())
    text += fmt::format("Lay beside `study.toml` the files that it names: {}.\n\n", facts.files);
  text +=
      "## 2. Render\n\n```\nseamline render study.toml --out set\nseamline check set\n```\n\n"
      "Pictures are the same byte for byte on processors that compute alike; `analyze --frozen` says whether they are those "
      "that were frozen.\n\n";
  text +=
      "## 3. Ask people\n\nIn the laboratory, a line for each participant:\n\n"
      "```\nseamline study set --log answers.sqlite --participant CODE\n```\n\n"
      "Or in browsers, by the link `https://HOST/?token=INVITATION`:\n\n"
      "```\nseamline export web set page --serve\nseamline serve --make-tokens " +
      std::to_string(content.participants) +
      " --tokens invitations.txt\nseamline serve page --log answers.sqlite --set set --tokens invitations.txt --host HOST\n"
      "```\n\n";
  text += "## 4. Analyse\n\n```\nseamline analyze answers.sqlite --out report --frozen frozen.json";
  if (!request.published.empty())
    text += fmt::format(" --published published.csv --published-margin {:.10g}", request.published_margin);
  if (analysis.exclude_screened) text += " --exclude-screened";
  if (analysis.exclude_inattentive) text += " --exclude-inattentive";
  if (analysis.exclude_uncorrected) text += " --exclude-uncorrected";
  if (analysis.include_pilot) text += " --include-pilot";
  for (const std::string& field : analysis.compare) text += " --compare " + field;
  text += fmt::format(" --bootstrap {} --seed {} --field-of-view {:.10g}\n```\n\n",
                      analysis.bootstrap_replicates, analysis.seed, analysis.field_of_view_deg);
  text += "The report names each deviation from what was frozen.";
  if (!request.published.empty())
    text += " It says of each published threshold whether yours agrees, differs, or is undecided.";
  if (!analysis.by_hand.empty()) text += " Excluded by hand: " + analysis.by_hand;
  return text + "\n";
}

}  // namespace

void write_replication_kit(const KitRequest& request) {
  const Archive archive = read_archive(request.archive);
  const study::RenderedSet set = study::load_rendered_set(request.set);
  const int trials = trials_of_a_participant(set);
  const std::string consent = replaced(
      set.study.consent.text, "[MINUTES]",
      fmt::format("{} to {}", whole_minutes(trials, quick_trial_s), whole_minutes(trials, slow_trial_s)));
  const auto write = [&](const char* name, const std::string& text) {
    write_file_atomically(request.folder / name, text);
  };
  const std::string page = steps(archive,
                                 {.adaptive = study::make_trial_rules(set).quest_plus != nullptr,
                                  .trials = trials,
                                  .to_fill_in = left_to_fill_in(consent),
                                  .files = files_of(set.study)},
                                 request);
  prepare_output_folder(request.folder);
  write("study.toml", archive.content.study_text);
  write("frozen.json", read_file(request.archive));
  write("consent.txt", consent + "\n");
  if (!request.published.empty())
    write("published.csv", request.published == published_paper_word
                               ? csv_text(published_table(read_published(request.published)))
                               : read_file(request.published));
  write("README.md", page);
}

}  // namespace seamline::analysis
