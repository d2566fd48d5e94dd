#pragma once
#include "raytracer/common/byte_stream.h"
#include "renderer/picture/scene_sums.h"

namespace seamline::renderer {

/// The sums of a truth pass for another process.
void write_sums(const SceneSums& sums, ByteWriter& out);

/// Into `sums`, which are empty ones of the same camera. False when the bytes are none of these, or are not
/// all used.
[[nodiscard]] bool read_sums(ByteReader& in, SceneSums& sums);

}  // namespace seamline::renderer
