#include "study/online/asking/ask.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/log_writer.h"
#include "study/online/messages/message.h"
#include "study/online/messages/strict_json.h"
#include "study/running/participant_session.h"
#include "study/trials/participant_trials.h"
#include "study/trials/rendered_set.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

using AskJson = nlohmann::ordered_json;

/// A set that nobody rendered: the study's stimuli, for a program that makes their pictures itself. Its hash
/// is one that no rendered set has. A log that an earlier version began may have idle settings, and goes on.
RenderedSet unrendered_set(const fs::path& file, const fs::path& log) {
  std::error_code error;
  const bool is_begun = fs::file_size(log, error) > 0 && !error;
  RenderedSet set{.folder = fs::absolute(file).lexically_normal().parent_path(),
                  .manifest = {},
                  .set_hash = {},
                  .study = read_study(file, AssetCheck::not_needed, {},
                                      is_begun ? IdleSettings::kept : IdleSettings::refused),
                  .study_text = read_file(file)};
  set.manifest.study_name = set.study.name;
  set.manifest.study_hash = study_hash(set.study);
  set.manifest.study_file = file.filename().string();
  set.manifest.width_px = set.study.width_px;
  set.manifest.height_px = set.study.height_px;
  for (const Stimulus& stimulus : list_stimuli(set.study)) {
    ManifestStimulus entry;
    entry.id = stimulus_id(stimulus);
    entry.stimulus = stimulus;
    set.manifest.stimuli.push_back(std::move(entry));
  }
  set.set_hash = sha256("not rendered " + set.manifest.study_hash);
  return set;
}

AskJson question_of(const RenderedSet& set, const Trial& trial, int index, int most) {
  const ManifestStimulus& shown = set.manifest.stimuli.at(trial.stimulus);
  AskJson question = {{"type", "question"},
                      {"trial_index", index},
                      {"most_trials", most},
                      {"kind", word(trial.kind)},
                      {"stimulus_id", shown.id},
                      {"scene", shown.stimulus.scene},
                      {"artifact", word(shown.stimulus.artifact)},
                      {"object", shown.stimulus.object},
                      {"object_index", shown.stimulus.object_index},
                      {"condition", shown.stimulus.condition},
                      {"level", shown.stimulus.level}};
  if (has_own_tasks(set.study)) question["task"] = word(facts_of(task_of(set, trial).get()).kind);
  if (!shown.image.empty() && trial.kind == TrialKind::stimulus)
    question["picture"] = path_in_set(set.folder, shown.image).string();
  return question;
}

std::int64_t nanoseconds_of(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * 1e9));
}

TrialAnswer answer_of_line(const std::string& line, int index, int alternatives) {
  constexpr double longest_s = 1e6;
  const JsonValue json = read_strict_json(line, "answer");
  const JsonFields fields(json, "answer", {"trial_index", "chosen_index", "rating", "choice_s", "rating_s"});
  static_cast<void>(fields.whole("trial_index", index, index));
  TrialAnswer answer{.trial_index = index,
                     .chosen_index = static_cast<int>(fields.whole("chosen_index", 1, alternatives)),
                     .rating = static_cast<int>(fields.whole("rating", 1, highest_rating)),
                     .choice_ns = nanoseconds_of(fields.real("choice_s", 0, longest_s))};
  answer.rating_ns =
      nanoseconds_of(fields.real("rating_s", fields.real("choice_s", 0, longest_s), longest_s));
  return answer;
}

std::string text_of(const AskJson& json) {
  return json.dump(-1, ' ', false, AskJson::error_handler_t::replace);
}

/// None: the lines have ended.
std::optional<TrialAnswer> hear(const LineSource& hear_line, const LineSink& say_line, int index,
                                int alternatives) {
  for (std::string line; hear_line(line);) try {
      if (line.size() > most_line_bytes)
        throw input_error({.field = "answer", .wanted = "at most 65536 bytes", .found = "more"});
      return answer_of_line(line, index, alternatives);
    } catch (const InputError& error) {
      say_line(text_of({{"type", "error"}, {"trial_index", index}, {"error", printable(error.what())}}));
    }
  return std::nullopt;
}

void check_may_ask(const std::optional<KnownParticipant>& known, const AskRequest& request) {
  if (!known || (!known->completed && !known->excluded)) return;
  throw input_error({.file = request.log.string(),
                     .field = "participant " + request.participant,
                     .wanted = "a participant who has not finished",
                     .found = known->excluded ? "one who is excluded" : "one who has"});
}

}  // namespace

void ask(const AskRequest& request, const LineSource& hear_line, const LineSink& say_line) {
  check_participant_code(request.participant);
  std::error_code error;
  const RenderedSet set = fs::is_directory(request.source, error)
                              ? load_rendered_set(request.source)
                              : unrendered_set(request.source, request.log);
  const TrialRules rules = make_trial_rules(set);
  if (rules.task.adjusts())
    throw input_error({.file = request.source.string(),
                       .field = "task.kind",
                       .wanted = "a task whose questions are answered by a choice",
                       .found = "\"match\", in which the participant moves the level"});
  LogWriter log(request.log, set);
  const Enrolment enrolment{.code = request.participant, .pilot = request.pilot};
  check_may_ask(log.find(enrolment), request);
  OpenSession place = enter_session(log, enrolment, set.study.session.orders);
  TrialSequence trials = open_trials(rules, log, place);
  while (const std::optional<Trial> due = current_trial(trials)) {
    store_due_trial(trials, log, place);
    const int index = answered_trials(trials);
    say_line(text_of(question_of(set, *due, index, study::most_trials(trials))));
    const std::optional<TrialAnswer> answer =
        hear(hear_line, say_line, index, rules.task_of(*due).alternatives);
    if (!answer) return;
    log.append_answer(place, *answer);
    trials = after_answer(std::move(trials), *answer);
  }
  log.transaction([&] {
    store_edge_alarms(trials.procedure, log, place, 0);
    log.complete(place);
  });
  say_line(text_of({{"type", "done"}, {"answered", answered_trials(trials)}}));
}

}  // namespace seamline::study::online
