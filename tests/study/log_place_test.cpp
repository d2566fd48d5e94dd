// A log has one place, by whatever path it is opened: links, folders that cannot be written to, second names.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <functional>

#include "log_fixture.h"
#include "study/log/log_admin.h"
#include "study/log/log_place.h"
#include "study/log/recovery/log_recovery.h"
#include "study/log/session_claims.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr fs::perms read_only = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
constexpr fs::perms read_only_folder =
    read_only | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;

/// Runs `work` in a process of its own, and returns what it says, or what it threw.
std::string in_child(const std::function<std::string()>& work) {
  int ends[2] = {};
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::string said;
    try {
      said = work();
    } catch (const std::exception& error) {
      said = error.what();
    }
    ::_exit(::write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0 : 3);
  }
  ::close(ends[1]);
  std::string said;
  char block[512];
  for (ssize_t count = 0; (count = ::read(ends[0], block, sizeof block)) > 0;)
    said.append(block, static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  return said;
}

/// The same without root's right to write everywhere.
std::string as_nobody(const std::function<std::string()>& work) {
  return in_child([&] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 &&
        (::setresgid(nobody, nobody, nobody) != 0 || ::setresuid(nobody, nobody, nobody) != 0))
      return std::string("cannot become nobody");
    return work();
  });
}

std::string answers_in(const fs::path& log) {
  return fmt::format("{} answers", read_log(log).answers.size());
}

class LogPlace : public LogTest {
 protected:
  fs::path link = folder / "linked" / "link.sqlite";  ///< to a link to the log, in another folder

  void SetUp() override {
    fs::create_directory(folder / "linked");
    fs::create_symlink("../other-link.sqlite", link);
    fs::create_symlink("log.sqlite", folder / "other-link.sqlite");
  }

  /// The files of a log whose last answers wait in its write-ahead log, as a kill or a copy leaves them, in a
  /// folder in which nobody can make anything.
  [[nodiscard]] fs::path archived(bool readable_ahead = true) {
    const fs::path archive = folder / "archive";
    fs::create_directory(archive);
    {
      LogWriter log(path, set);
      (void)enter(log, {.code = "p1"}, 20);
      for (const char* suffix : {"", "-wal"}) {
        const fs::path file = archive / (std::string("log.sqlite") + suffix);
        fs::copy_file(path.string() + suffix, file);
        fs::permissions(file, suffix == std::string() || readable_ahead ? read_only : fs::perms::none);
      }
    }
    fs::permissions(archive, read_only_folder);
    fs::permissions(folder.path(), read_only_folder, fs::perm_options::add);
    return archive / "log.sqlite";
  }
  void TearDown() override {
    if (fs::exists(folder / "archive")) fs::permissions(folder / "archive", fs::perms::owner_all);
  }
};

TEST_F(LogPlace, OneSessionOfAParticipantByWhateverPath) {
  { LogWriter log(path, set); }
  LogWriter log(link, set);
  OpenSession session = enter(log, {.code = "p1"}, 2);
  fs::create_directory_symlink(folder.path(), folder / "linked" / "folder");
  for (const fs::path& other : {path, link, folder / "linked" / "folder" / "log.sqlite"}) {
    LogWriter again(other, set);
    EXPECT_THAT(complaint_of([&] { (void)again.open_session({.code = "p1"}); }), HasSubstr("open in another"))
        << other;
    EXPECT_TRUE(read_log(other).participants.at(0).in_progress) << other;
    EXPECT_EQ(read_log(other).answers.size(), 2U) << other;
  }
  EXPECT_EQ(claims_file(link), fs::canonical(path).string() + "-lock");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "linked"), {}), 2)
      << "something was made beside the link";
  for (const char* gone : {"-wal", ""}) {
    fs::rename(path.string() + gone, folder / "moved");
    EXPECT_THAT(complaint_of([&] { log.append_answer(session, answer(2)); }), HasSubstr("deleted or moved"));
    fs::rename(folder / "moved", path.string() + gone);
  }
  log.append_answer(session, answer(2));
}

TEST_F(LogPlace, ALinkThatLeadsNowhereIsRefused) {
  EXPECT_THAT(complaint_of([&] { LogWriter log(link, set); }), HasSubstr("no such file"));
  EXPECT_THAT(complaint_of([&] { (void)read_log(link); }), HasSubstr("no such file"));
}

TEST_F(LogPlace, ForgettingThroughALinkRemovesTheLockToo) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 2);
  }
  ASSERT_TRUE(fs::exists(path.string() + "-lock"));
  forget_participant(link, "p1");
  EXPECT_FALSE(fs::exists(path.string() + "-lock"));
}

TEST_F(LogPlace, EveryAnswerIsReadInAFolderWhereNothingCanBeMade) {
  const fs::path log = archived();
  fs::remove(folder / "other-link.sqlite");
  fs::create_symlink(log, folder / "other-link.sqlite");
  fs::permissions(folder / "linked", read_only_folder);
  for (const fs::path& given : {log, link})
    EXPECT_EQ(as_nobody([&] { return answers_in(given); }), "20 answers") << given;
  EXPECT_EQ(std::distance(fs::directory_iterator(log.parent_path()), {}), 2);
  const fs::path saved = folder / "saved.sqlite";
  EXPECT_EQ(in_child([&] {
              (void)recover_log(link, saved, {});
              return answers_in(saved);
            }),
            "20 answers");
}

TEST_F(LogPlace, AWriteAheadLogThatCannotBeReadIsNeverLeftOut) {
  const fs::path log = archived(false);
  EXPECT_THAT(as_nobody([&] { return answers_in(log); }), HasSubstr("-wal: wanted a readable file"));
}

TEST_F(LogPlace, AHalfTransactionInAFolderWhereNothingCanBeMadeIsUndone) {
  const fs::path archive = folder / "archive";
  fs::create_directory(archive);
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 20);
  }
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec(
      "PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; BEGIN; DELETE FROM answers; DELETE FROM trials");
  database.exec("PRAGMA cache_spill = 1; DELETE FROM stimuli");
  ASSERT_TRUE(fs::exists(path.string() + "-journal"));
  for (const char* suffix : {"", "-journal"}) {
    fs::copy_file(path.string() + suffix, archive / (std::string("log.sqlite") + suffix));
    fs::permissions(archive / (std::string("log.sqlite") + suffix), read_only);
  }
  fs::permissions(archive, read_only_folder);
  fs::permissions(folder.path(), read_only_folder, fs::perm_options::add);
  EXPECT_EQ(as_nobody([&] { return answers_in(archive / "log.sqlite"); }), "20 answers");
}

TEST_F(LogPlace, ASecondNameIsRefused) {
  { LogWriter log(path, set); }
  fs::create_hard_link(path, folder / "linked" / "second.sqlite");
  for (const fs::path& name : {path, folder / "linked" / "second.sqlite"}) {
    EXPECT_THAT(complaint_of([&] { (void)read_log(name); }), HasSubstr("hard links"));
    EXPECT_THAT(complaint_of([&] { LogWriter log(name, set); }), HasSubstr("hard links"));
    EXPECT_THAT(complaint_of([&] { (void)recover_log(name, folder / "saved.sqlite", {}); }),
                HasSubstr("hard links"));
  }
}

TEST_F(LogPlace, AFileMountedAloneIsRefused) {
  { LogWriter log(path, set); }
  const fs::path alone = folder / "linked" / "alone.sqlite";
  write_file_atomically(alone, "x");
  const std::string said = in_child([&] {
    if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount(path.c_str(), alone.c_str(), nullptr, MS_BIND, nullptr) != 0)
      return std::string("not permitted");
    return answers_in(alone);
  });
  if (said == "not permitted") GTEST_SKIP() << "nobody may mount here";
  EXPECT_THAT(said, HasSubstr("mounted alone"));
}

TEST_F(LogPlace, WhatIsMadeIsForItsOwnerAlone) {
  const mode_t before = ::umask(022);
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 2);
    for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
      struct stat status = {};
      ASSERT_EQ(::stat((path.string() + suffix).c_str(), &status), 0) << suffix;
      EXPECT_EQ(status.st_mode & 0777, 0600U) << suffix;
    }
  }
  (void)recover_log(path, folder / "saved.sqlite", {});
  EXPECT_EQ(fs::status(folder / "saved.sqlite").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  // A log that its owner opened to a group stays so, and so is what lies beside it.
  fs::remove(path.string() + "-lock");
  fs::permissions(path, fs::perms::group_read | fs::perms::group_write, fs::perm_options::add);
  LogWriter log(path, set);
  (void)enter(log, {.code = "p2"}, 2);
  for (const char* suffix : {"", "-wal", "-lock"})
    EXPECT_NE(fs::status(path.string() + suffix).permissions() & fs::perms::group_write, fs::perms::none)
        << suffix;
  ::umask(before);
}

TEST_F(LogPlace, ALinkInThePlaceOfTheLockIsNotFollowed) {
  { LogWriter log(path, set); }
  fs::create_symlink("of-somebody", path.string() + "-lock");
  LogWriter log(path, set);
  EXPECT_THROW((void)log.open_session({.code = "p1"}), InputError);
  EXPECT_FALSE(fs::exists(folder / "of-somebody"));
}

TEST_F(LogPlace, NothingIsSavedBesideAForeignWriteAheadLog) {
  { LogWriter log(path, set); }
  const fs::path saved = folder / "saved.sqlite";
  write_file_atomically(saved.string() + "-wal", "of an older log");
  EXPECT_THAT(complaint_of([&] { (void)recover_log(path, saved, {}); }), HasSubstr("does not exist yet"));
}

}  // namespace
}  // namespace seamline::study
