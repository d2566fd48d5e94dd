// SIGKILL at random instants of the program in its window, under real keys: nothing that the screen showed as
// accepted is lost, nothing is doubled, and the next session goes on where the last one ended.
#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

#include "picture_set.h"
#include "scripted_window.h"
#include "study/log/log.h"
#include "support/arithmetic/random.h"

namespace seamline::test {
using namespace study;

inline constexpr int trials_of_a_person = 12;

struct KillTally {
  int kills = 0;
  int accepted = 0;   ///< answers that the screen showed as accepted
  int stored = 0;     ///< answers in the log at the end
  int continued = 0;  ///< sessions that went on in the middle of somebody's trials
  int completed = 0;  ///< participants who came to the end
};

inline std::string window_code(int person) {
  return fmt::format("p{:03}", person);
}

/// What a killed session had shown.
struct ShownProgress {
  int accepted = 0;                ///< answers shown as accepted: the trials below this number
  std::optional<int> first_trial;  ///< the trial that came first
  bool thanked = false;
};

inline ShownProgress progress_in(const std::filesystem::path& trace) {
  ShownProgress progress;
  if (!std::filesystem::exists(trace)) return progress;
  const std::string text = read_file(trace);
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const Line line = Line::parse(text.substr(begin, end - begin));
    progress.accepted = std::max(progress.accepted, line["answered"].get<int>());
    if (line["screen"] == "trial" && !progress.first_trial) progress.first_trial = line["trial"].get<int>();
    if (line["screen"] == "thanks") progress.thanked = true;
  }
  return progress;
}

/// The person's answers in the log, which must be the scripted ones without a gap.
inline int stored_answers(const std::filesystem::path& log, int person) {
  int count = 0;
  for (const Answer& answer : read_log(log).answers) {
    if (answer.participant != window_code(person)) continue;
    EXPECT_EQ(answer.trial_index, count);
    const ScriptedAnswer wanted = scripted_answer(person, count++);
    EXPECT_EQ(answer.chosen_index, wanted.chosen);
    EXPECT_EQ(answer.rating, wanted.rating);
  }
  return count;
}

inline void expect_sound(const std::filesystem::path& log) {
  SQLite::Database database(log.string(), SQLite::OPEN_READWRITE, 2000);
  EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
  SQLite::Statement orphans(database, "PRAGMA foreign_key_check");
  EXPECT_FALSE(orphans.executeStep());
}

/// Kills `kills` sessions, one person after the other.
inline KillTally kill_sessions(const std::filesystem::path& folder, int kills, std::uint64_t seed) {
  std::filesystem::remove_all(folder);
  (void)write_picture_set(folder / "set", {.width_px = 200,
                                           .height_px = 120,
                                           .widths = "64, 128, 256, 512",
                                           .session = "break_every_trials = 5\ninter_trial_s = 0.03\n",
                                           .top = "participant_form = false",
                                           .more = "[consent]\ntext = \"Discs.\"\n[training]\ntrials = 0\n"
                                                   "[[instructions.page]]\ntext = \"Press 1, 2 or 3.\"\n"});
  const XServer server(folder / "screen", 800, 600);
  keep_display_profile(folder / "run" / "config", 800, 600);
  Random random(seed);
  KillTally tally;
  int person = 1, stored = 0;
  while (tally.kills < kills) {
    WindowDriver window(server, {.set = folder / "set",
                                 .log = folder / "log.sqlite",
                                 .code = window_code(person),
                                 .folder = folder / "run"});
    const std::int64_t delay_ms = 50 + static_cast<std::int64_t>(random.below(4000));
    // A handle and not a number: the program may end by itself, and its number be given to another.
    const int handle = static_cast<int>(::syscall(SYS_pidfd_open, window.process(), 0));
    std::atomic<bool> ended = false;
    // Every fourth delay counts from the start of the program, the others from its first frame.
    const bool from_start = tally.kills % 4 == 3;
    std::thread killer([&] {
      for (int look = 0; look < 2000 && !from_start && !ended && !window.now(); ++look)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      for (std::int64_t waited_ms = 0; waited_ms < delay_ms && !ended; ++waited_ms)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ::syscall(SYS_pidfd_send_signal, handle, SIGKILL, nullptr, 0);
    });
    drive(window, person, [](const Line&) { return false; });
    ended = true;
    killer.join();
    ::close(handle);
    if (window.running()) window.kill();
    ++tally.kills;
    const ShownProgress shown = progress_in(window.trace());
    if (shown.first_trial) {
      EXPECT_EQ(*shown.first_trial, stored) << "person " << person << " goes on at another trial";
      tally.continued += stored > 0 ? 1 : 0;
    }
    if (!std::filesystem::exists(folder / "log.sqlite")) continue;  // killed before the log was begun
    expect_sound(folder / "log.sqlite");
    const int accepted = std::max(shown.accepted, stored);  // of this session and those before
    stored = stored_answers(folder / "log.sqlite", person);
    EXPECT_GE(stored, accepted) << "an accepted answer is lost";
    EXPECT_LE(stored, accepted + 1) << "an answer that was never shown as accepted";
    tally.accepted += std::max(0, shown.accepted - shown.first_trial.value_or(shown.accepted));
    const bool complete_before = shown.accepted == 0 && stored == trials_of_a_person;  // and refused now
    if (!shown.thanked && !complete_before) continue;
    EXPECT_EQ(stored, trials_of_a_person);
    ++tally.completed;
    ++person;
    stored = 0;
  }
  tally.stored = static_cast<int>(read_log(folder / "log.sqlite").answers.size());
  std::printf(
      "%d kills: %d answers shown as accepted, %d stored, %d sessions went on in the middle, %d participants "
      "came to the end\n",
      tally.kills, tally.accepted, tally.stored, tally.continued, tally.completed);
  return tally;
}

}  // namespace seamline::test
