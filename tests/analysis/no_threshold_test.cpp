// Why there is no threshold: an enumeration for programs, a sentence for people, a word between programs.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "analysis/report/json/json_values.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/closed_estimates.h"
#include "support/files/atomic_file.h"

namespace seamline::analysis {
namespace {

/// An interval that is open on both sides, and a curve steepest between 256 and 512.
std::string text_of(NoThreshold why, const LevelAxis& axis = {}) {
  return reason_text({.level_x = {},
                      .reason = why,
                      .ci95 = {.low_x = 6, .high_x = 7},
                      .steepest = {.low_x = 8, .high_x = 9}},
                     axis);
}

TEST(NoThreshold, EachHasAWordOfItsOwnThatReadsBack) {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < number_of_reasons; ++i) {
    const auto why = static_cast<NoThreshold>(i);
    EXPECT_EQ(no_threshold_from_word(word(why)), why) << word(why);
    EXPECT_EQ(word(why).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos)
        << word(why);
    words.insert(word(why));
  }
  EXPECT_EQ(words.size(), number_of_reasons);
  EXPECT_FALSE(no_threshold_from_word("above"));
  EXPECT_FALSE(no_threshold_from_word(""));
}

TEST(NoThreshold, EachHasItsSentence) {
  const std::array<std::pair<NoThreshold, const char*>, number_of_reasons> sentences = {{
      {NoThreshold::above_level, "above 64"},
      {NoThreshold::below_level, "below 128"},
      {NoThreshold::any_level, "not determined: no width is excluded"},
      {NoThreshold::open_hardest, "open where seams are hardest to see: add people, or levels there"},
      {NoThreshold::open_easiest, "open where seams are easiest to see: add people, or levels there"},
      {NoThreshold::open_both, "not determined: no level is excluded"},
      {NoThreshold::curve_above, "the curve lies above it at every width"},
      {NoThreshold::curve_below, "the curve lies below it at every width"},
      {NoThreshold::no_such_place, "the curve has no such place"},
      {NoThreshold::guess_floor, "not identified: the level lies in the guess floor"},
      {NoThreshold::step, "a step between 256 and 512: the widths tested do not say where"},
      {NoThreshold::straight, "not identified: the fit is all but a straight line"},
      {NoThreshold::steepest_below, "steepest below 512"},
      {NoThreshold::steepest_above, "steepest above 256"},
      {NoThreshold::not_falling, "not identified: noticeability does not fall with width"},
      {NoThreshold::under_four_levels, "not identified: under four widths"},
      {NoThreshold::no_answers, "no answers"},
      {NoThreshold::one_participant, "one participant"},
      {NoThreshold::too_few_levels, "too few levels"},
      {NoThreshold::only_guesses, "only guesses"},
      {NoThreshold::at_chance, "at chance"},
      {NoThreshold::never_wrong, "never wrong"},
      {NoThreshold::separated, "separated"},
      {NoThreshold::not_converged, "not converged"},
      {NoThreshold::nobody_on_curve, "nobody on the curve"},
      {NoThreshold::nobody_answered, "nobody answered at every width"},
      {NoThreshold::no_level_shown, "no level on the axis was shown"},
      {NoThreshold::too_few_trials, "too few trials"},
      {NoThreshold::ratings_not_asked, "ratings were not asked"},
      {NoThreshold::placed_by_answers, "widths were placed by the answers"},
      {NoThreshold::no_inflection, "not given where levels were placed by the answers"},
  }};
  std::set<NoThreshold> said;
  for (const auto& [why, sentence] : sentences) {
    EXPECT_EQ(text_of(why), sentence);
    said.insert(why);
  }
  EXPECT_EQ(said.size(), number_of_reasons);
  EXPECT_EQ(reason_text({.level_x = 8, .reason = {}, .ci95 = {}}, {}), "");
}

TEST(NoThreshold, SentencesSpeakOfTheStudysLevels) {
  const LevelAxis tolerance{.quantity = Quantity::mesh_tolerance, .noticeability = Direction::increasing};
  EXPECT_EQ(text_of(NoThreshold::not_falling, tolerance),
            "not identified: noticeability does not rise with the level");
  EXPECT_EQ(text_of(NoThreshold::curve_above, tolerance), "the curve lies above it at every level");
  // x is less log2 of the tolerance, so that the two ends change places.
  ThresholdEstimate open{.level_x = 3, .reason = {}, .ci95 = {.low_x = 2}};
  keep_closed(open, {.low_x = 3, .high_x = 3}, tolerance);
  EXPECT_EQ(open.reason, NoThreshold::below_level);
  EXPECT_EQ(reason_text(open, tolerance), "below 0.250");
  const std::vector<double> levels = {1, 2, 3, 4};
  Logistic4Fit before, beyond;
  before.verdict = Centre::below_range;
  beyond.verdict = Centre::above_range;
  EXPECT_EQ(reason_text(centre_of(before, levels, tolerance), tolerance), "steepest above 0.500");
  EXPECT_EQ(reason_text(centre_of(beyond, levels, tolerance), tolerance), "steepest below 0.0625");
  EXPECT_EQ(reason_text(centre_of(before, levels, {}), {}), "steepest below 2");
  EXPECT_EQ(reason_text(centre_of(beyond, levels, {}), {}), "steepest above 16");
}

TEST(NoThreshold, EveryWordIsExplained) {
  const std::string page =
      read_file(std::string(SEAMLINE_SOURCE_DIR) + "/documentation/reference/file_formats.md");
  for (std::size_t i = 0; i < number_of_reasons; ++i) {
    const std::string said(word(static_cast<NoThreshold>(i)));
    EXPECT_NE(page.find("`" + said + "`"), std::string::npos) << said;
  }
}

TEST(NoThreshold, ItsWordStandsBesideTheSentenceWhereThereIsNoEstimate) {
  const nlohmann::ordered_json without =
      json_estimate({.level_x = {}, .reason = NoThreshold::at_chance, .ci95 = {}}, {});
  EXPECT_EQ(without.at("reason"), "at chance");
  EXPECT_EQ(without.at("reason_word"), "at_chance");
  const nlohmann::ordered_json with = json_estimate({.level_x = 8, .reason = {}, .ci95 = {}}, {});
  EXPECT_TRUE(with.at("reason").is_null());
  EXPECT_FALSE(with.contains("reason_word"));
}

}  // namespace
}  // namespace seamline::analysis
