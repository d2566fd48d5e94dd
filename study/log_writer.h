#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/observer.h"
#include "study/study_set.h"
#include "study/trial.h"

namespace seamline {

/// Who a simulated participant is.
struct Simulated {
  ObserverKind observer = ObserverKind::threshold;
  std::uint64_t seed = 0;  ///< of the whole simulation
  bool operator==(const Simulated&) const = default;
};

/// Who is about to take part.
struct Enrolment {
  std::string code = {};  ///< 1 to 64 of A-Z a-z 0-9 . _ -; a code, never a name
  bool pilot = false;
  std::optional<Simulated> simulated = {};  ///< none: a person
  std::optional<int> slot = {};             ///< none: the lowest that no one of the same kind holds
};

/// A participant's place in the log, as found when the session began.
struct OpenSession {
  std::int64_t participant = 0;           ///< row in the log
  std::int64_t session = 0;               ///< row in the log; 0 when nothing is left to do
  int slot = 0;                           ///< which order of trials
  std::vector<int> planned = {};          ///< stimuli (indices into the set) of the trials planned so far
  int answered = 0;                       ///< the first `answered` of them have answers
  std::vector<TrialAnswer> answers = {};  ///< those answers
  bool completed = false;
  bool excluded = false;
};

/// Something raw that happened in a session: shown, choice, rating, focus_lost, focus_gained, pause, resize,
/// ...
struct RawEvent {
  std::int64_t monotonic_ns = 0;
  std::string kind = {};
  std::optional<int> trial_index = {};
  std::string detail = {};
};

/// Throws InputError unless the code is one that the log takes (see Enrolment).
void check_participant_code(const std::string& code);

/// The log, open for a session. Every call is a transaction of its own, on the disk (synchronous=FULL) when
/// the call returns, unless it is made inside `transaction`. Throws InputError when the disk or the file
/// fails; what was committed before stays.
class LogWriter {
 public:
  /// Opens or creates the log of a set, and proves by a committed write that it can be written to. Throws
  /// InputError when it cannot, or when the log belongs to another study or set; a log begun here is removed
  /// again then.
  LogWriter(std::filesystem::path path, const StudySet& set);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Enters a newcomer, or finds the participant again. Throws InputError when the code is not well formed or
  /// belongs to a participant of another kind (pilot, simulated, observer, seed).
  [[nodiscard]] OpenSession open_session(const Enrolment& enrolment);

  /// Adds trials after those already planned.
  void plan_trials(OpenSession& session, std::span<const int> stimuli);

  /// Stores the answer to trial `session.answered`, which must be planned.
  void append_answer(OpenSession& session, const TrialAnswer& answer);

  void append_events(const OpenSession& session, std::span<const RawEvent> events);

  /// Marks the participant as having answered everything.
  void complete(OpenSession& session);

  /// Runs `work` as one transaction: all of its calls are stored, or, when it throws, none.
  void transaction(const std::function<void()>& work);

 private:
  struct Tables;
  std::filesystem::path path_;
  std::unique_ptr<Tables> tables_;
};

}  // namespace seamline
