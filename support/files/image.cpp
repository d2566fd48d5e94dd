// The only file that includes OpenImageIO.
#include "support/files/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "support/files/atomic_file.h"
#include "support/files/exr_header.h"
#include "support/files/png_file.h"
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
std::uint64_t largest_expansion(const OIIO::ImageSpec& spec, const std::string& format) {
  if (format == "hdr") return 192;  // two bytes are a run of 127, and four bytes three floats
  if (format != "openexr") return limits::largest_picture_expansion;
  const std::string packing = spec.get_string_attribute("compression");
  if (packing == "none") return 1;
  if (packing == "rle") return 64;                         // two bytes are a run of 128
  if (packing == "zip" || packing == "zips") return 1032;  // deflate
  if (packing == "pxr24") return 1376;                     // deflate of three bytes of four
  if (packing == "piz") return 512;                        // ten bits are a run of 256 values of 16 bits
  if (packing.starts_with("b44")) return 11;               // three bytes are 16 values of 16 bits
  return limits::largest_picture_expansion;
}

/// Throws InputError unless what the header promises is bearable, and can be in a file of this size.
void check_size(const OIIO::ImageSpec& spec, const std::string& format, std::uint64_t file_bytes,
                const std::string& name) {
  using namespace limits;
  const auto refuse = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = name, .wanted = wanted, .found = found});
  };
  const std::string found =
      fmt::format("{} x {} pixels with {} channels", spec.width, spec.height, spec.nchannels);
  if (spec.deep || spec.depth > 1) throw refuse("a flat picture", "a deep or three-dimensional one");
  const bool sides = spec.width >= 1 && spec.width <= largest_picture_side_px && spec.height >= 1 &&
                     spec.height <= largest_picture_side_px && spec.nchannels >= 1 &&
                     spec.nchannels <= largest_picture_channels;
  if (!sides || std::int64_t{spec.width} * spec.height * spec.nchannels > largest_picture_values)
    throw refuse(fmt::format("a picture of at most {0} x {0} pixels with {1} channels, and {2} values in all",
                             largest_picture_side_px, largest_picture_channels, largest_picture_values),
                 found);
  if (std::uint64_t{spec.image_bytes(true)} / largest_expansion(spec, format) > file_bytes)
    throw refuse(fmt::format("a file that can hold {}", found), fmt::format("{} bytes", file_bytes));
}

/// Closes a picture. Errors that nobody asked the library about, it would print.
struct CloseImage {
  void operator()(OIIO::ImageInput* input) const {
    input->close();
    (void)input->geterror();
    delete input;  // NOLINT(cppcoreguidelines-owning-memory)
  }
};
using OpenedImage = std::unique_ptr<OIIO::ImageInput, CloseImage>;

OpenedImage open_image(const fs::path& path, const OIIO::ImageSpec& wishes = {}) {
  if (!fs::is_regular_file(path))
    throw input_error({.file = path.string(), .wanted = "an image file", .found = "no such file"});
  const std::string format = format_of(path);
  if (format == "openexr") check_exr_header(path);
  if (format == "png") check_png(path);
  OpenedImage input(OIIO::ImageInput::create(format).release());
  OIIO::ImageSpec spec;
  if (!input || !input->open(path.string(), spec, wishes))
    throw input_error({.file = path.string(),
                       .wanted = "an image that can be decoded",
                       .found = input ? input->geterror() : OIIO::geterror()});
  check_size(spec, format, static_cast<std::uint64_t>(fs::file_size(path)), path.string());
  return input;
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

/// Asked by the library between pieces of a picture.
bool stop_here(void*, float) {
  return interrupted();
}

void decode(OIIO::ImageInput& input, OIIO::TypeDesc type, void* values, const fs::path& name) {
  const bool decoded = input.read_image(0, 0, 0, input.spec().nchannels, type, values, OIIO::AutoStride,
                                        OIIO::AutoStride, OIIO::AutoStride, stop_here);
  stop_if_interrupted();
  if (!decoded || input.has_error())
    throw input_error(
        {.file = name.string(), .wanted = "an image that can be decoded", .found = input.geterror()});
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
void write_image(const fs::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create(path.string());
  const bool encoded =
      output && output->set_ioproxy(&bytes) && output->open(path.string(), spec) &&
      output->write_image(type, pixels, OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride, stop_here) &&
      output->close();
  stop_if_interrupted();
  if (!encoded)
    throw input_error({.file = path.string(),
                       .wanted = "a kind of picture that can be written (png, exr)",
                       .found = output ? output->geterror() : OIIO::geterror()});
  const std::vector<unsigned char>& buffer = bytes.buffer();
  write_file_atomically(path, std::string_view(reinterpret_cast<const char*>(buffer.data()), buffer.size()));
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
    const OIIO::ImageSpec spec = input->spec();
    if (accept) accept({spec.width, spec.height, spec.nchannels, spec.format.is_floating_point()});
    Image image(spec.width, spec.height, spec.nchannels);
    decode(*input, OIIO::TypeDesc::FLOAT, image.values.data(), path);
    if (!spec.format.is_floating_point())
      for (float& value : image.values) value = linear_from_srgb(value);
    return image;
  });
}

PictureShape picture_shape(const fs::path& path) {
  return with_image_errors(path, [&] {
    const OIIO::ImageSpec spec = open_image(path)->spec();
    return PictureShape{spec.width, spec.height, spec.nchannels};
  });
}

ByteImage read_bytes_image(const fs::path& path) {
  return with_image_errors(path, [&] {
    const OpenedImage input = open_image(path);
    const OIIO::ImageSpec spec = input->spec();
    ByteImage image{spec.width, spec.height, spec.nchannels, {}};
    image.values.resize(static_cast<std::size_t>(spec.image_pixels()) *
                        static_cast<std::size_t>(spec.nchannels));
    decode(*input, OIIO::TypeDesc::UINT8, image.values.data(), path);
    return image;
  });
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
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const OpenedImage input(OIIO::ImageInput::create(format).release());
    OIIO::ImageSpec spec, wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    if (!input || !input->set_ioproxy(&memory) || !input->open("texture." + format, spec, wishes))
      throw input_error({.file = name,
                         .wanted = "an image that can be decoded",
                         .found = input ? input->geterror() : OIIO::geterror()});
    check_size(spec, format, bytes.size(), name);
    if (spec.nchannels > 4)
      throw input_error(
          {.file = name, .wanted = "1 to 4 channels", .found = fmt::format("{}", spec.nchannels)});
    ByteImage image{spec.width, spec.height, spec.nchannels, {}};
    image.values.resize(static_cast<std::size_t>(spec.image_pixels()) *
                        static_cast<std::size_t>(spec.nchannels));
    decode(*input, OIIO::TypeDesc::UINT8, image.values.data(), name);
    return image;
  });
}

WordImage read_word_image(const fs::path& path, const std::function<void(const WordImage&)>& accept) {
  return with_image_errors(path, [&] {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const OpenedImage input = open_image(path, wishes);
    if (std::string_view(input->format_name()) != "png")
      throw input_error(
          {.file = path.string(), .wanted = "a PNG file", .found = fmt::format("{}", input->format_name())});
    const OIIO::ImageSpec spec = input->spec();
    WordImage image{
        spec.width, spec.height, spec.nchannels, spec.format == OIIO::TypeDesc::UINT16 ? 16 : 8, {}};
    if (accept) accept(image);
    const auto count =
        static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels);
    if (image.bits == 16) {
      image.values.resize(count);
      decode(*input, OIIO::TypeDesc::UINT16, image.values.data(), path);
    } else {
      std::vector<std::uint8_t> bytes(count);
      decode(*input, OIIO::TypeDesc::UINT8, bytes.data(), path);
      image.values.assign(bytes.begin(), bytes.end());
    }
    return image;
  });
}

void write_picture_exr(const fs::path& path, const Image& image) {
  require_numbers(image, path.string());
  write_exr(path, image);
}

void write_exr(const fs::path& path, const Image& image) {
  OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::FLOAT);
  if (image.channels == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("DateTime", "");  // else the library writes the time of day
  write_image(path, spec, OIIO::TypeDesc::FLOAT, image.values.data());
}

void draw_text(ByteImage& image, int x, int y, const std::string& text, int height_px, std::uint8_t code) {
  static const std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (!fs::exists(font)) return;
  const OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::UINT8);
  OIIO::ImageBuf buffer(spec, image.values.data());
  const float grey = static_cast<float>(code) / 255.0F;
  const std::vector<float> colour(static_cast<std::size_t>(image.channels), grey);
  OIIO::ImageBufAlgo::render_text(buffer, x, y, text, height_px, font, colour);
}

void write_png(const fs::path& path, const ByteImage& image) {
  OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 3);  // a third of the time of the usual 6, 7 % more bytes
  write_image(path, spec, OIIO::TypeDesc::UINT8, image.values.data());
}

}  // namespace seamline
