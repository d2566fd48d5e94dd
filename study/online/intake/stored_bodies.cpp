#include <fmt/core.h>

#include <algorithm>

#include "study/online/intake/intake.h"
#include "study/running/participant_session.h"
#include "study/trials/level_ladders.h"
#include "support/running/overloaded.h"

// What each kind of message becomes in the log, and what of it is refused.
namespace seamline::study::online {
namespace {

DisplayFacts facts_of(const DisplayBody& body) {
  return {.machine = {},
          .monitor = {},
          .renderer = "browser",
          .mode_width_px = body.screen_width_px,
          .mode_height_px = body.screen_height_px,
          .refresh_hz = body.refresh_hz,
          .content_scale = body.device_pixel_ratio,
          .framebuffer_width_px = body.viewport_width_px,
          .framebuffer_height_px = body.viewport_height_px,
          .mm_per_px = body.mm_per_px,
          .viewing_distance_mm = body.viewing_distance_mm,
          .pixels_per_degree = body.pixels_per_degree,
          .gamma_confirmed = body.gamma_confirmed,
          .scaling_allowed = body.image_scale != 1,
          .image_scale = body.image_scale};
}

TrialAnswer answer_of(int index, const PictureAnswer& answer) {
  return {.trial_index = index,
          .chosen_index = answer.chosen_index,
          .rating = answer.rating,
          .position = answer.position,
          .choice_ns = answer.choice_ns,
          .rating_ns = answer.rating_ns};
}

std::string_view text(FormFault fault) {
  switch (fault) {
    case FormFault::missing:
      return "nothing";
    case FormFault::not_a_number:
      return "no number";
    case FormFault::out_of_range:
      return "a number out of range";
    case FormFault::not_an_option:
      return "none of the options";
  }
  return {};
}

}  // namespace

void Intake::store(Person& who, const MessageBody& body) {
  std::visit(Overloaded{[](const EnrolBody&) {}, [](const DeclineBody&) {},
                        [&](const CompletionBody&) { store_completion(who); },
                        [&](const auto& other) { store(who, other); }},
             body);
}

void Intake::store(Person& who, const BeginBody& body) {
  log_.begin_sitting(who.stored, body.user_agent, time_of(who));
}

void Intake::store(Person& who, const FormBody& body) {
  if (who.stored.place.form_done) throw conflict("body.answers", "one form of a participant", "another one");
  std::vector<FormAnswer> answers;
  for (const FormAnswer& answer : body.answers) {
    const auto is_field = [&](const FormField& field) { return field.name == answer.field; };
    const auto is_same = [&](const FormAnswer& other) { return other.field == answer.field; };
    if (std::none_of(script_.form.begin(), script_.form.end(), is_field))
      throw wrong("body.answers", "fields of the study's form", in_quotes(answer.field));
    if (std::any_of(answers.begin(), answers.end(), is_same))
      throw wrong("body.answers", "each field once", in_quotes(answer.field) + " twice");
    answers.push_back(answer);
  }
  for (const FormField& field : script_.form) {
    std::string value;
    for (const FormAnswer& answer : answers)
      if (answer.field == field.name) value = answer.value;
    if (const std::optional<FormFault> fault = fault_of(field, value))
      throw wrong("body.answers." + field.name, "an answer to the question", std::string(text(*fault)));
  }
  log_.record_form(who.stored, answers);
}

void Intake::store(Person& who, const DisplayBody& body) {
  log_.record_display(who.stored, facts_of(body));
}

/// A message alone does not say among how many the participant chose.
void Intake::check_choice(const Trial& planned, const PictureAnswer& answer) const {
  const TaskFacts& task = rules_.task_of(planned);
  if (answer.chosen_index > task.alternatives)
    throw wrong("body.chosen_index", fmt::format("1 to {}", task.alternatives),
                std::to_string(answer.chosen_index));
  if (task.slides != (answer.position >= 0))
    throw wrong("body.position", task.slides ? "where the slider stood" : "no place of a slider",
                task.slides ? "nothing" : std::to_string(answer.position));
  if (!task.slides) return;
  const int rating = rating_at(answer.position);
  if (answer.chosen_index != (rating > 0 ? 1 : 2) || answer.rating != std::max(1, rating))
    throw wrong("body.rating", fmt::format("what place {} of the slider counts as", answer.position),
                fmt::format("choice {}, rating {}", answer.chosen_index, answer.rating));
}

void Intake::check_shown(const Trial& planned, const PictureAnswer& answer, const std::string& which) const {
  if (answer.kind == planned.kind && names_.is_name_of(planned, answer.stimulus_id, known_names_)) return;
  // Whoever asks may be the participant: the set's own id would tell them the right answer.
  throw conflict(which, fmt::format("the planned {} {}", word(planned.kind), names_.name_of(planned)),
                 fmt::format("{} {}", word(answer.kind), in_quotes(answer.stimulus_id)));
}

/// The picture of the trial's ladder that the answer names: where a participant stopped in a match.
int Intake::matched_stimulus(const Trial& planned, const PictureAnswer& answer,
                             const std::string& which) const {
  for (const Trial& picture : pictures_of_ladder(*rules_.ladders, planned))
    if (answer.kind == picture.kind && names_.is_name_of(picture, answer.stimulus_id, known_names_))
      return picture.stimulus;
  throw conflict(which, "a picture between which this trial moves", in_quotes(answer.stimulus_id));
}

void Intake::store(Person& who, const TrainingBody& body) {
  const std::string which = fmt::format("training_index {}", body.training_index);
  if (body.training_index >= static_cast<int>(script_.training.size()))
    throw wrong("body.training_index", fmt::format("one of {} practice trials", script_.training.size()),
                std::to_string(body.training_index));
  const Trial& planned = script_.training[static_cast<std::size_t>(body.training_index)];
  check_choice(planned, body.answer);
  check_shown(planned, body.answer, which);
  if (!log_.append_training(who.stored,
                            {.trial = planned, .answer = answer_of(body.training_index, body.answer)}))
    throw conflict(which, "one answer in a sitting", "another one");
}

void Intake::store(Person& who, const AnswerBody& body) {
  OnlinePerson& stored = who.stored;
  const std::string which = fmt::format("trial_index {}", body.trial_index);
  if (stored.place.completed)
    throw conflict(which, "a participant who has not finished", "an answer after the end");
  if (stored.answered.contains(body.trial_index))
    throw conflict(which, "one answer to a trial", "another one, with another id");
  if (body.trial_index >= static_cast<int>(stored.place.trials.size()))
    throw conflict(which, fmt::format("one of {} planned trials", stored.place.trials.size()),
                   "one that is not planned");
  const Trial& planned = stored.place.trials[static_cast<std::size_t>(body.trial_index)];
  check_choice(planned, body.answer);
  if (!rules_.ladders) check_shown(planned, body.answer, which);
  if (rules_.is_adaptive() && body.trial_index != stored.place.answered)
    throw conflict(which, fmt::format("the trial that is due, {}", stored.place.answered), "another one");
  TrialAnswer answer = answer_of(body.trial_index, body.answer);
  if (rules_.ladders) answer.matched = matched_stimulus(planned, body.answer, which);
  if (rules_.is_adaptive()) {
    TrialSequence& sequence = sequence_of(who);  // before the answer is among those it is made of
    sequence = after_answer(std::move(sequence), answer);
  }
  log_.append_answer(stored, answer, body.image_scale, time_of(who));
}

void Intake::store(Person& who, const EventBody& body) {
  if (body.kind == "matched" || body.kind == "slid")
    throw wrong("body.kind", "a raw event; where a match or a slider stopped comes with its answer",
                in_quotes(body.kind));
  const RawEvent event{.monotonic_ns = body.monotonic_ns,
                       .kind = body.kind,
                       .trial_index = body.trial_index,
                       .detail = body.detail};
  log_.append_events(who.stored, std::span<const RawEvent>(&event, 1));
}

void Intake::store_completion(Person& who) {
  const OpenSession& place = who.stored.place;
  if (place.completed) throw conflict("kind", "one completion", "another one");
  const bool over = rules_.is_adaptive() ? !current_trial(sequence_of(who))
                                         : place.answered == static_cast<int>(place.trials.size());
  if (!over)
    throw conflict("kind", "a completion when every trial is answered",
                   fmt::format("{} of {} answered", place.answered, place.trials.size()));
  if (rules_.quest_plus)
    if (const EdgeEvents edges = edge_events(sequence_of(who).procedure, 0); !edges.events.empty())
      log_.append_events(who.stored, edges.events);
  log_.complete(who.stored);
}

}  // namespace seamline::study::online
