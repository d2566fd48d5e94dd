#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "support/codec/hdr_header.h"
#include "support/codec/picture_channels.h"
#include "support/codec/picture_codec.h"
#include "support/text/error.h"

namespace seamline {

/// A picture whose header was read and is bearable.
struct OpenedPicture {
  std::unique_ptr<std::string> bytes;  ///< that the reader reads from; null: from the file
  std::unique_ptr<PictureReader> reader;
  CodedPicture picture;  ///< of the part that is open
  HdrHeader hdr;         ///< of Radiance files

  [[nodiscard]] std::size_t values() const {
    return static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px) *
           static_cast<std::size_t>(picture.channels);
  }
};

/// Opens a file of pixels: EXR, HDR, PNG, JPEG or TIFF, by its first bytes. With `alpha_apart` colours are
/// not multiplied by alpha. Throws InputError naming the file: no such file, another kind, a damaged header,
/// more pixels than are bearable or than a file of this size can hold.
[[nodiscard]] OpenedPicture open_picture(const std::filesystem::path& path, bool alpha_apart = false);

/// The same of bytes that live longer than what is returned; `format` is `picture_format` of them.
[[nodiscard]] OpenedPicture open_picture(std::string_view bytes, const std::string& format, bool alpha_apart,
                                         const std::string& name);

/// The library's name of the format that bytes begin like. Throws InputError at another kind of file.
[[nodiscard]] std::string picture_format(std::string_view bytes, const std::string& name);

/// Goes to the part in which channels are, which is looked at as the first one was.
void open_part(OpenedPicture& opened, int part, const std::filesystem::path& path);

/// Every channel of every part. The part that is open stays open.
[[nodiscard]] std::vector<NamedChannel> channels_of(OpenedPicture& opened, const std::filesystem::path& path);

/// Decodes all channels of the open part. Throws InputError at damaged pixels, Interrupted at Ctrl-C.
void decode(const OpenedPicture& opened, float* values, const std::filesystem::path& name);
void decode(const OpenedPicture& opened, std::uint16_t* values, const std::filesystem::path& name);
void decode(const OpenedPicture& opened, std::uint8_t* values, const std::filesystem::path& name);

/// Runs `read`; what the image libraries throw at damaged bytes becomes an InputError.
template <class Read>
auto with_picture_errors(const std::filesystem::path& path, Read&& read) {
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

}  // namespace seamline
