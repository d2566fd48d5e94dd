#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/definition/form_definition.h"
#include "study/log/participant_code.h"
#include "study/observers/observer.h"
#include "study/placement/trial.h"
#include "study/trials/rendered_set.h"
#include "study/trials/stimulus_order.h"
#include "study/visit/display_facts.h"

namespace seamline::study {

/// Who a simulated participant is.
struct Simulated {
  ObserverKind observer = ObserverKind::threshold;
  std::uint64_t seed = 0;                 ///< of the whole simulation
  std::optional<double> image_gain = {};  ///< of `image`
  bool operator==(const Simulated&) const = default;
};

/// Who is about to take part.
struct Enrolment {
  std::string code = {};  ///< 1 to 64 of A-Z a-z 0-9 . _ -; a code, never a name
  bool pilot = false;
  std::optional<Simulated> simulated = {};  ///< none: a person
  int slot = 0;                             ///< of a newcomer, see study/trials/stimulus_order.h
};

/// A participant's place in the log, as found when the session began.
struct OpenSession {
  std::int64_t participant = 0;           ///< row in the log
  std::int64_t session = 0;               ///< row in the log; 0 when nothing is left to do
  int slot = 0;                           ///< which order of trials
  std::vector<Trial> trials = {};         ///< decided so far
  int answered = 0;                       ///< the first `answered` of them have answers
  std::vector<TrialAnswer> answers = {};  ///< those answers
  bool completed = false;
  bool excluded = false;
  bool simulated = false;
  bool consented = false;
  bool form_done = false;  ///< the participant form is answered
  double image_scale = 1;  ///< screen pixels a picture pixel, see record_display
};

/// A participant whom the log knows, before any session is opened.
struct KnownParticipant {
  int answered = 0;
  bool consented = false;
  bool completed = false;
  bool excluded = false;
  bool in_progress = false;  ///< a session is open somewhere else
};

/// Frames of a session.
struct FrameCounts {
  std::int64_t shown = 0;
  std::int64_t late = 0;  ///< that missed at least one refresh of the screen
};

/// The answer to a practice trial.
struct TrainingAnswer {
  Trial trial;
  TrialAnswer answer;  ///< its trial_index is the place within this session's practice
};

/// Something raw that happened in a session: shown, choice, rating, focus_lost, focus_gained, pause, resize,
/// ...
struct RawEvent {
  std::int64_t monotonic_ns = 0;
  std::string kind = {};
  std::optional<int> trial_index = {};
  std::string detail = {};
  std::optional<std::int64_t> swap = {};  ///< number of the buffer swap that showed it, from 0 at the start
};

/// The log, open for a session. Every call is a transaction of its own, on the disk (synchronous=FULL) when
/// the call returns, unless it is made inside `transaction`. Throws InputError when the disk or the file
/// fails; what was committed before stays.
class LogWriter {
 public:
  /// Opens or creates the log of a set, and proves by a committed write that it can be written to. A set
  /// whose study differs in nothing but [observer] is the log's own. Throws InputError when it cannot, or
  /// when the log belongs to another study or set and holds anything. A log begun here in which nothing is
  /// stored yet is removed when this ends by an exception, then or later.
  LogWriter(std::filesystem::path path, const RenderedSet& set);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Before simulated observers enter: the log's text of the study becomes the set's, so that it says what
  /// they are made of. Throws InputError where the log has simulated observers of another [observer].
  void take_observer(const RenderedSet& set);

  /// What the log knows of a code; none: a newcomer. Throws InputError as open_session does.
  [[nodiscard]] std::optional<KnownParticipant> find(const Enrolment& enrolment);

  /// The slots of participants of the same kind (pilot, person, simulated) who are not excluded.
  [[nodiscard]] std::vector<HeldSlot> held_slots(const Enrolment& enrolment);

  /// Enters a newcomer with the slot of the enrolment, or finds the participant again, and begins a session.
  /// Throws InputError when the code is not well formed, belongs to a participant of another kind (pilot,
  /// simulated, observer, seed, gain), or, for a person, a session of the participant is open elsewhere. The
  /// claim on the participant ends with this LogWriter, or with the process, however that ends.
  [[nodiscard]] OpenSession open_session(const Enrolment& enrolment);

  /// Adds trials after those that the log has.
  void append_trials(OpenSession& session, std::span<const Trial> trials);

  /// Stores the answer to trial `session.answered`, which the log must have.
  void append_answer(OpenSession& session, const TrialAnswer& answer);

  /// Sets the participant's trials and answers aside (kept in the log, never analysed): the session is at
  /// trial 0 again, with no trial decided.
  void restart(OpenSession& session);

  /// That somebody declined to take part, and when; not who.
  void record_decline();

  /// That the participant accepted this text, and when.
  void record_consent(OpenSession& session, const std::string& consent_text, std::int64_t accepted_unix_s);

  /// The participant form; replaces what was answered before.
  void record_form(OpenSession& session, std::span<const FormAnswer> answers);

  /// What the session's pictures are shown on; replaces what was recorded before in this session. Answers
  /// stored from now on carry its `image_scale`.
  void record_display(OpenSession& session, const DisplayFacts& facts);

  /// What was recorded last on this machine and monitor.
  [[nodiscard]] std::optional<DisplayFacts> latest_display(const std::string& machine,
                                                           const std::string& monitor);

  /// Adds to the session's frame counts.
  void add_frames(const OpenSession& session, const FrameCounts& frames);

  void append_training(const OpenSession& session, const TrainingAnswer& answer);

  void append_events(const OpenSession& session, std::span<const RawEvent> events);

  /// Marks the participant as having answered everything.
  void complete(OpenSession& session);

  /// Runs `work` as one transaction: all of its calls are stored, or, when it throws, none.
  void transaction(const std::function<void()>& work);

 private:
  friend class OnlineLog;  // study/log/online: people in browsers
  struct Tables;
  void open(const RenderedSet& set);

  std::filesystem::path path_;
  std::unique_ptr<Tables> tables_;
  bool begun_here_;
  int exceptions_;  ///< that were on their way when this was made
};

}  // namespace seamline::study
