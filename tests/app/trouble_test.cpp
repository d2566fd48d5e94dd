// What a session does when things are not as they should be.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "picture_set.h"
#include "scripted_window.h"
#include "small_font.h"
#include "support/files/image.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using test::Line;
using testing::HasSubstr;

constexpr const char* short_study =
    "[consent]\ntext = \"Discs.\"\n[training]\ntrials = 0\n[[instructions.page]]\ntext = \"Press 1, 2 or "
    "3.\"\n";

class TroubleTest : public testing::Test {
 protected:
  fs::path folder;
  std::optional<test::XServer> server;

  void SetUp() override {
    if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
    folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" /
             testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder);
  }

  /// A set without a form, and a screen that is known.
  void prepare(int screen_w_px, int screen_h_px, const test::PictureSetRequest& request) {
    server.emplace(folder / "screen", screen_w_px, screen_h_px);
    (void)test::write_picture_set(folder / "set", request);
    test::keep_display_profile(folder / "run" / "config", screen_w_px, screen_h_px);
  }
  [[nodiscard]] test::WindowRun run(const std::string& options = "") const {
    return {
        .set = folder / "set", .log = folder / "log.sqlite", .options = options, .folder = folder / "run"};
  }
  [[nodiscard]] std::string value(const std::string& query) const {
    SQLite::Database log((folder / "log.sqlite").string());
    return log.execAndGet(query).getString();
  }
  void save(const std::string& name) const {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    write_png(folder / (name + ".png"), server->picture());
  }
  /// Comes to the trials and answers the first ones.
  static void answer_until(test::WindowDriver& window, int answered) {
    test::drive(window, 1, [&](const Line& line) {
      return line["screen"] == "trial" && line["trial"] == answered && line["phase"] == "choosing";
    });
  }
};

TEST_F(TroubleTest, WhoDeclinesLeavesOnlyTheFact) {
  prepare(800, 600, {.more = short_study});
  test::WindowDriver window(*server, run());
  window.wait_screen("consent");
  window.keys("Tab Return");
  window.wait_screen("declined");
  save("declined");
  window.key("Return");
  EXPECT_EQ(window.wait_end(), 0) << window.output();
  EXPECT_EQ(value("SELECT count(*) FROM declines"), "1");
  for (const char* table : {"participants", "sessions", "events", "consents"})
    EXPECT_EQ(value(fmt::format("SELECT count(*) FROM {}", table)), "0") << table;
}

TEST_F(TroubleTest, WithoutAScreenThereIsOneSentenceAndNoLog) {
  (void)test::write_picture_set(folder / "set", {.more = short_study});
  const fs::path out = folder / "output";
  const int status = std::system(
      fmt::format("env -u DISPLAY -u WAYLAND_DISPLAY '{}' study '{}' --log '{}' --participant p01 >'{}' 2>&1",
                  SEAMLINE_PROGRAM, (folder / "set").string(), (folder / "log.sqlite").string(), out.string())
          .c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_THAT(read_file(out), HasSubstr("display: wanted a screen to show the pictures on, found none"));
  EXPECT_FALSE(fs::exists(folder / "log.sqlite"));
}

TEST_F(TroubleTest, ADamagedFontIsOneSentence) {
  prepare(800, 600, {.session = "font = \"letters.ttf\"\n", .more = short_study});
  const std::string font = test::small_font();
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{3}, std::size_t{12}, font.size() / 2}) {
    std::ofstream(folder / "set" / "letters.ttf", std::ios::binary) << font.substr(0, bytes);
    test::WindowDriver window(*server, run());
    EXPECT_EQ(window.wait_end(), 1) << bytes;
    EXPECT_THAT(window.output(), HasSubstr("letters.ttf: font: wanted a TrueType or OpenType font"));
  }
  std::ofstream(folder / "set" / "letters.ttf", std::ios::binary) << font;
  test::WindowDriver window(*server, run());
  EXPECT_EQ(window.wait_end(), 1);
  EXPECT_THAT(window.output(), testing::AllOf(HasSubstr("a font with every character of the study's texts"),
                                              HasSubstr("found none with U+")));
}

TEST_F(TroubleTest, PicturesThatDoNotFitAreRefusedUnlessScalingIsAllowed) {
  prepare(640, 480, {.width_px = 900, .height_px = 500, .widths = "64", .top = "participant_form = false"});
  {
    test::WindowDriver window(*server, run("--pilot"));
    EXPECT_EQ(window.wait_end(), 1);
    EXPECT_THAT(window.output(), HasSubstr("wanted at least 900 x 632 pixels for pictures of 900 x 500"));
    EXPECT_THAT(window.output(), HasSubstr("found 640 x 480"));
  }
  test::WindowDriver window(*server, run("--pilot --allow-scaling"));
  test::drive(window, 1, [&](const Line& line) { return line["answered"] == 1; });
  const double scale = std::stod(value("SELECT image_scale FROM displays"));
  EXPECT_LT(scale, 640.0 / 900 + 1e-6);
  EXPECT_GT(scale, 0.5);
  EXPECT_EQ(std::stod(value("SELECT image_scale FROM answers")), scale);
}

TEST_F(TroubleTest, AVanishedLogStopsTheSessionAndKeepsWhatWasAnswered) {
  prepare(800, 600, {.top = "participant_form = false"});
  test::WindowDriver window(*server, run("--pilot"));
  answer_until(window, 2);
  fs::rename(folder / "log.sqlite", folder / "moved.sqlite");
  window.key("1");
  window.wait_trial("trial", 2, "rating");
  window.key("1");
  window.wait_screen("stopped");
  save("stopped");
  window.key("Return");
  EXPECT_EQ(window.wait_end(), 1);
  EXPECT_THAT(window.output(), HasSubstr("log.sqlite"));
  fs::rename(folder / "moved.sqlite",
             folder / "log.sqlite");  // the write-ahead log is still beside its place
  EXPECT_EQ(value("SELECT count(*) FROM answers"), "2");
}

TEST_F(TroubleTest, WhoLeavesComesBackToTheSamePicture) {
  prepare(800, 600, {.top = "participant_form = false"});
  std::string stimulus;
  {
    test::WindowDriver window(*server, run("--pilot"));
    answer_until(window, 2);
    stimulus = window.now()->at("stimulus");
    window.key("Escape");
    window.wait_screen("pause");
    window.keys("Tab Return");  // leave for now
    EXPECT_EQ(window.wait_end(), 0) << window.output();
  }
  test::WindowDriver window(*server, run("--pilot"));
  answer_until(window, 2);
  EXPECT_EQ(window.now()->at("stimulus"), stimulus);
  EXPECT_EQ(value("SELECT count(*) FROM consents"), "1");
}

TEST_F(TroubleTest, AnIdleScreenDrawsNothing) {
  prepare(800, 600, {.top = "participant_form = false"});
  const fs::path times = folder / "frames.csv";
  test::WindowDriver window(*server, run("--pilot --frame-times '" + times.string() + "'"));
  answer_until(window, 1);

  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  window.key("1");
  window.wait_trial("trial", 1, "rating");
  window.key("Escape");
  window.wait_screen("pause");
  window.keys("Tab Return");
  EXPECT_EQ(window.wait_end(), 0) << window.output();
  // The trial's picture was drawn for its first frame, its question and a key: not sixty times a second.
  const std::string csv = read_file(times);
  const std::string last = "trial/choosing";
  int choosing = 0;
  for (std::size_t at = csv.find(last); at != std::string::npos; at = csv.find(last, at + 1)) ++choosing;
  EXPECT_LT(choosing, 20);
}

}  // namespace
}  // namespace seamline::study::app
