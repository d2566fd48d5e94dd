#include "support/files/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "support/codec/plain_pictures.h"
#include "support/files/atomic_file.h"
#include "support/files/exr_header.h"
#include "support/files/picture_library.h"
#include "support/files/png_file.h"
#include "support/files/temporary_folder.h"
#include "support/files/word_image.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

/// The library's name of the format that a file begins like. Its other two dozen formats are never tried,
/// whatever a file is called: each would be one more decoder that strangers' bytes reach.
std::string format_of(std::string_view start, const std::string& name) {
  if (start.starts_with("\x76\x2f\x31\x01")) return "openexr";
  if (start.starts_with("\x89PNG\r\n\x1a\n")) return "png";
  if (start.starts_with("\xff\xd8\xff")) return "jpeg";
  if (start.starts_with("#?RADIANCE") || start.starts_with("#?RGBE")) return "hdr";
  throw input_error(
      {.file = name, .wanted = "an EXR, HDR, PNG or JPEG image", .found = "another kind of file"});
}

std::string format_of(const fs::path& path) {
  std::array<char, 12> block{};
  std::ifstream in(path, std::ios::binary);
  in.read(block.data(), block.size());
  return format_of(std::string_view(block.data(), static_cast<std::size_t>(in.gcount())), path.string());
}

/// Decoded bytes for each byte of a file, at most. What PNG files hold has been unpacked already
/// (`check_png`); the bytes of its 1-bit pixels are eight times as many.
std::uint64_t largest_expansion(const CodedPicture& picture) {
  if (picture.format == "hdr") return 192;  // two bytes are a run of 127, and four bytes three floats
  if (picture.format != "openexr") return limits::largest_picture_expansion;
  const std::string& packing = picture.compression;
  if (packing == "none") return 1;
  if (packing == "rle") return 64;                         // two bytes are a run of 128
  if (packing == "zip" || packing == "zips") return 1032;  // deflate
  if (packing == "pxr24") return 1376;                     // deflate of three bytes of four
  if (packing == "piz") return 512;                        // ten bits are a run of 256 values of 16 bits
  if (packing.starts_with("b44")) return 11;               // three bytes are 16 values of 16 bits
  return limits::largest_picture_expansion;
}

/// Throws InputError unless what the header promises is bearable, and can be in a file of this size.
void check_size(const CodedPicture& picture, std::uint64_t file_bytes, const std::string& name) {
  using namespace limits;
  const auto refuse = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = name, .wanted = wanted, .found = found});
  };
  const std::string found =
      fmt::format("{} x {} pixels with {} channels", picture.width_px, picture.height_px, picture.channels);
  if (!picture.flat) throw refuse("a flat picture", "a deep or three-dimensional one");
  const bool sides = picture.width_px >= 1 && picture.width_px <= largest_picture_side_px &&
                     picture.height_px >= 1 && picture.height_px <= largest_picture_side_px &&
                     picture.channels >= 1 && picture.channels <= largest_picture_channels;
  if (!sides ||
      std::int64_t{picture.width_px} * picture.height_px * picture.channels > largest_picture_values)
    throw refuse(fmt::format("a picture of at most {0} x {0} pixels with {1} channels, and {2} values in all",
                             largest_picture_side_px, largest_picture_channels, largest_picture_values),
                 found);
  if (picture.bytes / largest_expansion(picture) > file_bytes)
    throw refuse(fmt::format("a file that can hold {}", found), fmt::format("{} bytes", file_bytes));
}

/// A picture whose header was read and is bearable.
struct OpenedImage {
  std::unique_ptr<PictureReader> reader;
  CodedPicture picture;

  [[nodiscard]] std::size_t values() const {
    return static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px) *
           static_cast<std::size_t>(picture.channels);
  }
};

/// Whether a reader of plain pictures can do it. What is wrong, if not, the picture library has words for.
template <class Where>
bool opens(PictureReader& plain, const Where& where) {
  try {
    return plain.open(where).empty();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return false;
  }
}

/// `where` is a path or bytes in memory.
template <class Where>
OpenedImage open_with(const std::string& format, bool alpha_apart, const Where& where,
                      std::uint64_t file_bytes, const std::string& name) {
  OpenedImage opened{plain_reader(format), {}};
  if (!opened.reader || !opens(*opened.reader, where)) {
    opened.reader = picture_codec().reader(format, alpha_apart);
    if (const std::string complaint = opened.reader->open(where); !complaint.empty())
      throw input_error({.file = name, .wanted = "an image that can be decoded", .found = complaint});
  }
  opened.picture = opened.reader->picture();
  check_size(opened.picture, file_bytes, name);
  return opened;
}

OpenedImage open_image(const fs::path& path, bool alpha_apart = false) {
  if (!fs::is_regular_file(path))
    throw input_error({.file = path.string(), .wanted = "an image file", .found = "no such file"});
  const std::string format = format_of(path);
  if (format == "openexr") check_exr_header(path);
  if (format == "png") check_png(path);
  return open_with(format, alpha_apart, path.string(), static_cast<std::uint64_t>(fs::file_size(path)),
                   path.string());
}

/// Runs `read`; what the image libraries throw at damaged bytes becomes an InputError.
template <class Read>
auto with_image_errors(const fs::path& path, Read&& read) {
  try {
    return read();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw input_error(
        {.file = path.string(), .wanted = "an image that can be decoded", .found = error.what()});
  }
}

template <class Value>
void decode(const OpenedImage& opened, Value* values, const fs::path& name) {
  const std::string complaint = opened.reader->read(values, interrupted);
  stop_if_interrupted();
  if (!complaint.empty())
    throw input_error({.file = name.string(), .wanted = "an image that can be decoded", .found = complaint});
}

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

Image read_image(const fs::path& path, const std::function<void(const ImageHeader&)>& accept) {
  return with_image_errors(path, [&] {
    const OpenedImage input = open_image(path);
    const CodedPicture& picture = input.picture;
    const bool floats = picture.values == CodedPicture::Values::floats;
    if (accept) accept({picture.width_px, picture.height_px, picture.channels, floats, picture.orientation});
    Image image(picture.width_px, picture.height_px, picture.channels);
    decode(input, image.values.data(), path);
    if (!floats)
      for (float& value : image.values) value = linear_from_srgb(value);
    return image;
  });
}

std::string lower_case_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& letter : ending)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return ending;
}

Image upright(const Image& image, int orientation) {
  if (orientation < 2 || orientation > 8) return image;
  // What the file's rows and columns are, by EXIF: row 0 is the visual top, or right, or so.
  const bool turned = orientation >= 5;
  const int width = turned ? image.height_px : image.width_px,
            height = turned ? image.width_px : image.height_px;
  Image out(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int from_x = turned ? y : x, from_y = turned ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        from_x = image.width_px - 1 - from_x;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        from_y = image.height_px - 1 - from_y;
      for (int c = 0; c < image.channels; ++c) out.at(x, y, c) = image.at(from_x, from_y, c);
    }
  return out;
}

PictureShape picture_shape(const fs::path& path) {
  return with_image_errors(path, [&] {
    const CodedPicture picture = open_image(path).picture;
    return PictureShape{picture.width_px, picture.height_px, picture.channels};
  });
}

namespace {

ByteImage decode_bytes(const OpenedImage& input, const fs::path& name) {
  ByteImage image{input.picture.width_px, input.picture.height_px, input.picture.channels, {}};
  image.values.resize(input.values());
  decode(input, image.values.data(), name);
  return image;
}

}  // namespace

ByteImage read_bytes_image(const fs::path& path) {
  return with_image_errors(path, [&] { return decode_bytes(open_image(path), path); });
}

ByteImage decode_texture(std::string_view bytes, const std::string& name) {
  return with_image_errors(name, [&] {
    const std::string format = format_of(bytes, name);
    if (format != "png" && format != "jpeg")
      throw input_error({.file = name, .wanted = "a PNG or JPEG image", .found = "one of format " + format});
    if (format == "png") {
      check_png_sides(bytes, name);
      check_png(bytes, name);
    }
    if (format == "jpeg") check_jpeg_end(bytes, name);
    const OpenedImage input = open_with(format, true, bytes, bytes.size(), name);
    if (input.picture.channels > 4)
      throw input_error(
          {.file = name, .wanted = "1 to 4 channels", .found = fmt::format("{}", input.picture.channels)});
    return decode_bytes(input, name);
  });
}

WordImage read_word_image(const fs::path& path, const std::function<void(const WordImage&)>& accept) {
  return with_image_errors(path, [&] {
    const OpenedImage input = open_image(path, true);
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

}  // namespace seamline
