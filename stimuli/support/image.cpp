// The only file that includes OpenImageIO.
#include "stimuli/support/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "stimuli/support/atomic_file.h"
#include "stimuli/support/error.h"
#include "stimuli/support/exr_header.h"
#include "stimuli/support/interrupt.h"
#include "stimuli/support/limits.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

/// The library's name of the format that a file begins like. Its other two dozen formats are never tried,
/// whatever a file is called: each would be one more decoder that strangers' bytes reach.
std::string format_of(const fs::path& path) {
  std::array<char, 12> block{};
  std::ifstream in(path, std::ios::binary);
  in.read(block.data(), block.size());
  const std::string_view start(block.data(), static_cast<std::size_t>(in.gcount()));
  if (start.starts_with("\x76\x2f\x31\x01")) return "openexr";
  if (start.starts_with("\x89PNG\r\n\x1a\n")) return "png";
  if (start.starts_with("\xff\xd8\xff")) return "jpeg";
  if (start.starts_with("#?RADIANCE") || start.starts_with("#?RGBE")) return "hdr";
  throw input_error(
      {.file = path.string(), .wanted = "an EXR, HDR, PNG or JPEG image", .found = "another kind of file"});
}

/// Throws InputError unless what the header promises is bearable, and can be in a file of this size.
void check_size(const OIIO::ImageSpec& spec, const fs::path& path) {
  using namespace limits;
  const auto refuse = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = path.string(), .wanted = wanted, .found = found});
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
  const auto file_bytes = static_cast<std::uint64_t>(fs::file_size(path));
  if (std::uint64_t{spec.image_bytes(true)} / largest_picture_expansion > file_bytes)
    throw refuse(fmt::format("a file that can hold {}", found), fmt::format("{} bytes", file_bytes));
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  if (!fs::is_regular_file(path))
    throw input_error({.file = path.string(), .wanted = "an image file", .found = "no such file"});
  const std::string format = format_of(path);
  if (format == "openexr") check_exr_header(path);
  auto input = OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  if (!input || !input->open(path.string(), spec))
    throw input_error({.file = path.string(),
                       .wanted = "an image that can be decoded",
                       .found = input ? input->geterror() : OIIO::geterror()});
  check_size(spec, path);
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

void decode(OIIO::ImageInput& input, OIIO::TypeDesc type, void* values, const fs::path& path) {
  const bool decoded = input.read_image(0, 0, 0, input.spec().nchannels, type, values, OIIO::AutoStride,
                                        OIIO::AutoStride, OIIO::AutoStride, stop_here);
  stop_if_interrupted();
  if (!decoded)
    throw input_error(
        {.file = path.string(), .wanted = "an image that can be decoded", .found = input.geterror()});
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

ByteImage display_image(const Image& linear, double exposure_ev) {
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  ByteImage out{linear.width_px, linear.height_px, linear.channels, {}};
  out.values.reserve(linear.values.size());
  for (const float value : linear.values)
    out.values.push_back(code_from_display(srgb_from_linear(value * gain)));
  return out;
}

Image read_float_image(const fs::path& path) {
  with_image_errors(path, [&] {
    if (const auto input = open_image(path); !input->spec().format.is_floating_point())
      throw input_error({.file = path.string(),
                         .wanted = "an image of floating-point values",
                         .found = input->spec().format.c_str()});
  });
  return read_image(path);
}

Image read_image(const fs::path& path) {
  return with_image_errors(path, [&] {
    const auto input = open_image(path);
    const OIIO::ImageSpec spec = input->spec();
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
    const auto input = open_image(path);
    const OIIO::ImageSpec spec = input->spec();
    ByteImage image{spec.width, spec.height, spec.nchannels, {}};
    image.values.resize(static_cast<std::size_t>(spec.image_pixels()) *
                        static_cast<std::size_t>(spec.nchannels));
    decode(*input, OIIO::TypeDesc::UINT8, image.values.data(), path);
    return image;
  });
}

void write_exr(const fs::path& path, const Image& image) {
  OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::FLOAT);
  if (image.channels == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
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
