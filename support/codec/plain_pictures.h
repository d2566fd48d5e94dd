#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/codec/picture_codec.h"

namespace seamline {

/// Plain pictures are what Seamline writes, and most of what it reads: PNG of 8 bits, grey or RGB, without
/// palette, transparency, interlacing or camera data; EXR of one part in scan lines, R G B or one channel,
/// packed without loss. libpng and OpenEXR read and write them themselves, with the same values and the same
/// bytes as the picture library, whose 250 libraries then need not be loaded (half a second of every
/// command).

/// A reader of a plain PNG file of these bytes, which `check_png` found whole; null: it is no plain one.
[[nodiscard]] std::unique_ptr<PictureReader> plain_png_reader(std::string bytes);

/// A reader of a plain EXR file whose header `check_exr_header` found whole; null: it is no plain one.
[[nodiscard]] std::unique_ptr<PictureReader> plain_exr_reader(const std::string& path);

/// The file's bytes, without any date; none: this is no plain picture, or `stop` said so.
[[nodiscard]] std::optional<std::vector<unsigned char>> encode_plain(const PictureToEncode& picture,
                                                                     bool (*stop)());

}  // namespace seamline
