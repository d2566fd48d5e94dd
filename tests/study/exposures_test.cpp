// How long pictures stand on the screen, in its refreshes; and what an export says of it.
#include "study/visit/exposures.h"

#include <gtest/gtest.h>

#include "study/exchange/answer_tables.h"
#include "study/exchange/exposure_records.h"
#include "tests/study/log_fixture.h"

namespace seamline::study {
namespace {

constexpr std::int64_t refresh_ns = 16'666'667;

TEST(Exposures, TheFramesNearestToTheTimeAreWanted) {
  EXPECT_EQ(wanted_frames(500'000'000, refresh_ns), 30);
  EXPECT_EQ(wanted_frames(510'000'000, refresh_ns), 31);
  EXPECT_EQ(wanted_frames(1'000'000, refresh_ns), 1);
}

TEST(Exposures, AreCountedFromTheSwapThatShowsToTheOneThatTakesAway) {
  ExposureCounter counter;
  const auto at = [](int frame) { return 7 + frame * refresh_ns; };
  const auto note = [&](std::optional<int> picture, int frame) {
    return counter.note_shown(picture, at(frame), 3 * refresh_ns, refresh_ns);
  };
  EXPECT_EQ(note(std::nullopt, 0), std::nullopt);
  EXPECT_EQ(note(0, 1), std::nullopt);
  EXPECT_EQ(note(0, 2), std::nullopt);
  EXPECT_EQ(note(std::nullopt, 4), (Exposure{.picture = 1, .frames = 3, .wanted = 3}));
  EXPECT_EQ(note(1, 6), std::nullopt);
  EXPECT_EQ(note(std::nullopt, 10), (Exposure{.picture = 2, .frames = 4, .wanted = 3}));  // a frame late
  EXPECT_EQ(note(0, 11), std::nullopt);
  counter.forget();  // an answer
  EXPECT_EQ(note(std::nullopt, 12), std::nullopt);
}

TEST(Exposures, AreReadAsTheyAreWritten) {
  const Exposure exposure{.picture = 2, .frames = 31, .wanted = 30};
  EXPECT_EQ(text_of(exposure), "picture 2 frames 31 wanted 30");
  EXPECT_EQ(exposure_of(text_of(exposure)), exposure);
  for (const char* other : {"", "picture 0 frames 3 wanted 3", "picture 1 frames 3",
                            "picture 1 frames 3 wanted -3", "picture 1 frames 3 wanted 3 more"})
    EXPECT_EQ(exposure_of(other), std::nullopt) << other;
}

class ExposureRecords : public LogTest {};

TEST_F(ExposureRecords, AnExportMarksTrialsWithOthers) {
  const RenderedSet intervals =
      write_set_of_text(folder / "intervals",
                        study_text("tiny", "64, 512") + "[task]\nkind = \"interval\"\nexposure_s = 0.5\n");
  LogWriter writer(path, intervals);
  OpenSession session = enter_session(writer, {.code = "anna"}, 0);
  writer.append_trials(session, interleave(stimulus_order(24, {.study_seed = 7, .slot = session.slot}), {}));
  const auto seen = [](int trial, const char* detail) {
    return RawEvent{.kind = "exposure", .trial_index = trial, .detail = detail};
  };
  const std::vector<RawEvent> events = {
      seen(0, "picture 1 frames 30 wanted 30"),
      seen(0, "picture 2 frames 31 wanted 30"),
      seen(0, "picture 2 frames 30 wanted 30"),
      seen(1, "picture 1 frames 30 wanted 30"),
      seen(1, "picture 2 frames 32 wanted 30"),
      {.kind = "exposure", .detail = "practice picture 1 frames 9 wanted 30"}};
  writer.append_events(session, events);
  for (int i = 0; i < 3; ++i) writer.append_answer(session, answer(session.answered));
  const CsvTable answers = answer_tables(read_log(path)).front();
  ASSERT_EQ(answers.columns.back().name, "exposure_marked");
  const auto off = [&](std::size_t row) { return answers.rows.at(row).at(answers.columns.size() - 2); };
  EXPECT_EQ(off(0), CsvValue(std::int64_t{0})) << "as it was shown last";
  EXPECT_EQ(off(1), CsvValue(std::int64_t{2}));
  EXPECT_EQ(answers.rows[1].back(), CsvValue(std::int64_t{1}));
  EXPECT_EQ(answers.rows[2].size(), answers.columns.size());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(answers.rows[2].back()));
}

}  // namespace
}  // namespace seamline::study
