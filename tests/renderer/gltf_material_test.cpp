// Materials and textures of glTF files, from the file to the point that a ray meets.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "raytracer/scene/gltf/tangents.h"
#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "raytracer/tracing/geometry.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/renderer/gltf_bytes.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A square from (0, 0) to (1, 1) at z = 0 that looks to +Z, its picture upright on it; colours are red green
/// above blue white.
class GltfMaterial : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "scene");
    write_file_atomically(folder_ / "scene" / "square.bin",
                          bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +      // places
                              bytes_of<float>({0, 1, 1, 1, 1, 0, 0, 0}) +              // texture coordinates
                              bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) +  // normals
                              bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3}));
    write_png(folder_ / "scene" / "colours.png", {2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}});
    write_png(folder_ / "scene" / "holes.png", {2, 1, 4, {9, 9, 9, 0, 9, 9, 9, 255}});
    write_png(folder_ / "scene" / "right up.png", {1, 1, 3, {218, 218, 128}});  // (1, 1, 0) / sqrt 2
  }

  /// The square with this material, and images "colours", "holes" and "right up" as textures 0 to 2, nearest.
  fs::path gltf(
      const std::string& material, const std::string& attributes = R"("TEXCOORD_0":1,"NORMAL":2)",
      const std::string& images = R"([{"uri":"colours.png"},{"uri":"holes.png"},{"uri":"right%20up.png"}])") {
    const fs::path path = folder_ / "scene" / "square.gltf";
    write_file_atomically(
        path,
        fmt::format(
            R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":140,"uri":"square.bin"}}],"bufferViews":[)"
            R"({{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":32}},)"
            R"({{"buffer":0,"byteOffset":80,"byteLength":48}},{{"buffer":0,"byteOffset":128,"byteLength":12}}],)"
            R"("accessors":[{{"bufferView":0,"componentType":5126,"type":"VEC3","count":4}},)"
            R"({{"bufferView":1,"componentType":5126,"type":"VEC2","count":4}},)"
            R"({{"bufferView":2,"componentType":5126,"type":"VEC3","count":4}},)"
            R"({{"bufferView":3,"componentType":5123,"type":"SCALAR","count":6}}],)"
            R"("images":{},"samplers":[{{"magFilter":9728}}],)"
            R"("textures":[{{"source":0,"sampler":0}},{{"source":1,"sampler":0}},{{"source":2}},{{}}],)"
            R"("materials":[{}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,{}}},"indices":3,)"
            R"("material":0}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}]}})",
            images, material, attributes));
    return path;
  }

  static Geometry geometry(const SceneFile& file) {
    return Geometry(place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d::Zero(), 0.5, 0));
  }
  /// What a ray straight down meets at (x, y); from below, with -1.
  static std::optional<SurfacePoint> met(const Geometry& geometry, float x, float y, float from = 1) {
    return geometry.nearest({{x, y, from}, {0, 0, -from}});
  }
  template <class... Arguments>
  std::string complaint(MaterialModel model, const Arguments&... arguments) {
    return test::complaint_of([&] { (void)read_scene_file(gltf(arguments...), model); });
  }
  const TemporaryFolder folder_;
};

constexpr const char* coloured =
    R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,1,1],"baseColorTexture":{"index":0},"metallicFactor":0}})";

TEST_F(GltfMaterial, ThePictureIsUprightOnTheSurfaceAndTimesTheFactor) {
  const Geometry square = geometry(read_scene_file(gltf(coloured)));
  EXPECT_TRUE(met(square, 0.25F, 0.75F)->albedo.isApprox(Rgb(1, 0, 0)));
  EXPECT_TRUE(met(square, 0.75F, 0.75F)->albedo.isApprox(Rgb(0, 0.5F, 0)));
  EXPECT_TRUE(met(square, 0.25F, 0.25F)->albedo.isApprox(Rgb(0, 0, 1)));
  EXPECT_TRUE(met(square, 0.75F, 0.25F, -1)->albedo.isApprox(Rgb(1, 0.5F, 1)));
  EXPECT_FALSE(is_glossy(scatterer(*met(square, 0.75F, 0.25F))));
}

TEST_F(GltfMaterial, OnlyWhatAModelUsesIsReadAndTheRestIsNamed) {
  const std::string all =
      R"({"pbrMetallicRoughness":{"metallicFactor":0.5,"roughnessFactor":0.4},"normalTexture":{"index":77},)"
      R"("extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}}})";
  const SceneFile file = read_scene_file(gltf(all));
  EXPECT_THAT(file.left_out_of_diffuse, ElementsAre("gloss", "metals", "normal maps"));
  EXPECT_THAT(file.left_out, ElementsAre("clear coats"));
  EXPECT_FALSE(is_glossy(scatterer(*met(geometry(file), 0.5F, 0.4F))));
  EXPECT_THAT(complaint(MaterialModel::gltf, all), HasSubstr("materials[0].normalTexture"));
  EXPECT_TRUE(read_scene_file(gltf(coloured)).left_out.empty());
  EXPECT_TRUE(read_scene_file(gltf(coloured)).left_out_of_diffuse.empty());
}

TEST_F(GltfMaterial, MetalAndGlossAreThereInTheGltfModel) {
  const SceneFile file = read_scene_file(
      gltf(
          R"({"pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.2,1],"metallicFactor":1,"roughnessFactor":0.4}})"),
      MaterialModel::gltf);
  const auto point = met(geometry(file), 0.5F, 0.4F);
  EXPECT_TRUE(point->albedo.isZero());
  EXPECT_TRUE(point->f0.isApprox(Rgb(0.8F, 0.4F, 0.2F)));
  EXPECT_FLOAT_EQ(point->alpha, 0.16F);
  EXPECT_TRUE(file.left_out_of_diffuse.empty());
}

TEST_F(GltfMaterial, ExtensionsThatChangeNothingAreNoComplaint) {
  EXPECT_EQ(
      complaint(
          MaterialModel::gltf,
          R"({"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":0},"KHR_materials_ior":{"ior":1.5},)"
          R"("KHR_materials_specular":{"specularColorFactor":[1,1,1]},"KHR_materials_transmission":{}}})"),
      "no complaint");
  const auto left_out = [&](const std::string& extensions) {
    return left_out_sentence(
        read_scene_file(gltf(fmt::format(R"({{"extensions":{{{}}}}})", extensions)), MaterialModel::gltf));
  };
  EXPECT_EQ(left_out(R"("KHR_materials_ior":{"ior":1.33})"), "");
  EXPECT_THAT(left_out(R"("KHR_materials_sheen":{"sheenColorFactor":[0,0,1]},"KHR_materials_unlit":{})"),
              AllOf(HasSubstr("square.gltf: left out: sheen; the unlit look")));
  EXPECT_THAT(complaint(MaterialModel::gltf,
                        R"({"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5}}})"),
              AllOf(HasSubstr("KHR_materials_transmission"), HasSubstr("transparent opaque")));
  EXPECT_THAT(complaint(MaterialModel::gltf, R"({"extensions":{"KHR_materials_ior":{"ior":0.5}}})"),
              HasSubstr("KHR_materials_ior.ior: wanted a refractive index of at least 1"));
}

TEST_F(GltfMaterial, TheRefractiveIndexIsTheLayersReflectance) {
  const SceneFile file = read_scene_file(
      gltf(R"({"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_ior":{"ior":3},)"
           R"("KHR_materials_specular":{"specularFactor":0.5,"specularColorFactor":[1,2,8]}}})"),
      MaterialModel::gltf);
  const auto point = met(geometry(file), 0.5F, 0.4F);
  EXPECT_TRUE(point->f0.isApprox(Rgb(0.125F, 0.25F, 0.5F)));
  EXPECT_FLOAT_EQ(point->f90, 0.5F);
}

/// The texture leans to the right and up: the normal does, seen from the front, and the other way from
/// behind.
TEST_F(GltfMaterial, ANormalTextureTurnsTheNormal) {
  const std::string leaning = R"({"pbrMetallicRoughness":{"metallicFactor":0},"normalTexture":{"index":2}})";
  for (const char* attributes : {R"("TEXCOORD_0":1,"NORMAL":2)", R"("TEXCOORD_0":1)"}) {
    const Geometry square = geometry(read_scene_file(gltf(leaning, attributes), MaterialModel::gltf));
    const Eigen::Vector3f wanted = Eigen::Vector3f(1, 1, 0).normalized();
    const auto front = met(square, 0.6F, 0.5F), back = met(square, 0.6F, 0.5F, -1);
    EXPECT_GT(front->normal.dot(wanted), 0.99F);
    EXPECT_GE(front->normal.z(), 0.0099F);  // turned towards the viewer
    EXPECT_LT(back->normal.dot(wanted), -0.99F);
    EXPECT_TRUE(front->geometric_normal.isApprox(Eigen::Vector3f::UnitZ()));
    EXPECT_NEAR(front->normal.norm(), 1, 1e-5);
  }
}

TEST_F(GltfMaterial, TangentsAreThePicturesRightAndKnowMirroredPictures) {
  const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<Eigen::Vector3f> normals(3, Eigen::Vector3f::UnitZ());
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const std::vector<Eigen::Vector2f> upright = {{0, 1}, {1, 1}, {1, 0}}, mirrored = {{1, 1}, {0, 1}, {0, 0}},
                                     nothing(3, Eigen::Vector2f(0.5F, 0.5F));
  for (const Eigen::Vector4f& t : make_tangents(places, normals, triangles, upright))
    EXPECT_TRUE(t.isApprox(Eigen::Vector4f(1, 0, 0, 1)));
  for (const Eigen::Vector4f& t : make_tangents(places, normals, triangles, mirrored))
    EXPECT_TRUE(t.isApprox(Eigen::Vector4f(-1, 0, 0, -1)));
  for (const Eigen::Vector4f& t : make_tangents(places, {}, triangles, nothing)) {
    EXPECT_NEAR(t.head<3>().norm(), 1, 1e-6);
    EXPECT_NEAR(t.z(), 0, 1e-6);
  }
}

/// What lamps made of such a surface send out is what rays that meet it find.
TEST_F(GltfMaterial, EmissionIsTheTexturesWhereverItIsAskedFor) {
  const SceneFile file =
      read_scene_file(gltf(R"({"emissiveFactor":[1,1,0.5],"emissiveTexture":{"index":0},"alphaMode":"MASK",)"
                           R"("pbrMetallicRoughness":{"baseColorTexture":{"index":1}}})"));
  const Geometry square = geometry(file);
  const SurfaceMesh& mesh = *square.meshes()[0];
  EXPECT_TRUE(mesh.emission.isApprox(Rgb(1, 1, 0.5F)));
  EXPECT_TRUE(met(square, 0.75F, 0.75F)->emission.isApprox(Rgb(0, 1, 0)));
  EXPECT_TRUE(met(square, 0.75F, 0.25F)->emission.isApprox(Rgb(1, 1, 0.5F)));
  // The first triangle: right by u + v, up by v.
  EXPECT_TRUE(emission_at(mesh, 0, 0.5F, 0.25F).isApprox(Rgb(1, 1, 0.5F)));
  EXPECT_TRUE(emission_at(mesh, 0, 0.25F, 0.125F).isZero());
}

/// The left half of the square is a hole, for every kind of question.
TEST_F(GltfMaterial, RaysPassThroughTheHolesOfAMask) {
  const SceneFile file = read_scene_file(gltf(
      R"({"alphaMode":"MASK","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":1}}})"));
  const Geometry square = geometry(file);
  std::vector<Ray> rays;
  for (int i = 0; i < 20; ++i)
    rays.push_back({{0.025F + 0.05F * static_cast<float>(i), 0.3F, 1}, {0, 0, -1}});
  std::vector<std::optional<SurfacePoint>> hits(rays.size());
  std::vector<std::uint8_t> blocked(rays.size());
  std::vector<float> distance_m(rays.size());
  for (const Coherence coherence : {Coherence::together, Coherence::scattered}) {
    square.nearest(rays, hits, coherence);
    square.occluded(rays, blocked, coherence);
    square.distances(rays, distance_m);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const bool solid = i >= 10;
      EXPECT_EQ(hits[i].has_value(), solid) << i;
      EXPECT_EQ(blocked[i] != 0, solid) << i;
      EXPECT_EQ(std::isfinite(distance_m[i]), solid) << i;
      EXPECT_EQ(square.nearest(rays[i]).has_value(), solid) << i;
      EXPECT_EQ(square.occluded(rays[i]), solid) << i;
    }
  }
}

TEST_F(GltfMaterial, HalfTransparentSurfacesAreRefusedUnlessNothingIsTransparent) {
  const std::string blend =
      R"({{"name":"glass","alphaMode":"BLEND","pbrMetallicRoughness":{{"baseColorFactor":[1,1,1,{}]}}}})";
  for (const MaterialModel model : {MaterialModel::diffuse, MaterialModel::gltf}) {
    EXPECT_THAT(complaint(model, fmt::format(fmt::runtime(blend), 0.4)),
                AllOf(HasSubstr("alphaMode"), HasSubstr("half-transparent"), HasSubstr("\"glass\"")));
    EXPECT_EQ(complaint(model, fmt::format(fmt::runtime(blend), 1)), "no complaint");
    EXPECT_EQ(complaint(model, fmt::format(fmt::runtime(blend), 0.996)), "no complaint");
  }
}

TEST_F(GltfMaterial, CutOutsThatMixAreMasksAndSaySo) {
  const SceneFile file = read_scene_file(
      gltf(R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":1}}})"));
  const Geometry square = geometry(file);
  EXPECT_FALSE(met(square, 0.25F, 0.5F));
  EXPECT_TRUE(met(square, 0.75F, 0.5F));
  EXPECT_THAT(file.left_out, ElementsAre("soft edges of alpha (cut-outs are masks at 0.5)"));
}

TEST_F(GltfMaterial, AWayRoundHalfTransparencyIsAskedForAndSaid) {
  const fs::path glass =
      gltf(R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.4]}})");
  const auto seen = [&](Transparency transparency) {
    const SceneFile file = read_scene_file(glass, MaterialModel::gltf, transparency);
    EXPECT_EQ(file.left_out.size(), 1U);
    return !file.meshes.empty() && met(geometry(file), 0.5F, 0.4F).has_value();
  };
  EXPECT_TRUE(seen(Transparency::opaque));
  EXPECT_FALSE(seen(Transparency::mask));
  EXPECT_FALSE(seen(Transparency::left_out));
}

TEST_F(GltfMaterial, TexturesWithoutCoordinatesAreSaidAndTheirFirstTexelIsEverywhere) {
  const SceneFile file = read_scene_file(gltf(coloured, R"("NORMAL":2)"));
  EXPECT_THAT(file.left_out, ElementsAre(HasSubstr("textures of meshes without TEXCOORD_0")));
  EXPECT_TRUE(met(geometry(file), 0.75F, 0.25F)->albedo.isApprox(Rgb(1, 0, 0)));
}

TEST_F(GltfMaterial, WhatIsWrongWithATextureIsOneSentence) {
  const auto said = [&](const std::string& texture, const std::string& attributes = R"("TEXCOORD_0":1)",
                        const std::string& images = R"([{"uri":"colours.png"}])") {
    return complaint(MaterialModel::diffuse,
                     fmt::format(R"({{"pbrMetallicRoughness":{{"baseColorTexture":{}}}}})", texture),
                     attributes, images);
  };
  EXPECT_EQ(said(R"({"index":0})"), "no complaint");
  EXPECT_THAT(said(R"({"index":9})"), HasSubstr("wanted a texture that exists, found 9"));
  EXPECT_THAT(said(R"({"index":3})"), HasSubstr("wanted a PNG or JPEG picture, found a texture without one"));
  EXPECT_THAT(said(R"({"index":1})"), HasSubstr("found one that does not exist"));
  EXPECT_THAT(said(R"({"index":0,"texCoord":2})"), HasSubstr("wanted 0 or 1"));
  EXPECT_THAT(said(R"({"index":0})", R"("TEXCOORD_0":1)", R"([{"uri":"none.png"}])"),
              AllOf(HasSubstr("images[0]"), HasSubstr("none.png")));
  write_png(folder_ / "outside.png", {1, 1, 3, {1, 2, 3}});
  EXPECT_THAT(said(R"({"index":0})", R"("TEXCOORD_0":1)", R"([{"uri":"../outside.png"}])"),
              HasSubstr("leads out of it"));
  EXPECT_THAT(said(R"({"index":0})", R"("TEXCOORD_0":1)", R"([{"bufferView":0}])"),
              HasSubstr("another kind of file"));
  EXPECT_THAT(said(R"({"index":0})", R"("TEXCOORD_0":1)", R"([{"bufferView":40}])"),
              HasSubstr("a buffer view that exists"));
  EXPECT_THAT(said(R"({"index":0})", R"("TEXCOORD_0":1)", R"({"images":1})"), HasSubstr("wanted an array"));
}

}  // namespace
}  // namespace seamline::renderer
