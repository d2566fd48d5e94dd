#pragma once
#include <cstdint>
#include <optional>
#include <variant>

#include "study/placement/trial.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

// The phases of a session. Times are monotonic nanoseconds from whatever clock the caller has.

struct Grey {                                 ///< grey with a fixation mark, for SessionPace::inter_trial_ns
  std::optional<std::int64_t> since_ns = {};  ///< none until the first Tick
};
struct AwaitingImage {};  ///< the due picture is not on the screen yet
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
using Phase = std::variant<Grey, AwaitingImage, Choosing, Rating, Storing, OnBreak, Done>;

// What can happen to a session.

struct Tick {  ///< time passes
  std::int64_t now_ns = 0;
};
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
struct PictureTaken {};  ///< the picture left the screen before the answer was complete (a pause)
using Event =
    std::variant<Tick, ImageShown, ObjectChosen, RatingGiven, AnswerStored, BreakEnded, PictureTaken>;

/// How a session is paced.
struct SessionPace {
  int break_every_trials = 0;           ///< 0: no breaks
  std::int64_t minimum_viewing_ns = 0;  ///< a choice sooner than this after the onset does not count
  std::int64_t inter_trial_ns = 0;      ///< 0: no grey between trials
};

/// A session of one participant; a value. The trial that is due is number `answered_trials(trials)`.
struct Session {
  TrialSequence trials;
  SessionPace pace;
  Phase phase;
};

/// A session at the first unanswered trial (which need not be trial 0: that is how a session resumes), or
/// done when there is none.
[[nodiscard]] Session begin_session(TrialSequence trials, const SessionPace& pace);

/// The session after an event. Pure: no clock, no random numbers, no log.
///
///     Grey --Tick, inter_trial_ns after the first Tick--> AwaitingImage
///     AwaitingImage --ImageShown--> Choosing --ObjectChosen--> Rating --RatingGiven--> Storing
///     --AnswerStored--> Grey of the next trial | OnBreak (every break_every_trials answers, never after the
///     last) | Done
///     Rating --ObjectChosen--> Rating (the last choice before the rating counts)
///     OnBreak --BreakEnded--> Grey
///     Grey, Choosing, Rating --PictureTaken--> Grey (the trial begins again)
///
/// Grey is passed over when inter_trial_ns is 0. Every other event leaves the session as it was, and so does
/// an object outside 1..3, a rating outside 1..4, a time before the image's onset or the choice, or a choice
/// before minimum_viewing_ns: a stray key can neither skip a trial, nor change a rated choice. No image
/// follows an answer that the log has not committed, because only AnswerStored leaves Storing.
[[nodiscard]] Session next(Session session, const Event& event);

}  // namespace seamline::study
