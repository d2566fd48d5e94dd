// serve, import and merge as people type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "refusal.h"
#include "run_program.h"
#include "study/log/log.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using test::expect_refused;
using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;

TEST(OnlineCommands, InvitationsArePrintedAndTheirHashesStored) {
  const auto folder = fresh_folder("online-tokens");
  const std::string file = (folder / "tokens").string();
  const Outcome made = run_seamline("serve --make-tokens 3 --tokens " + file);
  EXPECT_EQ(made.status, 0) << made.output;
  EXPECT_EQ(made.output.size(), 3U * 33);
  EXPECT_EQ(read_text(file).size(), 3U * 65);
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  expect_refused("serve --make-tokens 3", "wanted --tokens FILE");
  expect_refused("serve " + folder.string() + " --make-tokens 3 --tokens " + file,
                 "nothing served by the same");
}

TEST(OnlineCommands, AConfigurationForNginxIsWritten) {
  const auto folder = fresh_folder("online-nginx");
  const std::string file = (folder / "nginx.conf").string();
  const Outcome written = run_seamline("serve --nginx " + file + " --port 8123");
  EXPECT_EQ(written.status, 0) << written.output;
  EXPECT_THAT(read_text(file), HasSubstr("server 127.0.0.1:8123;"));
  expect_refused("serve --nginx " + file + " --log x.sqlite", "nothing served by the same");
  const Outcome named = run_seamline("serve --nginx " + file + " --host a.example.org --host b.example.org");
  EXPECT_EQ(named.status, 0) << named.output;
  EXPECT_THAT(read_text(file), HasSubstr("server_name a.example.org b.example.org;"));
}

TEST(OnlineCommands, WhoIsForgottenIsTakenOutOfTheFileOfCodesToo) {
  const auto folder = fresh_folder("online-forget");
  const std::string log = (folder / "log.sqlite").string(), codes = (folder / "codes").string(),
                    hashes = std::string(64, 'a') + " ", others = std::string(64, 'b') + " somebody-else\n";
  test::write_picture_set(folder / "set", {});
  const Outcome simulated =
      run_seamline("study " + (folder / "set").string() + " --observer perfect --count 2 --log " + log);
  ASSERT_EQ(simulated.status, 0) << simulated.output;
  const std::vector<study::ParticipantRecord> people = study::read_log(log).participants;
  const std::string first = people.at(0).code, second = people.at(1).code;
  write_text(codes, hashes + first + "\n" + others);
  const std::string forget = "log forget " + log + " ";
  // A code that neither knows changes neither.
  expect_refused(forget + "nobody --codes " + codes, "wanted a code that is in the log");
  expect_refused(forget + first + " --codes " + log, "wanted the hash of an invitation and a code");
  EXPECT_EQ(study::read_log(log).participants.size(), 2U);
  const Outcome forgotten = run_seamline(forget + first + " --codes " + codes);
  EXPECT_EQ(forgotten.status, 0) << forgotten.output;
  EXPECT_EQ(read_text(codes), others);
  EXPECT_EQ(study::read_log(log).participants.size(), 1U);
  // Forgotten in the log first, and in the file later.
  EXPECT_EQ(run_seamline(forget + second).output, "");  // nobody came by an invitation
  write_text(codes, hashes + second + "\n" + others);
  const Outcome later = run_seamline(forget + second + " --codes " + codes);
  EXPECT_EQ(later.status, 0) << later.output;
  EXPECT_THAT(later.output, HasSubstr("not there any more in"));
  EXPECT_EQ(read_text(codes), others);
  expect_refused("log status " + log + " --codes " + codes, "--codes");
}

TEST(OnlineCommands, WhatIsMissingOrWrongIsSaidInOneSentence) {
  const auto folder = fresh_folder("online-wrong");
  const std::string none = (folder / "none").string(), text = (folder / "text.txt").string();
  write_text(text, "no message\n");
  expect_refused("serve", "wanted a folder of seamline export web");
  expect_refused("serve " + none, "found no log");
  expect_refused("serve " + none + " --log " + none, "none: wanted a folder that seamline export web wrote");
  expect_refused("serve " + none + " --log " + none + " --port 70000", "--port");
  expect_refused("serve " + none + " --log " + none + " --host 'a;b'",
                 "--host: wanted a name like study.example.org");
  expect_refused("serve " + none + " --log " + none + " --codes " + text, "--codes: wanted --tokens FILE");
  expect_refused("serve --code-of abc", "--code-of: wanted --codes FILE");
  expect_refused("serve --code-of abc --codes " + text, "wanted the hash of an invitation and a code");
  expect_refused("serve --code-of abc --codes " + none, "none: wanted a readable file");
  expect_refused("import " + none + ".sqlite " + text, "--set: wanted the rendered set");
  expect_refused("merge " + none + " " + none, "no such file");
  EXPECT_FALSE(std::filesystem::exists(none + ".sqlite"));
}

}  // namespace
}  // namespace seamline
