#pragma once
#include <filesystem>

namespace seamline::inline stimuli {

/// Writes every clip of a set, and every reference, as an uncompressed video `OUT/NAME.y4m` (YUV4MPEG2,
/// 4:4:4, full range, ITU-R BT.709) for programs that measure video. Y, U and V are rounded to 8 bits, so
/// codes may come back one off: the set's clips stay what people see. Returns how many were written. Throws
/// InputError when the set is one of stills.
int write_videos(const std::filesystem::path& set_folder, const std::filesystem::path& out_folder);

}  // namespace seamline::inline stimuli
