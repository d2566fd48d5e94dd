// Published thresholds beside a study's: what is planted is what is said.
#include "analysis/replication/replication.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/analysis/true_joint.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

using test::complaint_of;
using testing::ElementsAre;
using testing::HasSubstr;
using enum ReplicationVerdict;

/// 20 people in the paper's design, of whom the true crossings are known; their generator is not the model.
JointAnalysis analysed_study(std::uint64_t seed) {
  const test::TruePeople people;
  const std::vector<int> width_px = {64, 128, 256, 512, 1024, 2048, 4096};
  std::vector<double> level_x;
  for (const int width : width_px) level_x.push_back(std::log2(width));
  const test::TrueStudy study{.width_px = width_px,
                              .people = test::answer_as_people(people, 20, level_x, seed)};
  JointAnalysis joint;
  for (const Artifact artifact : paper_artifacts)
    joint.labels.push_back({.artifact = std::string(word(artifact)), .condition = "", .group = ""});
  joint.data = test::joint_data_of(study);
  joint.fit = fit_joint(joint.data);
  joint.left_out = leave_people_out(joint.fit, joint.data, 1);
  joint.thresholds = joint_thresholds(joint.fit, joint.data, joint.left_out);
  return joint;
}

/// The true PT of every artifact, moved.
PublishedThresholds true_thresholds(double octaves) {
  PublishedThresholds published{.name = "the truth", .sha256 = {}, .values = {}};
  for (int curve = 0; curve < test::true_curves; ++curve)
    published.values.push_back({.artifact = paper_artifacts[static_cast<std::size_t>(curve)],
                                .condition = {},
                                .quantity = "PT",
                                .level = std::exp2(test::true_crossings_x({}, curve)[0] + octaves),
                                .low = {},
                                .high = {},
                                .participants = {},
                                .source = "truth"});
  return published;
}

struct Rates {
  int agrees_count = 0, differs_count = 0, all = 0;
};

Rates rates_of(double octaves, int studies) {
  Rates rates;
  for (int seed = 1; seed <= studies; ++seed) {
    const Replication found =
        compare_with_published(analysed_study(static_cast<std::uint64_t>(seed)),
                               {.published = true_thresholds(octaves), .replicates = 100});
    rates.agrees_count += found.count(agrees);
    rates.differs_count += found.count(differs);
    rates.all += static_cast<int>(found.thresholds.size());
  }
  return rates;
}

/// Of 48 thresholds each. A true value is said to differ in at most 5 %; one beyond the margin to agree
/// likewise; three octaves are never missed.
TEST(Replication, PlantedDifferencesAreSaidAsOftenAsPromised) {
  constexpr int studies = 12;
  const Rates at = rates_of(0, studies), margin = rates_of(0.6, studies), far = rates_of(3, studies);
  EXPECT_LE(at.differs_count, 7);  // 48 of 5 %: more come in 1 of 1000
  EXPECT_LE(margin.agrees_count, 7);
  EXPECT_EQ(far.differs_count, far.all);
  EXPECT_EQ(at.all, 4 * studies);
}

TEST(Replication, TheOrderOfDistantCurvesIsCertainAndThatOfEqualOnesIsNot) {
  const JointAnalysis joint = analysed_study(3);
  const Replication found = compare_with_published(joint, {.published = true_thresholds(0)});
  ASSERT_EQ(found.orders.size(), 1U);
  EXPECT_THAT(found.orders[0].artifacts, ElementsAre("shadow", "receiver", "occlusion", "overlap"));
  EXPECT_EQ(found.orders[0].found, found.orders[0].artifacts);
  EXPECT_GT(found.orders[0].probability, 0.9);
  PublishedThresholds turned = true_thresholds(0);
  std::swap(turned.values[0].level, turned.values[3].level);
  EXPECT_LT(compare_with_published(joint, {.published = turned}).orders[0].probability, 0.01);
}

TEST(Replication, APublishedIntervalMakesTheDifferenceLessCertain) {
  const JointAnalysis joint = analysed_study(1);
  PublishedThresholds exact = true_thresholds(0), known = exact;
  for (PublishedThreshold& one : known.values) {
    one.low = *one.level / 2;
    one.high = *one.level * 2;
  }
  const Replication a = compare_with_published(joint, {.published = exact}),
                    b = compare_with_published(joint, {.published = known});
  for (std::size_t i = 0; i < a.thresholds.size(); ++i) {
    EXPECT_DOUBLE_EQ(*a.thresholds[i].difference, *b.thresholds[i].difference);
    const double shorter = *a.thresholds[i].difference - *a.thresholds[i].low95;
    EXPECT_NEAR(*b.thresholds[i].difference - *b.thresholds[i].low95, std::hypot(shorter, 1), 1e-9);
  }
}

TEST(Replication, WhatCannotBeComparedIsSaid) {
  JointAnalysis joint = analysed_study(1);
  PublishedThresholds published = true_thresholds(0);
  published.values[0].level.reset();
  published.values[1].artifact = Artifact::bounce;
  joint.thresholds[2 * every_joint_quantity.size()].here = {
      .level_x = {}, .reason = NoThreshold::open_hardest, .ci95 = {}};
  const Replication found = compare_with_published(joint, {.published = published});
  EXPECT_EQ(found.thresholds[0].verdict, not_reported);
  EXPECT_EQ(found.thresholds[1].verdict, not_tested);
  EXPECT_EQ(found.thresholds[2].verdict, no_estimate);
  EXPECT_TRUE(found.orders.empty()) << "one curve has no order";
}

TEST(PublishedThresholds, ThePapersTableHasItsDashes) {
  const PublishedThresholds paper = read_published("paper");
  ASSERT_EQ(paper.values.size(), 12U);
  EXPECT_EQ(paper.values[0].level, 426);
  EXPECT_FALSE(paper.values[6].level) << "PT of occlusion";
}

class PublishedFile : public testing::Test {
 protected:
  [[nodiscard]] std::string complaint(const std::string& text) const {
    const std::filesystem::path file = folder_.path() / "published.csv";
    write_file_atomically(file, text);
    return complaint_of([&] { (void)read_published(file.string()); });
  }
  TemporaryFolder folder_;
};

TEST_F(PublishedFile, IsReadWithWhatIsKnown) {
  EXPECT_EQ(complaint("artifact,quantity,value\nreceiver,PT,426\n"), "no complaint");
  EXPECT_EQ(complaint("source,quantity,value,artifact,n,low,high\n\"A, B 2020\",SN,300,shadow,12,200,400\n"
                      ",PT,,shadow,,,\n"),
            "no complaint");
}

TEST_F(PublishedFile, IsRefusedWithOneSentence) {
  const std::string head = "artifact,quantity,value,low,high\n";
  EXPECT_THAT(complaint(head + "floor,PT,426,,\n"), HasSubstr("line 2: artifact: wanted receiver"));
  EXPECT_THAT(complaint(head + "receiver,P,426,,\n"), HasSubstr("quantity: wanted one of PT, SN"));
  EXPECT_THAT(complaint(head + "receiver,PT,-3,,\n"), HasSubstr("value: wanted a level above 0"));
  EXPECT_THAT(complaint(head + "receiver,PT,426,500,600\n"), HasSubstr("an interval that holds the value"));
  EXPECT_THAT(complaint(head + "receiver,PT,426,300,\n"), HasSubstr("or no interval"));
  EXPECT_THAT(complaint(head + "receiver,PT,426,,\nreceiver,PT,400,,\n"), HasSubstr("each threshold once"));
  EXPECT_THAT(complaint(head), HasSubstr("at least one published threshold"));
}

}  // namespace
}  // namespace seamline::analysis
