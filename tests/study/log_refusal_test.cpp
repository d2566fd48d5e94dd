// What a log refuses: values out of range, files that are no logs, other studies, other places.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "log_fixture.h"
#include "study/log/log_admin.h"
#include "study/log/log_schema.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(LogTest, TheTablesRefuseValuesOutOfRange) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 1);
  }
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA foreign_keys = ON");
  const auto answer_row = [](const std::string& trial, const std::string& rest) {
    return "INSERT INTO answers VALUES (1, " + trial + ", 1, " + rest + ", 1.0)";
  };
  const auto participant_row = [](const std::string& values) {
    return "INSERT INTO participants (code, slot, pilot, observer, seed) VALUES (" + values + ")";
  };
  for (const std::string& bad : {
           answer_row("1", "0, 1, 0, 0"),
           answer_row("1", "4, 1, 0, 0"),
           answer_row("1", "NULL, 1, 0, 0"),
           answer_row("1", "1, 0, 0, 0"),
           answer_row("1", "1, 5, 0, 0"),
           answer_row("1", "1, 1.5, 0, 0"),
           answer_row("1", "1, 'x', 0, 0"),
           answer_row("1", "1, 1, -1, 0"),
           answer_row("1", "1, 1, 5, 4"),
           answer_row("0", "1, 1, 0, 0"),   // answered already
           answer_row("24", "1, 1, 0, 0"),  // no such trial
           std::string("INSERT INTO answers VALUES (9, 1, 1, 1, 1, 0, 0, 1.0)"),
           std::string("INSERT INTO answers VALUES (1, 1, 9, 1, 1, 0, 0, 1.0)"),
           std::string("INSERT INTO answers VALUES (1, 1, 1, 1, 1, 0, 0, 0.0)"),
           std::string("INSERT INTO trials VALUES (1, 24, 'stimulus', 24)"),
           std::string("INSERT INTO trials VALUES (1, -1, 'stimulus', 0)"),
           std::string("INSERT INTO trials VALUES (1, 24, 'practice', 0)"),
           participant_row("'p1', 1, 0, NULL, NULL"),
           participant_row("'a b', 1, 0, NULL, NULL"),
           participant_row("'p2', -1, 0, NULL, NULL"),
           participant_row("'p2', 1, 2, NULL, NULL"),
           participant_row("'p2', 1, 0, 'perfect', NULL"),
           participant_row("'p2', 1, 0, NULL, 3"),
           std::string("INSERT INTO study SELECT 2, study_name, study_hash, set_hash, '', '', '' FROM study"),
           std::string("UPDATE stimuli SET artifact = 'glow'"),
           std::string("UPDATE stimuli SET object_index = 4"),
           std::string("UPDATE stimuli SET depth_width_px = 7"),
           std::string("UPDATE sessions SET started_unix_s = -1"),
           std::string("INSERT INTO events VALUES (1, 1, -1, 'shown', 0, '', NULL)"),
           std::string("INSERT INTO events VALUES (1, 1, 0, '', 0, '', NULL)"),
       })
    EXPECT_THROW(database.exec(bad), SQLite::Exception) << bad;
  EXPECT_NO_THROW(database.exec(answer_row("1", "3, 4, 5, 5")));
}

TEST_F(LogTest, ALogOfAnotherStudyOrSetIsRefusedAndUnharmed) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 1);
  }
  const RenderedSet other_study = write_set(folder / "other", "64, 512", "another");
  const std::string said = complaint_of([&] { LogWriter log(path, other_study); });
  EXPECT_THAT(said, HasSubstr("study_hash"));
  for (const RenderedSet& of : {set, other_study})
    EXPECT_THAT(said, HasSubstr(" of study \"" + of.study.name + "\", set " + of.folder.string()));
  Manifest rendered_again = set.manifest;
  rendered_again.stimuli[0].sha256 = std::string(64, '1');
  write_manifest(folder / "set", rendered_again);
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, load_rendered_set(folder / "set")); }),
              HasSubstr("set_hash"));
  EXPECT_EQ(read_log(path).set_hash, set.set_hash);
}

TEST_F(LogTest, StimuliThatAreNotThoseOfTheSetAreRefused) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 3);
  }
  const std::string whole = read_file(path);
  for (const char* change :
       {"UPDATE stimuli SET stimulus = 1000 WHERE stimulus = 5",
        "INSERT INTO stimuli SELECT 1000, 'more', scene, artifact, object, object_index, "
        "depth_width_px, yaw_texels, sha256, condition, level FROM stimuli WHERE stimulus = 5",
        "UPDATE stimuli SET condition = 'soft' WHERE stimulus = 5",
        "UPDATE stimuli SET level = 65 WHERE stimulus = 5",
        "UPDATE stimuli SET depth_width_px = 66 WHERE stimulus = 5"}) {
    write_file_atomically(path, whole);
    SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
        .exec(std::string("PRAGMA foreign_keys = OFF; ") + change +
              "; UPDATE trials SET stimulus = 1000 WHERE stimulus = 5 AND 1000 IN (SELECT stimulus FROM "
              "stimuli)");
    EXPECT_THAT(complaint_of([&] { LogWriter log(path, set); }), HasSubstr("wanted the stimuli of the set"))
        << change;
  }
}

TEST_F(LogTest, FilesThatAreNotLogsAreRefused) {
  const auto refused = [&](const char* reason) {
    EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr(reason));
    EXPECT_THAT(complaint_of([&] { exclude_participant(path, "p1"); }), HasSubstr(reason));
    EXPECT_THAT(complaint_of([&] { LogWriter log(path, set); }), HasSubstr(reason));
    EXPECT_TRUE(fs::exists(path));
    fs::remove_all(path);
  };
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("no such file"));
  for (const std::string& text :
       {std::string("x"), std::string("level,correct,trials\n"), std::string(100000, 'x')}) {
    std::ofstream(path) << text;
    refused("not SQLite");
  }
  fs::create_directory(path);
  refused("not a file");
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE other (x)");
  refused("another SQLite database");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 1");
  refused("written by an older seamline");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec(fmt::format("PRAGMA user_version = {}", newest_log_schema_version + 1));
  refused("written by a newer seamline");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec("ALTER TABLE answers RENAME COLUMN rating TO stars");
  refused("other tables");
}

TEST_F(LogTest, ATruncatedLogIsRefused) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 24);
  }
  const auto whole = fs::file_size(path);
  for (const auto bytes : {whole / 2, whole - 4096, std::uintmax_t{4096}, std::uintmax_t{1000}}) {
    const fs::path cut = folder / "cut.sqlite";
    fs::copy_file(path, cut, fs::copy_options::overwrite_existing);
    fs::resize_file(cut, bytes);
    EXPECT_NE(complaint_of([&] { (void)read_log(cut); }), "no complaint") << bytes << " of " << whole;
    for (const char* suffix : {"-wal", "-shm"}) fs::remove(cut.string() + suffix);
  }
}

TEST_F(LogTest, AnEmptyFileBecomesALogButIsNotReadAsOne) {
  std::ofstream(path).flush();
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("empty"));
  { LogWriter log(path, set); }
  EXPECT_EQ(read_log(path).study_name, "tiny");
}

TEST_F(LogTest, AnUnwritableLocationIsRefusedAndNothingIsLeft) {
  std::ofstream(folder / "file") << "x";
  for (const fs::path& bad :
       {folder / "none/log.sqlite", folder / "file/log.sqlite", fs::path("/proc/log.sqlite")}) {
    EXPECT_THAT(complaint_of([&] { LogWriter log(bad, set); }), HasSubstr("log")) << bad;
    EXPECT_FALSE(fs::exists(folder / "none"));
  }
}

TEST_F(LogTest, WhatBeganBadlyIsRemoved) {
  Manifest wrong = set.manifest;
  wrong.stimuli[1].id = wrong.stimuli[0].id;
  RenderedSet twice = set;
  twice.manifest = wrong;
  EXPECT_ANY_THROW(LogWriter(path, twice));
  for (const char* suffix : {"", "-wal", "-shm"}) EXPECT_FALSE(fs::exists(path.string() + suffix)) << suffix;
}

TEST_F(LogTest, ASetWithoutManifestOrWithAnotherStudyIsRefused) {
  fs::create_directories(folder / "empty");
  EXPECT_THROW((void)load_rendered_set(folder / "empty"), InputError);
  EXPECT_THROW((void)load_rendered_set(folder / "nowhere"), InputError);
  write_file_atomically(folder / "set/study.toml", study_text("edited", "64, 512"));
  EXPECT_THAT(complaint_of([&] { (void)load_rendered_set(folder / "set"); }),
              HasSubstr("render the set again"));
  fs::remove(folder / "set/study.toml");
  EXPECT_THROW((void)load_rendered_set(folder / "set"), InputError);
}

}  // namespace
}  // namespace seamline::study
