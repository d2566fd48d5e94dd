// A whole session in Arabic and in Hindi, in the real program on a real (virtual) screen: pages are mirrored
// where the language runs from right to left, and the log holds the study's own words. Screens are saved.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "picture_set.h"
#include "study/log/log.h"
#include "window_driver.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* two_languages = R"(
[consent]
text = "This is a study."
[training]
trials = 0
[[language]]
tag = "ar"
texts = ["builtin:ar", "consent.toml"]
[[language]]
tag = "hi"
texts = "hi.toml"
)";

constexpr const char* arabic_consent = R"(format = "seamline texts 1"
language = "ar"
[consent]
text = "أنت مدعو للمشاركة في دراسة حول كيفية رؤية الناس للصور."
)";

class ScriptWindow : public testing::TestWithParam<const char*> {
 protected:
  fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / fmt::format("script-{}", GetParam());
  std::optional<test::XServer> server;
  std::optional<test::WindowDriver> window;

  void SetUp() override {
    if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
    fs::remove_all(folder);
    test::write_picture_set(folder / "set",
                            {.widths = "64", .session = "inter_trial_s = 0.05\n", .more = two_languages});
    write_file_atomically(folder / "set" / "consent.toml", arabic_consent);
    write_file_atomically(folder / "set" / "hi.toml",
                          read_file(fs::path(SEAMLINE_SOURCE_DIR) / "tests/app/hindi.toml"));
    test::keep_display_profile(folder / "run" / "config", 1280, 800);
    server.emplace(folder / "screen", 1280, 800);
    window.emplace(*server, test::WindowRun{.set = folder / "set",
                                            .log = folder / "log.sqlite",
                                            .options = fmt::format("--language {}", GetParam()),
                                            .folder = folder / "run"});
  }

  void save(const std::string& name) const {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the server copies after the swap
    write_png(folder / (name + ".png"), server->picture());
  }

  [[nodiscard]] static double left_of(const test::Line& line, const char* item) {
    return line["items"][item][0].get<double>();
  }

  void fill_in_form() {
    const test::Line line = window->wait_screen("form");
    window->type("33");
    window->keys("Tab 2 Tab 1 Tab 2");
    save("2-form");
    window->click(line["items"]["submit"]);
  }

  void answer_all() {
    for (int trial = 0; trial < 3; ++trial) {
      window->wait_trial("trial", trial, "choosing");
      if (trial == 0) save("4-trial");
      window->key("1");
      const test::Line line = window->wait_trial("trial", trial, "rating");
      if (trial == 0) save("5-rating");
      EXPECT_EQ(left_of(line, "rating/1") > left_of(line, "rating/4"), is_mirrored());
      window->click(line["items"]["rating/2"]);
    }
  }

  [[nodiscard]] static bool is_mirrored() { return std::string(GetParam()) == "ar"; }
};

TEST_P(ScriptWindow, ASessionIsReadAndAnswered) {
  const test::Line consent = window->wait_screen("consent");
  save("1-consent");
  EXPECT_EQ(left_of(consent, "accept") < left_of(consent, "decline"), is_mirrored());
  window->click(consent["items"]["accept"]);
  fill_in_form();
  window->wait_screen("instructions");
  save("3-instructions");
  window->key("Return");
  const test::Line last =
      window->wait("page 2", [](const test::Line& l) { return l["items"].contains("back"); });
  EXPECT_EQ(left_of(last, "continue") < left_of(last, "back"), is_mirrored());
  window->key("Return");
  const test::Line next = window->wait("the first trial", [](const test::Line& l) {
    return l["screen"] == "ready" || l["screen"] == "trial";
  });
  if (next["screen"] == "ready") window->key("Return");
  answer_all();
  window->wait_screen("thanks");
  save("6-thanks");
  window->key("Return");
  EXPECT_EQ(window->wait_end(), 0) << window->output();
  const LogContents log = read_log(folder / "log.sqlite");
  ASSERT_EQ(log.answers.size(), 3U);
  for (const Answer& answer : log.answers) EXPECT_EQ(answer.rating, 2);
  // In the study's own words.
  ASSERT_EQ(log.participants.size(), 1U);
  EXPECT_THAT(log.participants[0].form, testing::Contains(FormAnswer{"gender", "male"}));
  EXPECT_THAT(log.participants[0].form, testing::Contains(FormAnswer{"technical_background", "no"}));
}

INSTANTIATE_TEST_SUITE_P(Scripts, ScriptWindow, testing::Values("ar", "hi"),
                         [](const auto& tried) { return std::string(tried.param); });

}  // namespace
}  // namespace seamline::study::app
