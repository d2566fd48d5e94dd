// Generated scenes: the same numbers give the same scene, every scene is another, and a mirrored one is its
// picture in a mirror.
#include <gtest/gtest.h>

#include <set>

#include "scenes/families/scene_family.h"

namespace seamline::scenes {
namespace {

GeneratedScene generated(SceneFamily family, std::uint64_t seed) {
  Random random(seed);
  return generate_scene(family, random);
}

/// What tells one scene from another: where its parts and objects are.
std::vector<double> places_of(const GeneratedScene& scene) {
  std::vector<double> places;
  for (const ScenePart& part : scene.background.parts) {
    const Eigen::AlignedBox3d box = bounds(part.mesh);
    places.insert(places.end(), {box.min().x(), box.max().y(), box.max().z()});
  }
  for (const PlacedObject& object : scene.objects)
    places.insert(places.end(), {object.position_m.x(), object.position_m.z(), object.yaw_deg, object.scale});
  return places;
}

TEST(SceneFamilies, ASeedIsAScene) {
  for (const SceneFamily family : every_scene_family) {
    std::set<std::vector<double>> different;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const std::vector<double> places = places_of(generated(family, seed));
      EXPECT_EQ(places, places_of(generated(family, seed))) << word(family);
      different.insert(places);
    }
    EXPECT_EQ(different.size(), 4U) << word(family);
    EXPECT_EQ(scene_family_from_word(word(family)), family);
  }
}

TEST(SceneFamilies, AnObjectMovesAloneAndNearItsPlace) {
  for (const SceneFamily family : every_scene_family) {
    Random random(7);
    const GeneratedScene before = generate_scene(family, random);
    GeneratedScene after = before;
    place_anew(family, after, 2, random);
    EXPECT_EQ(after.objects[0].position_m, before.objects[0].position_m);
    EXPECT_EQ(after.objects[1].position_m, before.objects[1].position_m);
    EXPECT_NE(after.objects[2].position_m, before.objects[2].position_m);
    EXPECT_LT((after.objects[2].position_m - before.objects[2].position_m).norm(), 1);
  }
}

TEST(SceneFamilies, AMirrorExchangesLeftAndRight) {
  GeneratedScene scene = generated(SceneFamily::rooms, 3);
  scene.mirrored = true;
  const GeneratedScene shown = as_shown(scene);
  EXPECT_FALSE(shown.mirrored);
  EXPECT_EQ(shown.background.sun->to_sun.x(), -scene.background.sun->to_sun.x());
  EXPECT_EQ(shown.objects[0].position_m.x(), -scene.objects[0].position_m.x());
  for (std::size_t part = 0; part < scene.background.parts.size(); ++part) {
    const Eigen::AlignedBox3d there = bounds(scene.background.parts[part].mesh);
    EXPECT_EQ(bounds(shown.background.parts[part].mesh).min().x(), -there.max().x());
  }
  scene.mirrored = false;
  EXPECT_EQ(as_shown(scene).objects[0].position_m, scene.objects[0].position_m);
}

}  // namespace
}  // namespace seamline::scenes
