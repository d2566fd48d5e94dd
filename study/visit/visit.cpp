#include "study/visit/visit.h"

#include "study/trials/catch_trials.h"
#include "support/running/overloaded.h"

namespace seamline::study {
namespace {

Session begin_training(const VisitScript& script) {
  ConstantProcedure procedure;
  for (const Trial& trial : script.training)
    if (trial.kind == TrialKind::stimulus) procedure.order.push_back(trial.stimulus);
  SessionPace pace = script.pace;
  pace.break_every_trials = 0;
  pace.briefed = nullptr;
  return begin_session({.procedure = std::move(procedure),
                        .catches = catch_trials_of(script.training),
                        .right = script.training_rule},
                       pace);
}

template <class Wanted>
bool is(const VisitEvent& event) {
  return std::holds_alternative<Wanted>(event);
}

std::vector<FormProblem> problems_in(const std::vector<FormField>& form,
                                     const std::vector<FormAnswer>& answers) {
  std::vector<FormProblem> problems;
  for (const FormField& field : form) {
    std::string value;
    for (const FormAnswer& answer : answers)
      if (answer.field == field.name) value = answer.value;
    if (const std::optional<FormFault> fault = fault_of(field, value))
      problems.push_back({.field = field.name, .fault = *fault});
  }
  return problems;
}

/// The answers to questions that there are.
std::vector<FormAnswer> known_answers(const std::vector<FormField>& form,
                                      const std::vector<FormAnswer>& answers) {
  std::vector<FormAnswer> known;
  for (const FormField& field : form)
    for (const FormAnswer& answer : answers)
      if (answer.field == field.name && !answer.value.empty()) known.push_back(answer);
  return known;
}

Screen after_consent(const Visit& visit) {
  return visit.form_done || visit.script->form.empty() ? Screen(DisplayScreen{}) : Screen(FormScreen{});
}

Screen training_or_ready(const Visit& visit) {
  return std::holds_alternative<Done>(visit.training.phase) ? Screen(ReadyScreen{})
                                                            : Screen(TrainingScreen{});
}

Screen after_display(const Visit& visit) {
  return visit.script->instruction_pages > 0 ? Screen(InstructionScreen{}) : training_or_ready(visit);
}

/// The screen of the session's phase; asks for the completion after the last trial.
void show_session(Visit& visit) {
  if (std::holds_alternative<OnBreak>(visit.session.phase)) {
    visit.screen = BreakScreen{};
    return;
  }
  if (std::holds_alternative<Briefing>(visit.session.phase)) {
    visit.screen = BriefingScreen{};
    return;
  }
  visit.screen = TrialScreen{};
  if (std::holds_alternative<Done>(visit.session.phase)) visit.pending = CompletionRecord{};
}

void after_training_stored(Visit& visit, const TrainingRecord& record) {
  visit.training = next(std::move(visit.training), AnswerStored{});
  visit.screen = FeedbackScreen{.trial = record.trial,
                                .chosen_index = record.answer.chosen_index,
                                .right_index = visit.script->training_right[record.answer.trial_index]};
}

/// What was pending is stored.
void after_stored(Visit& visit, const Record& record) {
  std::visit(Overloaded{[&](const DeclineRecord&) { visit.screen = DeclinedScreen{}; },
                        [&](const ConsentRecord&) {},  // `Enrolled` follows a consent
                        [&](const FormRecord&) {
                          visit.form_done = true;
                          visit.screen = DisplayScreen{};
                        },
                        [&](const DisplayRecord&) { visit.screen = after_display(visit); },
                        [&](const TrainingRecord& training) { after_training_stored(visit, training); },
                        [&](const AnswerRecord&) {
                          visit.session = next(std::move(visit.session), AnswerStored{});
                          show_session(visit);
                        },
                        [&](const CompletionRecord&) { visit.screen = ThanksScreen{}; }},
             record);
}

Visit after_record(Visit visit, const VisitEvent& event) {
  const Record record = *visit.pending;
  if (std::holds_alternative<ConsentRecord>(record)) {
    const auto* enrolled = std::get_if<Enrolled>(&event);
    if (enrolled == nullptr) return visit;
    visit.pending.reset();
    visit.session = begin_session(enrolled->trials, visit.script->pace);
    visit.screen = after_consent(visit);
  } else if (is<RecordStored>(event)) {
    visit.pending.reset();
    after_stored(visit, record);
  }
  return visit;
}

/// A trial of the training or of the session; the answer, once complete, is pending.
void on_training(Visit& visit, const VisitEvent& event) {
  if (const auto* inner = std::get_if<Event>(&event)) visit.training = next(visit.training, *inner);
  if (const auto* storing = std::get_if<Storing>(&visit.training.phase))
    visit.pending =
        TrainingRecord{.trial = current_trial(visit.training.trials).value(), .answer = storing->answer};
}

void on_trial(Visit& visit, const VisitEvent& event) {
  if (const auto* inner = std::get_if<Event>(&event)) visit.session = next(visit.session, *inner);
  if (const auto* storing = std::get_if<Storing>(&visit.session.phase))
    visit.pending = AnswerRecord{storing->answer};
}

void on_form(Visit& visit, const VisitEvent& event) {
  const auto* submitted = std::get_if<FormSubmitted>(&event);
  if (submitted == nullptr) return;
  const std::vector<FormProblem> problems = problems_in(visit.script->form, submitted->answers);
  visit.screen = FormScreen{problems};
  if (problems.empty()) visit.pending = FormRecord{known_answers(visit.script->form, submitted->answers)};
}

void on_instructions(Visit& visit, InstructionScreen screen, const VisitEvent& event) {
  if (is<WentBack>(event) && screen.page > 0) visit.screen = InstructionScreen{screen.page - 1};
  if (!is<Continued>(event)) return;
  visit.screen = screen.page + 1 < visit.script->instruction_pages
                     ? Screen(InstructionScreen{screen.page + 1})
                     : training_or_ready(visit);
}

/// A break, or what is read before a block.
void on_break(Visit& visit, bool continued) {
  if (!continued) return;
  visit.session = next(std::move(visit.session), BreakEnded{});
  show_session(visit);
}

/// The screen that a pause interrupts, if it can.
std::optional<PausableScreen> pausable(const Screen& screen) {
  return std::visit(
      [](const auto& now) -> std::optional<PausableScreen> {
        if constexpr (std::is_constructible_v<PausableScreen, decltype(now)>)
          return PausableScreen(now);
        else
          return std::nullopt;
      },
      screen);
}

void begin_pause(Visit& visit, const PausableScreen& below) {
  if (std::holds_alternative<TrainingScreen>(below)) visit.training = next(visit.training, PictureTaken{});
  if (std::holds_alternative<TrialScreen>(below)) visit.session = next(visit.session, PictureTaken{});
  visit.screen = PauseScreen{below};
}

void on_screen(Visit& visit, const VisitEvent& event) {
  const Screen screen = visit.screen;
  const bool continued = is<Continued>(event);
  std::visit(
      Overloaded{[&](const ConsentScreen&) {
                   if (const auto* given = std::get_if<ConsentGiven>(&event))
                     visit.pending = ConsentRecord{given->unix_s};
                   if (is<ConsentRefused>(event)) visit.pending = DeclineRecord{};
                 },
                 [&](const FormScreen&) { on_form(visit, event); },
                 [&](const DisplayScreen&) {
                   if (const auto* confirmed = std::get_if<DisplayConfirmed>(&event))
                     visit.pending = DisplayRecord{confirmed->facts};
                 },
                 [&](const InstructionScreen& now) { on_instructions(visit, now, event); },
                 [&](const TrainingScreen&) { on_training(visit, event); },
                 [&](const FeedbackScreen&) {
                   if (continued) visit.screen = training_or_ready(visit);
                 },
                 [&](const ReadyScreen&) {
                   if (continued) show_session(visit);
                 },
                 [&](const TrialScreen&) { on_trial(visit, event); },
                 [&](const BreakScreen&) { on_break(visit, continued); },
                 [&](const BriefingScreen&) { on_break(visit, continued); },
                 [&](const PauseScreen& now) {
                   if (continued)
                     visit.screen = std::visit([](const auto& below) { return Screen(below); }, now.below);
                 },
                 [](const ThanksScreen&) {}, [](const DeclinedScreen&) {}, [](const StoppedScreen&) {}},
      screen);
}

bool has_ended(const Screen& screen) {
  return std::holds_alternative<ThanksScreen>(screen) || std::holds_alternative<DeclinedScreen>(screen) ||
         std::holds_alternative<StoppedScreen>(screen);
}

}  // namespace

Visit begin_visit(std::shared_ptr<const VisitScript> script) {
  Visit visit;
  visit.training = begin_training(*script);
  visit.screen = ConsentScreen{};
  visit.script = std::move(script);
  return visit;
}

Visit resume_visit(std::shared_ptr<const VisitScript> script, bool form_done, TrialSequence trials) {
  Visit visit = begin_visit(std::move(script));
  visit.form_done = form_done;
  visit.session = begin_session(std::move(trials), visit.script->pace);
  if (std::holds_alternative<Done>(visit.session.phase))
    show_session(visit);
  else
    visit.screen = after_consent(visit);
  return visit;
}

Visit next(Visit visit, const VisitEvent& event) {
  if (const auto* failed = std::get_if<StoreFailed>(&event)) {
    if (!has_ended(visit.screen)) visit.screen = StoppedScreen{failed->message};
    visit.pending.reset();
    return visit;
  }
  if (visit.pending) return after_record(std::move(visit), event);
  if (is<PauseBegun>(event)) {
    if (const std::optional<PausableScreen> below = pausable(visit.screen)) begin_pause(visit, *below);
    return visit;
  }
  on_screen(visit, event);
  return visit;
}

bool is_over(const Visit& visit) {
  return !visit.pending && has_ended(visit.screen);
}

const Session* session_on_screen(const Visit& visit) {
  if (std::holds_alternative<TrainingScreen>(visit.screen)) return &visit.training;
  if (std::holds_alternative<TrialScreen>(visit.screen)) return &visit.session;
  return nullptr;
}

std::optional<Trial> trial_on_screen(const Visit& visit) {
  if (const auto* feedback = std::get_if<FeedbackScreen>(&visit.screen)) return feedback->trial;
  const Session* session = session_on_screen(visit);
  return session == nullptr ? std::nullopt : current_trial(session->trials);
}

}  // namespace seamline::study
