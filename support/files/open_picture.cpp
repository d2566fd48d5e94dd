#include "support/files/open_picture.h"

#include <fmt/core.h>

#include <array>
#include <fstream>
#include <sstream>

#include "support/codec/exr_header.h"
#include "support/codec/plain_pictures.h"
#include "support/codec/png_file.h"
#include "support/files/atomic_file.h"
#include "support/files/picture_library.h"
#include "support/running/interrupt.h"
#include "support/text/limits.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

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
  // EXR files hold a renderer's whole output, of which a few channels are kept.
  constexpr int most_exr_channels = 128;
  const int most_channels = picture.format == "openexr" ? most_exr_channels : largest_picture_channels;
  const bool sides = picture.width_px >= 1 && picture.width_px <= largest_picture_side_px &&
                     picture.height_px >= 1 && picture.height_px <= largest_picture_side_px &&
                     picture.channels >= 1 && picture.channels <= most_channels;
  if (!sides ||
      std::int64_t{picture.width_px} * picture.height_px * picture.channels > largest_picture_values)
    throw refuse(fmt::format("a picture of at most {0} x {0} pixels with {1} channels, and {2} values in all",
                             largest_picture_side_px, most_channels, largest_picture_values),
                 found);
  if (picture.shown_width_px < 1 || picture.shown_width_px > largest_picture_side_px ||
      picture.shown_height_px < 1 || picture.shown_height_px > largest_picture_side_px ||
      std::int64_t{picture.shown_width_px} * picture.shown_height_px * picture.channels >
          largest_picture_values)
    throw refuse(fmt::format("a display window of at most {0} x {0} pixels", largest_picture_side_px),
                 fmt::format("{} x {}", picture.shown_width_px, picture.shown_height_px));
  if (picture.bytes / largest_expansion(picture) > file_bytes)
    throw refuse(fmt::format("a file that can hold {}", found), fmt::format("{} bytes", file_bytes));
}

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
OpenedPicture open_with(const std::string& format, bool alpha_apart, const Where& where,
                        std::uint64_t file_bytes, const std::string& name) {
  OpenedPicture opened{.bytes = {}, .reader = plain_reader(format), .picture = {}, .hdr = {}};
  if (!opened.reader || !opens(*opened.reader, where)) {
    opened.reader = picture_codec().reader(format, alpha_apart);
    if (const std::string complaint = opened.reader->open(where); !complaint.empty())
      throw input_error({.file = name, .wanted = "an image that can be decoded", .found = complaint});
  }
  opened.picture = opened.reader->picture();
  check_size(opened.picture, file_bytes, name);
  return opened;
}

std::string format_of_file(const fs::path& path) {
  std::array<char, 12> block{};
  std::ifstream in(path, std::ios::binary);
  if (!in) static_cast<void>(read_file(path));  // which says why it cannot be read
  in.read(block.data(), block.size());
  return picture_format(std::string_view(block.data(), static_cast<std::size_t>(in.gcount())), path.string());
}

/// Lines of columns and CIE XYZ the library does not know: it gets the same pixels behind a header that it
/// knows, and they are turned and converted afterwards.
std::string as_usual_hdr(const fs::path& path, const HdrHeader& header) {
  std::ostringstream bytes;
  bytes << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << header.lines << " +X " << header.line_px << '\n';
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header.pixels_at));
  bytes << in.rdbuf();
  return std::move(bytes).str();
}

template <class Value>
void decode_values(const OpenedPicture& opened, Value* values, const fs::path& name) {
  const std::string complaint = opened.reader->read(values, interrupted);
  stop_if_interrupted();
  if (!complaint.empty())
    throw input_error({.file = name.string(), .wanted = "an image that can be decoded", .found = complaint});
}

}  // namespace

/// The library's other two dozen formats are never tried, whatever a file is called: each would be one more
/// decoder that strangers' bytes reach.
std::string picture_format(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x76\x2f\x31\x01")) return "openexr";
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "png";
  if (bytes.starts_with("\xff\xd8\xff")) return "jpeg";
  if (bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE")) return "hdr";
  constexpr std::string_view little("II*\0", 4), big("MM\0*", 4);
  if (bytes.starts_with(little) || bytes.starts_with(big)) return "tiff";
  throw input_error(
      {.file = name, .wanted = "an EXR, HDR, PNG, JPEG or TIFF image", .found = "another kind of file"});
}

OpenedPicture open_picture(const fs::path& path, bool alpha_apart) {
  if (!fs::is_regular_file(path))
    throw input_error({.file = path.string(),
                       .wanted = "an image file",
                       .found = fs::is_directory(path) ? "a folder" : "no such file"});
  const std::string format = format_of_file(path);
  const auto file_bytes = static_cast<std::uint64_t>(fs::file_size(path));
  if (format == "openexr") check_exr_header(path);
  if (format == "png") check_png(path);
  if (format != "hdr") return open_with(format, alpha_apart, path.string(), file_bytes, path.string());
  const HdrHeader header = read_hdr_header(path);
  OpenedPicture opened;
  if (header.xyz || header.orientation >= 5) {
    auto bytes = std::make_unique<std::string>(as_usual_hdr(path, header));
    opened = open_with(format, alpha_apart, std::string_view(*bytes), bytes->size(), path.string());
    opened.bytes = std::move(bytes);
  } else {
    opened = open_with(format, alpha_apart, path.string(), file_bytes, path.string());
  }
  opened.hdr = header;
  opened.picture.orientation = header.orientation;
  return opened;
}

OpenedPicture open_picture(std::string_view bytes, const std::string& format, bool alpha_apart,
                           const std::string& name) {
  return open_with(format, alpha_apart, bytes, bytes.size(), name);
}

void open_part(OpenedPicture& opened, int part, const fs::path& path) {
  if (const std::string complaint = opened.reader->open_part(part); !complaint.empty())
    throw input_error({.file = path.string(), .wanted = "an image that can be decoded", .found = complaint});
  opened.picture = opened.reader->picture();
  check_size(opened.picture, static_cast<std::uint64_t>(fs::file_size(path)), path.string());
}

std::vector<NamedChannel> channels_of(OpenedPicture& opened, const fs::path& path) {
  std::vector<NamedChannel> channels;
  const std::vector<std::string> parts = opened.picture.parts;
  if (parts.empty()) {
    append_channels(opened.picture.channel_names, "", 0, channels);
    return channels;
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto index = static_cast<int>(part);
    if (const std::string complaint = opened.reader->open_part(index); !complaint.empty())
      throw input_error(
          {.file = path.string(), .wanted = "an image that can be decoded", .found = complaint});
    append_channels(opened.reader->picture().channel_names, parts[part], index, channels);
  }
  (void)opened.reader->open_part(0);
  return channels;
}

void decode(const OpenedPicture& opened, float* values, const fs::path& name) {
  decode_values(opened, values, name);
}
void decode(const OpenedPicture& opened, std::uint16_t* values, const fs::path& name) {
  decode_values(opened, values, name);
}
void decode(const OpenedPicture& opened, std::uint8_t* values, const fs::path& name) {
  decode_values(opened, values, name);
}

}  // namespace seamline
