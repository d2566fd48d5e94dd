#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "study/placement/trial.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

struct LevelLadders;  // study/trials/level_ladders.h

// The phases of a session. Times are monotonic nanoseconds from whatever clock the caller has.

struct Grey {                                 ///< grey with a fixation mark, for SessionPace::inter_trial_ns
  std::optional<std::int64_t> since_ns = {};  ///< none until the first Tick
};
struct AwaitingImage {  ///< the due picture is not on the screen yet
  int picture = 0;      ///< which of those that the trial shows one after another
};
struct Viewing {  ///< one of several pictures is on the screen, for SessionTask::exposure_ns
  std::int64_t onset_ns = 0;
  int picture = 0;
};
struct Gap {  ///< grey between two pictures, for SessionTask::gap_ns
  std::int64_t since_ns = 0;
  int next_picture = 0;
};
struct Choosing {  ///< it is, or they were; which of the alternatives is it?
  std::int64_t onset_ns = 0;
  int moved_to =
      -1;  ///< of a match, the stimulus that is on the screen; -1: the one that the trial begins with
};
struct Rating {  ///< it is chosen, or the task has no choice; how noticeable was the insertion?
  std::int64_t onset_ns = 0;
  int chosen_index = 0;
  std::int64_t choice_ns = 0;  ///< from onset
};
struct Storing {  ///< the answer is complete and must be committed to the log
  TrialAnswer answer;
};
struct OnBreak {
  bool briefing_next = false;  ///< a block begins after it
};
struct Briefing {};  ///< a block of trials begins with instructions of its own
struct Done {};
using Phase =
    std::variant<Grey, AwaitingImage, Viewing, Gap, Choosing, Rating, Storing, OnBreak, Briefing, Done>;

// What can happen to a session.

struct Tick {  ///< time passes: of Viewing and Gap, the time for which the next frame is drawn
  std::int64_t now_ns = 0;
};
struct ImageShown {
  std::int64_t now_ns = 0;  ///< when the swap that showed the image was done
};
struct ObjectChosen {
  int index = 0;  ///< 1 left, 2 middle, 3 right; or the alternative from 1
  std::int64_t now_ns = 0;
};
struct RatingGiven {
  int rating = 0;  ///< 1..4; 0 where there is no choice and nothing was seen; of a slider nothing
  std::int64_t now_ns = 0;
  int position = -1;  ///< of a slider
};
struct AnswerStored {};  ///< the log has committed the answer
struct BreakEnded {};    ///< a break, or a briefing
struct PictureTaken {};  ///< the picture left the screen before the answer was complete (a pause)
using Event =
    std::variant<Tick, ImageShown, ObjectChosen, RatingGiven, AnswerStored, BreakEnded, PictureTaken>;

/// What a trial asks, and for how long its pictures are seen.
struct SessionTask {
  TaskFacts facts = {};
  std::int64_t exposure_ns = 0;  ///< 0: until the answer
  std::int64_t gap_ns = 0;
  std::int64_t mask_ns = 0;                          ///< from the end of each exposure; 0: no mask
  std::shared_ptr<const LevelLadders> ladders = {};  ///< of a match: between which pictures people move
};

/// Of each stimulus of a set whose conditions have tasks of their own; null: all ask what the study asks.
using OwnSessionTasks = std::shared_ptr<const std::vector<SessionTask>>;

/// Of each stimulus the block that is briefed before its first trial, -1 of blocks without words; null: none
/// is.
using BriefedBlocks = std::shared_ptr<const std::vector<int>>;

/// How a session is paced.
struct SessionPace {
  int break_every_trials = 0;           ///< 0: no breaks
  std::int64_t minimum_viewing_ns = 0;  ///< a choice sooner than this after the onset does not count
  std::int64_t inter_trial_ns = 0;      ///< 0: no grey between trials
  SessionTask task = {};
  OwnSessionTasks own_tasks = {};
  BriefedBlocks briefed = {};
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
///     Before a session's first trial, and before that of a block with a briefing: Briefing --BreakEnded-->
///     Grey; a break comes first
///     Grey, Viewing, Gap, Choosing, Rating --PictureTaken--> Grey (the trial begins again)
///
/// A task of several pictures, and tasks without a rating or without a choice:
///
///     AwaitingImage --ImageShown--> Viewing --Tick, exposure_ns after the onset--> Gap --Tick, after
///     gap_ns--> AwaitingImage of the next picture; after the last one Choosing Choosing --ObjectChosen-->
///     Storing;    AwaitingImage --ImageShown--> Rating --RatingGiven--> Storing
///
/// A match:
///
///     Choosing --ObjectChosen 1 or 2--> Choosing one level on, unless there is none --ObjectChosen 3-->
///     Storing
///
/// Grey is passed over when inter_trial_ns is 0. Every other event leaves the session as it was, and so does
/// a choice outside the alternatives, a rating outside 1..4 (0..4 without a choice), a time before the
/// image's onset or the choice, or a choice before minimum_viewing_ns: a stray key can neither skip a trial,
/// nor change a rated choice. No image follows an answer that the log has not committed, because only
/// AnswerStored leaves Storing.
[[nodiscard]] Session next(Session session, const Event& event);

/// What the trial that is due asks; after the last one what the study asks.
[[nodiscard]] const SessionTask& task_due(const Session& session);

/// The picture that is due, or in a match the one that the participant has moved to. None where none is due.
[[nodiscard]] std::optional<Trial> picture_on_screen(const Session& session);

/// Whether the picture of a trial is seen at a time while the answer is awaited: not where pictures were
/// shown one after another, nor after the exposure.
[[nodiscard]] bool is_picture_seen(const SessionTask& task, std::int64_t onset_ns, std::int64_t now_ns);

/// Whether the mask of the picture that came at `onset_ns` is seen at a time.
[[nodiscard]] bool is_mask_seen(const SessionTask& task, std::int64_t onset_ns, std::int64_t now_ns);

}  // namespace seamline::study
