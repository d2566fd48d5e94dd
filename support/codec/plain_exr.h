#pragma once
#include <memory>
#include <string>
#include <vector>

#include "support/codec/picture_codec.h"

namespace seamline {

/// Reads plain EXR files (`plain_pictures.h`) whose headers `check_exr_header` found whole; complains of all
/// others, and of bytes in memory.
[[nodiscard]] std::unique_ptr<PictureReader> plain_exr_reader();

/// Floats of 1 or 3 channels as an EXR file's bytes, packed by zip. Sets `complaint` when `stop` said so.
[[nodiscard]] std::vector<unsigned char> encode_plain_exr(const PictureToEncode& picture, bool (*stop)(),
                                                          std::string& complaint);

}  // namespace seamline
