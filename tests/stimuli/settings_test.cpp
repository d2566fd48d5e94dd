// Rows of settings: what each says of itself holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/mitigation_settings.h"
#include "stimuli/settings/pipeline_settings.h"
#include "stimuli/settings/read_settings.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

template <class Owner>
Owner read_as(const std::string& toml, Owner owner = {}) {
  const TomlTable table = TomlTable::parse(toml, "study.toml");
  read_settings(table, owner);
  table.finish();
  return owner;
}

/// What makes a row's setting have a meaning: `shadows = "shadow_map"`.
template <class Owner>
std::string beside_it(const Setting<Owner>& row) {
  return row.beside.key.empty()
             ? ""
             : std::string(row.beside.key) + " = \"" + std::string(row.beside.words.first) + "\"\n";
}

TEST(Settings, EveryWordOfAChoiceIsReadAndSaidAgain) {
  int words = 0;
  for (const Setting<Pipeline>& row : settings_of<Pipeline>)
    if (const auto* choice = std::get_if<Choice<Pipeline>>(&row.slot))
      for (const std::string_view word : choice->words) {
        ++words;
        const std::string toml = beside_it(row) + std::string(row.key) + " = \"" + std::string(word) + "\"";
        EXPECT_EQ(value_text(row, read_as<Pipeline>(toml)), word) << row.key;
      }
  EXPECT_EQ(words, 18);
}

TEST(Settings, EndsOfARangeAreReadAndWhatLiesBeyondIsRefused) {
  for (const Setting<Pipeline>& row : settings_of<Pipeline>) {
    if (row.range.least == row.range.most) continue;
    for (const double end : {row.range.least, row.range.most})
      EXPECT_NO_THROW((void)read_as<Pipeline>(beside_it(row) + fmt::format("{} = {}", row.key, end)))
          << row.key;
    EXPECT_THAT(
        test::complaint_of([&] {
          (void)read_as<Pipeline>(beside_it(row) + fmt::format("{} = {}", row.key, row.range.most + 1));
        }),
        HasSubstr(std::string(row.key) + ": wanted a"));
  }
}

TEST(Settings, WhatStandsBesideNothingIsRefusedAndOtherwiseDropped) {
  int idle = 0;
  for (const Setting<Pipeline>& row : settings_of<Pipeline>) {
    if (row.beside.key.empty()) continue;
    ++idle;
    EXPECT_THAT(
        test::complaint_of([&] { (void)read_as<Pipeline>(std::string(row.key) + " = 1"); }),
        HasSubstr(beside_text(row.beside) + " beside it, found " + std::string(row.beside.key) + " = "));
  }
  EXPECT_EQ(idle, 7);
  Pipeline pipeline;
  pipeline.shadow_map_px = 64;
  pipeline.light_count = 2;
  drop_idle(pipeline);
  EXPECT_EQ(pipeline, Pipeline{});
}

TEST(Settings, AMisspeltWordAndAMisspeltKeyAreAnsweredWithTheNearest) {
  EXPECT_EQ(test::complaint_of([] { (void)read_as<Pipeline>("shadows = \"shadow_mat\""); }),
            "study.toml: shadows: wanted \"traced\" or \"shadow_map\" or \"occlusion_field\", found "
            "\"shadow_mat\"; did you mean \"shadow_map\"?");
  EXPECT_THAT(test::complaint_of([] { (void)read_as<Mitigation>("blocker = \"layers\""); }),
              HasSubstr("did you mean \"blockers\"?"));
}

TEST(Settings, ALevelIsTheRowsMemberAndNoOther) {
  Pipeline pipeline;
  set_level_of(pipeline, Quantity::field_bands, 7);
  EXPECT_EQ(pipeline, (Pipeline{.field_bands = 7}));
  set_level_of(pipeline, Quantity::depth_noise, 3);
  EXPECT_EQ(pipeline, (Pipeline{.field_bands = 7}));
  EXPECT_EQ(setting_of_level<Pipeline>(Quantity::light_count)->key, "light_count");
  EXPECT_EQ(setting_of_level<Pipeline>(Quantity::depth_delay_ms), nullptr);
}

}  // namespace
}  // namespace seamline
