#include "renderer/transport/answers.h"

#include <gtest/gtest.h>

#include <array>

namespace seamline::renderer {
namespace {

TEST(Answers, OfSeveralArtifactsAreTheDepthMeshsWhereAnyOfThemAsksIt) {
  const std::array recipes = {recipe(Artifact::receiver, Isolation::query),
                              recipe(Artifact::occlusion, Isolation::query)};
  const Answers asked = asked_by_any(recipes);
  EXPECT_EQ(asked.receiver, Who::depth);
  EXPECT_EQ(asked.occlusion, Who::depth);
  EXPECT_EQ(asked.real_lit, Who::truth);
  EXPECT_EQ(asked.object_lit, Who::truth);
  EXPECT_EQ(asked.bounce, Who::truth);
}

TEST(Answers, OnlyLightFromElsewhereTracesRaysThroughTheDepthMesh) {
  for (const Artifact artifact : {Artifact::receiver, Artifact::occlusion, Artifact::none})
    EXPECT_FALSE(recipe(artifact, Isolation::query).answers.traces_depth()) << word(artifact);
  for (const Artifact artifact : {Artifact::shadow, Artifact::overlap, Artifact::bounce, Artifact::all})
    EXPECT_TRUE(recipe(artifact, Isolation::query).answers.traces_depth()) << word(artifact);
  EXPECT_TRUE(recipe(Artifact::receiver, Isolation::query).answers.asks_depth_for_light());
  EXPECT_TRUE(recipe(Artifact::receiver, Isolation::mask).answers.traces_depth());
}

TEST(Answers, AnOcclusionAsksTheDepthMeshButNotForLight) {
  const Answers of_occlusion = recipe(Artifact::occlusion, Isolation::query).answers;
  EXPECT_TRUE(of_occlusion.needs_depth());
  EXPECT_FALSE(of_occlusion.asks_depth_for_light());
  EXPECT_TRUE(recipe(Artifact::occlusion, Isolation::mask).answers.asks_depth_for_light());
  EXPECT_FALSE(asked_by_any({}).needs_depth());
}

TEST(Answers, LightIsOfOneGeometryWhereNoneTakesTheSkyOfOneAndTheBouncesOfTheOther) {
  for (const Artifact artifact : {Artifact::occlusion, Artifact::reflection, Artifact::all, Artifact::none})
    EXPECT_TRUE(light_of_one_geometry(recipe(artifact, Isolation::query).answers)) << word(artifact);
  for (const Artifact artifact :
       {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::bounce}) {
    EXPECT_FALSE(light_of_one_geometry(recipe(artifact, Isolation::query).answers)) << word(artifact);
    EXPECT_EQ(light_of_one_geometry(recipe(artifact, Isolation::mask).answers), artifact != Artifact::bounce)
        << word(artifact);
  }
}

}  // namespace
}  // namespace seamline::renderer
