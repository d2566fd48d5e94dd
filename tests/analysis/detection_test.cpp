// The observer beside eyes that are not ours: ModelFest's published thresholds, the published standard
// observer, and pairs that planted observers saw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/detection/detection_comparison.h"
#include "analysis/detection/pair_fit.h"
#include "analysis/detection/standard_observer.h"
#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

/// The standard observer was fitted to ModelFest by its authors: with their numbers it repeats the people's
/// thresholds only if the pictures are theirs.
TEST(Detection, TheStandardObserverKnowsOurPatternsAsModelFests) {
  double sum = 0;
  for (const DetectionPattern& pattern : modelfest_thresholds().patterns) {
    const double predicted =
        standard_observer_threshold_db(pattern_contrast(pattern), pattern.pixels_per_degree);
    sum += std::pow(predicted - pattern.threshold_db, 2);
    if (pattern.kind != PatternKind::noise) {
      EXPECT_NEAR(predicted, pattern.threshold_db, 2) << pattern.number << " " << pattern.name;
    }
  }
  EXPECT_LT(std::sqrt(sum / 42), 0.95);
}

TEST(Detection, PatternsHaveContrastOneAndAGreyField) {
  for (const DetectionPattern& pattern : modelfest_thresholds().patterns) {
    const Image contrast = pattern_contrast(pattern);
    const auto [least, most] = std::minmax_element(contrast.values.begin(), contrast.values.end());
    EXPECT_GE(*least, -1.001F) << pattern.name;
    EXPECT_LE(*most, 1.001F) << pattern.name;
    EXPECT_GT(std::max(*most, -*least), 0.98F) << pattern.name;
    EXPECT_NEAR(contrast.at(0, 0), 0, 0.1) << pattern.name;
    EXPECT_FLOAT_EQ(pattern_picture(contrast, 0).at(77, 99), 0.5F);
  }
}

TEST(Detection, TheGainIsWhatModelFestsPeopleSay) {
  const DetectionThresholds& people = modelfest_thresholds();
  const std::vector<PatternResponse> responses = pattern_responses(people);
  const MeasureFit fit = fit_measure(people, responses, DifferenceMeasure::pooled_3);
  EXPECT_NEAR(fit.criterion, detection_visible_difference, 0.0002);
  EXPECT_LT(fit.rms_error_db, 2.5);
  EXPECT_LT(fit.rms_error_other_half_db, 2.5);
  // Pooling matters: neither the mean nor the largest value does as well.
  EXPECT_GT(fit_measure(people, responses, DifferenceMeasure::mean_flip).rms_error_db, 10);
  EXPECT_GT(fit_measure(people, responses, DifferenceMeasure::largest_flip).rms_error_db, 4);
  // At threshold 68 of 100 are seen.
  const ObserverDefinition observer;
  const double octaves = std::log2(detection_gain(observer) * detection_visible_difference);
  EXPECT_NEAR(1 / (1 + std::exp(-octaves / observer.scale_octaves)), 0.68, 1e-9);
}

/// What FLIP cannot see: how light it is. The people of 2 and 150 cd/m2 have other thresholds for a fine
/// pattern, the observer has the same.
TEST(Detection, FlipDoesNotKnowHowLightItIs) {
  const auto patterns = hdr_vdp_thresholds().patterns;
  const DetectionPattern& dim = patterns[11];
  const DetectionPattern& light = patterns[39];
  ASSERT_EQ(dim.frequency_cpd, 8);
  ASSERT_EQ(light.frequency_cpd, 8);
  EXPECT_GT(light.threshold_db - dim.threshold_db, 10);
  EXPECT_EQ(pattern_contrast(dim).values, pattern_contrast(light).values);
}

/// Discs: nothing was fitted to their people. The image observer is right about the middle one, and takes
/// what a wide one changes inside for visible, which people and the published standard observer do not.
TEST(Detection, DiscsOfAQuarterDegreeAreSeenAsPeopleSayAndWideOnesTooEasily) {
  const DetectionThresholds& people = disc_thresholds();
  const std::vector<PatternResponse> responses = pattern_responses(people);
  const MeasureFit fit =
      judge_measure(people, responses, DifferenceMeasure::pooled_3, detection_visible_difference);
  for (std::size_t i = 0; i < people.patterns.size(); ++i) {
    const DetectionPattern& disc = people.patterns[i];
    if (disc.sigma_x_deg == 0.25) {
      EXPECT_NEAR(fit.predicted_db[i], disc.threshold_db, 3) << disc.mean_luminance_cdm2;
    }
    if (disc.sigma_x_deg == 1) {
      EXPECT_GT(fit.predicted_db[i], disc.threshold_db + 5) << disc.mean_luminance_cdm2;
      EXPECT_NEAR(standard_observer_threshold_db(pattern_contrast(disc), disc.pixels_per_degree), 35.75,
                  0.02);  // a script of NumPy that shares nothing with the program
    }
  }
}

struct PlantedPairs {
  std::vector<SeenPair> pairs;
  std::vector<MeasuredDifference> measured;
};

PlantedPairs planted_pairs(const SeenModel& model, double chance, int looks) {
  PlantedPairs planted;
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    MeasuredDifference measured = {};
    for (double& value : measured) value = random.uniform();
    measured[static_cast<std::size_t>(model.measure)] = std::exp2(6 * random.uniform() - 3) / model.gain;
    SeenPair pair{.reference = std::to_string(i / 4), .picture = "p", .looks = looks, .chance = chance};
    pair.seen = random.binomial(looks, right_probability(model, measured, chance));
    planted.pairs.push_back(pair);
    planted.measured.push_back(measured);
  }
  return planted;
}

TEST(SeenPairs, GainScaleAndPoolingComeBack) {
  const SeenModel model{.measure = DifferenceMeasure::pooled_4, .gain = 17, .scale_octaves = 0.7};
  for (const double chance : {0.0, 0.5}) {
    const PlantedPairs planted = planted_pairs(model, chance, 40);
    const PairJudgement judgement = judge_pairs(planted.pairs, planted.measured);
    EXPECT_TRUE(judgement.split_by_reference);
    EXPECT_EQ(judgement.fitted_pairs + judgement.judged_pairs, 200);
    EXPECT_EQ(judgement.observer.model.measure, DifferenceMeasure::pooled_4);
    EXPECT_NEAR(std::log2(judgement.observer.model.gain / model.gain), 0, 0.1);
    EXPECT_NEAR(judgement.observer.model.scale_octaves, model.scale_octaves, 0.1);
    EXPECT_GT(judgement.observer.judged_bits, judgement.constant_bits + 0.1);
    EXPECT_GT(judgement.observer.roc_area, 0.75);
    for (const JudgedModel& other : judgement.others) {
      EXPECT_LT(other.judged_bits, judgement.observer.judged_bits - 0.1);
      EXPECT_NEAR(other.roc_area, 0.5, 0.1);
    }
    for (const CalibrationGroup& group : judgement.observer.calibration)
      EXPECT_NEAR(group.seen, group.predicted, 0.06);
  }
}

TEST(SeenPairs, PicturesAreMeasuredAndBadTablesRefused) {
  const TemporaryFolder folder;
  const ByteImage grey{
      .width_px = 40, .height_px = 30, .channels = 1, .values = std::vector<std::uint8_t>(1200, 100)};
  ByteImage other = grey;
  for (std::uint8_t& value : other.values) value = 151;
  write_png(folder.path() / "a.png", grey);
  write_png(folder.path() / "b.png", other);
  const std::filesystem::path table = folder.path() / "pairs.csv";
  const std::string header = "reference,picture,seen,n,pixels_per_degree\n";
  write_file_atomically(table, header +
                                   "a.png,b.png,9,10,38\na.png,a.png,1,10,38\na.png,b.png,8,10,38\n"
                                   "b.png,a.png,9,10,38\n");
  const std::vector<MeasuredDifference> measured = measure_pairs(read_seen_pairs(table), 2);
  EXPECT_NEAR(value_of(measured[0], DifferenceMeasure::root_mean_square), 0.2, 1e-9);
  EXPECT_EQ(measured[0], measured[3]);
  for (const double value : measured[1]) EXPECT_EQ(value, 0);
  const auto refused = [&](const std::string& text, const std::string& why) {
    write_file_atomically(table, text);
    EXPECT_THAT(test::complaint_of([&] { (void)measure_pairs(read_seen_pairs(table), 1); }),
                testing::HasSubstr(why));
  };
  refused(header + "a.png,b.png,11,10,38\n", "line 2: seen: wanted no more than n, 10, found 11");
  refused(header + "a.png,b.png,1,0,38\n", "line 2: n: wanted 1 look or more, found 0");
  refused(header + "a.png,b.png,1,2,0.5\n", "line 2: pixels_per_degree: wanted 1 to 1000, found 0.5");
  refused(header + "a.png,b.png,1,2,38\n", "wanted at least four pairs");
  write_png(folder.path() / "small.png",
            {.width_px = 2, .height_px = 2, .channels = 1, .values = std::vector<std::uint8_t>(4, 1)});
  refused(header + "a.png,small.png,1,2,38\na.png,b.png,1,2,38\na.png,b.png,1,2,38\na.png,b.png,1,2,38\n",
          "small.png: wanted 40 x 30 px and 1 channels, as its reference");
}

TEST(SeenPairs, HalvesWithOneAnswerAreRefused) {
  PlantedPairs planted = planted_pairs({.gain = 1}, 0, 5);
  for (SeenPair& pair : planted.pairs) pair.seen = 5;
  EXPECT_THROW((void)judge_pairs(planted.pairs, planted.measured), InputError);
}

}  // namespace
}  // namespace seamline::analysis
