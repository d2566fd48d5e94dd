// Objects that a person puts somewhere: what each action changes, and that the file holds it.
#include "composites/objects/placing.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "composites/objects/objects_file.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

Placing two_objects() {
  Placing placing;
  for (const char* name : {"builtin:statue", "builtin:teapot"})
    placing.objects.push_back({.file = name, .path = name, .height_m = 0.5, .stands = true});
  return placing;
}

std::string text_of(const Placing& placing) {
  return objects_file_text(placing.objects);
}

TEST(Placing, EveryActionIsTakenBack) {
  const std::vector<PlaceAction> actions = {StoodOn{{1, 2, 3}, {0, 1, 0}, 0.3, false},
                                            Shifted{{0.1, 0.2, 0.3}},
                                            Turned{30},
                                            Resized{1.5},
                                            Duplicated{},
                                            Removed{}};
  for (const PlaceAction& action : actions) {
    Placing placing = two_objects();
    const std::string before = text_of(placing);
    EXPECT_TRUE(act(placing, action));
    EXPECT_NE(text_of(placing), before);
    EXPECT_TRUE(act(placing, TakenBack{}));
    EXPECT_EQ(text_of(placing), before);
    EXPECT_FALSE(act(placing, TakenBack{})) << "nothing is left to take back";
  }
}

TEST(Placing, ADragIsTakenBackAsOne) {
  Placing placing = two_objects();
  const std::string before = text_of(placing);
  for (int i = 0; i < 5; ++i) act(placing, StoodOn{{0.1 * i, 0, -2}, {0, 1, 0}, 0.3, i > 0});
  act(placing, TakenBack{});
  EXPECT_EQ(text_of(placing), before);
}

TEST(Placing, OnAFloorItStandsWhereItWasPutAndBesideAWallHalfItsWidthAway) {
  Placing placing = two_objects();
  act(placing, StoodOn{{1, -1.5, -3}, Eigen::Vector3d(0.1, 1, 0).normalized(), 0.3, false});
  EXPECT_EQ(placing.objects[0].position_m, Eigen::Vector3d(1, -1.5, -3));
  act(placing, StoodOn{{1, 0, -3}, {0, 0, 1}, 0.3, false});
  EXPECT_TRUE(placing.objects[0].position_m.isApprox(Eigen::Vector3d(1, 0, -2.7)));
  act(placing, StoodOn{{1, 2, -3}, {0, -1, 0}, 0.3, false});
  EXPECT_EQ(placing.objects[0].position_m, Eigen::Vector3d(1, 2, -3)) << "a ceiling";
}

TEST(Placing, TurnsAddUpToWholeOnesAndSizesStayWithinBounds) {
  Placing placing = two_objects();
  for (int i = 0; i < 72; ++i) act(placing, Turned{5});
  EXPECT_NEAR(placing.objects[0].rotation_deg.y(), 0, 1e-9);
  for (int i = 0; i < 500; ++i) act(placing, Resized{2});
  EXPECT_EQ(*placing.objects[0].height_m, 1000);
  for (int i = 0; i < 500; ++i) act(placing, Resized{0.5});
  EXPECT_EQ(*placing.objects[0].height_m, 1e-3);
}

TEST(Placing, ChoosingGoesRoundAndTheLastObjectStays) {
  Placing placing = two_objects();
  act(placing, NextChosen{});
  EXPECT_EQ(placing.chosen, 1U);
  act(placing, NextChosen{});
  EXPECT_EQ(placing.chosen, 0U);
  EXPECT_FALSE(act(placing, Chosen{7}));
  EXPECT_EQ(placing.chosen, 1U);
  EXPECT_TRUE(act(placing, Removed{}));
  EXPECT_FALSE(act(placing, Removed{}));
  EXPECT_EQ(placing.objects.size(), 1U);
}

std::filesystem::path folder() {
  const std::filesystem::path made = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "placing";
  std::filesystem::create_directories(made);
  return made;
}

TEST(Placing, WhatIsSavedIsReadAgainWithTheLightThatStoodBeforeIt) {
  const std::filesystem::path file = folder() / "objects.toml";
  write_file_atomically(
      file,
      "# two lines\nenvironment_radiance = [0.4, 0.5, 0.7]\n\n[[object]]\nfile = \"builtin:statue\"\n"
      "position_m = [1, 2, 3]\nscale = 0.25\nroughness = 0.125\n");
  OpenedObjects opened = open_objects(file, {});
  Placing placing;
  placing.objects = opened.objects;
  act(placing, Shifted{{0.1, 0, 0}});
  save_objects(file, opened.head, "seamline composite --out a.png", placing.objects);
  EXPECT_EQ(read_file(file).rfind(
                "# made by: seamline composite --out a.png\n# two lines\nenvironment_radiance", 0),
            0U);
  const ObjectsFile again = read_objects_file(file, {});
  EXPECT_TRUE(again.has_light);
  ASSERT_EQ(again.objects.size(), 1U);
  EXPECT_EQ(again.objects[0].position_m, Eigen::Vector3d(1.1, 2, 3));
  EXPECT_EQ(again.objects[0].scale, 0.25);
  EXPECT_EQ(again.objects[0].roughness, 0.125);
  save_objects(file, open_objects(file, {}).head, "seamline", again.objects);
  const std::string once = read_file(file);
  EXPECT_EQ(once.rfind("# made by: seamline\n# two lines", 0), 0U) << "in place of the command before";
  save_objects(file, open_objects(file, {}).head, "seamline", open_objects(file, {}).objects);
  EXPECT_EQ(read_file(file), once);
}

TEST(Placing, RefusesWhatSavingWouldLose) {
  const std::filesystem::path file = folder() / "late-light.toml";
  write_file_atomically(
      file,
      "[[object]]\nfile = \"builtin:statue\"\n\n[[suns]]\nto_sun = [0, 1, 0]\nirradiance_w_m2 = [1, 1, 1]\n");
  EXPECT_THROW((void)open_objects(file, {}), InputError);
  EXPECT_THROW((void)new_object("builtin:kettle"), InputError);
  EXPECT_THROW((void)new_object("/nowhere/vase.glb"), InputError);
}

TEST(Placing, FilesFromAnywhereAreNamedSoThatTheCommandFindsThem) {
  namespace fs = std::filesystem;
  const fs::path beside = folder() / "project", elsewhere = folder() / "elsewhere";
  fs::create_directories(beside / "models");
  fs::create_directories(elsewhere / "vases");
  for (const fs::path& file : {beside / "models/a.glb", elsewhere / "vases/b.glb", elsewhere / "c.glb"})
    write_file_atomically(file, "of no meaning");
  const fs::path file = beside / "objects.toml";
  std::vector<PlacedModel> objects;
  for (const fs::path& named : {beside / "models/a.glb", elsewhere / "vases/b.glb", elsewhere / "c.glb"})
    objects.push_back(new_object(named.string()));
  objects.push_back(new_object("builtin:teapot"));
  const fs::path root = name_for(file, objects);
  EXPECT_EQ(root, fs::weakly_canonical(elsewhere));
  EXPECT_EQ(objects[0].file, "models/a.glb");
  EXPECT_EQ(objects[3].file, "builtin:teapot");
  save_objects(file, "", "seamline", objects);
  const ObjectsFile read = read_objects_file(file, root);
  ASSERT_EQ(read.objects.size(), 4U);
  EXPECT_TRUE(fs::equivalent(read.objects[1].path, elsewhere / "vases/b.glb"));
  EXPECT_THROW((void)read_objects_file(file, {}), InputError)
      << "without --asset-root files elsewhere are not read";
  std::vector<PlacedModel> below = {objects[0]};
  EXPECT_TRUE(name_for(file, below).empty());
}

}  // namespace
}  // namespace seamline::renderer
