#include "study/running/visit_store.h"

#include "stimuli/definition/people/language_definition.h"
#include "support/running/overloaded.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

InputError refusal(const fs::path& log, const std::string& code, const std::string& wanted,
                   const std::string& found) {
  return input_error(
      {.file = log.string(), .field = "participant " + code, .wanted = wanted, .found = found});
}

void check_consent_text(const RenderedSet& set, const Visitor& visitor) {
  if (visitor.pilot || !is_default_consent(set.study.consent)) return;
  throw input_error({.file = (set.folder / set.manifest.study_file).string(),
                     .field = "consent.text",
                     .wanted = "your own consent text (for a trial run with the shipped one use " +
                               request_name("pilot") + ")",
                     .found = set.study.consent.text.substr(0, 8) == "TEMPLATE" ? "the shipped template"
                                                                                : "the shipped text"});
}

void check_may_begin(const KnownParticipant& known, const fs::path& log, const Visitor& visitor,
                     ResumePolicy policy) {
  if (known.completed)
    throw refusal(log, visitor.code, "a participant who has not finished",
                  "one who has: a finished participant is not overwritten");
  if (known.excluded) throw refusal(log, visitor.code, "a participant who takes part", "one who is excluded");
  if (policy == ResumePolicy::refuse && known.answered > 0)
    throw refusal(log, visitor.code, "a participant who has not begun (session.resume = \"refuse\")",
                  "one with " + counted(known.answered, "answer"));
}

}  // namespace

struct VisitStore::State {
  State(const RenderedSet& rendered, const fs::path& log_path, const Visitor& visitor)
      : set(rendered),
        enrolment{.code = visitor.code, .pilot = visitor.pilot},
        own_form(visitor.own_form),
        rules(make_trial_rules(rendered)),
        script(std::make_shared<const VisitScript>(make_visit_script(rendered))),
        log(log_path, rendered) {}

  const RenderedSet& set;
  Enrolment enrolment;
  std::vector<FormField> own_form;
  TrialRules rules;
  std::shared_ptr<const VisitScript> script;
  LogWriter log;
  std::optional<OpenSession> place;  ///< none until the participant has consented
  std::vector<RawEvent> noted;
  FrameCounts frames;
  std::int64_t last_ns = 0;  ///< of the events noted
  bool failed = false;       ///< the log could not be written to: nothing more is tried

  /// Stores one record; returns the event that says so.
  VisitEvent store(const Record& record);
  void store_noted();
  /// An adaptive procedure's trial must be in the log before its picture is shown.
  [[nodiscard]] bool must_store_trial(const Visit& visit) const;

  /// Runs `work` as one transaction; when the log fails the visit stops.
  template <class Work>
  Visit guarded(Visit visit, Work&& work);

  /// Stores whatever the visit asks for.
  Visit settle(Visit visit);
};

VisitEvent VisitStore::State::store(const Record& record) {
  return std::visit(
      Overloaded{[&](const DeclineRecord&) -> VisitEvent {
                   noted.clear();
                   frames = {};
                   log.record_decline();
                   return RecordStored{};
                 },
                 [&](const ConsentRecord& consent) -> VisitEvent {
                   place = enter_session(log, enrolment, set.study.session.orders);
                   log.record_consent(*place, set.study.consent.text, consent.accepted_unix_s);
                   return Enrolled{open_trials(rules, log, *place)};
                 },
                 [&](const FormRecord& form) -> VisitEvent {
                   const bool translated = !own_form.empty();
                   log.record_form(*place, translated
                                               ? answers_of_study(own_form, set.study.form, form.answers)
                                               : form.answers);
                   return RecordStored{};
                 },
                 [&](const DisplayRecord& display) -> VisitEvent {
                   log.record_display(*place, display.facts);
                   return RecordStored{};
                 },
                 [&](const TrainingRecord& training) -> VisitEvent {
                   log.append_training(*place, {.trial = training.trial, .answer = training.answer});
                   return RecordStored{};
                 },
                 [&](const AnswerRecord& answer) -> VisitEvent {
                   log.append_answer(*place, answer.answer);
                   return RecordStored{};
                 },
                 [&](const CompletionRecord&) -> VisitEvent {
                   log.complete(*place);
                   return RecordStored{};
                 }},
      record);
}

void VisitStore::State::store_noted() {
  if (!place) return;  // before consent nothing is stored
  if (!noted.empty()) log.append_events(*place, noted);
  if (frames.shown > 0 || frames.late > 0) log.add_frames(*place, frames);
}

bool VisitStore::State::must_store_trial(const Visit& visit) const {
  return place && std::holds_alternative<TrialScreen>(visit.screen) &&
         std::ssize(place->trials) <= place->answered;
}

template <class Work>
Visit VisitStore::State::guarded(Visit visit, Work&& work) {
  if (failed) return visit;
  const Visit before = visit;
  try {
    log.transaction([&] { work(visit); });
    if (place) {
      noted.clear();
      frames = {};
    }
    return visit;
  } catch (const InputError& error) {
    failed = true;
    return next(before, StoreFailed{error.what()});
  }
}

Visit VisitStore::State::settle(Visit visit) {
  if (!visit.pending && !must_store_trial(visit)) return visit;
  return guarded(std::move(visit), [&](Visit& now) {
    while (now.pending) {
      if (std::holds_alternative<CompletionRecord>(*now.pending))
        store_edge_alarms(now.session.trials.procedure, log, *place, last_ns);
      const VisitEvent stored = store(*now.pending);
      now = next(std::move(now), stored);
    }
    store_noted();
    if (must_store_trial(now)) store_due_trial(now.session.trials, log, *place);
  });
}

VisitStore::VisitStore(const RenderedSet& set, const fs::path& log, const Visitor& visitor) {
  check_participant_code(visitor.code);
  check_consent_text(set, visitor);
  state_ = std::make_unique<State>(set, log, visitor);
  if (!visitor.language.empty()) note({.kind = "language", .detail = visitor.language});
  const std::optional<KnownParticipant> known = state_->log.find(state_->enrolment);
  if (!known) return;
  check_may_begin(*known, log, visitor, set.study.session.resume);
  if (known->consented) state_->place = state_->log.open_session(state_->enrolment);
}

VisitStore::~VisitStore() = default;

Visit VisitStore::begin() {
  State& state = *state_;
  if (!state.place) return begin_visit(state.script);
  if (state.set.study.session.resume == ResumePolicy::restart && state.place->answered > 0)
    state.log.restart(*state.place);
  return state.settle(
      resume_visit(state.script, state.place->form_done, open_trials(state.rules, state.log, *state.place)));
}

Visit VisitStore::step(Visit visit, const VisitEvent& event) {
  return state_->settle(next(std::move(visit), event));
}

void VisitStore::note(RawEvent event) {
  state_->last_ns = event.monotonic_ns;
  state_->noted.push_back(std::move(event));
}

void VisitStore::count_frames(const FrameCounts& frames) {
  state_->frames.shown += frames.shown;
  state_->frames.late += frames.late;
}

Visit VisitStore::flush(Visit visit) {
  return state_->guarded(std::move(visit), [&](Visit&) { state_->store_noted(); });
}

std::optional<DisplayFacts> VisitStore::latest_display(const std::string& machine,
                                                       const std::string& monitor) {
  return state_->log.latest_display(machine, monitor);
}

}  // namespace seamline::study
