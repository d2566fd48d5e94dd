#pragma once
#include <memory>
#include <string>
#include <vector>

#include "support/codec/picture_codec.h"

namespace seamline {

/// Plain pictures are what Seamline writes, and most of what it reads: PNG of 8 bits, grey or RGB, without
/// palette, transparency, interlacing or camera data; EXR of one part in scan lines, R G B or one channel,
/// packed without loss. libpng and OpenEXR read and write them themselves, with the same values and the same
/// bytes as the picture library, whose 250 libraries then need not be loaded (half a second of every
/// command).

constexpr char not_plain[] = "one that is not plain";  ///< the complaint of a reader whose file is another

/// A reader of plain pictures of a format, which complains when it opens another; null: the format has none.
[[nodiscard]] std::unique_ptr<PictureReader> plain_reader(const std::string& format);

/// Whether a picture that is to be encoded is plain.
[[nodiscard]] bool is_plain(const PictureToEncode& picture);

/// As `PictureCodec::encode`; of a plain picture.
[[nodiscard]] std::vector<unsigned char> encode_plain(const PictureToEncode& picture, bool (*stop)(),
                                                      std::string& complaint);

constexpr int rows_between_questions = 64;  ///< so often readers and encoders ask whether to stop
constexpr char was_stopped[] = "one whose reading or writing was stopped";  ///< their complaint then

}  // namespace seamline
