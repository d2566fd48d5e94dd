#include "analysis/foresight/predict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/text/predict_text.h"
#include "study/observers/observer.h"
#include "support/text/error.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline::analysis {
using namespace study;
namespace {

constexpr int widths_px[] = {64, 128, 256, 512, 1024, 2048, 4096};

/// A manifest with differences that fall with width as c / W, so that PT, with every width an octave apart,
/// follows the gain.
struct Study {
  Manifest manifest;
  VisibleDifferences differences;

  void add(Artifact artifact, const std::string& object, double c) {
    for (const int width_px : widths_px) {
      ManifestStimulus record = test::record_of(artifact, object, width_px);
      const double difference = artifact == Artifact::none ? 0.001 : c / width_px;
      differences[record.id] = {.pooled = difference, .above_floor = difference};
      manifest.stimuli.push_back(record);
    }
  }
};

Study example() {
  Study study;
  study.add(Artifact::receiver, "left", 40);
  study.add(Artifact::receiver, "right", 80);
  study.add(Artifact::shadow, "left", 15);
  study.add(Artifact::overlap, "left", 4000);
  study.add(Artifact::none, "left", 0);
  return study;
}

const PredictedArtifact& find(const std::vector<PredictedArtifact>& artifacts, Artifact artifact) {
  for (const PredictedArtifact& predicted : artifacts)
    if (predicted.artifact == artifact) return predicted;
  throw std::logic_error("no such artifact");
}

TEST(Predict, CellsAreTheObserversExpectedMeansOverObjects) {
  const Study study = example();
  const ObserverDefinition observer{.image_gain = 10};
  const std::vector<PredictedArtifact> artifacts =
      predict_artifacts(study.manifest, study.differences, observer);
  ASSERT_EQ(artifacts.size(), 3U);  // none is not a seam
  const PredictedCell& cell = find(artifacts, Artifact::receiver).cells[2];
  EXPECT_EQ(cell.level, 256);
  EXPECT_NEAR(cell.visible_difference, 60.0 / 256, 1e-12);
  EXPECT_NEAR(cell.expected_noticeability,
              (expected_noticeability_of_difference(observer, 40.0 / 256) +
               expected_noticeability_of_difference(observer, 80.0 / 256)) /
                  2,
              1e-12);
}

/// With differences c / W the `image` observer is the `threshold` observer with midpoint gain * c.
TEST(Predict, ThresholdsAreThoseOfTheThresholdObserverWithTheSameCurve) {
  Study study;
  study.add(Artifact::receiver, "left", 30);
  const ObserverDefinition image{.image_gain = 10};
  ObserverDefinition threshold;
  threshold.midpoint[Artifact::receiver] = 300;
  std::vector<double> level_x, means;
  for (const int width_px : widths_px) {
    level_x.push_back(std::log2(width_px));
    means.push_back(expected_noticeability(threshold, Artifact::receiver, width_px));
  }
  const CurveThresholds expected = thresholds_of_means(level_x, means);
  const CurveThresholds found = predict_artifacts(study.manifest, study.differences, image)[0].thresholds;
  EXPECT_NEAR(found.perceptual.level_x.value(), expected.perceptual.level_x.value(), 1e-9);
  EXPECT_NEAR(found.slightly_noticeable.level_x.value(), expected.slightly_noticeable.level_x.value(), 1e-9);
}

/// Grain that every stimulus of an object has, pooled with the seam, is taken away again: what is left of a
/// planted c / W is that less what the finest width shows.
TEST(Predict, WhatTheFinestWidthShowsIsTakenForGrain) {
  Study study = example();
  const double grain = 0.4;
  const auto pooled = [&](double seam) { return std::cbrt(std::pow(seam, 3) + std::pow(grain, 3)); };
  for (auto& [id, difference] : study.differences) difference.pooled = pooled(difference.pooled);
  const double highest = take_finest_for_floor(study.manifest, study.differences);
  EXPECT_NEAR(highest, pooled(4000.0 / 4096), 1e-12);  // the overlap's own
  for (const ManifestStimulus& record : study.manifest.stimuli) {
    if (record.stimulus.artifact != Artifact::receiver || record.stimulus.object != "left") continue;
    const double finest = 40.0 / 4096, seam = 40.0 / record.stimulus.depth.width_px;
    EXPECT_NEAR(study.differences.at(record.id).above_floor,
                std::cbrt(std::pow(seam, 3) - std::pow(finest, 3)), 1e-6)
        << record.id;
  }
}

/// Where nobody is asked for ratings, a threshold is where half see it, which no chance moves.
TEST(Predict, WithoutRatingsItIsDetection) {
  Study study;
  study.add(Artifact::receiver, "left", 30);
  const ObserverDefinition image{.image_gain = 10};
  for (const TaskKind kind : {TaskKind::pair, TaskKind::yes_no}) {
    Prediction prediction{.observer = image, .artifacts = {}};
    prediction.task.facts = {.kind = kind, .alternatives = 2, .chance = 0.5, .rates = false};
    prediction.artifacts = predict_artifacts(study.manifest, study.differences, image, {}, prediction.task);
    const PredictedArtifact& receiver = prediction.artifacts[0];
    EXPECT_NEAR(receiver.thresholds.perceptual.level_x.value(), std::log2(300), 0.02);
    EXPECT_GT(receiver.cells.front().expected_noticeability, 0.95);
    EXPECT_LT(receiver.cells.back().expected_noticeability, 0.05);
    const std::string text = prediction_text(prediction);
    EXPECT_NE(text.find("| detection |"), std::string::npos) << text;
    EXPECT_EQ(text.find("paper"), std::string::npos) << text;
  }
}

/// Who sees nothing is right by the chance of the task, and rates 1.
TEST(Predict, NoticeabilityOfARatedTaskHasItsChance) {
  Study study;
  study.add(Artifact::receiver, "left", 0);
  study.add(Artifact::shadow, "left", 1e9);
  PlannedTask pair{.facts = {.kind = TaskKind::pair, .alternatives = 2, .chance = 0.5}};
  const std::vector<PredictedArtifact> artifacts =
      predict_artifacts(study.manifest, study.differences, {.image_gain = 10}, {}, pair);
  EXPECT_NEAR(find(artifacts, Artifact::receiver).cells[0].expected_noticeability, 0.5, 1e-9);
  EXPECT_NEAR(find(artifacts, Artifact::shadow).cells[0].expected_noticeability, 4, 1e-6);
}

TEST(Predict, CalibrationMeetsTheReceiversThreshold) {
  const Study study = example();
  ObserverDefinition observer;
  observer.image_gain = calibrated_gain(study.manifest, study.differences, observer, 426);
  const auto artifacts = predict_artifacts(study.manifest, study.differences, observer);
  EXPECT_NEAR(std::exp2(find(artifacts, Artifact::receiver).thresholds.perceptual.level_x.value()), 426,
              1e-3);
  EXPECT_EQ(demanding_order(artifacts),
            (std::vector<Artifact>{Artifact::overlap, Artifact::receiver, Artifact::shadow}));
}

TEST(Predict, CalibrationWithoutReceiverOrBeyondTheWidthsIsWrongInput) {
  Study study;
  study.add(Artifact::shadow, "left", 15);
  EXPECT_THROW((void)calibrated_gain(study.manifest, study.differences, {}, 426), InputError);
  EXPECT_THROW((void)calibrated_gain(example().manifest, example().differences, {}, 5000), InputError);
}

TEST(Predict, TextSaysWhatItRestsOn) {
  const Study study = example();
  const Prediction prediction{
      .observer = {.image_gain = 10},
      .artifacts = predict_artifacts(study.manifest, study.differences, {.image_gain = 10})};
  const std::string text = prediction_text(prediction);
  EXPECT_NE(text.find("nobody was asked"), std::string::npos);
  EXPECT_NE(text.find("426"), std::string::npos);
  EXPECT_NE(text.find("gain 10"), std::string::npos);
  EXPECT_NE(text.find("Floor: 0"), std::string::npos);
}

}  // namespace
}  // namespace seamline::analysis
