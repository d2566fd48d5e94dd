#pragma once
#include <vector>

#include "composites/photo_view.h"
#include "composites/place/place_request.h"

namespace seamline::place {

/// Whether depth is an estimate of which nobody said where its scale and shift come from.
[[nodiscard]] bool needs_measuring(const renderer::PhotoDepthRequest& depth);

/// Shows the photograph, and lets a person click places and type their distances, until scale and shift are
/// known (`sensors::fit_depth`); the line and its errors are shown as soon as there are two. Empty: the
/// window was left. Throws InputError where there is no screen or the map cannot be read.
[[nodiscard]] std::vector<sensors::KnownPoint> measure_in_window(const renderer::PlaceRequest& request,
                                                                 const renderer::SeenPhoto& seen);

}  // namespace seamline::place
