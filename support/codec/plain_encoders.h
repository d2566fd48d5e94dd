#pragma once
#include <optional>
#include <vector>

#include "support/codec/picture_codec.h"

namespace seamline {

constexpr int rows_between_questions =
    64;  ///< so often a plain picture's reader and writer ask whether to stop

/// Codes of 1 or 3 channels as PNG; none: `stop` said so, or it could not.
[[nodiscard]] std::optional<std::vector<unsigned char>> encode_plain_png(const PictureToEncode& picture,
                                                                         bool (*stop)());

/// Floats of 1 or 3 channels as EXR, packed by zip; none: `stop` said so.
[[nodiscard]] std::optional<std::vector<unsigned char>> encode_plain_exr(const PictureToEncode& picture,
                                                                         bool (*stop)());

}  // namespace seamline
