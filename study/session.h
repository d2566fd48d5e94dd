#pragma once
#include <cstdint>
#include <variant>

#include "study/procedure.h"
#include "study/trial.h"

namespace seamline {

// The phases of a session. Times are monotonic nanoseconds from whatever clock the caller has.

struct AwaitingImage {};  ///< the due stimulus is not on the screen yet
struct Choosing {         ///< it is; which of the three objects was inserted?
  std::int64_t onset_ns = 0;
};
struct Rating {  ///< an object is chosen; how noticeable was the insertion?
  std::int64_t onset_ns = 0;
  int chosen_index = 0;
  std::int64_t choice_ns = 0;  ///< from onset
};
struct Storing {  ///< the answer is complete and must be committed to the log
  TrialAnswer answer;
};
struct OnBreak {};
struct Done {};
using Phase = std::variant<AwaitingImage, Choosing, Rating, Storing, OnBreak, Done>;

// What can happen to a session.

struct ImageShown {
  std::int64_t now_ns = 0;  ///< when the swap that showed the image was done
};
struct ObjectChosen {
  int index = 0;  ///< 1 left, 2 middle, 3 right
  std::int64_t now_ns = 0;
};
struct RatingGiven {
  int rating = 0;  ///< 1..4
  std::int64_t now_ns = 0;
};
struct AnswerStored {};  ///< the log has committed the answer
struct BreakEnded {};
using Event = std::variant<ImageShown, ObjectChosen, RatingGiven, AnswerStored, BreakEnded>;

/// A session of one participant; a value. The trial that is due is `answered_trials(procedure)`.
struct Session {
  Procedure procedure;
  int break_every_trials = 0;  ///< 0: no breaks
  Phase phase;
};

/// A session at the procedure's first unanswered trial (which need not be trial 0: that is how a session
/// resumes), or done when there is none.
[[nodiscard]] Session begin_session(Procedure procedure, int break_every_trials);

/// The session after an event. Pure: no clock, no random numbers, no log.
///
///     AwaitingImage --ImageShown--> Choosing --ObjectChosen--> Rating --RatingGiven--> Storing
///     --AnswerStored--> AwaitingImage of the next trial | OnBreak (every break_every_trials answers, never
///     after the last) | Done Rating --ObjectChosen--> Rating (the last choice before the rating counts)
///     OnBreak --BreakEnded--> AwaitingImage
///
/// Every other event leaves the session as it was, and so does an object outside 1..3, a rating outside 1..4
/// or a time before the image's onset or the choice: a stray key can neither skip a trial, nor change a rated
/// choice. No image follows an answer that the log has not committed, because only AnswerStored leaves
/// Storing.
[[nodiscard]] Session next(Session session, const Event& event);

}  // namespace seamline
