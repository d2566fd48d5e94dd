#include "support/files/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "support/codec/plain_pictures.h"
#include "support/codec/png_file.h"
#include "support/files/atomic_file.h"
#include "support/files/open_picture.h"
#include "support/files/picture_file.h"
#include "support/files/picture_library.h"
#include "support/files/temporary_folder.h"
#include "support/files/word_image.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

/// By a PNG's header, which is looked at before its pixels are unpacked to see whether they are whole.
void check_png_sides(std::string_view bytes, const std::string& name) {
  constexpr std::size_t first_side = 16, after_sides = 24;
  if (bytes.size() < after_sides) return;  // `check_png` complains
  const auto side_px = [&](std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
  };
  const std::uint32_t width_px = side_px(first_side), height_px = side_px(first_side + 4);
  if (std::max(width_px, height_px) > static_cast<std::uint32_t>(limits::largest_picture_side_px))
    throw input_error({.file = name,
                       .wanted = fmt::format("at most {0} x {0} pixels", limits::largest_picture_side_px),
                       .found = fmt::format("{} x {}", width_px, height_px)});
}

/// Throws InputError unless a JPEG's pixels end with the mark that says so: the library fills what is missing
/// with grey. Other pictures may lie in its header, with marks of their own.
void check_jpeg_end(std::string_view bytes, const std::string& name) {
  std::size_t at = 2;
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(bytes[i]));
  };
  constexpr unsigned start_of_pixels = 0xda;
  while (at + 4 <= bytes.size() && byte(at) == 0xff && byte(at + 1) != start_of_pixels)
    at += 2 + (byte(at + 2) << 8 | byte(at + 3));
  if (at + 4 > bytes.size() || bytes.find("\xff\xd9", at) == std::string_view::npos)
    throw input_error({.file = name, .wanted = "a whole JPEG image", .found = "one that ends early"});
}

/// The picture is encoded in memory and then written: image libraries do not notice every write that failed,
/// and a picture that a full disk cut short would pass for a finished one.
void write_image(const fs::path& path, PictureToEncode picture) {
  picture.extension = path.extension().string();
  std::string complaint;
  const std::vector<unsigned char> bytes = is_plain(picture)
                                               ? encode_plain(picture, interrupted, complaint)
                                               : picture_codec().encode(picture, interrupted, complaint);
  stop_if_interrupted();
  if (!complaint.empty())
    throw input_error({.file = path.string(),
                       .wanted = "a kind of picture that can be written (png, exr)",
                       .found = complaint});
  write_file_atomically(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace

void require_numbers(const Image& image, const std::string& what) {
  const auto none = std::count_if(image.values.begin(), image.values.end(),
                                  [](float value) { return !std::isfinite(value); });
  if (none > 0)
    throw input_error({.file = what,
                       .wanted = "a picture whose values are all numbers",
                       .found = fmt::format("{} that are none: light too strong to be added up", none)});
}

ByteImage display_image(const Image& linear, double exposure_ev) {
  require_numbers(linear);
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  ByteImage out{linear.width_px, linear.height_px, linear.channels, {}};
  out.values.reserve(linear.values.size());
  for (const float value : linear.values)
    out.values.push_back(code_from_display(srgb_from_linear(value * gain)));
  return out;
}

std::string lower_case_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& letter : ending)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return ending;
}

PictureShape picture_shape(const fs::path& path) {
  return with_picture_errors(path, [&] {
    const CodedPicture picture = open_picture(path).picture;
    return PictureShape{picture.width_px, picture.height_px, picture.channels};
  });
}

namespace {

ByteImage decode_bytes(const OpenedPicture& input, const fs::path& name) {
  ByteImage image{input.picture.width_px, input.picture.height_px, input.picture.channels, {}};
  image.values.resize(input.values());
  decode(input, image.values.data(), name);
  return image;
}

}  // namespace

ByteImage read_bytes_image(const fs::path& path) {
  return with_picture_errors(path, [&] { return decode_bytes(open_picture(path), path); });
}

ByteImage decode_texture(std::string_view bytes, const std::string& name) {
  return with_picture_errors(name, [&] {
    const std::string format = picture_format(bytes, name);
    if (format != "png" && format != "jpeg")
      throw input_error({.file = name, .wanted = "a PNG or JPEG image", .found = "one of format " + format});
    if (format == "png") {
      check_png_sides(bytes, name);
      check_png(bytes, name);
    }
    if (format == "jpeg") check_jpeg_end(bytes, name);
    const OpenedPicture input = open_picture(bytes, format, true, name);
    if (input.picture.channels > 4)
      throw input_error(
          {.file = name, .wanted = "1 to 4 channels", .found = fmt::format("{}", input.picture.channels)});
    return decode_bytes(input, name);
  });
}

WordImage read_word_image(const fs::path& path, const std::function<void(const WordImage&)>& accept) {
  return with_picture_errors(path, [&] {
    const OpenedPicture input = open_picture(path, true);
    const CodedPicture& picture = input.picture;
    if (picture.format != "png")
      throw input_error({.file = path.string(), .wanted = "a PNG file", .found = picture.format});
    WordImage image{picture.width_px,
                    picture.height_px,
                    picture.channels,
                    picture.values == CodedPicture::Values::words ? 16 : 8,
                    {}};
    if (accept) accept(image);
    if (image.bits == 16) {
      image.values.resize(input.values());
      decode(input, image.values.data(), path);
    } else {
      std::vector<std::uint8_t> bytes(input.values());
      decode(input, bytes.data(), path);
      image.values.assign(bytes.begin(), bytes.end());
    }
    return image;
  });
}

void write_picture_exr(const fs::path& path, const Image& image) {
  require_numbers(image, path.string());
  write_exr(path, image);
}

namespace {

PictureToEncode floats_of(const Image& image) {
  return {.extension = {},
          .width_px = image.width_px,
          .height_px = image.height_px,
          .channels = image.channels,
          .floats = image.values.data()};
}

}  // namespace

void write_exr(const fs::path& path, const Image& image) {
  write_image(path, floats_of(image));
}

void write_layers_exr(const fs::path& path, const std::vector<PictureLayer>& layers) {
  std::vector<NamedPart> parts;
  for (const PictureLayer& layer : layers) parts.push_back({layer.name, floats_of(*layer.image)});
  const TemporaryFolder folder;
  const std::string made = (folder / "layers.exr").string();
  const std::string complaint = picture_codec().write_parts(made, parts, interrupted);
  stop_if_interrupted();
  if (!complaint.empty())
    throw input_error(
        {.file = path.string(), .wanted = "layers that can be written as one EXR file", .found = complaint});
  write_file_atomically(path, read_file(made));
}

void draw_text(ByteImage& image, int x, int y, const std::string& text, int height_px, std::uint8_t code) {
  static const std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (!fs::exists(font)) return;
  picture_codec().draw_text(
      {.extension = {}, .width_px = image.width_px, .height_px = image.height_px, .channels = image.channels},
      image.values.data(), x, y, text, height_px, font, code);
}

void write_png(const fs::path& path, const ByteImage& image) {
  write_image(path, {.extension = {},
                     .width_px = image.width_px,
                     .height_px = image.height_px,
                     .channels = image.channels,
                     .codes = image.values.data()});
}

void write_png(const fs::path& path, const ByteImage& image, const std::string& profile) {
  write_image(path, {.extension = {},
                     .width_px = image.width_px,
                     .height_px = image.height_px,
                     .channels = image.channels,
                     .codes = image.values.data(),
                     .profile = profile});
}

}  // namespace seamline
