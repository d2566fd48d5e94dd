#pragma once
#include <filesystem>
#include <vector>

#include "stimuli/pictures/distance_transform.h"
#include "stimuli/set/manifest.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What a place of a scene needs so that no inserted object shows a seam there.
enum class GeometryNeed : std::uint8_t {
  nothing,  ///< no object, and no seam at any width
  coarse,   ///< a depth map of at most `coarse_px`
  fine,     ///< at most `fine_px`
  mask      ///< more than that, or no width of the set: to be masked, matted or modelled
};

struct ArtistsRule {
  int coarse_px = 256, fine_px = 1024;  ///< widths of depth maps
  int seam_step = 8;                    ///< a seam is more than so many steps of 255 beyond noise
  int least_px = 8;                     ///< and so many pixels that touch: fewer are what is left of noise
  double reach_deg =
      0.15;  ///< a seam is painted so far around itself: a region, and not a line, is to be worked on
};

/// The set without its connected parts (eight neighbours) of fewer than `least_px` pixels.
[[nodiscard]] PixelSet without_specks(const PixelSet& set, int least_px);

/// Where each stimulus of one reference has a seam, at its width.
struct SeamAtWidth {
  int width_px = 0;
  PixelSet seam;
};
/// The need of every pixel, row by row. A pixel needs the smallest width of those given from which on no
/// wider map has a seam there. `objects`: pixels that show an object.
[[nodiscard]] std::vector<GeometryNeed> geometry_needs(const std::vector<SeamAtWidth>& seams,
                                                       const PixelSet& objects, const ArtistsRule& rule,
                                                       int reach_px);

/// The reference, grey, and over it the needs in colours that people with any colour vision tell apart by
/// their lightness; what needs a mask is hatched too. Below it a legend with the share of each.
[[nodiscard]] ByteImage artists_picture(const ByteImage& reference, const std::vector<GeometryNeed>& needs,
                                        const ArtistsRule& rule);

/// Writes `artists-TRUTH.png` for every reference of a set into a folder and returns what was written. All
/// artifacts and objects count; of the conditions only those that hide nothing by a mitigation. Throws
/// InputError when the set's levels are no widths, or no width is as small as `coarse_px` or as large as
/// `fine_px`.
std::vector<std::filesystem::path> write_artists_maps(const std::filesystem::path& folder,
                                                      const std::filesystem::path& set_folder,
                                                      const ArtistsRule& rule);

}  // namespace seamline::renderer
