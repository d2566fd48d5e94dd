// Depth maps of other programs: where depth is in a file, what stands for nothing, and what an estimate
// becomes.
#include "sensors/files/depth_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "sensors/files/depth_units.h"
#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class Number>
std::string little_endian(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

template <class Number>
std::string reversed_bytes(const std::vector<Number>& numbers) {
  std::string bytes = little_endian(numbers);
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number))
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + sizeof(Number)));
  return bytes;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& order = "False") {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header;
}

class DepthValues : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& bytes) {
    write_file_atomically(folder_ / name, bytes);
    return folder_ / name;
  }
  std::vector<float> values(const std::string& name, const std::string& bytes) {
    return read_raw_depth(write(name, bytes), {}).values;
  }
  std::string complaint(const std::string& name, const std::string& bytes) {
    return complaint_of([&] { (void)values(name, bytes); });
  }
  /// 4 x 1 pixels.
  static RawDepth raw_of(std::vector<float> values, bool whole = false, int bits = 32) {
    RawDepth raw;
    raw.width_px = static_cast<int>(values.size()) / 2;
    raw.height_px = 2;
    raw.values = std::move(values);
    raw.whole = whole;
    raw.bits = bits;
    return raw;
  }
  static DepthFileForm form_of(const RawDepth& raw) {
    DepthFileForm form;
    form.camera = pinhole_of_field_of_view(raw.width_px, raw.height_px, 60);
    return form;
  }
  static DepthFromValues read(const RawDepth& raw, const DepthMeaning& meaning) {
    return depth_of_values(raw, "map", form_of(raw), meaning);
  }

  TemporaryFolder folder_;
};

TEST_F(DepthValues, ArraysAreReadInEveryOrder) {
  const std::vector<float> numbers = {1, 2, 3, 4, 5, 6};
  const std::vector<float> flipped = {4, 5, 6, 1, 2, 3}, turned = {1, 4, 2, 5, 3, 6};
  EXPECT_EQ(values("a.pfm", "Pf\n3 2\n-1.0\n" + little_endian(flipped)), numbers);
  EXPECT_EQ(values("b.pfm", "Pf 3 2 1\n" + reversed_bytes(flipped)), numbers);
  std::vector<float> three;
  for (const float value : flipped) three.insert(three.end(), 3, value);
  EXPECT_EQ(values("c.pfm", "PF\n3 2\n-1\n" + little_endian(three)), numbers);
  EXPECT_EQ(values("a.npy", npy("<f4", "(2, 3)") + little_endian(numbers)), numbers);
  EXPECT_EQ(values("b.npy", npy(">f4", "(1, 2, 3)") + reversed_bytes(numbers)), numbers);
  EXPECT_EQ(values("c.npy", npy("<f4", "(2, 3)", "True") + little_endian(turned)), numbers);
  EXPECT_EQ(values("d.npy", npy("<f8", "(2, 3, 1)") + little_endian(std::vector<double>{1, 2, 3, 4, 5, 6})),
            numbers);
  EXPECT_EQ(values("e.npy", npy("<f2", "(2, 3)") + little_endian(std::vector<std::uint16_t>{
                                                       0x3C00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600})),
            numbers);
  EXPECT_EQ(
      values("f.npy", npy("<i2", "(2, 3)") + little_endian(std::vector<std::int16_t>{1, 2, 3, 4, 5, -6})),
      (std::vector<float>{1, 2, 3, 4, 5, -6}));
  const std::vector<std::int32_t> sides = {3, 2};
  EXPECT_EQ(values("a.dpt", "PIEH" + little_endian(sides) + little_endian(numbers)), numbers);
}

TEST_F(DepthValues, ArraysThatAreOtherOrCutAreRefused) {
  EXPECT_THAT(complaint("a.pfm", "Pf\n3 2\n-1\nabc"),
              HasSubstr("3 bytes of numbers where its header says 24"));
  EXPECT_THAT(complaint("a.pfm", "PF\n1 1\n-1\n" + little_endian(std::vector<float>{1, 2, 1})),
              HasSubstr("one channel, or three of equal values"));
  EXPECT_THAT(complaint("a.npy", npy("<c8", "(2, 3)")), HasSubstr("an array of real numbers"));
  EXPECT_THAT(complaint("a.npy", npy("<f4", "(3, 2, 3)")), HasSubstr("an array of two axes"));
  EXPECT_THAT(complaint("a.npz", "PK\x03\x04 and so on"), HasSubstr("save the one array as .npy"));
  const std::string whole = npy("<f4", "(2, 3)") + little_endian(std::vector<float>(6, 1.0F));
  for (std::size_t size = 8; size < whole.size(); size += 3)
    EXPECT_THAT(complaint("cut.npy", whole.substr(0, size)), HasSubstr("wanted ")) << size;
}

TEST_F(DepthValues, ColoursThatAreEqualAreDepthAndOthersAreNot) {
  Image grey(4, 2, 3, 2.5F);
  write_exr(folder_ / "grey.exr", grey);
  const RawDepth raw = read_raw_depth(folder_ / "grey.exr", {});
  EXPECT_EQ(raw.values, std::vector<float>(8, 2.5F));
  EXPECT_THAT(raw.notes, ElementsAre(HasSubstr("red, green and blue are equal")));
  grey.at(1, 1, 2) = 3;
  write_exr(folder_ / "grey.exr", grey);
  EXPECT_THAT(complaint_of([&] { (void)read_raw_depth(folder_ / "grey.exr", {}); }),
              HasSubstr("found 2.5 and 3 in pixel (1, 1)"));
  EXPECT_EQ(read_raw_depth(folder_ / "grey.exr", {.channel = "B"}).values[5], 3);
  EXPECT_THAT(complaint_of([&] { (void)read_raw_depth(folder_ / "grey.exr", {.channel = "Z"}); }),
              HasSubstr("depth_channel: wanted one of its channels, found Z beside the channels R, G, B"));
}

TEST_F(DepthValues, WhatStandsForNothingIsCountedAndSaid) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const RawDepth raw = raw_of({2, 3, 0, -1, nan, inf, 65535, 4});
  const DepthFromValues all = read(raw, {});
  EXPECT_EQ(all.file.holes, 4);
  EXPECT_EQ(all.file.frame.depth_m[6], 65535);
  const DepthFromValues coded = read(raw, {.nothing = {65535, 4}});
  EXPECT_EQ(coded.file.holes, 6);
  EXPECT_EQ(coded.why.coded, 2);
  EXPECT_THAT(coded.notes,
              ElementsAre("6 of 8 pixels have no depth: 2 of 65535 or 4, taken for nothing, 1 of 0, 1 "
                          "negative, 1 no number, 1 infinite"));
}

TEST_F(DepthValues, PlantedScaleAndShiftComeBack) {
  Random random(3);
  for (const DepthValue kind : {DepthValue::inverse, DepthValue::relative})
    for (int round = 0; round < 20; ++round) {
      const double scale = std::exp2(20 * random.uniform() - 10), shift = scale * (random.uniform() + 0.01);
      std::vector<KnownValue> known;
      for (int i = 0; i < 50; ++i) {
        const double value = random.uniform();
        known.push_back({value, metres_of_value(kind, {scale, shift}, value)});
      }
      const DepthFit fit = fit_depth(kind, known, "--depth-reference");
      EXPECT_NEAR(fit.line.scale / scale, 1, 1e-9);
      EXPECT_NEAR(fit.line.shift / shift, 1, 1e-9);
      EXPECT_LT(fit.abs_rel, 1e-9);
      EXPECT_NEAR(fit.within_quarter, 1, 1e-9);
    }
}

TEST_F(DepthValues, AnEstimateBecomesMetresByPointsAndByAReference) {
  constexpr double scale = 0.004, shift = 0.05;
  Image metres(6, 4, 1);
  RawDepth raw = raw_of(std::vector<float>(24));
  raw.width_px = 6;
  raw.height_px = 4;
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    raw.values[i] = 10 + 7 * static_cast<float>(i);
    metres.values[i] = static_cast<float>(1 / (scale * static_cast<double>(raw.values[i]) + shift));
  }
  write_exr(folder_ / "metres.exr", metres);
  DepthEstimate estimate;
  const auto expect_metres = [&](const DepthFromValues& read) {
    for (std::size_t i = 0; i < raw.values.size(); ++i)
      EXPECT_NEAR(read.file.frame.depth_m[i] / metres.values[i], 1, 1e-6);
  };
  estimate.reference = folder_ / "metres.exr";
  const DepthFromValues by_map = read(raw, {.estimate = estimate});
  expect_metres(by_map);
  EXPECT_THAT(by_map.notes,
              ElementsAre(HasSubstr("1 / distance = 0.004 value + 0.05, least squares on 24 pixels")));
  estimate.reference.clear();
  for (const std::size_t at : {3U, 20U}) {
    const std::size_t row = at / 6, column = at % 6;
    estimate.points.push_back({.x_px = static_cast<double>(column) + 0.5,
                               .y_px = static_cast<double>(row) + 0.5,
                               .depth_m = static_cast<double>(metres.values[at])});
  }
  expect_metres(read(raw, {.estimate = estimate}));
  estimate.points.clear();
  estimate.stated = DepthLine{.scale = scale, .shift = shift};
  expect_metres(read(raw, {.estimate = estimate}));
}

TEST_F(DepthValues, AnEstimateWithoutAScaleIsNoDistance) {
  const RawDepth raw = raw_of({0, 0.2F, 0.5F, 1});
  const auto said = [&](const DepthMeaning& meaning) {
    return complaint_of([&] { (void)read(raw, meaning); });
  };
  EXPECT_THAT(said({}), HasSubstr("found values that fill 0 to 1, as of an estimate"));
  EXPECT_THAT(said({.estimate = DepthEstimate{}}), HasSubstr("none, without which it is no distance"));
  // Larger where it is farther is no inverse depth.
  DepthEstimate estimate;
  estimate.points = {{0.5, 0.5, 1}, {1.5, 1.5, 4}};
  EXPECT_THAT(said({.estimate = estimate}), HasSubstr("(depth_value relative?)"));
  estimate.value = DepthValue::relative;
  EXPECT_EQ(read(raw, {.estimate = estimate}).file.holes, 0);
  estimate.points = {{5, 0.5, 1}};
  EXPECT_THAT(said({.estimate = estimate}), HasSubstr("which is outside"));
  DepthFileForm form = form_of(raw);
  form.metres_per_step = 1;
  EXPECT_EQ(depth_of_values(raw, "map", form, {}).file.frame.depth_m[3], 1);
}

TEST_F(DepthValues, UnitsHaveNames) {
  EXPECT_EQ(depth_unit("kitti", "--depth-unit").metres_per_step * 256, 1);
  EXPECT_EQ(depth_unit("tum", "--depth-unit").metres_per_step, 1.0 / 5000);
  EXPECT_THAT(complaint_of([] { (void)depth_unit("milimetres", "--depth-unit"); }),
              HasSubstr("found milimetres; did you mean millimetres?"));
  EXPECT_THAT(complaint_of([] { (void)depth_unit("cubits", "--depth-unit"); }),
              HasSubstr("--depth-unit: wanted one of metres, millimetres"));
}

}  // namespace
}  // namespace seamline::sensors
