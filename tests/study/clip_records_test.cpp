// How clips were shown, as the log holds it and tables say it.
#include "study/exchange/clip_records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/exchange/answer_tables.h"
#include "study/exchange/dataset.h"
#include "tests/study/log_fixture.h"

namespace seamline::study {
namespace {

std::string text_with_clips(const std::string& analysis = "") {
  std::string text = study_text("tiny", "64");
  text.insert(text.find("[session]"), "[clip]\nframes = 20\nframes_per_s = 10\n" + analysis);
  const std::string object = "name = \"left\"\nfile = \"none.glb\"\n";
  text.insert(text.find(object) + object.size(), "path = { kind = \"turn\", speed_deg_s = 10 }\n");
  return text;
}

class ClipRecords : public LogTest {
 protected:
  /// A log in which a person answered three trials of a study of clips; of the first two frames were counted.
  LogContents log_of_clips(const std::vector<RawEvent>& events, const std::string& analysis = "") {
    const RenderedSet clips = write_set_of_text(folder / "clips", text_with_clips(analysis));
    LogWriter writer(path, clips);
    OpenSession session = enter_session(writer, {.code = "anna"}, 0);
    writer.append_trials(session,
                         interleave(stimulus_order(12, {.study_seed = 7, .slot = session.slot}), {}));
    writer.append_events(session, events);
    for (int i = 0; i < 3; ++i) writer.append_answer(session, answer(session.answered));
    return read_log(path);
  }
};

TEST_F(ClipRecords, CountsAreReadAndNothingElse) {
  const std::optional<ClipCounts> counts = clip_counts_of("shown 48 late 3 dropped 2");
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->shown, 48);
  EXPECT_NEAR(counts->late_share(), 5.0 / 50, 1e-12);
  for (const char* other :
       {"", "shown 48", "shown 48 late 3", "shown 1 late 2 dropped 0", "shown -1 late 0 dropped 0",
        "shown 48 late 3 dropped 2 more", "practice shown 48 late 3 dropped 2"})
    EXPECT_FALSE(clip_counts_of(other)) << other;
}

TEST_F(ClipRecords, AnswersBearWhatWasCounted) {
  const LogContents log =
      log_of_clips({{.kind = "clip", .trial_index = 0, .detail = "shown 9 late 9 dropped 9"},
                    {.kind = "clip", .trial_index = 0, .detail = "shown 19 late 0 dropped 1"},
                    {.kind = "clip", .detail = "practice shown 1 late 1 dropped 5"},
                    {.kind = "clip", .trial_index = 1, .detail = "shown 20 late 2 dropped 0"}});
  const auto counts = read_clip_counts(log);
  ASSERT_EQ(counts.size(), 3U);
  EXPECT_NEAR(counts[0]->late_share(), 0.05, 1e-12) << "as it was shown last";
  EXPECT_NEAR(counts[1]->late_share(), 0.1, 1e-12);
  EXPECT_FALSE(counts[2]);
  const CsvTable table = answer_tables(log).front();
  ASSERT_EQ(table.columns.back().name, "marked");
  EXPECT_EQ(std::get<std::int64_t>(table.rows[0].back()), 0) << "a twentieth is not more than a twentieth";
  EXPECT_EQ(std::get<std::int64_t>(table.rows[1].back()), 1);
  EXPECT_EQ(table.rows[2].size(), table.columns.size());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[2].back()));
}

TEST_F(ClipRecords, TheStudySaysFromWhereOnATrialIsMarked) {
  const LogContents log =
      log_of_clips({{.kind = "clip", .trial_index = 1, .detail = "shown 20 late 2 dropped 0"}},
                   "[analysis]\nlate_frames_most = 0.1\n");
  EXPECT_EQ(std::get<std::int64_t>(answer_tables(log).front().rows[1].back()), 0);
}

TEST_F(ClipRecords, DatasetsHaveThemAndAnonymisedOnesHaveTheMarksAlone) {
  const LogContents log =
      log_of_clips({{.kind = "clip", .trial_index = 0, .detail = "shown 20 late 0 dropped 0"},
                    {.kind = "clip", .trial_index = 1, .detail = "shown 20 late 2 dropped 0"}});
  const auto beh_of = [](const std::vector<DatasetFile>& files) {
    return std::find_if(files.begin(), files.end(),
                        [](const DatasetFile& file) { return file.path.ends_with("_beh.tsv"); })
        ->text;
  };
  const std::string whole = beh_of(bids_files(log, {}));
  EXPECT_THAT(whole, testing::HasSubstr("\tframes_shown\tframes_late\tframes_dropped\tlate_share\tmarked\n"));
  EXPECT_THAT(whole, testing::HasSubstr("\t20\t2\t0\t0.1\t1\n"));
  LogContents finished = log;
  finished.participants.front().completed = true;
  finished.participants.push_back(finished.participants.front());
  finished.participants.back().code = "bert";
  const AnonymisedLog anonymous = anonymise(finished, 2);
  const CsvTable table = answer_tables(anonymous.log, anonymous.anonymity).front();
  ASSERT_EQ(table.columns.back().name, "marked");
  int marked = 0, counted = 0;
  for (const auto& row : table.rows)
    if (const auto* mark = std::get_if<std::int64_t>(&row.back())) {
      marked += static_cast<int>(*mark);
      ++counted;
    }
  EXPECT_EQ(counted, 2);
  EXPECT_EQ(marked, 1);
  const std::string given_away = beh_of(bids_files(anonymous.log, anonymous.anonymity));
  EXPECT_THAT(given_away, testing::HasSubstr("\tmarked\n"));
  EXPECT_THAT(given_away, testing::Not(testing::HasSubstr("frames_")));
}

TEST_F(ClipRecords, OtherEventsAreRefused) {
  EXPECT_THAT(complaint_of([&] {
                return answer_tables(log_of_clips({{.kind = "clip", .trial_index = 0, .detail = "all"}}));
              }),
              testing::HasSubstr("events.detail"));
}

TEST_F(ClipRecords, AStudyOfStillsHasNoSuchColumns) {
  const LogWriter written(path, set);
  EXPECT_TRUE(read_clip_counts(read_log(path)).empty());
  EXPECT_EQ(answer_tables(read_log(path)).front().columns.back().name, "image_scale");
}

}  // namespace
}  // namespace seamline::study
