#pragma once

namespace seamline::renderer {

/// Samples that the pixels of a picture took: not the same where the picture's error decides.
struct SamplesTaken {
  int least = 0, most = 0;
  double mean = 0;
};

}  // namespace seamline::renderer
