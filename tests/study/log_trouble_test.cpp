// A disk without room, and a log that is gone, in the middle of a visit.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "scripted_person.h"
#include "sound_log.h"
#include "study/log/log.h"
#include "study/running/visit_store.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text_of_study() {
  return study_text("tiny", paper_widths_px) + "[consent]\ntext = \"Our own text.\"\n";
}

/// How a visit under a limit ended: answers accepted, and the message of the screen.
struct Ending {
  int accepted = 0;
  bool stopped = false;
  char message[400] = {};
};

Ending visit_until_it_stops(const RenderedSet& set, const fs::path& path, int most_answers) {
  VisitStore store(set, path, {.code = "p01"});
  ScriptedPerson person(3);
  Visit visit = store.begin();
  Ending ending;
  while (!is_over(visit) && answered_trials(visit.session.trials) < most_answers)
    visit = store.step(std::move(visit), person.act(visit));
  ending.accepted = answered_trials(visit.session.trials);
  if (const auto* stopped = std::get_if<StoppedScreen>(&visit.screen)) {
    ending.stopped = true;
    stopped->message.copy(ending.message, sizeof ending.message - 1);
  }
  return ending;
}

/// The same in a process whose files may not grow beyond a limit.
Ending visit_under_a_limit(const RenderedSet& set, const fs::path& path, rlim_t bytes) {
  int ends[2] = {};
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Ending ending;
    try {
      ending = visit_until_it_stops(set, path, 1000);
    } catch (const std::exception& error) {
      std::string(error.what()).copy(ending.message, sizeof ending.message - 1);
    }
    ::_exit(::write(ends[1], &ending, sizeof ending) == sizeof ending ? 0 : 3);
  }
  ::close(ends[1]);
  Ending ending;
  EXPECT_EQ(::read(ends[0], &ending, sizeof ending), static_cast<ssize_t>(sizeof ending));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  return ending;
}

TEST(LogTrouble, OnAFullDiskTheVisitStopsPlainlyAndKeepsWhatWasAnswered) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", text_of_study());
  int stopped_in_trials = 0;
  for (const rlim_t kilobytes : {120, 160, 200, 250, 300}) {
    const fs::path path = folder / fmt::format("log{}.sqlite", kilobytes);
    { const LogWriter log(path, set); }
    const Ending ending = visit_under_a_limit(set, path, kilobytes * 1024);
    std::printf("%d KB: %d answers accepted\n", static_cast<int>(kilobytes), ending.accepted);
    EXPECT_TRUE(ending.stopped) << kilobytes << " KB: " << ending.message;
    EXPECT_THAT(std::string(ending.message), HasSubstr("every answer stored before is kept"));
    EXPECT_THAT(std::string(ending.message), HasSubstr("disk"));
    expect_sound(path);
    EXPECT_EQ(static_cast<int>(read_log(path).answers.size()), ending.accepted);
    stopped_in_trials += ending.accepted > 0 ? 1 : 0;
    const Ending after = visit_until_it_stops(set, path, 1000);  // with room again
    EXPECT_FALSE(after.stopped) << after.message;
    EXPECT_EQ(read_log(path).answers.size(), 84U);
  }
  EXPECT_GE(stopped_in_trials, 2);
}

TEST(LogTrouble, ALogThatIsGoneStopsTheVisit) {
  for (const char* gone : {"", "-wal"}) {
    const TemporaryFolder folder;
    const RenderedSet set = write_set_of_text(folder / "set", text_of_study());
    const fs::path path = folder / "log.sqlite";
    VisitStore store(set, path, {.code = "p01"});
    ScriptedPerson person(3);
    Visit visit = store.begin();
    while (answered_trials(visit.session.trials) < 3) visit = store.step(std::move(visit), person.act(visit));
    fs::rename(path.string() + gone, folder / "moved");
    while (!is_over(visit)) visit = store.step(std::move(visit), person.act(visit));
    ASSERT_TRUE(std::holds_alternative<StoppedScreen>(visit.screen)) << gone;
    EXPECT_THAT(std::get<StoppedScreen>(visit.screen).message, HasSubstr("deleted or moved"));
    EXPECT_EQ(answered_trials(visit.session.trials), 3);
  }
}

}  // namespace
}  // namespace seamline::study
