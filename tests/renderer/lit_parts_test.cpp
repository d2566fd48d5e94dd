// Screens with little light on them, cut where they are lit.
#include "raytracer/scene/lit_parts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace seamline::renderer {
namespace {

constexpr int texels = 32;

/// A square of one square metre whose first `lit` columns of texels emit.
std::shared_ptr<SurfaceMesh> screen(int lit_columns, int lit_rows, bool nearest) {
  auto picture = std::make_shared<ByteImage>(ByteImage{texels, texels, 3, {}});
  picture->values.assign(texels * texels * 3, 0);
  for (int y = 8; y < 8 + lit_rows; ++y)
    for (int x = 8; x < 8 + lit_columns; ++x)
      for (int c = 0; c < 3; ++c) picture->values[static_cast<std::size_t>((y * texels + x) * 3 + c)] = 255;
  auto material = std::make_shared<Material>();
  material->emission = Rgb::Constant(100.0F);
  material->emission_texture = Texture{.picture = picture, .encoding = Encoding::srgb, .nearest = nearest};
  auto mesh = std::make_shared<SurfaceMesh>();
  mesh->positions_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh->uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh->emission = Rgb::Constant(100.0F);
  mesh->material = material;
  return mesh;
}

double area_m2(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * static_cast<double>((mesh.positions_m[b] - mesh.positions_m[a])
                                         .cross(mesh.positions_m[c] - mesh.positions_m[a])
                                         .norm());
  return sum;
}

TEST(LitParts, OneLitTexelIsALampOfAboutItsSize) {
  for (const bool nearest : {true, false}) {
    std::vector<std::shared_ptr<const SurfaceMesh>> meshes = {screen(1, 1, nearest)};
    cut_where_lit(meshes);
    ASSERT_GT(meshes.size(), 1U);
    double all_m2 = 0, lit_m2 = 0;
    for (const auto& mesh : meshes) {
      all_m2 += area_m2(*mesh);
      if ((mesh->emission > 0.0F).any()) lit_m2 += area_m2(*mesh);
    }
    EXPECT_NEAR(all_m2, 1.0, 1e-5);
    EXPECT_GE(lit_m2, 1.0 / (texels * texels));
    EXPECT_LE(lit_m2, 20.0 / (texels * texels));
  }
}

TEST(LitParts, EmissionOfAPartIsItsLargest) {
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes = {screen(1, 1, true)};
  cut_where_lit(meshes);
  float brightest = 0;
  for (const auto& mesh : meshes) {
    brightest = std::max(brightest, mesh->emission.maxCoeff());
    const bool emits = (mesh->emission > 0.0F).any();
    EXPECT_EQ(emits, mesh->material->emission_texture.has_value());
  }
  EXPECT_FLOAT_EQ(brightest, 100.0F);
}

TEST(LitParts, WhatIsLitInALargePartStaysWhole) {
  const auto whole = screen(20, 20, true);
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes = {whole};
  cut_where_lit(meshes);
  ASSERT_EQ(meshes.size(), 1U);
  EXPECT_EQ(meshes[0], whole);
}

}  // namespace
}  // namespace seamline::renderer
