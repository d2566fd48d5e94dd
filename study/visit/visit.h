#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stimuli/definition/form_definition.h"
#include "study/visit/display_facts.h"
#include "study/visit/session.h"
#include "study/visit/visit_script.h"

namespace seamline::study {

// A visit is everything a participant meets, from consent to thanks, as a value. `next` is pure: no clock, no
// window, no log. What must be stored comes out in `Visit::pending`, and nothing goes on until the caller
// says that it is stored (study/running/visit_store.h does).

// Screens.

struct ConsentScreen {};
struct FormProblem {
  std::string field;
  FormFault fault = FormFault::missing;
  bool operator==(const FormProblem&) const = default;
};
struct FormScreen {
  std::vector<FormProblem> problems = {};  ///< with what was submitted last
};
struct DisplayScreen {};
struct InstructionScreen {
  int page = 0;  ///< 0-based
};
struct TrainingScreen {};  ///< a trial of `Visit::training`, whose phase says what is seen
struct FeedbackScreen {    ///< on the training trial that was just answered
  Trial trial;
  int chosen_index = 0;
  int right_index = 0;
  [[nodiscard]] bool right() const { return chosen_index == right_index; }
};
struct ReadyScreen {};  ///< practice is over, the trials begin
struct TrialScreen {};  ///< a trial of `Visit::session`, whose phase says what is seen
struct BreakScreen {};
struct BriefingScreen {};  ///< the instructions of the block whose first trial is due
struct ThanksScreen {};
struct DeclinedScreen {};
struct StoppedScreen {  ///< something could not be stored; what was stored before is
  std::string message;
};
using PausableScreen = std::variant<InstructionScreen, TrainingScreen, FeedbackScreen, ReadyScreen,
                                    TrialScreen, BreakScreen, BriefingScreen>;
struct PauseScreen {
  PausableScreen below;  ///< what goes on after the pause
};
using Screen = std::variant<ConsentScreen, FormScreen, DisplayScreen, InstructionScreen, TrainingScreen,
                            FeedbackScreen, ReadyScreen, TrialScreen, BreakScreen, BriefingScreen,
                            PauseScreen, ThanksScreen, DeclinedScreen, StoppedScreen>;

// What must be stored.

struct DeclineRecord {};  ///< the fact alone
struct ConsentRecord {
  std::int64_t accepted_unix_s = 0;
};
struct FormRecord {
  std::vector<FormAnswer> answers;
};
struct DisplayRecord {
  DisplayFacts facts;
};
struct TrainingRecord {
  Trial trial;
  TrialAnswer answer;
};
struct AnswerRecord {
  TrialAnswer answer;
};
struct CompletionRecord {};
using Record = std::variant<DeclineRecord, ConsentRecord, FormRecord, DisplayRecord, TrainingRecord,
                            AnswerRecord, CompletionRecord>;

// What can happen besides the events of a session.

struct ConsentGiven {
  std::int64_t unix_s = 0;
};
struct ConsentRefused {};
struct FormSubmitted {
  std::vector<FormAnswer> answers;
};
struct DisplayConfirmed {
  DisplayFacts facts;
};
struct Continued {};  ///< next page, after feedback, ready, after a break, after a pause
struct WentBack {};   ///< to the page before
struct PauseBegun {};
struct RecordStored {};  ///< what is pending, unless it is a consent
struct Enrolled {        ///< a consent is stored, and the participant has a place and an order
  TrialSequence trials;
};
struct StoreFailed {  ///< what is pending could not be stored
  std::string message;
};
using VisitEvent = std::variant<ConsentGiven, ConsentRefused, FormSubmitted, DisplayConfirmed, Continued,
                                WentBack, PauseBegun, RecordStored, Enrolled, StoreFailed, Event>;

struct Visit {
  std::shared_ptr<const VisitScript> script;
  bool form_done = false;  ///< a participant who comes again has answered it
  Session training;
  Session session;  ///< empty until the participant is enrolled
  Screen screen;
  std::optional<Record> pending = {};  ///< to be stored before anything else happens
};

/// The visit of a newcomer: at the consent.
[[nodiscard]] Visit begin_visit(std::shared_ptr<const VisitScript> script);

/// The visit of a participant who has consented before: at the form, or at the display check when the form is
/// answered. When no trial is left, the completion is pending.
[[nodiscard]] Visit resume_visit(std::shared_ptr<const VisitScript> script, bool form_done,
                                 TrialSequence trials);

/// The visit after an event.
///
///     Consent --ConsentGiven--> [ConsentRecord] --Enrolled--> Form --FormSubmitted, no problems-->
///     [FormRecord] --> Display --DisplayConfirmed--> [DisplayRecord] --> Instruction pages --Continued-->
///     Training, each trial [TrainingRecord] --> Feedback --Continued--> ... --> Ready --Continued-->
///     Trials, each [AnswerRecord], with Breaks between, and a Briefing before each block that has one -->
///     [CompletionRecord] --> Thanks
///     Consent --ConsentRefused--> [DeclineRecord] --> Declined
///     PauseBegun on a PausableScreen --> Pause --Continued--> what it interrupted; a trial whose picture was
///     on the screen begins again with a new onset, and a choice without a rating is dropped
///     StoreFailed, wherever it happens before the end --> Stopped
///
/// `[Record]` is pending until RecordStored (Enrolled for a consent) and lets no other event through except
/// StoreFailed. Form and training are passed over when they are empty. Every event that does not belong to
/// the screen leaves the visit as it was.
[[nodiscard]] Visit next(Visit visit, const VisitEvent& event);

/// Nothing more will happen: thanks, declined or stopped, with nothing pending.
[[nodiscard]] bool is_over(const Visit& visit);

/// The session whose trial is on the screen: the training, or the trials themselves; null elsewhere.
[[nodiscard]] const Session* session_on_screen(const Visit& visit);

/// The trial whose picture is, or is about to be, on the screen: of the training, or of the session.
[[nodiscard]] std::optional<Trial> trial_on_screen(const Visit& visit);

}  // namespace seamline::study
