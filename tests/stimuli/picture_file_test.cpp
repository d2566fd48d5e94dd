// Pictures as other programs leave them: windows, layers, exposure, orientation, colours of other primaries.
#include "support/files/picture_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/codec/colour_profile.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A channel of one value everywhere, but 9 in the first pixel of the data window.
struct PlantedChannel {
  const char* name;
  float value;
};

/// By OpenEXR itself.
void write_planted_exr(const fs::path& path, const std::vector<PlantedChannel>& channels,
                       const Imath::Box2i& data, const Imath::Box2i& shown,
                       const Imf::Chromaticities* colours = nullptr) {
  Imf::Header header(shown, data);
  if (colours) Imf::addChromaticities(header, *colours);
  const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
  std::vector<std::vector<float>> values;
  Imf::FrameBuffer buffer;
  for (const PlantedChannel& channel : channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    values.emplace_back(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), channel.value);
    values.back().front() = 9;
  }
  for (std::size_t i = 0; i < channels.size(); ++i)
    buffer.insert(channels[i].name, Imf::Slice::Make(Imf::FLOAT, values[i].data(), data, sizeof(float),
                                                     sizeof(float) * static_cast<std::size_t>(width)));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(height);
}

const Imath::Box2i small_box({0, 0}, {3, 2});

TEST(PictureFiles, PixelsLieInTheDisplayWindow) {
  const TemporaryFolder folder;
  const std::vector<PlantedChannel> rgb = {{"R", 1}, {"G", 2}, {"B", 3}};
  write_planted_exr(folder / "a.exr", rgb, {{2, 1}, {9, 3}}, {{0, 0}, {5, 4}});
  const PictureFile picture = read_picture(folder / "a.exr");
  EXPECT_EQ(picture.image.width_px, 6);
  EXPECT_EQ(picture.image.height_px, 5);
  EXPECT_EQ(picture.image.at(1, 1), 0);
  EXPECT_EQ(picture.image.at(2, 1), 9);
  EXPECT_EQ(picture.image.at(5, 3, 2), 3);
  EXPECT_EQ(picture.image.at(5, 4), 0);
  EXPECT_THAT(picture.notes,
              ElementsAre(HasSubstr("8 x 3 at (2, 1), are brought into its display window, 6 x 5")));
  write_planted_exr(folder / "z.exr", {{"Z", 4}}, {{2, 1}, {9, 3}}, {{0, 0}, {5, 4}});
  const RawPicture depth = read_raw_picture(folder / "z.exr", "");
  EXPECT_EQ(depth.beyond, 6U * 5 - 4 * 3);
  EXPECT_TRUE(std::isnan(depth.image.at(1, 1)));
  EXPECT_EQ(depth.image.at(3, 1), 4);
  write_planted_exr(folder / "b.exr", rgb, {{5, 7}, {8, 9}}, {{5, 7}, {8, 9}});
  EXPECT_THAT(read_picture(folder / "b.exr").notes, IsEmpty());
}

TEST(PictureFiles, LayersAreTakenByName) {
  const TemporaryFolder folder;
  const auto write = [&](const std::vector<PlantedChannel>& channels) {
    write_planted_exr(folder / "a.exr", channels, small_box, small_box);
  };
  const auto green = [&](const std::string& layer = {}) {
    return read_picture(folder / "a.exr", {}, layer).image.at(1, 1, 1);
  };
  write({{"Albedo.R", 1},
         {"Albedo.G", 1},
         {"Albedo.B", 1},
         {"View.Combined.R", 2},
         {"View.Combined.G", 2},
         {"View.Combined.B", 2}});
  EXPECT_EQ(green(), 2);
  EXPECT_EQ(green("Albedo"), 1);
  EXPECT_THAT(read_picture(folder / "a.exr").notes, ElementsAre(HasSubstr("the picture is View.Combined")));
  EXPECT_THAT(complaint_of([&] { (void)green("Depth"); }),
              HasSubstr("layer: wanted one of the layers Albedo, View"));
  write({{"N.X", 1}, {"N.Y", 1}, {"N.Z", 1}, {"beauty.R", 2}, {"beauty.G", 2}, {"beauty.B", 2}});
  EXPECT_EQ(green(), 2);
  write({{"a.R", 1}, {"a.G", 1}, {"a.B", 1}, {"b.R", 2}, {"b.G", 2}, {"b.B", 2}});
  EXPECT_THAT(complaint_of([&] { (void)green(); }),
              HasSubstr("layer: wanted which of its layers is the picture"));
  write({{"N.X", 1}, {"N.Y", 1}, {"N.Z", 1}});
  EXPECT_THAT(complaint_of([&] { (void)green(); }), HasSubstr("found the channels N.X, N.Y, N.Z"));
  write({{"R", 1}, {"G", 1}, {"B", 1}, {"A", 0.5F}});
  EXPECT_THAT(read_picture(folder / "a.exr").notes,
              ElementsAre(HasSubstr("11 of its pixels are not opaque")));
}

TEST(PictureFiles, LuminanceAndChromaAreColours) {
  const TemporaryFolder folder;
  const int width = 16, height = 8;
  std::vector<Imf::Rgba> pixels(static_cast<std::size_t>(width) * height, Imf::Rgba(0.5F, 0.25F, 0.75F));
  {
    Imf::RgbaOutputFile file((folder / "a.exr").c_str(), width, height, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, width);
    file.writePixels(height);
  }
  const Image image = read_picture(folder / "a.exr").image;
  EXPECT_NEAR(image.at(9, 5, 0), 0.5, 0.01);
  EXPECT_NEAR(image.at(9, 5, 1), 0.25, 0.01);
  EXPECT_NEAR(image.at(9, 5, 2), 0.75, 0.01);
}

TEST(PictureFiles, DepthIsTakenByName) {
  const TemporaryFolder folder;
  const auto depth = [&](const std::vector<PlantedChannel>& channels) {
    write_planted_exr(folder / "a.exr", channels, small_box, small_box);
    return read_raw_picture(folder / "a.exr", "").image.at(2, 2);
  };
  EXPECT_EQ(depth({{"R", 1}, {"G", 1}, {"B", 1}, {"Z", 2}}), 2);
  EXPECT_EQ(depth({{"V", 2}}), 2);
  EXPECT_EQ(depth({{"R", 1}, {"G", 1}, {"B", 1}, {"depth.V", 2}, {"Z", 3}}), 2);
  EXPECT_EQ(depth({{"N.X", 1}, {"N.Y", 1}, {"N.Z", 1}, {"View.Depth.Z", 2}}), 2);
  EXPECT_EQ(depth({{"Y", 2}, {"A", 1}}), 2);
  EXPECT_THAT(complaint_of([&] {
                (void)depth({{"N.X", 1}, {"N.Y", 1}, {"N.Z", 1}});
              }),
              HasSubstr("depth_channel: wanted the name of its channel of depth"));
  EXPECT_THAT(complaint_of([&] {
                (void)depth({{"left.Z", 1}, {"right.Z", 1}});
              }),
              HasSubstr("left.Z, right.Z"));
}

TEST(PictureFiles, ChromaticitiesAreConverted) {
  const TemporaryFolder folder;
  // CIE XYZ as primaries, with the white of sRGB: what comes out is XYZ's own matrix into sRGB.
  const Imf::Chromaticities xyz({1, 0}, {0, 1}, {0, 0}, {0.3127F, 0.3290F});
  const Imf::Chromaticities one_line({0.6F, 0.3F}, {0.4F, 0.3F}, {0.2F, 0.3F}, {0.3127F, 0.3290F});
  const Imf::Chromaticities wide({0.708F, 0.292F}, {0.170F, 0.797F}, {0.131F, 0.046F}, {0.3127F, 0.3290F});
  const std::vector<PlantedChannel> rgb = {{"R", 1}, {"G", 0}, {"B", 0}};
  write_planted_exr(folder / "wide.exr", rgb, small_box, small_box, &wide);
  const PictureFile picture = read_picture(folder / "wide.exr");
  // ITU-R BT.2087-0, Table 2: from BT.2020 into BT.709.
  EXPECT_NEAR(picture.image.at(1, 1, 0), 1.6605, 2e-4);
  EXPECT_NEAR(picture.image.at(1, 1, 1), -0.1246, 2e-4);
  EXPECT_NEAR(picture.image.at(1, 1, 2), -0.0182, 2e-4);
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("chromaticities")));
  const Imf::Chromaticities usual;
  write_planted_exr(folder / "usual.exr", rgb, small_box, small_box, &usual);
  EXPECT_THAT(read_picture(folder / "usual.exr").notes, IsEmpty());
  EXPECT_EQ(read_picture(folder / "usual.exr").image.at(1, 1, 0), 1);
  write_planted_exr(folder / "xyz.exr", rgb, small_box, small_box, &xyz);
  EXPECT_NEAR(read_picture(folder / "xyz.exr").image.at(1, 1, 0), 3.2404542, 1e-3);
  EXPECT_NEAR(read_picture(folder / "xyz.exr").image.at(1, 1, 1), -0.9692660, 1e-3);
  write_planted_exr(folder / "none.exr", rgb, small_box, small_box, &one_line);
  EXPECT_THAT(read_picture(folder / "none.exr").notes, ElementsAre(HasSubstr("are no colours")));
}

/// 3 x 2 pixels without packing: the values 1 to 6 in red, line after line.
std::string hdr_of(const std::string& keys, const std::string& size) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + keys + "\n" + size + "\n";
  for (int i = 1; i <= 6; ++i) bytes += {static_cast<char>(i * 16), 0, 0, static_cast<char>(132)};
  return bytes;
}

TEST(PictureFiles, RadianceLinesComeInEightOrders) {
  const TemporaryFolder folder;
  const auto rows = [&](const std::string& size) {
    write_file_atomically(folder / "a.hdr", hdr_of("", size));
    const Image image = read_picture(folder / "a.hdr").image;
    std::vector<float> red;
    for (int y = 0; y < image.height_px; ++y)
      for (int x = 0; x < image.width_px; ++x) red.push_back(image.at(x, y));
    return red;
  };
  const auto reds = [](std::vector<float> red) { return red; };
  EXPECT_EQ(rows("-Y 2 +X 3"), reds({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(rows("-Y 2 -X 3"), reds({3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(rows("+Y 2 +X 3"), reds({4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(rows("+Y 2 -X 3"), reds({6, 5, 4, 3, 2, 1}));
  // Lines are columns: two of three pixels each.
  EXPECT_EQ(rows("+X 2 -Y 3"), reds({1, 4, 2, 5, 3, 6}));
  EXPECT_EQ(rows("-X 2 -Y 3"), reds({4, 1, 5, 2, 6, 3}));
  EXPECT_EQ(rows("+X 2 +Y 3"), reds({3, 6, 2, 5, 1, 4}));
  EXPECT_EQ(rows("-X 2 +Y 3"), reds({6, 3, 5, 2, 4, 1}));
}

TEST(PictureFiles, RadianceExposureAndXyzAreUndone) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& keys) {
    write_file_atomically(folder / "a.hdr", hdr_of(keys, "-Y 2 +X 3"));
    return read_picture(folder / "a.hdr");
  };
  EXPECT_EQ(read("EXPOSURE=4\nEXPOSURE= 0.5\n").image.at(1, 1), 2.5F);
  EXPECT_EQ(read("COLORCORR=2 1 1\n").image.at(1, 1), 2.5F);
  EXPECT_THAT(read("EXPOSURE=4\n").notes, ElementsAre(HasSubstr("divided by its EXPOSURE, 4")));
  EXPECT_THAT(complaint_of([&] { (void)read("EXPOSURE=0\n"); }), HasSubstr("an EXPOSURE above 0, found 0"));
  std::string xyz = hdr_of("", "-Y 2 +X 3");
  xyz.replace(xyz.find("rgbe"), 4, "xyze");
  write_file_atomically(folder / "b.hdr", xyz);
  const PictureFile picture = read_picture(folder / "b.hdr");
  EXPECT_NEAR(picture.image.at(0, 0, 0), 3.2404542, 1e-5);  // IEC 61966-2-1's matrix, X of 1 alone
  EXPECT_NEAR(picture.image.at(0, 0, 1), -0.9692660, 1e-5);
  EXPECT_NEAR(picture.image.at(0, 0, 2), 0.0556434, 1e-5);
  const Image light = read_image(folder / "b.hdr");  // of an environment, which sends no negative light
  EXPECT_EQ(light.at(0, 0, 0), picture.image.at(0, 0, 0));
  EXPECT_EQ(light.at(0, 0, 1), 0);
}

TEST(PictureFiles, AProfileIsUsedAndWrittenAgain) {
  const fs::path path = fs::path(SEAMLINE_SOURCE_DIR) / "tests/data/p3_patches.png";
  const PictureFile picture = read_picture(path);
  std::string complaint;
  if (!picture.profile) {  // a build without Little CMS says so
    EXPECT_THAT(picture.notes, Contains(HasSubstr("taken as sRGB")));
    return;
  }
  // As Pillow 9.4 (ImageCms, relative colorimetry) brings them into sRGB.
  const ByteImage shown = display_image(picture.image);
  const auto code = [&](int x, int y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * 80 + static_cast<std::size_t>(x));
    return std::vector<int>{shown.values[at], shown.values[at + 1], shown.values[at + 2]};
  };
  EXPECT_EQ(code(5, 5), (std::vector<int>{219, 37, 34}));
  EXPECT_EQ(code(25, 5), (std::vector<int>{0, 185, 45}));
  EXPECT_EQ(code(45, 5), (std::vector<int>{51, 80, 209}));
  EXPECT_EQ(code(75, 5), (std::vector<int>{237, 200, 0}));
  const TemporaryFolder folder;
  write_png(folder / "again.png", picture.image, 0, picture.profile.get());
  EXPECT_EQ(read_bytes_image(folder / "again.png").values, read_bytes_image(path).values);
  const PictureFile again = read_picture(folder / "again.png");
  ASSERT_TRUE(again.profile);
  EXPECT_EQ(again.profile->bytes(), picture.profile->bytes());
}

}  // namespace
}  // namespace seamline
