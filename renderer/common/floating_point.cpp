#include "renderer/common/floating_point.h"

#include <immintrin.h>

namespace seamline::renderer {

void flush_denormals_to_zero() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

}  // namespace seamline::renderer
