// Plain pictures are the same by libpng and OpenEXR alone as by the picture library: values and bytes.
#include "support/codec/plain_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"
#include "support/files/picture_library.h"
#include "support/files/temporary_folder.h"

namespace seamline {
namespace {

bool go_on() {
  return false;
}
bool stop_now() {
  return true;
}

std::vector<unsigned char> by_library(const PictureToEncode& picture) {
  std::string complaint;
  std::vector<unsigned char> bytes = picture_codec().encode(picture, go_on, complaint);
  EXPECT_EQ(complaint, "");
  return bytes;
}

/// Every code, and then random ones.
std::vector<std::uint8_t> codes(std::size_t count) {
  Random random(5);
  std::vector<std::uint8_t> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = static_cast<std::uint8_t>(i < 256 ? i : static_cast<std::size_t>(256 * random.uniform()));
  return values;
}

/// Light of all strengths, with what is no number among it.
std::vector<float> radiances(std::size_t count) {
  Random random(6);
  std::vector<float> values = {0.0F,
                               -0.0F,
                               -1.5F,
                               std::numeric_limits<float>::infinity(),
                               std::numeric_limits<float>::denorm_min(),
                               std::nanf("")};
  while (values.size() < count) values.push_back(static_cast<float>(std::exp2(40 * random.uniform() - 20)));
  return values;
}

struct Shape {
  int width_px, height_px, channels;

  [[nodiscard]] std::size_t values() const {
    return static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
           static_cast<std::size_t>(channels);
  }
};

constexpr Shape shapes[] = {{300, 200, 3}, {257, 131, 1}, {1, 400, 3}, {1300, 1, 1}};

template <class Value>
std::vector<Value> read_by(PictureReader& reader, std::size_t count) {
  std::vector<Value> values(count);
  EXPECT_EQ(reader.read(values.data(), go_on), "");
  return values;
}

void expect_same_header(const CodedPicture& plain, const CodedPicture& library) {
  EXPECT_EQ(plain.width_px, library.width_px);
  EXPECT_EQ(plain.height_px, library.height_px);
  EXPECT_EQ(plain.channels, library.channels);
  EXPECT_EQ(plain.flat, library.flat);
  EXPECT_EQ(plain.values, library.values);
  EXPECT_EQ(plain.bytes, library.bytes);
  EXPECT_EQ(plain.format, library.format);
  EXPECT_EQ(plain.orientation, library.orientation);
}

TEST(PlainPictures, PngIsTheSameByBoth) {
  for (const Shape& shape : shapes) {
    const std::vector<std::uint8_t> values = codes(shape.values());
    const PictureToEncode picture{".png",         shape.width_px, shape.height_px,
                                  shape.channels, nullptr,        values.data()};
    const auto bytes = encode_plain(picture, go_on);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, by_library(picture));

    const std::string file(bytes->begin(), bytes->end());
    const auto plain = plain_png_reader(file);
    ASSERT_TRUE(plain);
    const auto library = [&] {  // which reads from memory once
      auto reader = picture_codec().reader("png", false);
      EXPECT_EQ(reader->open(std::string_view(file)), "");
      return reader;
    };
    expect_same_header(plain->picture(), library()->picture());
    EXPECT_EQ(read_by<std::uint8_t>(*plain, values.size()), values);
    EXPECT_EQ(read_by<float>(*plain, values.size()), read_by<float>(*library(), values.size()));
    EXPECT_EQ(read_by<std::uint16_t>(*plain, values.size()), read_by<std::uint16_t>(*library(), values.size()));
  }
}

TEST(PlainPictures, ExrIsTheSameByBoth) {
  const TemporaryFolder folder;
  for (const Shape& shape : shapes) {
    const std::vector<float> values = radiances(shape.values());
    const PictureToEncode picture{".exr",         shape.width_px, shape.height_px,
                                  shape.channels, values.data(),  nullptr};
    const auto bytes = encode_plain(picture, go_on);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, by_library(picture));

    const auto path = folder / "picture.exr";
    write_file_atomically(path, std::string(bytes->begin(), bytes->end()));
    const auto plain = plain_exr_reader(path.string());
    ASSERT_TRUE(plain);
    const auto library = picture_codec().reader("openexr", false);
    ASSERT_EQ(library->open(path.string()), "");
    expect_same_header(plain->picture(), library->picture());
    EXPECT_EQ(plain->picture().compression, library->picture().compression);
    const std::vector<float> again = read_by<float>(*plain, values.size());
    EXPECT_EQ(std::memcmp(again.data(), values.data(), values.size() * sizeof(float)), 0);
  }
}

TEST(PlainPictures, WhatIsNotPlainIsLeftToTheLibrary) {
  const std::vector<std::uint8_t> values = codes(64);
  const PictureToEncode transparent{".png", 4, 4, 4, nullptr, values.data()};
  EXPECT_FALSE(encode_plain(transparent, go_on));
  const std::vector<unsigned char> bytes = by_library(transparent);
  EXPECT_FALSE(plain_png_reader(std::string(bytes.begin(), bytes.end())));

  const TemporaryFolder folder;
  const std::vector<float> floats = radiances(64);
  const PictureToEncode part{".exr", 4, 4, 3, floats.data(), nullptr};
  const auto path = folder / "parts.exr";
  ASSERT_EQ(picture_codec().write_parts(path.string(), {{"one", part}, {"two", part}}, go_on), "");
  EXPECT_FALSE(plain_exr_reader(path.string()));
  write_file_atomically(path, "no picture");
  EXPECT_FALSE(plain_exr_reader(path.string()));
}

TEST(PlainPictures, OneThatIsCutOrStoppedIsNoPicture) {
  const std::vector<std::uint8_t> values = codes(300 * 300);
  const PictureToEncode picture{".png", 300, 300, 1, nullptr, values.data()};
  EXPECT_FALSE(encode_plain(picture, stop_now));
  const auto bytes = encode_plain(picture, go_on);
  ASSERT_TRUE(bytes);
  std::vector<std::uint8_t> again(values.size());
  const std::string cut(bytes->begin(), bytes->begin() + static_cast<std::ptrdiff_t>(bytes->size() / 2));
  EXPECT_NE(plain_png_reader(cut)->read(again.data(), go_on), "");
  EXPECT_NE(plain_png_reader(std::string(bytes->begin(), bytes->end()))->read(again.data(), stop_now), "");
}

}  // namespace
}  // namespace seamline
