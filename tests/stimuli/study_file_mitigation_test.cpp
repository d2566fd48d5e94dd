// What a study file says of mitigations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition mitigated(const std::string& tables,
                          const std::string& artifacts = "\"occlusion\", \"overlap\"") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 512]\n" +
                     tables + "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [" + artifacts +
                     "]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

std::string mitigation_complaint(const std::string& tables,
                                 const std::string& artifacts = "\"occlusion\", \"overlap\"") {
  return test::complaint_of([&] { (void)mitigated(tables, artifacts); });
}

TEST(StudyFileMitigation, IsTheStudysOrAConditions) {
  EXPECT_EQ(mitigated("").depth.mitigation, Mitigation{});
  const StudyDefinition study = mitigated(
      "[mitigation]\nshadow = \"matte\"\n[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\n"
      "mitigation.occlusion = \"mask\"\nmitigation.mask_width_px = 512\n[[condition]]\nname = \"c\"\n"
      "mitigation = {shadow = \"none\", blockers = \"layers\"}\n");
  EXPECT_EQ(canonical_text(study.conditions[0].depth.mitigation), "shadow matte 4096");
  EXPECT_EQ(canonical_text(study.conditions[1].depth.mitigation), "occlusion mask 512, shadow matte 4096");
  EXPECT_EQ(canonical_text(study.conditions[2].depth.mitigation), "blockers layers");
  EXPECT_EQ(list_truths(study).size(), 1U);
}

TEST(StudyFileMitigation, ChangesTheHashWhereThereIsOne) {
  EXPECT_EQ(study_hash(mitigated("[mitigation]\nshadow = \"none\"")), study_hash(mitigated("")));
  EXPECT_NE(study_hash(mitigated("[mitigation]\nshadow = \"matte\"")), study_hash(mitigated("")));
  EXPECT_NE(study_hash(mitigated("[mitigation]\nshadow = \"matte\"")),
            study_hash(mitigated("[mitigation]\nshadow = \"matte\"\nmatte_width_px = 64")));
}

TEST(StudyFileMitigation, RefusesWhatNothingLooksAt) {
  EXPECT_THAT(mitigation_complaint("[mitigation]\nshadow = \"paint\""),
              HasSubstr("\"none\" or \"matte\" or \"detected\""));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nmask = 1"), HasSubstr("mask"));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nmask_width_px = 64"), HasSubstr("occlusion = \"mask\""));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nshadow = \"matte\"\nmatte_width_px = 65"),
              HasSubstr("even"));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nshadow = \"matte\"", "\"occlusion\""),
              HasSubstr("mitigation.shadow"));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nocclusion = \"mask\"", "\"overlap\""),
              HasSubstr("mitigation.occlusion"));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nocclusion = \"mask\"\n[depth]\nocclusion = \"depth_test\""),
              HasSubstr("depth test"));
  EXPECT_THAT(mitigation_complaint("[mitigation]\nblockers = \"layers\"\n[depth]\njumps = \"cut\""),
              HasSubstr("exact panoramas"));
  EXPECT_NO_THROW((void)mitigated("isolation = \"mask\"\n[mitigation]\nshadow = \"matte\"", "\"receiver\""));
}

TEST(StudyFileMitigation, TheReadyStudyHasEachAloneAndBothTogether) {
  const StudyDefinition study = read_study(
      std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "mitigations.toml", AssetCheck::not_needed);
  ASSERT_EQ(study.conditions.size(), 7U);
  EXPECT_EQ(study.conditions[0].depth.mitigation, Mitigation{});
  EXPECT_EQ(canonical_text(study.conditions[5].depth.mitigation), "occlusion mask 4096, shadow matte 4096");
  EXPECT_EQ(list_truths(study).size(), study.scenes.size()) << "mitigations change no light";
}

}  // namespace
}  // namespace seamline
