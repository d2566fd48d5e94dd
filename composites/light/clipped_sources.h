#pragma once
#include "raytracer/tracing/geometry.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Light sources of a panorama of codes that are white, and so as bright as codes go, not as they were.
struct ClippedSources {
  double share = 0;           ///< of all directions
  double factor = 1;          ///< by which they have to be brighter, at least
  double factor_of_grey = 1;  ///< with which half of the surfaces they reach have an albedo of 0.5 at most
};

/// The least factor k with which no photographed surface needs to be more than white. A surface that sends B
/// receives R from all that is not clipped and S from what is (both as what a white one would send), so that
/// its albedo is B / (R + k S), and k = (B - R) / S where that is 1, in the colour that asks for most. Of the
/// surfaces that the clipped sources reach (with a tenth at least of what those receive that they reach
/// best), the fiftieth with the largest k (by solid angle) is left out: mirrors, and noise of depth. True
/// sources are brighter than that where no surface is white: with albedo a over all colours, k = (B / a - R)
/// / S, of which `factor_of_grey` is the median for 0.5. `white`: the radiance of the largest code; `local`:
/// the local scene. The same for any number of threads.
[[nodiscard]] ClippedSources find_clipped_sources(const Image& panorama, const Geometry& local, float white,
                                                  int threads);

/// Makes them so many times as bright.
void raise_clipped_sources(Image& panorama, float white, double factor);

}  // namespace seamline::renderer
