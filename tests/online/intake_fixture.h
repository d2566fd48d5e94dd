#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "online_people.h"
#include "study/log/log_database.h"
#include "study/online/intake/intake.h"
#include "tests/complaint.h"

namespace seamline::study::online {

/// A log, and people whose messages come into it.
class IntakeTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  std::filesystem::path path = folder / "log.sqlite";

  static GivenIdentity given(std::uint64_t number) {
    return {.code = fmt::format("s-{}", number),
            .secret_sha256 = sha256(fmt::format("secret {}", number)),
            .slots = 200};
  }
  /// Somebody at a server.
  Page enrolled(Intake& intake, std::uint64_t number) const {
    Page page{.set = &set, .number = number};
    const Message message = page.enrol();
    intake.transaction([&] {
      const EnrolledPerson person = intake.enrol(message, given(number));
      page.code = person.code;
      page.slot = person.slot;
    });
    return page;
  }
  static bool take(Intake& intake, const Message& message) {
    bool stored = false;
    intake.transaction([&] { stored = intake.take(message); });
    return stored;
  }
  static void take_all(Intake& intake, const std::vector<Message>& messages) {
    intake.transaction([&] {
      for (const Message& message : messages) EXPECT_TRUE(intake.take(message));
    });
  }
  std::string refusal(Intake& intake, const Message& message) const {
    return test::complaint_of([&] { intake.transaction([&] { (void)intake.take(message); }); });
  }
  [[nodiscard]] std::int64_t rows(const std::string& table) const {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    return database.execAndGet("SELECT count(*) FROM " + table).getInt64();
  }
};

}  // namespace seamline::study::online
