// Damaged pictures: one sentence each and nothing else on the terminal, and no memory for pixels that are not
// there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>

#include "png_parts.h"
#include "support/arithmetic/random.h"
#include "support/codec/png_file.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::big_endian;
using test::complaint_of;
using test::png_head;
using test::png_part;
using test::png_signature;
using test::png_sum;
using testing::AllOf;
using testing::HasSubstr;

/// zlib's stream of bytes as they are, at most 65,535.
std::string stored(const std::string& raw) {
  std::uint32_t a = 1, b = 0;
  for (const char letter : raw) {
    a = (a + static_cast<unsigned char>(letter)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<unsigned>(raw.size());
  const auto byte = [](unsigned value) { return static_cast<char>(value & 0xFFU); };
  return std::string("\x78\x01\x01") + byte(size) + byte(size >> 8) + byte(~size) + byte(~size >> 8) + raw +
         big_endian(b << 16 | a);
}

/// The sums of all parts put right, as somebody would who wants a decoder to look inside.
std::string with_right_sums(std::string png) {
  for (std::size_t at = png_signature.size(); at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(png[at + i]);
    if (length > png.size() - at - 12) break;
    png.replace(at + 8 + length, 4, big_endian(png_sum(std::string_view(png).substr(at + 4, 4 + length))));
    at += 12 + length;
  }
  return png;
}

std::string damaged(const std::string& whole, Random& random) {
  std::string bytes = whole;
  switch (random.below(4)) {
    case 0:
      return bytes.substr(0, random.below(bytes.size()));
    case 1: {
      const std::size_t at = random.below(bytes.size());
      bytes.replace(at, std::min<std::size_t>(40, bytes.size() - at), std::string(40, '\0'), 0,
                    std::min<std::size_t>(40, bytes.size() - at));
      return bytes;
    }
    case 2:
      return bytes.erase(random.below(bytes.size()), 1 + random.below(30));
    default:
      for (std::uint64_t i = 0; i <= random.below(6); ++i)
        bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
      return bytes;
  }
}

class DamagedPictures : public testing::Test {
 protected:
  static ByteImage codes() {
    ByteImage image{37, 23, 3, {}};
    for (int i = 0; i < 37 * 23 * 3; ++i) image.values.push_back(static_cast<std::uint8_t>(i * 7 % 251));
    return image;
  }
  static Image floats() {
    Image image(37, 23, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = 0.01F * static_cast<float>(i % 97);
    return image;
  }

  /// How many of the files are refused. What the libraries print counts as a failure of the test.
  int refused(const std::vector<std::string>& files) {
    int count = 0;
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string sentences;
    for (const std::string& bytes : files) {
      write_file_atomically(folder_ / "picture", bytes);
      for (const bool as_codes : {false, true}) try {
          if (as_codes)
            (void)read_bytes_image(folder_ / "picture");
          else
            (void)read_image(folder_ / "picture");
        } catch (const InputError& error) {
          count += as_codes ? 0 : 1;
          sentences += error.what();
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(sentences.find('\n'), std::string::npos);
    return count;
  }

  std::vector<std::string> many_of(const std::string& whole, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::string> files;
    for (int i = 0; i < 300; ++i) files.push_back(damaged(whole, random));
    return files;
  }

  const TemporaryFolder folder_;
};

TEST_F(DamagedPictures, PngFilesAreOneSentence) {
  write_png(folder_ / "whole.png", codes());
  const std::string whole = read_file(folder_ / "whole.png");
  EXPECT_EQ(refused({whole}), 0);
  std::vector<std::string> files = many_of(whole, 1);
  EXPECT_GE(refused(files), 280);
  for (std::string& file : files) file = with_right_sums(std::move(file));
  EXPECT_GE(refused(files), 200);
}

TEST_F(DamagedPictures, OtherFormatsAreOneSentence) {
  // The library writes by the ending of a name.
  write_png(folder_ / "whole.jpg", codes());
  write_exr(folder_ / "whole.hdr", floats());
  write_exr(folder_ / "whole.exr", floats());
  for (const char* name : {"whole.jpg", "whole.hdr", "whole.exr"}) {
    SCOPED_TRACE(name);
    const std::string whole = read_file(folder_ / name);
    EXPECT_EQ(refused({whole}), 0);
    EXPECT_GE(refused(many_of(whole, 2)), 50);
  }
}

TEST_F(DamagedPictures, EveryKindOfPngIsStillRead) {
  struct Kind {
    std::string header;       ///< bits, colour, interlaced
    int channels, row_bytes;  ///< channels: those that are read, without colours' alpha
  };
  for (const Kind& kind :
       {Kind{std::string("\x01\x00\x00", 3), 1, 1}, Kind{std::string("\x02\x00\x00", 3), 1, 2},
        Kind{std::string("\x04\x00\x00", 3), 1, 3}, Kind{std::string("\x08\x00\x00", 3), 1, 5},
        Kind{std::string("\x10\x00\x00", 3), 1, 10}, Kind{std::string("\x08\x02\x00", 3), 3, 15},
        Kind{std::string("\x10\x02\x00", 3), 3, 30}, Kind{std::string("\x08\x04\x00", 3), 2, 10},
        Kind{std::string("\x10\x06\x00", 3), 3, 40}, Kind{std::string("\x08\x03\x00", 3), 3, 5},
        Kind{std::string("\x02\x03\x00", 3), 3, 2}}) {
    std::string rows;
    for (int y = 0; y < 3; ++y)
      rows +=
          std::string(1, static_cast<char>(y)) + std::string(static_cast<std::size_t>(kind.row_bytes), '\0');
    const std::string palette = kind.header[1] == 3 ? png_part("PLTE", std::string(12, 'p')) : "";
    write_file_atomically(folder_ / "a.png", png_head(5, 3, kind.header) + palette + png_part("tEXt", "a") +
                                                 png_part("IDAT", stored(rows).substr(0, 9)) +
                                                 png_part("IDAT", stored(rows).substr(9)) +
                                                 png_part("IEND", ""));
    const Image image = read_image(folder_ / "a.png");
    EXPECT_EQ(image.channels, kind.channels);
    EXPECT_EQ(image.width_px, 5);
  }
  // Interlaced: 5 x 3 pixels are passes of 1, 1, 1, 3, 2 x 2 and 5 pixels.
  std::string rows;
  const std::vector<std::pair<int, int>> passes = {{1, 1}, {1, 1}, {1, 1}, {1, 3}, {2, 2}, {1, 5}};
  for (const auto& [count, columns] : passes)
    for (int i = 0; i < count; ++i) rows += std::string(static_cast<std::size_t>(1 + columns), '\0');
  write_file_atomically(folder_ / "a.png", png_head(5, 3, std::string("\x08\x00\x01", 3)) +
                                               png_part("IDAT", stored(rows)) + png_part("IEND", ""));
  EXPECT_EQ(read_image(folder_ / "a.png").values.size(), 15U);
}

TEST_F(DamagedPictures, EveryFaultOfAPngHasItsSentence) {
  const std::string head = png_head(2, 1, std::string("\x08\x00\x00", 3)), end = png_part("IEND", "");
  const std::string pixels = png_part("IDAT", stored(std::string(3, '\0')));
  const auto said = [&](const std::string& bytes) {
    write_file_atomically(folder_ / "a.png", bytes);
    return complaint_of([&] { check_png(folder_ / "a.png"); });
  };
  EXPECT_NO_THROW({
    write_file_atomically(folder_ / "a.png", head + pixels + end);
    check_png(folder_ / "a.png");
  });
  EXPECT_THAT(said(head + pixels), HasSubstr("wanted a whole PNG file, found one that ends early"));
  EXPECT_THAT(said(head + end), HasSubstr("fewer pixels than its header says"));
  EXPECT_THAT(said(head + png_part("IDAT", stored(std::string(4, '\0'))) + end),
              HasSubstr("more pixels than its header says"));
  EXPECT_THAT(said(head + png_part("IDAT", stored(std::string("\x05\0\0", 3))) + end),
              HasSubstr("a row of an unknown filter"));
  EXPECT_THAT(said(head + png_part("IDAT", "no stream") + end), HasSubstr("pixels that do not unpack"));
  EXPECT_THAT(said(head + pixels + png_part("tEXt", "a") + pixels + end), HasSubstr("pixels in two places"));
  EXPECT_THAT(said(head + png_part("ABCD", "") + pixels + end), HasSubstr("a part of an unknown kind"));
  EXPECT_THAT(said(png_head(2, 1, std::string("\x08\x03\x00", 3)) + pixels + end), HasSubstr("no palette"));
  EXPECT_THAT(said(png_head(2, 1, std::string("\x03\x00\x00", 3)) + pixels + end),
              HasSubstr("a header of no PNG picture"));
  std::string wrong_sum = head + pixels + end;
  wrong_sum[head.size() + 12] ^= 1;
  EXPECT_THAT(said(wrong_sum), testing::AnyOf(HasSubstr("sum is wrong"), HasSubstr("do not unpack")));
}

/// Peak memory of this process in MiB.
long peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST_F(DamagedPictures, WhatAHeaderClaimsTakesNoMemory) {
  const long before_mib = peak_mib();
  // 300 KB cannot be 1 GiB of bytes, and 1.1 MB that could be do not unpack to it.
  write_file_atomically(folder_ / "bomb.png", png_head(16384, 16384, std::string("\x08\x06\x00", 3)) +
                                                  png_part("IDAT", std::string(300'000, 'x')));
  EXPECT_THAT(complaint_of([&] { (void)read_image(folder_ / "bomb.png"); }),
              AllOf(HasSubstr("wanted a file that can hold 16384 x 16384 pixels with 4 channels"),
                    HasSubstr("found 3000")));
  write_file_atomically(folder_ / "bomb.png", png_head(16384, 16384, std::string("\x08\x06\x00", 3)) +
                                                  png_part("IDAT", stored(std::string(60'000, '\0'))) +
                                                  png_part("tEXt", std::string(1'100'000, 'x')) +
                                                  png_part("IEND", ""));
  EXPECT_THAT(complaint_of([&] { (void)read_image(folder_ / "bomb.png"); }), HasSubstr("fewer pixels"));
  EXPECT_LT(peak_mib() - before_mib, 200);
}

TEST_F(DamagedPictures, AHeaderThatIsNotWantedIsRefusedBeforeThePixels) {
  write_exr(folder_ / "whole.hdr", floats());
  const std::string whole = read_file(folder_ / "whole.hdr");
  write_file_atomically(folder_ / "cut.hdr", whole.substr(0, whole.size() / 2));
  EXPECT_THAT(complaint_of([&] { (void)read_image(folder_ / "cut.hdr"); }), HasSubstr("that can be decoded"));
  EXPECT_THAT(complaint_of([&] {
                (void)read_image(folder_ / "cut.hdr", [](const ImageHeader& header) {
                  EXPECT_TRUE(header.floating_point);
                  throw InputError(std::to_string(header.channels) + " channels");
                });
              }),
              HasSubstr("3 channels"));
}

}  // namespace
}  // namespace seamline
