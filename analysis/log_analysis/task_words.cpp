#include "analysis/log_analysis/task_words.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "analysis/thresholds/planted_noticeability.h"
#include "stimuli/definition/parts/task_definition.h"
#include "study/observers/observer.h"

namespace seamline::analysis {
namespace {

/// What a trial showed, with its times.
std::string shown_text(const TaskFacts& task, const TaskDefinition& definition) {
  const std::string seen =
      definition.exposure_s > 0 ? fmt::format(" for {:g} s", definition.exposure_s) : std::string();
  switch (task.kind) {
    case TaskKind::object:
      return fmt::format(
          "Each trial showed a picture of {} objects, one of which had been composited into it with the help of "
          "a depth map. Participants chose the object that they took for the inserted one.",
          number_word(task.objects));
    case TaskKind::pair:
      if (task.compares)
        return fmt::format(
            "Each trial showed two pictures side by side{}: on the left a reference, and on the right one into "
            "which an object had been composited with the help of a depth map, or the reference again. "
            "Participants said whether the two were the same.",
            seen);
      return fmt::format(
          "Each trial showed two pictures side by side{}: one into which an object had been composited with the "
          "help of a depth map, and its reference. Participants chose the picture with the insertion (two "
          "alternatives, forced choice).",
          seen);
    case TaskKind::interval:
      return fmt::format(
          "Each trial showed {} pictures one after another, each{}, {:g} s of grey between them: one into which "
          "an object had been composited with the help of a depth map, the others its reference. Participants "
          "chose the picture with the insertion (forced choice).",
          task.pictures, seen, definition.gap_s);
    case TaskKind::yes_no:
      return fmt::format(
          "Each trial showed one picture{}, into which an object had been composited with the help of a depth "
          "map, or its reference. Participants said whether something was inserted (yes or no).",
          seen);
    case TaskKind::match:  // has a report of its own (analysis/matching)
    case TaskKind::rating:
      return fmt::format(
          "Each trial showed one picture{}, into which an object had been composited with the help of a depth "
          "map, or its reference (hidden). Participants judged it on five labels, which count 0 to 4.",
          seen);
  }
  return {};
}

std::string chance_fraction(const TaskFacts& task) {
  return fmt::format("1/{}", task.alternatives);
}

/// Shares of right answers, or of yes.
void name_shares(TaskWords& words, bool yes) {
  words.mean = yes ? "share of yes" : "share of right answers";
  words.Mean = yes ? "Share of yes" : "Share of right answers";
  words.title = yes ? "Answers of yes" : "Right answers";
}

}  // namespace

bool asks_ratings(const study::LogContents& log) {
  const TaskFacts task = facts_of(log.task.get());
  return task.rates || !task.chooses;
}

bool is_papers_task(const study::LogContents& log) {
  return facts_of(log.task.get()).is_papers();
}

std::vector<std::string> notes_on_task(const study::LogContents& log) {
  if (is_papers_task(log)) return {};
  const TaskFacts task = facts_of(log.task.get());
  std::vector<std::string> notes;
  std::string chance = "is right as often as there are false alarms in reference trials";
  if (!task.right_is_yes) chance = fmt::format("guesses, and is right in 1 of {}", task.alternatives);
  notes.push_back(fmt::format("The task is {} ({}), {}. Who sees no seam {}.", word(task.kind),
                              task.chooses ? fmt::format("{} answers", task.alternatives) : "five labels",
                              task.rates ? "with a rating" : "without a rating", chance));
  if (!asks_ratings(log))
    notes.emplace_back(
        "Ratings were not asked, so there are no PT, SN and IP. The threshold is detection: the level that is "
        "seen half of the time, with chance taken out.");
  return notes;
}

TaskWords task_words(const Analysis& analysis) {
  const TaskDefinition* definition = analysis.log.task.get();
  const TaskFacts task = facts_of(definition);
  const bool yes = task.right_is_yes;
  const double guess = analysis.scores.guess_rate;
  TaskWords words{
      .rated = asks_ratings(analysis.log),
      .of_three = std::abs(guess - 1.0 / 3) < 1e-9,
      .chance = guess,
      .mean = "mean noticeability",
      .Mean = "Mean noticeability",
      .title = "Noticeability",
      .right_choices = yes ? "yes" : "right choices",
      .of_right_choices = yes ? "Share of yes" : "Share of right choices",
      .choices_title = yes ? "Answers of yes" : "Right choices",
      .chance_word = yes ? "false alarms" : "chance",
      .chance_text = yes ? fmt::format("false alarms, {:.2f}", guess) : "chance, " + chance_fraction(task),
      .wrong = "the wrong object was chosen",
      .procedure = {},
      .chance_number = yes ? fmt::format("{:.2f}, the share of false alarms", guess) : chance_fraction(task),
      .guess = {}};
  if (!words.rated) name_shares(words, yes);
  if (task.kind != TaskKind::object) words.wrong = yes ? "nothing was seen" : "the wrong answer was chosen";
  if (!is_papers_task(analysis.log) && definition != nullptr) {
    words.procedure = shown_text(task, *definition);
    if (task.rates && task.chooses)
      words.procedure +=
          " They then rated how noticeable the insertion was: 1 slightly, 2 moderately, 3 very, 4 extremely. "
          "Noticeability is the rating when the choice was right and 0 when it was wrong.";
    if (definition->repetitions > 1)
      words.procedure += fmt::format(" Each stimulus was shown {} times.", definition->repetitions);
  }
  words.guess = yes ? fmt::format(
                          "A participant who sees nothing scores as in reference trials, where {:.0f} % of "
                          "the answers were more than the lowest.",
                          100 * guess)
                    : fmt::format(
                          "Because the choice is forced, a participant who sees nothing is right one time "
                          "in {} and then rates at least 1: the floor of mean noticeability is at least "
                          "{}, not 0.",
                          number_word(task.alternatives), chance_fraction(task));
  return words;
}

PlantedDetection planted_detection(const Analysis& analysis) {
  PlantedDetection planted;
  if (asks_ratings(analysis.log) || common_observer(analysis.people) != word(study::ObserverKind::threshold))
    return planted;
  std::vector<std::string> unread;
  const std::optional<StudyDefinition> study = study_of_log(analysis.log, unread);
  if (!study || study->observer.direction != analysis.log.noticeability) return planted;
  for (const ArtifactScores& scores : analysis.data.artifacts)
    if (const auto midpoint = planted_midpoint(study->observer, scores.artifact, scores.condition))
      planted[{scores.artifact, scores.condition}] = x_of(analysis.data.axis, *midpoint);
  return planted;
}

void set_aside_unrated(Analysis& analysis) {
  const auto take_out = [](CurveThresholds& found) {
    for (ThresholdEstimate CurveThresholds::*one :
         {&CurveThresholds::perceptual, &CurveThresholds::slightly_noticeable, &CurveThresholds::inflection,
          &CurveThresholds::perceptual_logistic, &CurveThresholds::slightly_noticeable_logistic})
      found.*one = {.level_x = {}, .reason = NoThreshold::ratings_not_asked, .ci95 = {}};
  };
  for (ArtifactThresholds& thresholds : analysis.thresholds) take_out(thresholds.estimates);
  for (CorrectedCurve& curve : analysis.guessing.curves) take_out(curve.estimates);
  analysis.object_influence.clear();
  analysis.differences.clear();
  analysis.screened.clear();
}

}  // namespace seamline::analysis
