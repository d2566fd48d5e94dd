#pragma once

namespace seamline::renderer {

/// Denormal numbers become zero on the calling thread (SSE flush-to-zero and denormals-are-zero); every
/// worker calls it.
void flush_denormals_to_zero();

}  // namespace seamline::renderer
