#pragma once
#include <cstdint>

namespace seamline::renderer {

/// Rays that this thread has traced; read it by `rays_traced_by_this_thread`.
inline thread_local std::int64_t rays_traced = 0;

}  // namespace seamline::renderer
