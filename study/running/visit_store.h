#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/trials/rendered_set.h"
#include "study/visit/visit.h"

namespace seamline::study {

/// Who comes, and as what.
struct Visitor {
  std::string code = {};  ///< 1 to 64 of A-Z a-z 0-9 . _ -; never a name
  bool pilot = false;
  /// In which language they read, where the study has several; empty: it has one.
  std::string language = {};
  /// The form whose options are stored, where the set's study is read in another language; empty: its own.
  std::vector<FormField> own_form = {};
};

/// Between a visit and the log: everything but the window.
///
///     VisitStore store(set, log, {.code = "p01"});   // before the participant sees anything
///     Visit visit = store.begin();
///     while (!is_over(visit)) { draw(visit); visit = store.step(std::move(visit), what_happened); }
class VisitStore {
 public:
  /// Opens or creates the log and proves that it can be written to. Throws InputError when it cannot be, when
  /// the shipped consent text would be shown to somebody who is no pilot, or when the participant is
  /// complete, excluded, of another kind, in a session elsewhere, or has begun and the study refuses to
  /// resume. `set` must live as long as the store.
  VisitStore(const RenderedSet& set, const std::filesystem::path& log, const Visitor& visitor);
  ~VisitStore();
  VisitStore(const VisitStore&) = delete;
  VisitStore& operator=(const VisitStore&) = delete;

  /// The visit at its start: a newcomer's, or where the participant goes on. Throws InputError when the log
  /// fails.
  [[nodiscard]] Visit begin();

  /// The visit after an event, with everything that it asks to be stored committed, in one transaction with
  /// the events noted before. When the log fails the visit is at StoppedScreen.
  [[nodiscard]] Visit step(Visit visit, const VisitEvent& event);

  /// Keeps a raw event for the next commit. Before consent they wait, and after a refusal they are dropped.
  void note(RawEvent event);

  /// Counts frames for the next commit; adds to what was counted before.
  void count_frames(const FrameCounts& frames);

  /// Commits what was noted and counted. When the log fails the visit is at StoppedScreen.
  [[nodiscard]] Visit flush(Visit visit);

  /// What the display check found last time on this machine and monitor.
  [[nodiscard]] std::optional<DisplayFacts> latest_display(const std::string& machine,
                                                           const std::string& monitor);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace seamline::study
