#pragma once
#include "composites/place/place_request.h"

namespace seamline::place {

/// Shows the photograph with its objects in a window, until the person closes it; saves the file of objects
/// when asked to. Throws InputError where there is no screen, or something is wrong with what was asked.
void place_in_window(const renderer::PlaceRequest& request);

}  // namespace seamline::place
