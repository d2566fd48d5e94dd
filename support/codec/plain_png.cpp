#include "support/codec/plain_png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "support/codec/plain_pictures.h"

namespace seamline {
namespace {

constexpr std::size_t signature_bytes = 8, around_chunk_bytes = 12;  // length, type and sum

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return number;
}

struct PngHeader {
  std::uint32_t width_px, height_px;
  int channels;
};

/// Of a plain picture; none: it is another.
std::optional<PngHeader> plain_header(std::string_view bytes) {
  constexpr std::size_t width = 16, height = 20, bits = 24, colour = 25, interlacing = 28, end = 33;
  constexpr char grey = 0, rgb = 2;
  if (bytes.size() < end || bytes[bits] != 8 || bytes[interlacing] != 0) return {};
  if (bytes[colour] != grey && bytes[colour] != rgb) return {};
  // Transparency, colours of another kind, and text in which cameras leave an orientation.
  for (std::size_t at = signature_bytes; at + around_chunk_bytes <= bytes.size();
       at += around_chunk_bytes + number_at(bytes, at)) {
    const std::string_view type = bytes.substr(at + 4, 4);
    if (type == "tRNS" || type == "iCCP" || type == "eXIf" || type == "zTXt" || type == "iTXt") return {};
    if (type == "tEXt" && bytes.substr(at + 8).starts_with("Orientation")) return {};
  }
  return PngHeader{number_at(bytes, width), number_at(bytes, height), bytes[colour] == rgb ? 3 : 1};
}

[[noreturn]] void jump_back(png_structp png, png_const_charp why) {
  auto& complaint = *static_cast<std::string*>(png_get_error_ptr(png));
  complaint = why;
  std::longjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)), 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (count > left.size()) png_error(png, "one that ends early");
  std::memcpy(to, left.data(), count);
  left.remove_prefix(count);
}

void give_bytes(png_structp png, png_bytep from, std::size_t count) {
  auto& bytes = *static_cast<std::vector<unsigned char>*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), from, from + count);
}

void flush_nothing(png_structp) {}

/// Rows are asked for or given one at a time; false: something was wrong, or `stop` said so. Everything that
/// has a destructor lies in the caller, because libpng leaves by a long jump.
template <class EachRow>
bool for_each_row(png_uint_32 rows, bool (*stop)(), EachRow each_row) {
  for (png_uint_32 row = 0; row < rows; ++row) {
    if (row % rows_between_questions == 0 && stop && stop()) return false;
    each_row(row);
  }
  return true;
}

bool decode_rows(png_structp png, png_infop info, const PngHeader& header, std::uint8_t* codes,
                 bool (*stop)()) {
  if (setjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)))) return false;
  png_read_info(png, info);
  const std::size_t row_bytes = std::size_t{header.width_px} * static_cast<std::size_t>(header.channels);
  if (png_get_rowbytes(png, info) != row_bytes) png_error(png, "another header than it began with");
  return for_each_row(header.height_px, stop,
                      [&](png_uint_32 row) { png_read_row(png, codes + row * row_bytes, nullptr); });
}

class PngReader final : public PictureReader {
 public:
  std::string open(const std::string& path) override {
    constexpr std::uintmax_t largest_bytes = 1U << 30U;  // the file is read whole
    if (std::filesystem::file_size(path) > largest_bytes) return not_plain;
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return take(std::move(bytes).str());
  }
  std::string open(std::string_view bytes) override { return take(std::string(bytes)); }

  CodedPicture picture() const override {
    CodedPicture picture;
    picture.width_px = static_cast<int>(header_.width_px);
    picture.height_px = static_cast<int>(header_.height_px);
    picture.channels = header_.channels;
    picture.bytes = values();
    picture.format = "png";
    picture.channel_names =
        header_.channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
    picture.shown_width_px = picture.width_px;
    picture.shown_height_px = picture.height_px;
    return picture;
  }

  std::string read(float* out, bool (*stop)()) override {
    std::vector<std::uint8_t> codes(values());
    const std::string complaint = read(codes.data(), stop);
    constexpr float step = 1.0F / 255.0F;
    std::transform(codes.begin(), codes.end(), out, [](std::uint8_t code) { return code * step; });
    return complaint;
  }

  std::string read(std::uint16_t* out, bool (*stop)()) override {
    std::vector<std::uint8_t> codes(values());
    const std::string complaint = read(codes.data(), stop);
    std::transform(codes.begin(), codes.end(), out,
                   [](std::uint8_t code) { return static_cast<std::uint16_t>(code * 257); });
    return complaint;
  }

  std::string read(std::uint8_t* out, bool (*stop)()) override {
    std::string complaint;
    std::string_view left = bytes_;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint, jump_back, ignore_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    bool whole = false;
    if (info) {
      png_set_read_fn(png, &left, take_bytes);
      whole = decode_rows(png, info, header_, out, stop);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    if (!whole && complaint.empty()) complaint = was_stopped;
    return complaint;
  }

 private:
  std::string take(std::string bytes) {
    const std::optional<PngHeader> header = plain_header(bytes);
    if (!header) return not_plain;
    header_ = *header;
    bytes_ = std::move(bytes);
    return {};
  }

  [[nodiscard]] std::size_t values() const {
    return std::size_t{header_.width_px} * header_.height_px * static_cast<std::size_t>(header_.channels);
  }

  std::string bytes_;
  PngHeader header_{};
};

/// Chunks as the picture library writes them, in its order, so that pictures of older versions keep their
/// bytes.
bool encode_rows(png_structp png, png_infop info, const PictureToEncode& picture, bool (*stop)()) {
  if (setjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)))) return false;
  const auto width = static_cast<png_uint_32>(picture.width_px);
  const auto height = static_cast<png_uint_32>(picture.height_px);
  constexpr int quick = 3;  // a third of the time of the usual 6, 7 % more bytes
  png_set_compression_level(png, quick);
  png_set_compression_strategy(png, 0);
  png_set_filter(png, 0, PNG_NO_FILTERS);
  png_set_IHDR(png, info, width, height, 8, picture.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
  if (picture.profile.empty())
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  else
    png_set_iCCP(png, info, "ICC profile", PNG_COMPRESSION_TYPE_BASE,
                 reinterpret_cast<png_const_bytep>(picture.profile.data()),
                 static_cast<png_uint_32>(picture.profile.size()));
  std::array<char, 16> key{"oiio:ColorSpace"};
  std::array<char, 5> value{"sRGB"};
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = key.data();
  text.text = value.data();
  text.text_length = value.size() - 1;
  if (picture.profile.empty()) png_set_text(png, info, &text, 1);
  png_write_info(png, info);
  const std::size_t row_bytes = std::size_t{width} * static_cast<std::size_t>(picture.channels);
  const bool all = for_each_row(
      height, stop, [&](png_uint_32 row) { png_write_row(png, picture.codes + row * row_bytes); });
  if (all) png_write_end(png, info);
  return all;
}

}  // namespace

std::unique_ptr<PictureReader> plain_png_reader() {
  return std::make_unique<PngReader>();
}

std::vector<unsigned char> encode_plain_png(const PictureToEncode& picture, bool (*stop)(),
                                            std::string& complaint) {
  std::vector<unsigned char> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, jump_back, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool whole = false;
  if (info) {
    png_set_write_fn(png, &bytes, give_bytes, flush_nothing);
    whole = encode_rows(png, info, picture, stop);
  }
  png_destroy_write_struct(&png, &info);
  if (!whole && complaint.empty()) complaint = was_stopped;
  return bytes;
}

}  // namespace seamline
