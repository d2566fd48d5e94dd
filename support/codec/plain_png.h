#pragma once
#include <memory>
#include <string>
#include <vector>

#include "support/codec/picture_codec.h"

namespace seamline {

/// Reads plain PNG files (`plain_pictures.h`) that `check_png` found whole; complains of all others.
[[nodiscard]] std::unique_ptr<PictureReader> plain_png_reader();

/// Codes of 1 or 3 channels as a PNG file's bytes. Sets `complaint` when `stop` said so, or it could not.
[[nodiscard]] std::vector<unsigned char> encode_plain_png(const PictureToEncode& picture, bool (*stop)(),
                                                          std::string& complaint);

}  // namespace seamline
