#pragma once

namespace seamline::sensors {

/// What a mesh of depth does between neighbouring pixels whose distances differ by more than a ratio.
enum class Jumps {
  stretch,  ///< one sheet from the near thing to the far one (paper 000)
  cut,      ///< no triangle: a hole opens instead
  layer     ///< nothing, with a second surface behind it, which the truth gives
};

}  // namespace seamline::sensors
