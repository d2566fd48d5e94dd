// A participant does a whole study with mouse and keyboard, in the real program on a real (virtual) screen:
// the log holds exactly what was pressed, and every screen is saved as a picture.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "picture_set.h"
#include "study/log/log.h"
#include "study/trials/trial_picture.h"
#include "window_driver.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using test::Line;

constexpr int screen_width_px = 1280, screen_height_px = 800;
constexpr const char* texts = R"(
[consent]
text = """
This is a study of discs. Größe, façade, Ωμέγα: the letters of other languages are there too.

You may stop at any time."""

[[instructions.page]]
text = "Three discs are in the picture. Which one was inserted?"
pictures = ["room.png"]
[[instructions.page]]
text = "Press 1, 2 or 3."

[training]
trials = 1
[catch]
attention = 1
reference = 1
)";

struct Pressed {
  int chosen = 0, rating = 0;
};

class SessionTest : public testing::Test {
 protected:
  fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "session";
  RenderedSet set;
  std::optional<test::XServer> server;
  std::optional<test::WindowDriver> window;

  void SetUp() override {
    if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
    fs::remove_all(folder);
    set = test::write_picture_set(
        folder / "set", {.session = "break_every_trials = 4\ninter_trial_s = 0.2\n", .more = texts});
    server.emplace(folder / "screen", screen_width_px, screen_height_px);
    window.emplace(
        *server,
        test::WindowRun{.set = folder / "set", .log = folder / "log.sqlite", .folder = folder / "run"});
  }

  void save(const std::string& name) const {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the server copies after the swap
    write_png(folder / (name + ".png"), server->picture());
  }

  void consent_and_form() {
    Line line = window->wait_screen("consent");
    save("01-consent");
    window->key("Return");  // agrees to nothing
    window->key("Tab");
    save("02-consent-focus");
    window->click(line["items"]["accept"]);
    line = window->wait_screen("form");
    save("03-form");
    window->click(line["items"]["submit"]);
    const double before = line["items"]["submit"][1];
    window->wait("problems", [&](const Line& now) { return now["items"]["submit"][1] != before; });
    save("04-form-problems");
    window->key("Tab");  // the button has the focus; the first field comes next
    window->type("331");
    window->keys("BackSpace Tab Right Tab Right Right Tab 2");
    save("05-form-filled");
    window->keys("Tab Return");
  }

  void display_check() {
    window->wait_screen("display");
    save("06-display-card");
    window->keys("Right Right Tab Return");
    Line distance =
        window->wait("distance", [](const Line& now) { return now["items"].contains("distance"); });
    // What was refused is said at once: nothing else happens that would draw the page again.
    window->type("5");
    window->keys("Tab Return");
    const double before = distance["items"]["continue"][1];
    window->wait("the refused distance",
                 [&](const Line& now) { return now["items"]["continue"][1] != before; });
    save("07-display-distance-refused");
    window->keys("shift+Tab BackSpace");
    window->type("60");
    save("07-display-distance");
    window->keys("Tab Return");
    const Line line = window->wait("gamma", [](const Line& now) { return now["items"].contains("same"); });
    save("08-display-gamma");
    window->click(line["items"]["same"]);
  }

  void practise() {
    window->wait_screen("instructions");
    save("09-instructions");
    window->key("Return");
    window->wait("page 2", [](const Line& line) { return line["items"].contains("back"); });
    save("10-instructions-2");
    window->key("Return");
    window->wait_screen("training");
    save("11-fixation");
    window->wait_trial("training", 0, "choosing");
    save("12-practice");
    window->key("1");
    window->wait_trial("training", 0, "rating");
    window->key("2");
    window->wait_screen("feedback");
    save("13-feedback");
    window->key("Return");
    window->wait_screen("ready");
    save("14-ready");
    window->key("space");  // not the button: it has no focus yet
    window->keys("Tab space");
  }

  /// The server copies after the swap: soon, however busy the machine is.
  void expect_picture_on_screen(const Line& line) const {
    int different = different_bytes_on_screen(line);
    for (int look = 0; look < 500 && different > 0; ++look) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      different = different_bytes_on_screen(line);
    }
    EXPECT_EQ(different, 0) << "bytes of trial " << line["trial"];
  }

  [[nodiscard]] int different_bytes_on_screen(const Line& line) const {
    const ByteImage screen = server->picture();
    const int x0 = line["picture"][0], y0 = line["picture"][1];
    int index = 0;
    while (set.manifest.stimuli[static_cast<std::size_t>(index)].id != line["stimulus"]) ++index;
    const Trial trial{trial_kind_from_word(line["kind"].get<std::string>()).value(), index};
    const ByteImage picture = load_trial_picture(set, trial);
    int different = 0;
    for (int y = 0; y < picture.height_px; ++y)
      for (int x = 0; x < picture.width_px; ++x)
        for (int c = 0; c < 3; ++c)
          different +=
              screen.values[static_cast<std::size_t>(((y0 + y) * screen.width_px + x0 + x) * 3 + c)] !=
              picture.values[static_cast<std::size_t>((y * picture.width_px + x) * 3 + c)];
    return different;
  }

  /// The chosen object has bolder corners than the one that is only pointed at.
  void expect_bolder_corners(const Line& chosen, const Line& pointed_at) {
    window->move(pointed_at[0].get<double>() + pointed_at[2].get<double>() / 2,
                 pointed_at[1].get<double>() + pointed_at[3].get<double>() / 2);
    const auto is_white = [&](const Line& frame, int from_corner_px) {
      const ByteImage screen = server->picture();
      const int x = frame[0].get<int>() + from_corner_px, y = frame[1].get<int>() + from_corner_px;
      return screen.values[static_cast<std::size_t>((y * screen.width_px + x) * 3)] == 255;
    };
    bool as_wanted = false;
    for (int look = 0; look < 500 && !as_wanted; ++look) {  // the server copies after the swap
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      as_wanted =
          is_white(chosen, 1) && is_white(chosen, 5) && is_white(pointed_at, 1) && !is_white(pointed_at, 5);
    }
    EXPECT_TRUE(as_wanted);
    save("17-rating-pointed-at");
  }

  void pause_and_go_on(int trial) {
    window->key("1");
    window->wait_trial("trial", trial, "rating");
    window->key("Escape");  // the choice without a rating is dropped
    window->wait_screen("pause");
    save("18-pause");
    window->key("Return");
  }

  Pressed answer(int trial) {
    Line line = window->wait_trial("trial", trial, "choosing");
    expect_picture_on_screen(line);
    if (trial == 0) save("15-trial");
    if (trial == 2) {
      pause_and_go_on(trial);
      line = window->wait_trial("trial", trial, "choosing");
    }
    const Pressed pressed{1 + (trial + 1) % 3, 1 + (trial * 3 + 1) % 4};
    if (trial % 2 == 0) {
      window->click(line["objects"][static_cast<std::size_t>(pressed.chosen - 1)]);
    } else if (trial % 4 == 1) {
      window->key(fmt::format("{}", pressed.chosen));
    } else {
      for (int i = 0; i < pressed.chosen; ++i) window->key("Tab");
      if (trial == 3) save("16-trial-focus");
      window->key("Return");
    }
    line = window->wait_trial("trial", trial, "rating");
    if (trial == 0) save("17-rating");
    if (trial == 4) {  // the choice may change until it is rated
      window->click(line["objects"][0]);
      expect_bolder_corners(line["objects"][0], line["objects"][1]);
      window->click(line["objects"][static_cast<std::size_t>(pressed.chosen - 1)]);
    }
    if (trial % 3 == 0)
      window->click(line["items"][fmt::format("rating/{}", pressed.rating)]);
    else
      window->key(fmt::format("{}", pressed.rating));
    window->move(3, 3);
    window->wait("the answer's end",
                 [&](const Line& now) { return now["answered"].get<int>() == trial + 1; });
    return pressed;
  }

  std::vector<Pressed> answer_all(int trials) {
    std::vector<Pressed> pressed;
    for (int trial = 0; trial < trials; ++trial) {
      pressed.push_back(answer(trial));
      if (window->now()->at("screen") != "break") continue;
      save("19-break");
      window->key("Return");
    }
    return pressed;
  }
};

TEST_F(SessionTest, TheLogHoldsExactlyWhatWasPressed) {
  consent_and_form();
  display_check();
  practise();
  constexpr int trials = 8;  // six stimuli, an attention trial and a reference
  const std::vector<Pressed> pressed = answer_all(trials);
  window->wait_screen("thanks");
  save("20-thanks");
  window->key("Return");
  EXPECT_EQ(window->wait_end(), 0) << window->output();

  SQLite::Database log((folder / "log.sqlite").string());
  SQLite::Statement answers(
      log, "SELECT chosen_index, rating, choice_ns, rating_ns FROM answers ORDER BY trial_index");
  for (int trial = 0; trial < trials; ++trial) {
    ASSERT_TRUE(answers.executeStep());
    EXPECT_EQ(answers.getColumn(0).getInt(), pressed[static_cast<std::size_t>(trial)].chosen) << trial;
    EXPECT_EQ(answers.getColumn(1).getInt(), pressed[static_cast<std::size_t>(trial)].rating) << trial;
    EXPECT_GT(answers.getColumn(2).getInt64(), 0);
    EXPECT_GT(answers.getColumn(3).getInt64(), answers.getColumn(2).getInt64());
  }
  EXPECT_FALSE(answers.executeStep());
  const auto value = [&](const std::string& query) { return log.execAndGet(query).getString(); };
  EXPECT_EQ(value("SELECT group_concat(answer, '; ') FROM "
                  "(SELECT field || '=' || value AS answer FROM form_answers ORDER BY field)"),
            "age=33; gender=female; technical_background=no; vision=corrected to normal (glasses or lenses)");
  EXPECT_EQ(value("SELECT count(*) FROM training_answers WHERE chosen_index = 1 AND rating = 2"), "1");
  EXPECT_EQ(value("SELECT completed FROM participants"), "1");
  EXPECT_EQ(value("SELECT count(*) FROM consents"), "1");
  EXPECT_EQ(value("SELECT read_back_different || ' of ' || read_back_bytes FROM displays"),
            fmt::format("0 of {}", 400 * 240 * 3));
  EXPECT_EQ(value("SELECT viewing_distance_mm FROM displays"), "600.0");
  // Every picture that was shown, with its swap; the paused one twice; and what was pressed on the way.
  EXPECT_EQ(
      value("SELECT count(*) FROM events WHERE kind = 'shown' AND trial_index IS NOT NULL AND swap > 0"),
      std::to_string(trials + 1));
  EXPECT_EQ(value("SELECT count(*) FROM events WHERE kind = 'pause'"), "1");
  EXPECT_EQ(value("SELECT count(*) FROM events WHERE kind = 'choice' AND trial_index IS NOT NULL"),
            std::to_string(trials + 3));
  EXPECT_EQ(value("SELECT count(*) FROM events WHERE kind = 'rating' AND trial_index IS NOT NULL"),
            std::to_string(trials));
  EXPECT_EQ(value("SELECT pixels_per_degree BETWEEN 30 AND 50 FROM displays"), "1");
}

}  // namespace
}  // namespace seamline::study::app
