// Depth maps from files: whole numbers raw, metres as metres, and one sentence about what is wrong.
#include "sensors/files/depth_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensors/files/pgm.h"
#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/stimuli/png_parts.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr int file_width_px = 12, file_height_px = 9, file_pixels = file_width_px * file_height_px;

/// zlib's stream of bytes as they are, at most 65,535.
std::string stored_stream(const std::string& raw) {
  std::uint32_t a = 1, b = 0;
  for (const char letter : raw) {
    a = (a + static_cast<unsigned char>(letter)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<unsigned>(raw.size());
  const auto byte = [](unsigned value) { return std::string(1, static_cast<char>(value & 0xFFU)); };
  return "\x78\x01\x01" + byte(size) + byte(size >> 8) + byte(~size) + byte(~size >> 8) + raw +
         test::big_endian(b << 16 | a);
}

/// A PNG of rows without filters. `header`: bits, colour, no interlace.
std::string png_of(const std::string& header, const std::string& pixels) {
  const std::size_t row_bytes = pixels.size() / file_height_px;
  std::string raw;
  for (std::size_t row = 0; row < file_height_px; ++row)
    raw += '\0' + pixels.substr(row * row_bytes, row_bytes);
  return test::png_head(file_width_px, file_height_px, header) + test::png_part("IDAT", stored_stream(raw)) +
         test::png_part("IEND", "");
}

const std::string grey_16("\x10\x00\x00", 3), grey_8("\x08\x00\x00", 3), rgb_8("\x08\x02\x00", 3);

std::string words(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  for (const std::uint16_t value : values) {
    bytes += static_cast<char>(value >> 8);
    bytes += static_cast<char>(value & 0xFF);
  }
  return bytes;
}

class DepthFiles : public ::testing::Test {
 protected:
  DepthFiles() {
    form_.camera = pinhole_of_field_of_view(file_width_px, file_height_px, 50);
    form_.metres_per_step = 0.001;
    Random random(4);
    for (int i = 0; i < file_pixels; ++i)
      millimetres_.push_back(i % 5 == 0 ? 0 : static_cast<std::uint16_t>(random.below(65536)));
    millimetres_[1] = 65535;
    millimetres_[2] = 1;
  }

  fs::path write(const std::string& name, const std::string& bytes) {
    write_file_atomically(folder_ / name, bytes);
    return folder_ / name;
  }
  std::string pgm_of(const std::string& header) { return header + words(millimetres_); }
  std::string complaint(const fs::path& path) {
    const std::string sentence = complaint_of([&] { (void)read_depth_file(path, form_); });
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0);
    EXPECT_TRUE(sentence.starts_with(path.string() + ": ") || sentence == "no complaint") << sentence;
    return sentence == "no complaint" ? sentence : sentence.substr(path.string().size() + 2);
  }
  void expect_raw(const DepthFile& file) {
    EXPECT_EQ(file.holes, std::count(millimetres_.begin(), millimetres_.end(), 0));
    for (std::size_t i = 0; i < millimetres_.size(); ++i)
      ASSERT_EQ(file.frame.depth_m[i],
                millimetres_[i] == 0 ? hole : static_cast<float>(0.001 * millimetres_[i]));
  }

  TemporaryFolder folder_;
  DepthFileForm form_;
  std::vector<std::uint16_t> millimetres_;
};

TEST_F(DepthFiles, SixteenBitsAreReadRawFromPngPgmAndTwoColours) {
  expect_raw(read_depth_file(write("a.png", png_of(grey_16, words(millimetres_))), form_));
  expect_raw(read_depth_file(write("a.pgm", pgm_of("P5\n12 9\n65535\n")), form_));
  expect_raw(read_depth_file(write("b.pgm", pgm_of("P5 # a comment\n# 1 1\n12\t9 65535 ")), form_));
  std::string colours;
  for (const std::uint16_t value : millimetres_)
    colours += {static_cast<char>(value >> 8), static_cast<char>(value & 0xFF), '\x7f'};
  form_.packing = DepthPacking::red_green;
  expect_raw(read_depth_file(write("rg.png", png_of(rgb_8, colours)), form_));
}

TEST_F(DepthFiles, ExrIsMetresUnlessStatedAndKeepsItsBits) {
  Image image(file_width_px, file_height_px, 1);
  Random random(2);
  for (float& value : image.values) value = static_cast<float>(0.3 + random.uniform());
  image.values[3] = hole;
  image.values[4] = -1;
  image.values[5] = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder_ / "a.exr", image);
  form_.metres_per_step.reset();
  form_.convention = DepthConvention::radial;
  const DepthFile file = read_depth_file(folder_ / "a.exr", form_);
  EXPECT_EQ(file.holes, 3);
  EXPECT_EQ(file.frame.convention, DepthConvention::radial);
  for (std::size_t i = 6; i < image.values.size(); ++i) ASSERT_EQ(file.frame.depth_m[i], image.values[i]);
  form_.metres_per_step = 2;
  EXPECT_EQ(read_depth_file(folder_ / "a.exr", form_).frame.depth_m[9], 2 * image.values[9]);
}

TEST_F(DepthFiles, WhatIsOutOfRangeReadsAsHolesAndIsCounted) {
  const fs::path path = write("a.pgm", pgm_of("P5\n12 9\n65535\n"));
  form_.nearest_m = 10;
  form_.farthest_m = 30;
  const DepthFile file = read_depth_file(path, form_);
  EXPECT_EQ(file_pixels - file.holes, std::count_if(millimetres_.begin(), millimetres_.end(),
                                                    [](int mm) { return mm >= 10000 && mm <= 30000; }));
  form_.nearest_m = 65.6;
  form_.farthest_m = 66;
  EXPECT_EQ(complaint(path), "wanted a depth from 65.6 to 66 m, found none");
}

TEST_F(DepthFiles, AnotherSizeOrShapeIsRefused) {
  const fs::path path = write("a.png", png_of(grey_16, words(millimetres_)));
  form_.camera = pinhole_of_field_of_view(24, 18, 50);
  EXPECT_EQ(complaint(path),
            "size: wanted 24 x 18 pixels, as its camera is stated, found 12 x 9: state the camera of that "
            "size, its numbers of pixels times 0.5");
  form_.camera = pinhole_of_field_of_view(12, 10, 50);
  EXPECT_EQ(complaint(path),
            "size: wanted 12 x 10 pixels, as its camera is stated, found 12 x 9, which is of another shape");
  EXPECT_EQ(complaint(write("a.pgm", pgm_of("P5\n12 9\n65535\n"))),
            "size: wanted 12 x 10 pixels, as its camera is stated, found 12 x 9, which is of another shape");
}

TEST_F(DepthFiles, EightBitsAndOtherKindsAreRefused) {
  const std::string bytes(file_pixels, 'a');
  EXPECT_EQ(complaint(write("8.png", png_of(grey_8, bytes))),
            "wanted one channel of 16 bits, found one channel of 8 bits");
  EXPECT_EQ(complaint(write("8.pgm", "P5\n12 9\n255\n" + bytes)),
            "wanted depths of 16 bits, found 8 bits (its maximum is 255)");
  EXPECT_EQ(complaint(write("rgb.png", png_of(rgb_8, bytes + bytes + bytes))),
            "wanted one channel of 16 bits, found 3 channels of 8 bits");
  EXPECT_EQ(complaint(write("a.txt", "depths")),
            "wanted an EXR, PNG, PGM (P5), TIFF, PFM, NPY or DPT file, found another kind of file");
  EXPECT_EQ(complaint(write("empty", "")),
            "wanted an EXR, PNG, PGM (P5), TIFF, PFM, NPY or DPT file, found another kind of file");
  EXPECT_EQ(complaint(folder_ / "none.png"), "wanted a depth map, found no such file");
  EXPECT_EQ(complaint(folder_.path()),
            "wanted the file of one depth map (EXR, PNG, PGM, TIFF, PFM, NPY or DPT), found a folder");
  Image colours(file_width_px, file_height_px, 3, 1);
  colours.at(2, 1, 1) = 3;
  write_exr(folder_ / "3.exr", colours);
  EXPECT_THAT(complaint(folder_ / "3.exr"),
              HasSubstr("wanted one channel of depth, or red, green and blue of equal "
                        "values, found 1 and 3 in pixel (2, 1)"));
  form_.packing = DepthPacking::red_green;
  EXPECT_EQ(
      complaint(write("16.png", png_of(grey_16, words(millimetres_)))),
      "wanted an RGB picture of 8 bits, whose red and green hold the depth, found one channel of 16 bits");
  EXPECT_EQ(complaint(write("a.pgm", pgm_of("P5\n12 9\n65535\n"))),
            "packing: wanted an 8-bit PNG, whose red and green hold the depth, found a PGM file");
  EXPECT_EQ(complaint(folder_ / "3.exr"),
            "packing: wanted an 8-bit PNG, whose red and green hold the depth, found an EXR file");
}

TEST_F(DepthFiles, HolesOnlyAreRefused) {
  std::fill(millimetres_.begin(), millimetres_.end(), 0);
  EXPECT_EQ(complaint(write("a.png", png_of(grey_16, words(millimetres_)))),
            "wanted a depth map with at least one depth, found nothing but holes (0, negative or no number)");
}

TEST_F(DepthFiles, MillimetresForMetresAndTheReverseAreAskedAbout) {
  std::fill(millimetres_.begin(), millimetres_.end(), 1500);
  const fs::path path = write("a.png", png_of(grey_16, words(millimetres_)));
  form_.metres_per_step = 1;
  form_.farthest_m = 10;  // a range does not hide it
  EXPECT_EQ(
      complaint(path),
      "metres_per_step: wanted a median depth from 0.05 to 500 m, found 1500 m with 1 metres a step: give "
      "0.001 metres a step if it is 1.5 m, or set unusual_distances if that is meant");
  form_.metres_per_step = 1e-6;
  EXPECT_THAT(complaint(path),
              HasSubstr("found 0.0015 m with 1e-06 metres a step: give 0.001 metres a step if it is 1.5 m"));
  form_.unusual_distances = true;
  EXPECT_EQ(read_depth_file(path, form_).frame.depth_m[0], 0.0015F);
  form_.metres_per_step.reset();
  EXPECT_EQ(
      complaint(path),
      "metres_per_step: wanted how many metres a step of its whole numbers is (0.001: millimetres), found "
      "nothing");
  form_.metres_per_step = -1;
  EXPECT_EQ(complaint(path), "metres_per_step: wanted a number above 0, found -1");
}

TEST_F(DepthFiles, CutFilesAreRefusedWhereverTheyEnd) {
  write_exr(folder_ / "a.exr", Image(file_width_px, file_height_px, 1, 2));
  for (const std::string& whole :
       {png_of(grey_16, words(millimetres_)), pgm_of("P5\n12 9\n65535\n"), read_file(folder_ / "a.exr")})
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200)
      EXPECT_THAT(complaint(write("cut", whole.substr(0, size))), HasSubstr("wanted ")) << size;
  EXPECT_EQ(complaint(write("long.pgm", pgm_of("P5\n12 9\n65535\n") + "x")),
            "wanted a whole PGM file (P5), found one with 217 bytes of pixels where its header says 216");
}

TEST_F(DepthFiles, ChangedBytesAreReadOrRefusedInOneSentence) {
  write_exr(folder_ / "a.exr", Image(file_width_px, file_height_px, 1, 2));
  Random random(6);
  for (const std::string& whole :
       {png_of(grey_16, words(millimetres_)), pgm_of("P5\n12 9\n65535\n"), read_file(folder_ / "a.exr")})
    for (int round = 0; round < 300; ++round) {
      std::string bytes = whole;
      for (int changes = 0; changes < 3; ++changes)
        bytes[random.below(round % 2 == 0 ? 24 : bytes.size())] = static_cast<char>(random.below(256));
      EXPECT_THAT(complaint(write("changed", bytes)), AnyOf(HasSubstr("wanted "), "no complaint"));
    }
}

TEST_F(DepthFiles, ImpossiblePgmHeadersAreRefused) {
  for (const char* header : {"P5", "P5\n", "P5\n0 9\n65535\n", "P5\n12 -9\n65535\n", "P5\n12 9\n65536\n",
                             "P5\n99999999999 9\n65535\n", "P5\n12 9 #", "P5\n12 9\n65535x"})
    EXPECT_THAT(complaint(write("a.pgm", pgm_of(header).substr(0, 40))), HasSubstr("wanted a whole PGM file"))
        << header;
  EXPECT_EQ(complaint(write("a.pgm", pgm_of("P5\n12 9\n1000\n"))),
            "wanted a whole PGM file (P5), found one with a value of 65535 above its own maximum, 1000");
  EXPECT_THAT(complaint(write("b.pgm", "P5\n#" + std::string(100000, 'a') + "\n12 9\n65535\n")),
              HasSubstr("ends in its header"));
}

}  // namespace
}  // namespace seamline::sensors
