#include "analysis/log_analysis/analysis.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/log_analysis/adaptive_log.h"
#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/participant_facts.h"
#include "analysis/log_analysis/task_words.h"
#include "analysis/replication/published_text.h"
#include "analysis/screening/catch_answers.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "stimuli/study_file/study_file.h"
#include "study/observers/observer.h"
#include "support/files/assets.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

AnalysisDefinition asked_of_log(const study::LogContents& log) {
  try {
    return log.study_text.empty() ? AnalysisDefinition{} : read_analysis_text(log.study_text, log.file);
  } catch (const InputError&) {
    return {};  // `study_of_log` says so
  }
}

namespace {

std::vector<std::string> notes_on_people(const Analysis& analysis) {
  std::vector<std::string> notes;
  const ParticipantCounts& counts = analysis.counts;
  if (counts.used < counts.in_log)
    notes.push_back(fmt::format(
        "Of {} in the log {} used; left out: {} excluded, {} pilot, {} who did not finish{}.",
        counted(counts.in_log, "participant"), counted(counts.used, "is", "are"), counts.excluded,
        counts.pilot, counts.incomplete,
        fmt::format("{}{}", counts.screened > 0 ? fmt::format(", {} named by a screen", counts.screened) : "",
                    counts.vision > 0
                        ? fmt::format(", {} whose vision is neither normal nor corrected", counts.vision)
                        : "")));
  std::vector<std::string> uncorrected;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used && has_uncorrected_vision(person.record))
      uncorrected.push_back(person.record.code);
  if (!uncorrected.empty())
    notes.push_back(
        fmt::format("{} used whose vision is neither normal nor corrected ({}); {} leaves them out.",
                    counted(uncorrected.size(), "participant is", "participants are"),
                    fmt::join(uncorrected, ", "), request_name("exclude_uncorrected")));
  if (analysis.log.forgotten_participants > 0)
    notes.push_back(
        fmt::format("{} deleted from the log at their request.",
                    counted(analysis.log.forgotten_participants, "participant was", "participants were")));
  if (counts.simulated > 0 && counts.simulated < counts.used)
    notes.push_back(
        fmt::format("{} of the {} participants used {}.", counts.simulated, counts.used,
                    counts.simulated == 1 ? "is a simulated observer" : "are simulated observers"));
  if (counts.used < 2)
    notes.emplace_back(
        "With one participant there are no standard errors and no intervals over participants, so no "
        "threshold is determined.");
  const bool rated = asks_ratings(analysis.log);
  if (std::string few = few_people_sentence(analysis); !few.empty()) notes.push_back(std::move(few));
  for (const ArtifactScores& scores : analysis.data.artifacts)
    if (rated && !analysis.adaptive && levels_on_axis(scores).size() == 4)
      notes.push_back(fmt::format(
          "'{}'{} was tested at four {}s only: the logistic has as many parameters, so its inflection "
          "point rests on no spare data.",
          word(scores.artifact), in_condition(scores.condition), level_word(scores.axis)));
  if (const std::string answered = answered_text(analysis); !answered.empty()) notes.push_back(answered);
  return notes;
}

/// Where an estimate is the middle of a range that is as likely all along.
std::vector<std::string> notes_on_steps(const Analysis& analysis) {
  std::vector<std::string> notes;
  if (!asks_ratings(analysis.log)) return notes;
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) {
    const ArtifactThresholds& found = analysis.thresholds[i];
    const LevelAxis& axis = analysis.data.axis;
    const Logistic4Fit& fit = found.estimates.logistic;
    if (fit.verdict != Centre::step || !found.estimates.inflection.level_x) continue;
    const LevelRange range = range_at(axis, fit.centre_range);
    notes.push_back(
        fmt::format("The logistic of '{}'{} is a step between {} and {}: its inflection point is the middle "
                    "of {}s that are as likely.",
                    word(found.artifact), in_condition(found.condition), estimated_text(axis, range.low),
                    estimated_text(axis, range.high), level_word(axis)));
  }
  return notes;
}

bool leaves_out(const AnalysisOptions& options, ScreeningRule rule) {
  return options.exclude_screened || (options.exclude_inattentive && rule == ScreeningRule::attention);
}

/// Whom each screen names, and whether they are used all the same.
void add_notes_on_screening(Analysis& analysis) {
  for (ScreeningRule rule : every_screening_rule)
    if (const std::vector<std::string> named = analysis.screening.named_by(rule); !named.empty())
      analysis.notes.push_back(
          fmt::format("Screening by {} names {} ({}), {}.", word(rule), counted(named.size(), "participant"),
                      fmt::join(named, ", "),
                      leaves_out(analysis.options, rule)
                          ? "left out"
                          : "used all the same unless " + request_name("exclude_screened") + " is given"));
  if (analysis.options.exclude_screened)
    for (ScreeningRule rule : {ScreeningRule::kurtosis, ScreeningRule::correlation})
      if (const std::string why = why_not_judged(analysis.screening, rule); !why.empty())
        analysis.notes.push_back(fmt::format("By {} nobody is left out: not judged, {}.", word(rule), why));
}

/// Codes of those named whom the options leave out.
std::vector<std::string> named_and_left_out(const Analysis& analysis) {
  if (analysis.options.exclude_screened) return analysis.screening.named();
  if (analysis.options.exclude_inattentive) return analysis.screening.named_by(ScreeningRule::attention);
  return {};
}

void leave_out_screened(Analysis& analysis) {
  analysis.people = leave_out(analysis.people, named_and_left_out(analysis));
  if (count_participants(analysis.people).used == 0)
    throw input_error({.file = analysis.log.file.string(),
                       .field = "",
                       .wanted = "at least one participant whom no screen names",
                       .found = "all of them named (without " + request_name("exclude_screened") + " and " +
                                request_name("exclude_inattentive") + " they are used)"});
  analysis.scores = score_matrix(analysis.log, analysis.people, analysis.conditions);
}

/// Of the test of the joint model, each of which fits all of it again.
int model_replicates(const ResamplingRequest& request) {
  constexpr int fewest = 19, most = 299;
  return std::clamp(request.replicates / 10, fewest, most);
}

/// `[analysis]` of the study that the log keeps, what is usual where that cannot be read, and the options.
AnalysisDefinition asked_of(const Analysis& analysis) {
  AnalysisDefinition asked = asked_of_log(analysis.log);
  for (const std::string& word : analysis.options.own)
    if (const SharedBlock* block = shared_block(word)) asked.*block->shared = false;
  return asked;
}

JointSharing sharing_of(const AnalysisDefinition& asked) {
  return {.scale = asked.share_scale,
          .criteria = asked.share_criteria,
          .lapse = asked.share_lapse,
          .guess_ratings = asked.share_guess_ratings};
}

/// What stands beside the thresholds: single objects, guessing, opinion scores.
void add_checks(Analysis& analysis) {
  analysis.differences = threshold_differences(analysis.data, analysis.resampling);
  analysis.origins = compare_origins(analysis.log, analysis.people, analysis.resampling, analysis.conditions);
  analysis.object_influence = leave_one_object_out(analysis.log, analysis.people, analysis.data);
  const GuessTrials trials = count_guess_trials(analysis.log, analysis.data, analysis.options.references);
  analysis.guessing = correct_for_guessing(trials, analysis.data, analysis.resampling);
  if (const AnalysisDefinition asked = asked_of(analysis); asked.joint)
    analysis.joint = analyze_jointly(trials, analysis.data, analysis.guessing.guessers,
                                     {.sharing = sharing_of(asked),
                                      .sharing_tested = asked.sharing_tested,
                                      .goodness = {.replicates = model_replicates(analysis.resampling),
                                                   .seed = analysis.resampling.seed,
                                                   .threads = analysis.resampling.threads}});
  analysis.opinion = opinion_scores(analysis.scores.score);
  analysis.sos = sos_parameter(analysis.scores.score, {.lowest = 0, .highest = study::highest_rating});
  for (std::string& note : notes_on_headline(analysis)) analysis.notes.push_back(std::move(note));
  for (std::string& note : notes_on_steps(analysis)) analysis.notes.push_back(std::move(note));
  add_notes_on_screening(analysis);
  if (asks_ratings(analysis.log))  // else no curve that is corrected for guessing is shown
    analysis.notes.insert(analysis.notes.end(), analysis.guessing.notes.begin(),
                          analysis.guessing.notes.end());
}

std::string rising_note(const LevelAxis& axis) {
  if (of_depth_widths(axis))
    return "The study's simulated observers notice more as maps grow finer; PT, SN and IP are of "
           "noticeability that falls, and no values are planted for them.";
  return fmt::format(
      "The study's simulated observers notice more where the study says that noticeability {}, so no values "
      "are planted for PT, SN and IP.",
      axis.noticeability == Direction::increasing ? "falls" : "rises");
}

/// The options, with the log's catch trials beside those that were given.
AnalysisOptions with_catch_trials(AnalysisOptions options, const study::LogContents& log) {
  for (const ReferenceAnswer& answer : reference_answers(log)) options.references.push_back(answer);
  for (const CatchAnswer& answer : attention_answers(log)) options.catches.push_back(answer);
  return options;
}

/// The log's, or the frozen study's where the two differ in nothing that people are shown.
std::string hash_beside(const Archive& archive, const study::LogContents& log) {
  if (archive.content.study_hash == log.study_hash) return log.study_hash;
  try {
    if (same_but_observer(read_study_text(archive.content.study_text, archive.file),
                          read_study_text(log.study_text, log.file)))
      return archive.content.study_hash;
  } catch (const InputError&) {
    // a text of another program's time
  }
  return log.study_hash;
}

}  // namespace

void compare_with_archive(Analysis& analysis, const Archive& archive) {
  AnalysisDone done{.program_version = program_version(),
                    .study_hash = hash_beside(archive, analysis.log),
                    .set_hash = analysis.log.set_hash,
                    .analysis = {.thresholds = {},
                                 .include_pilot = analysis.include_pilot,
                                 .exclude_screened = analysis.options.exclude_screened,
                                 .exclude_inattentive = analysis.options.exclude_inattentive,
                                 .exclude_uncorrected = analysis.options.exclude_uncorrected,
                                 .field_of_view_deg = analysis.options.field_of_view_deg,
                                 .bootstrap_replicates = analysis.resampling.replicates,
                                 .seed = analysis.resampling.seed,
                                 .rules = rules_of_analysis(),
                                 .by_hand = {},
                                 .compare = analysis.options.compare},
                    .participants_used = analysis.counts.used,
                    .excluded = {}};
  for (const std::string& sentence : sentences_of(asked_of(analysis)))
    done.analysis.rules.push_back(sentence);
  const auto late = read_late_frames_text(analysis.log.study_text, analysis.log.file);
  if (late && *late != LateFrames{}) done.analysis.rules.push_back(sentence_of(*late));
  if (analysis.replication) {
    std::vector<PublishedThreshold> published;
    for (const ReplicatedThreshold& one : analysis.replication->thresholds)
      published.push_back(one.published);
    done.analysis.rules.push_back(rule_of_published(published, analysis.replication->margin));
  }
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::excluded) done.excluded.push_back(person.record.code);
  analysis.frozen = compare_with_frozen(archive, done);
  analysis.notes.insert(analysis.notes.begin(), verdict_of(*analysis.frozen));
}

namespace {

/// Of a log of one task the conditions that ask it.
bool is_asked_in(const study::LogContents& log, const std::string& condition) {
  return std::any_of(log.answers.begin(), log.answers.end(),
                     [&](const study::Answer& answer) { return answer.condition == condition; });
}

}  // namespace

Analysis analyze(study::LogContents log, bool include_pilot, const ResamplingRequest& resampling,
                 const AnalysisOptions& options) {
  Analysis analysis;
  analysis.log = std::move(log);
  analysis.include_pilot = include_pilot;
  analysis.resampling = resampling;
  analysis.options = with_catch_trials(options, analysis.log);
  const AnalysisDefinition asked = asked_of(analysis);
  if (analysis.options.compare.empty()) analysis.options.compare = asked.compare;
  analysis.people = select_participants(analysis.log, include_pilot);
  if (options.exclude_uncorrected)
    for (ParticipantUse& person : analysis.people)
      if (person.use == Use::used && has_uncorrected_vision(person.record)) person.use = Use::vision;
  std::vector<std::string> notes_on_study;
  const std::optional<StudyDefinition> study = study_of_log(analysis.log, notes_on_study);
  if (study)
    for (const ConditionDefinition& condition : study->conditions)
      if (!has_own_tasks(*study) || is_asked_in(analysis.log, condition.name))
        analysis.conditions.push_back(condition.name);
  require_answers(analysis.log, analysis.people);
  analysis.scores = score_matrix(analysis.log, analysis.people, analysis.conditions);
  analysis.screening = screen_participants(analysis.scores, analysis.options.catches);
  analysis.adaptive = is_adaptive(study);
  if (!analysis.adaptive)
    analysis.screened = thresholds_with_and_without(analysis.log, analysis.people, analysis.screening,
                                                    resampling, analysis.conditions);
  if (const auto left_out = named_and_left_out(analysis); !left_out.empty()) leave_out_screened(analysis);
  analysis.counts = count_participants(analysis.people);
  analysis.data = average_answers(analysis.log, analysis.people, analysis.conditions);
  if (analysis.adaptive) set_aside_adaptive(analysis);
  analysis.notes = notes_on_people(analysis);
  analysis.notes.insert(analysis.notes.end(), notes_on_study.begin(), notes_on_study.end());
  for (std::string& note : notes_on_task(analysis.log)) analysis.notes.push_back(std::move(note));
  for (const std::string& sentence : sentences_of(asked)) analysis.notes.push_back(sentence);
  if (analysis.adaptive) {
    if (asked.joint)
      analysis.joint =
          analyze_placed(analysis, {.sharing = sharing_of(asked), .sharing_tested = asked.sharing_tested});
    analysis.notes.push_back(adaptive_note(analysis.log));
    for (std::string& note : notes_on_headline(analysis)) analysis.notes.push_back(std::move(note));
    add_notes_on_screening(analysis);
  } else {
    const std::vector<std::string> left_out = named_and_left_out(analysis);
    analysis.thresholds =
        std::find_if(analysis.screened.begin(), analysis.screened.end(),
                     [&](const ScreenedThresholds& result) { return result.left_out == left_out; })
            ->thresholds;
    add_checks(analysis);
    if (!asks_ratings(analysis.log)) set_aside_unrated(analysis);
  }
  const bool simulated = study && common_observer(analysis.people) == word(study::ObserverKind::threshold);
  const bool rising = simulated && study->observer.direction != analysis.log.noticeability;
  if (rising && !analysis.adaptive) analysis.notes.emplace_back(rising_note(analysis.data.axis));
  // PT, SN and IP are planted with the floor of a guess among three, rated.
  const bool papers_task = is_papers_task(analysis.log);
  if (simulated && !rising && papers_task) analysis.planted = planted_values(study->observer, analysis.data);
  return analysis;
}

std::string source_text(const Analysis& analysis) {
  const ParticipantCounts& counts = analysis.counts;
  if (counts.simulated == 0) return counted(counts.used, "participant");
  if (counts.simulated < counts.used)
    return fmt::format("{} participants, {} of them simulated observers", counts.used, counts.simulated);
  const std::string_view kind = common_observer(analysis.people);
  return fmt::format("{} ({})", counted(counts.used, "simulated observer"),
                     kind.empty() ? "several kinds" : kind);
}

std::string answered_text(const Analysis& analysis) {
  std::string curves;
  for (const ArtifactScores& scores : analysis.data.artifacts) {
    const auto [fewest, most] = people_at_levels(scores);
    if (most == 0 || fewest == analysis.counts.used) continue;
    curves += fmt::format("{}{}{} {}", curves.empty() ? "" : ", ", word(scores.artifact),
                          in_condition(scores.condition),
                          fewest == most ? std::to_string(most) : fmt::format("{} to {}", fewest, most));
  }
  if (curves.empty()) return "";
  return fmt::format(
      "Not everybody answered at every {}; each mean is over those who did: {} of the {} used.",
      level_word(analysis.data.axis), curves, analysis.counts.used);
}

std::string source_sentence(const Analysis& analysis) {
  const std::string answered = answered_text(analysis);
  return source_text(analysis) + "." + (answered.empty() ? "" : " " + answered);
}

PlantedValues planted_values(const ObserverDefinition& observer, const NoticeabilityData& data) {
  PlantedValues planted;
  for (const ArtifactScores& scores : data.artifacts) {
    const std::optional<double> midpoint = planted_midpoint(observer, scores.artifact, scores.condition);
    std::vector<double> levels;
    for (const double level : scores.level)
      if (!stands_apart(scores.axis, level)) levels.push_back(level);
    if (!midpoint || levels.empty()) continue;
    planted[{scores.artifact, scores.condition}] =
        planted_thresholds(observer, scores.axis, *midpoint, levels);
  }
  return planted;
}

std::optional<StudyDefinition> study_of_log(const study::LogContents& log, std::vector<std::string>& notes) {
  if (log.study_text.empty()) {
    notes.emplace_back(
        "The log keeps no study text: planted values are not known, and widths are taken as not placed by "
        "the answers.");
    return std::nullopt;
  }
  try {
    return read_study_text(log.study_text, "study text of the log");
  } catch (const InputError& error) {
    notes.push_back(
        "The study of the log cannot be read, so planted values are not known and widths are taken as not "
        "placed by the answers: " +
        std::string(error.what()));
    return std::nullopt;
  }
}

}  // namespace seamline::analysis
