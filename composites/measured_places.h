#pragma once
#include <span>
#include <string>
#include <vector>

#include "composites/photo_view.h"

namespace seamline::renderer {

/// A place of the picture whose distance a person knows.
struct MeasuredPlace {
  double across = 0, down = 0;  ///< shares of the picture's width and height
  double distance_m = 0;        ///< from the camera, as a tape measures it
};

/// The same as --depth-point takes them: pixels of the photograph's file (of the panorama, where the picture
/// is a view of it), to a tenth; distances in the map's convention, so along the axis where the map has the
/// photograph's own view and nothing else is said, to a tenth of a millimetre.
[[nodiscard]] std::vector<sensors::KnownPoint> known_points(std::span<const MeasuredPlace> places,
                                                            const SeenPhoto& seen,
                                                            const PhotoDepthRequest& request);

/// " --depth-point 812.4,640,2.1 --depth-point ...", which reads back as the same numbers.
[[nodiscard]] std::string point_options(std::span<const sensors::KnownPoint> points);

}  // namespace seamline::renderer
