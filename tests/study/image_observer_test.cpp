#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "study/log/log.h"
#include "study/observers/observer.h"
#include "study/running/simulation.h"
#include "support/files/image.h"
#include "support/text/error.h"
#include "tests/study/temporary_set.h"

namespace seamline::study {
namespace {

constexpr double seen_half_of_the_time = 0.25;

ObserverDefinition definition() {
  ObserverDefinition observer;
  observer.image_gain = 1 / seen_half_of_the_time;
  return observer;
}

Stimulus stimulus_of_width(int width_px) {
  return {.scene = "room",
          .artifact = Artifact::receiver,
          .object = "thing",
          .object_index = 2,
          .level = 1.0 * width_px,
          .depth = {.width_px = width_px}};
}

TEST(ImageObserver, MeansAreTheExpectedNoticeability) {
  for (const double visible : {0.05, 0.2, 0.25, 0.4, 2.0}) {
    const Stimulus stimulus = stimulus_of_width(64);
    const auto differences = std::make_shared<const VisibleDifferences>(
        VisibleDifferences{{stimulus_id(stimulus), {.pooled = 3, .above_floor = visible}}});
    double sum = 0, squares = 0;
    constexpr int people = 40000;
    for (int person = 0; person < people; ++person) {
      Random random(5, static_cast<std::uint64_t>(person));
      const Observer observer = make_observer(ObserverKind::image, definition(), random, differences);
      const Response response = respond(observer, stimulus, random);
      const double score = response.chosen_index == stimulus.object_index ? response.rating : 0;
      sum += score;
      squares += score * score;
    }
    const double mean = sum / people, error = std::sqrt((squares / people - mean * mean) / people);
    EXPECT_NEAR(mean, expected_noticeability_of_difference(definition(), visible), 4 * error) << visible;
  }
}

/// The link is the threshold observer's with octaves of visible difference in place of octaves of width.
TEST(ImageObserver, ExpectationAtItsLimitsAndBesideTheThresholdObserver) {
  EXPECT_NEAR(expected_noticeability_of_difference(definition(), 0), 1.0 / 3, 1e-12);
  EXPECT_NEAR(expected_noticeability_of_difference(definition(), 1e9), 4, 1e-9);
  for (const double octaves : {-2.0, -0.5, 0.0, 1.0})
    EXPECT_NEAR(
        expected_noticeability_of_difference(definition(), seen_half_of_the_time * std::exp2(-octaves)),
        expected_noticeability(definition(), Artifact::receiver, 300 * std::exp2(octaves)), 1e-9);
}

TEST(ImageObserver, AStimulusItHasNoPictureOfIsWrongInput) {
  Random random(1);
  const Observer observer =
      make_observer(ObserverKind::image, definition(), random, std::make_shared<const VisibleDifferences>());
  EXPECT_THROW((void)respond(observer, stimulus_of_width(64), random), InputError);
}

/// A set whose coarse pictures differ from the reference and whose fine ones do not.
RenderedSet write_pictures(const std::filesystem::path& folder) {
  const std::string text = study_text("tiny", "64, 512") + "[observer]\nimage_gain = 20\n";
  Manifest manifest = write_set_of_text(folder, text).manifest;
  manifest.width_px = 64;
  manifest.height_px = 36;
  const ByteImage plain{64, 36, 3, std::vector<std::uint8_t>(64 * 36 * 3, 120)};
  ByteImage seam = plain;
  for (std::size_t i = 600; i < 4200; ++i) seam.values[i] = 255;
  write_png(folder / "reference.png", plain);
  for (ManifestStimulus& record : manifest.stimuli) {
    record.reference = "reference.png";
    write_png(folder / record.image, record.stimulus.depth.width_px == 64 ? seam : plain);
  }
  write_manifest(folder, manifest);
  return load_rendered_set(folder);
}

TEST(ImageObserver, LooksAtTheSetAndAnswersByWhatIsThere) {
  const TemporaryFolder folder;
  const RenderedSet set = write_pictures(folder / "set");
  const auto simulate = [&](const std::string& log) {
    return run_simulated_study({.set_folder = set.folder,
                                .log = folder / log,
                                .observer = ObserverKind::image,
                                .count = 40,
                                .seed = 3});
  };
  EXPECT_EQ(simulate("a").answers_added, 40 * 24);
  simulate("b");
  const LogContents log = read_log(folder / "a"), again = read_log(folder / "b");
  std::map<int, double> means;
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    means[log.answers[i].depth_width_px] += log.answers[i].noticeability() / (40.0 * 12);
    EXPECT_EQ(log.answers[i].rating, again.answers[i].rating);
    EXPECT_EQ(log.answers[i].chosen_index, again.answers[i].chosen_index);
  }
  EXPECT_GT(means[64], 3);
  EXPECT_NEAR(means[512], 1.0 / 3, 0.1);  // nothing to see: guesses
  EXPECT_EQ(log.participants.front().observer, "image");
  EXPECT_EQ(log.participants.front().image_gain, 20);
}

/// People of two gains are two kinds of people: the log keeps the gain and mixes none.
TEST(ImageObserver, TheLogKeepsTheGainThatWasGiven) {
  const TemporaryFolder folder;
  const RenderedSet set = write_pictures(folder / "set");
  const auto simulate = [&](double gain, int count) {
    run_simulated_study({.set_folder = set.folder,
                         .log = folder / "log",
                         .observer = ObserverKind::image,
                         .image_gain = gain,
                         .count = count,
                         .seed = 3});
  };
  simulate(7.5, 2);
  EXPECT_EQ(read_log(folder / "log").participants[1].image_gain, 7.5);
  EXPECT_THROW(simulate(7.25, 3), InputError);
  EXPECT_NO_THROW(simulate(7.5, 3));
}

TEST(ImageObserver, WithoutAGainIsWrongInput) {
  EXPECT_THROW((void)expected_noticeability_of_difference({}, 0.5), InputError);
}

TEST(ImageObserver, ASetWithoutPicturesIsWrongInputAndBeginsNoLog) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set(folder / "set");
  EXPECT_THROW(
      run_simulated_study(
          {.set_folder = set.folder, .log = folder / "log", .observer = ObserverKind::image, .count = 1}),
      InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "log"));
}

TEST(ImageObserver, SettingsAreReadAndOldStudiesKeepTheirHash) {
  const std::string text = study_text("tiny", "64, 512");
  const StudyDefinition plain = read_study_text(text, "study.toml");
  const StudyDefinition stated = read_study_text(
      text + fmt::format("[observer]\npixels_per_degree = {}\n", default_pixels_per_degree), "study.toml");
  const StudyDefinition other =
      read_study_text(text + "[observer]\nimage_gain = 7.5\npixels_per_degree = 60\n", "study.toml");
  EXPECT_EQ(other.observer.image_gain, 7.5);
  EXPECT_EQ(other.observer.pixels_per_degree, 60);
  EXPECT_EQ(study_hash(stated), study_hash(plain));
  EXPECT_NE(study_hash(other), study_hash(plain));
  EXPECT_THROW((void)read_study_text(text + "[observer]\nimage_gain = -1\n", "study.toml"), InputError);
}

}  // namespace
}  // namespace seamline::study
