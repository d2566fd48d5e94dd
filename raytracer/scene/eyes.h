#pragma once
#include "raytracer/scene/camera.h"
#include "stimuli/definition/views/view.h"

namespace seamline::renderer {

/// The camera of a view: its eyes' pictures side by side, each of the field of view of `centre`. Eye k of N
/// stands (k - (N - 1) / 2) separations along the camera's right vector (paper 000, section 3.2), and its
/// frustum leans so that all meet in the window at the zero-parallax distance Z: a point X to the right and d
/// in front of the camera's place is seen by an eye e to the right at the tangent (X - e) / d + e / Z. Two
/// eyes b apart therefore see it b (1 / d - 1 / Z) apart, whatever X. Of a mono view `centre` itself.
///
/// Of a panorama: omnidirectional stereo (Peleg, Ben-Ezra and Pritch 2001), each eye's whole panorama, one
/// above the other. For every azimuth the eyes stand beside the axis as they do in a head that faces it: a
/// ray of azimuth a begins at e (cos a, 0, sin a). A point of azimuth A, at a horizontal distance d from the
/// axis and a height h, is seen at the azimuth A - asin(e / d), at the elevation atan(h / sqrt(d^2 - e^2)).
/// Where parallax is the depth mesh's, one more panorama lies below them, from the axis.
[[nodiscard]] Camera view_camera(const Camera& centre, const View& view);

/// The camera of one eye at the origin from which `view_camera` made this one.
[[nodiscard]] Camera centre_camera(const Camera& camera);

}  // namespace seamline::renderer
