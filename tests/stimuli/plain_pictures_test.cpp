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

std::vector<unsigned char> encoded(const PictureToEncode& picture) {
  EXPECT_TRUE(is_plain(picture));
  std::string complaint;
  std::vector<unsigned char> bytes = encode_plain(picture, go_on, complaint);
  EXPECT_EQ(complaint, "");
  return bytes;
}

TEST(PlainPictures, PngIsTheSameByBoth) {
  for (const Shape& shape : shapes) {
    const std::vector<std::uint8_t> values = codes(shape.values());
    const PictureToEncode picture{".png",         shape.width_px, shape.height_px,
                                  shape.channels, nullptr,        values.data()};
    const std::vector<unsigned char> bytes = encoded(picture);
    EXPECT_EQ(bytes, by_library(picture));

    const std::string file(bytes.begin(), bytes.end());
    const auto plain = plain_reader("png");
    ASSERT_EQ(plain->open(std::string_view(file)), "");
    const auto library = [&] {  // which reads from memory once
      auto reader = picture_codec().reader("png", false);
      EXPECT_EQ(reader->open(std::string_view(file)), "");
      return reader;
    };
    EXPECT_EQ(plain->picture(), library()->picture());
    EXPECT_EQ(read_by<std::uint8_t>(*plain, values.size()), values);
    EXPECT_EQ(read_by<float>(*plain, values.size()), read_by<float>(*library(), values.size()));
    EXPECT_EQ(read_by<std::uint16_t>(*plain, values.size()),
              read_by<std::uint16_t>(*library(), values.size()));
  }
}

TEST(PlainPictures, ExrIsTheSameByBoth) {
  const TemporaryFolder folder;
  for (const Shape& shape : shapes) {
    const std::vector<float> values = radiances(shape.values());
    const PictureToEncode picture{".exr",         shape.width_px, shape.height_px,
                                  shape.channels, values.data(),  nullptr};
    const std::vector<unsigned char> bytes = encoded(picture);
    EXPECT_EQ(bytes, by_library(picture));

    const auto path = folder / "picture.exr";
    write_file_atomically(path, std::string(bytes.begin(), bytes.end()));
    const auto plain = plain_reader("openexr");
    ASSERT_EQ(plain->open(path.string()), "");
    const auto library = picture_codec().reader("openexr", false);
    ASSERT_EQ(library->open(path.string()), "");
    EXPECT_EQ(plain->picture(), library->picture());
    const std::vector<float> again = read_by<float>(*plain, values.size());
    EXPECT_EQ(std::memcmp(again.data(), values.data(), values.size() * sizeof(float)), 0);
    EXPECT_EQ(read_by<std::uint8_t>(*plain, values.size()), read_by<std::uint8_t>(*library, values.size()));
    EXPECT_EQ(read_by<std::uint16_t>(*plain, values.size()), read_by<std::uint16_t>(*library, values.size()));
  }
}

TEST(PlainPictures, WhatIsNotPlainIsLeftToTheLibrary) {
  const std::vector<std::uint8_t> values = codes(64);
  const PictureToEncode transparent{".png", 4, 4, 4, nullptr, values.data()};
  EXPECT_FALSE(is_plain(transparent));
  const std::vector<unsigned char> bytes = by_library(transparent);
  const std::string file(bytes.begin(), bytes.end());
  EXPECT_EQ(plain_reader("png")->open(std::string_view(file)), not_plain);
  EXPECT_EQ(plain_reader("jpeg"), nullptr);

  const TemporaryFolder folder;
  const std::vector<float> floats = radiances(64);
  const PictureToEncode part{".exr", 4, 4, 3, floats.data(), nullptr};
  const std::string path = (folder / "parts.exr").string();
  ASSERT_EQ(picture_codec().write_parts(path, {{"one", part}, {"two", part}}, go_on), "");
  EXPECT_EQ(plain_reader("openexr")->open(path), not_plain);
  write_file_atomically(path, "no picture");
  EXPECT_EQ(plain_reader("openexr")->open(path), not_plain);
}

TEST(PlainPictures, OneThatIsCutOrStoppedIsNoPicture) {
  const std::vector<std::uint8_t> values = codes(300 * 300);
  const PictureToEncode picture{".png", 300, 300, 1, nullptr, values.data()};
  std::string complaint;
  (void)encode_plain(picture, stop_now, complaint);
  EXPECT_EQ(complaint, was_stopped);

  const std::vector<unsigned char> bytes = encoded(picture);
  const std::string file(bytes.begin(), bytes.end());
  std::vector<std::uint8_t> again(values.size());
  const auto read = [&](std::string_view part, bool (*stop)()) {
    const auto reader = plain_reader("png");
    EXPECT_EQ(reader->open(part), "");
    return reader->read(again.data(), stop);
  };
  EXPECT_EQ(read(file, go_on), "");
  EXPECT_EQ(again, values);
  EXPECT_EQ(read(std::string_view(file).substr(0, file.size() / 2), go_on), "one that ends early");
  EXPECT_EQ(read(file, stop_now), was_stopped);
}

}  // namespace
}  // namespace seamline
