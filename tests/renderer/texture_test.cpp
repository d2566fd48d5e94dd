#include "raytracer/material/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raytracer/material/material.h"
#include "raytracer/material/reflectance_table.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

using testing::HasSubstr;

/// Two columns, two rows: black, red / green, white; alpha 0, 1 / 2, 3 of 3 quarters.
Texture four_texels(Encoding encoding = Encoding::linear) {
  ByteImage picture{2, 2, 4, {0, 0, 0, 0, 255, 0, 0, 64, 0, 255, 0, 128, 255, 255, 255, 191}};
  return {.picture = std::make_shared<const ByteImage>(std::move(picture)), .encoding = encoding};
}

TEST(Texture, TheUpperLeftTexelIsNearZeroAndTexelsAreMixedBetweenTheirCentres) {
  const Texture texture = four_texels();
  EXPECT_TRUE(look_up(texture, {0.75F, 0.25F}).isApprox(Eigen::Array4f(1, 0, 0, 64 / 255.0F)));
  EXPECT_TRUE(look_up(texture, {0.25F, 0.75F}).isApprox(Eigen::Array4f(0, 1, 0, 128 / 255.0F)));
  EXPECT_TRUE(look_up(texture, {0.5F, 0.25F}).isApprox(Eigen::Array4f(0.5F, 0, 0, 32 / 255.0F)));
  EXPECT_TRUE(look_up(texture, {0.5F, 0.5F}).head<3>().isApprox(Eigen::Array3f(0.5F, 0.5F, 0.25F)));
}

TEST(Texture, ColoursAreDecodedBeforeTheyAreMixedAndAlphaIsLinear) {
  ByteImage grey{2, 1, 1, {188, 0}};
  const Texture texture{.picture = std::make_shared<const ByteImage>(std::move(grey)),
                        .encoding = Encoding::srgb,
                        .wrap_u = Wrap::clamp};
  EXPECT_NEAR(look_up(texture, {0, 0.5F})[1], linear_from_srgb(188 / 255.0F), 1e-6);
  EXPECT_NEAR(look_up(texture, {0.5F, 0.5F})[2], linear_from_srgb(188 / 255.0F) / 2, 1e-6);
  EXPECT_EQ(look_up(texture, {0.5F, 0.5F})[3], 1);
  EXPECT_NEAR(look_up(four_texels(Encoding::srgb), {0.25F, 0.75F})[3], 128 / 255.0F, 1e-6);
}

TEST(Texture, OutsideItRepeatsMirrorsOrStays) {
  Texture texture = four_texels();
  const auto red_at = [&](float u) { return look_up(texture, {u, 0.25F})[0]; };
  for (const float u : {0.1F, 0.25F, 0.6F, 0.9F}) {
    texture.wrap_u = Wrap::repeat;
    EXPECT_NEAR(red_at(u + 3), red_at(u), 1e-5);
    EXPECT_NEAR(red_at(u - 2), red_at(u), 1e-5);
    texture.wrap_u = Wrap::mirrored;
    EXPECT_NEAR(red_at(-u), red_at(u), 1e-5);
    EXPECT_NEAR(red_at(2 - u), red_at(u), 1e-5);
    EXPECT_NEAR(red_at(u + 4), red_at(u), 1e-5);
    texture.wrap_u = Wrap::clamp;
    EXPECT_EQ(red_at(u + 1), 1);
    EXPECT_EQ(red_at(u - 1), 0);
  }
  texture.wrap_u = Wrap::repeat;
  EXPECT_NEAR(red_at(1), 0.5, 1e-6);  // between the last texel and the first
  for (const float far : {1e30F, -1e30F, std::numeric_limits<float>::infinity(), std::nanf("")})
    EXPECT_TRUE(look_up(texture, {far, far}).isFinite().all());
}

TEST(Texture, NearestTakesOneTexel) {
  Texture texture = four_texels();
  texture.nearest = true;
  EXPECT_EQ(look_up(texture, {0.49F, 0.1F})[0], 0);
  EXPECT_EQ(look_up(texture, {0.51F, 0.1F})[0], 1);
  EXPECT_EQ(look_up(texture, {-0.01F, 0.1F})[0], 1);
}

/// KHR_texture_transform: scale, then turn (what points right points up after a quarter), then move.
TEST(Texture, TransformsAsGltfSays) {
  const auto moved = [](const Eigen::Matrix<float, 2, 3>& transform, float u, float v) -> Eigen::Vector2f {
    return transform * Eigen::Vector3f(u, v, 1);
  };
  const float quarter = std::numbers::pi_v<float> / 2;
  EXPECT_TRUE(
      moved(texture_transform({0, 0}, quarter, {1, 1}), 1, 0).isApprox(Eigen::Vector2f(0, -1), 1e-6F));
  EXPECT_TRUE(
      moved(texture_transform({0.5F, 0.25F}, 0, {2, 3}), 1, 1).isApprox(Eigen::Vector2f(2.5F, 3.25F)));
  EXPECT_TRUE(moved(texture_transform({5, 6}, quarter, {2, 3}), 0, 1).isApprox(Eigen::Vector2f(8, 6), 1e-6F));
}

class TexturePicture : public testing::Test {
 protected:
  std::string png(const ByteImage& picture) {
    write_png(folder_ / "a.png", picture);
    return read_file(folder_ / "a.png", 1 << 20);
  }
  static std::string complaint(const std::string& bytes) {
    return test::complaint_of([&] { (void)decode_texture(bytes, "a picture"); });
  }
  const TemporaryFolder folder_;
};

TEST_F(TexturePicture, KeepsItsCodesAndDoesNotMultiplyByAlpha) {
  // What writes it takes colours for multiplied by alpha, and divides.
  const ByteImage read = decode_texture(png({2, 1, 4, {20, 10, 5, 51, 1, 2, 3, 255}}), "a picture");
  EXPECT_EQ(read.channels, 4);
  EXPECT_EQ(read.values, (std::vector<std::uint8_t>{100, 50, 25, 51, 1, 2, 3, 255}));
  const ByteImage grey{3, 1, 1, {7, 8, 9}};
  EXPECT_EQ(decode_texture(png(grey), "a picture").values, grey.values);
}

/// Three pixels by two of the grey 200.
const std::string grey_jpeg(
    "\xff\xd8\xff\xe0\x00\x10\x4a\x46\x49\x46\x00\x01\x01\x00\x00\x01\x00\x01\x00\x00\xff\xdb\x00\x43"
    "\x00\x03\x02\x02\x03\x02\x02\x03\x03\x03\x03\x04\x03\x03\x04\x05\x08\x05\x05\x04\x04\x05\x0a\x07"
    "\x07\x06\x08\x0c\x0a\x0c\x0c\x0b\x0a\x0b\x0b\x0d\x0e\x12\x10\x0d\x0e\x11\x0e\x0b\x0b\x10\x16\x10"
    "\x11\x13\x14\x15\x15\x15\x0c\x0f\x17\x18\x16\x14\x18\x12\x14\x15\x14\xff\xc0\x00\x0b\x08\x00\x02"
    "\x00\x03\x01\x01\x11\x00\xff\xc4\x00\x14\x00\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00"
    "\x00\x00\x00\x08\xff\xc4\x00\x14\x10\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00"
    "\x00\x00\xff\xda\x00\x08\x01\x01\x00\x00\x3f\x00\x60\x3f\xff\xd9",
    160);

TEST_F(TexturePicture, AJpegIsReadAndOneThatIsCutIsNotFilledWithGrey) {
  const ByteImage read = decode_texture(grey_jpeg, "a picture");
  EXPECT_EQ(read.width_px, 3);
  EXPECT_EQ(read.height_px, 2);
  EXPECT_EQ(read.values, std::vector<std::uint8_t>(6, 200));
  for (std::size_t size = 3; size < grey_jpeg.size(); size += 7)
    EXPECT_THAT(complaint(grey_jpeg.substr(0, size)), HasSubstr("wanted a whole JPEG image")) << size;
}

TEST_F(TexturePicture, OneThatIsCutTooLargeOrOfAnotherKindIsOneSentence) {
  std::string bytes = png({64, 64, 3, std::vector<std::uint8_t>(64 * 64 * 3, 7)});
  EXPECT_THAT(complaint(bytes.substr(0, bytes.size() / 2)), HasSubstr("found one that ends early"));
  EXPECT_THAT(complaint("RIFF....WEBP"), HasSubstr("wanted an EXR, HDR, PNG, JPEG or TIFF image"));
  EXPECT_THAT(complaint("#?RADIANCE\n"), HasSubstr("wanted a PNG or JPEG image, found one of format hdr"));
  EXPECT_THAT(complaint(std::string("\xff\xd8\xff\xe0\0\4ab\xff\xda\0\2 pixels", 20)),
              HasSubstr("ends early"));
  const std::string side("\0\0\x9c\x40", 4);  // 40,000
  bytes.replace(16, 8, side + side);
  EXPECT_THAT(complaint(bytes), HasSubstr("wanted at most 16384 x 16384 pixels, found 40000 x 40000"));
}

TEST(Material, IsMetalAndBaseByItsShare) {
  Material material{
      .base_colour = Rgb(0.8F, 0.4F, 0.2F), .has_layer = true, .metallic = 0.25F, .roughness = 0.5F};
  const MaterialValues values = material_at(material, {});
  EXPECT_TRUE(values.scatterer.albedo.isApprox(material.base_colour * 0.75F));
  EXPECT_TRUE(values.scatterer.f0.isApprox(0.03F + 0.25F * material.base_colour));
  EXPECT_FLOAT_EQ(values.scatterer.alpha, 0.25F);
  material.has_layer = false;
  EXPECT_TRUE((material_at(material, {}).scatterer.albedo == material.base_colour).all());
  EXPECT_FALSE(is_glossy(material_at(material, {}).scatterer));
}

/// KHR_materials_ior and KHR_materials_specular: f0 and f90 by the formulas of their specifications.
TEST(Material, ALayerOfItsOwnStrengthAndColour) {
  Material material{.base_colour = Rgb(0.8F, 0.4F, 0.2F), .has_layer = true, .metallic = 0.0F};
  material.dielectric_f0 = 0.25F;  // a refractive index of 3
  material.specular_colour = Rgb(1, 2, 8);
  material.specular = 0.5F;
  const Scatterer half = material_at(material, {}).scatterer;
  EXPECT_TRUE(half.f0.isApprox(Rgb(0.125F, 0.25F, 0.5F)));
  EXPECT_FLOAT_EQ(half.f90, 0.5F);
  EXPECT_TRUE(half.albedo.isApprox(material.base_colour));
  material.metallic = 1.0F;
  EXPECT_TRUE(material_at(material, {}).scatterer.f0.isApprox(material.base_colour));
  EXPECT_FLOAT_EQ(material_at(material, {}).scatterer.f90, 1.0F);
  material.metallic = 0.0F;
  material.specular = 0.0F;
  EXPECT_FALSE(is_glossy(material_at(material, {}).scatterer));
}

/// KHR_materials_pbrSpecularGlossiness: diffuse (1 - max(specular)), f0 = specular, roughness = 1 -
/// glossiness.
TEST(Material, TheOtherModelOfGloss) {
  const Material material{.base_colour = Rgb(0.8F, 0.4F, 0.2F),
                          .has_layer = true,
                          .metallic = 0.0F,
                          .dielectric_f0 = 1.0F,
                          .specular_colour = Rgb(0.5F, 0.25F, 0.1F),
                          .glossiness = 0.4F};
  const Scatterer surface = material_at(material, {}).scatterer;
  EXPECT_TRUE(surface.f0.isApprox(Rgb(0.5F, 0.25F, 0.1F)));
  EXPECT_TRUE(surface.albedo.isApprox(0.5F * material.base_colour));
  EXPECT_FLOAT_EQ(surface.alpha, 0.36F);
}

TEST(Material, VertexColoursMultiplyTheBaseColourAndItsAlpha) {
  Material material{.base_colour = Rgb(0.8F, 0.4F, 0.2F), .alpha_cutoff = 0.5F};
  const TextureCoordinates dim{.colour = {0.5F, 1, 1, 0.4F}};
  EXPECT_TRUE(material_at(material, dim).scatterer.albedo.isApprox(Rgb(0.4F, 0.4F, 0.2F)));
  EXPECT_TRUE(cut_away(material, dim));
  EXPECT_FALSE(cut_away(material, {}));
}

TEST(Material, ABlackMetalStillHasALayer) {
  const Material material{.base_colour = Rgb::Zero(), .has_layer = true};
  EXPECT_TRUE(is_glossy(material_at(material, {}).scatterer));
}

TEST(Material, ItsTexturesMultiplyItsNumbers) {
  Material material{.base_colour = Rgb(0.5F, 1, 1), .emission = Rgb(2, 2, 2), .has_layer = true};
  material.base_colour_texture = four_texels();
  material.emission_texture = four_texels();
  material.metallic_roughness_texture = four_texels();
  const TextureCoordinates red{.sets = {Eigen::Vector2f(0.75F, 0.25F), Eigen::Vector2f::Zero()}};
  const MaterialValues values = material_at(material, red);
  EXPECT_TRUE(values.emission.isApprox(Rgb(2, 0, 0)));
  EXPECT_TRUE(values.scatterer.albedo.isApprox(Rgb(0.5F, 0, 0)));  // blue of the texture: no metal
  EXPECT_FLOAT_EQ(values.scatterer.alpha, least_alpha);
}

TEST(Material, HolesAreWhereAlphaIsBelowTheCutoff) {
  Material material{.base_colour_texture = four_texels()};
  const TextureCoordinates red{.sets = {Eigen::Vector2f(0.75F, 0.25F), Eigen::Vector2f::Zero()}};
  EXPECT_FALSE(cut_away(material, red));
  material.alpha_cutoff = 0.3F;
  EXPECT_TRUE(cut_away(material, red));
  material.alpha_cutoff = 0.2F;
  EXPECT_FALSE(cut_away(material, red));
  material.alpha = 0.5F;
  EXPECT_TRUE(cut_away(material, red));
}

}  // namespace
}  // namespace seamline::renderer
