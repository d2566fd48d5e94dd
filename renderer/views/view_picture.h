#pragma once
#include "raytracer/scene/camera.h"
#include "stimuli/definition/views/view.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What people are shown of the picture of a view's camera (`view_camera`), linear. Of a depth image the
/// picture without its depth.
[[nodiscard]] Image compose_view(const View& view, const Image& all_eyes);

/// The picture of a view's camera with what people are shown in place of each eye's picture, where one
/// picture shows all eyes: it is repeated for each, so that an error of it has its place in the camera's
/// picture.
[[nodiscard]] Image shown_to_each_eye(const View& view, Image all_eyes);

/// The bytes that people are shown of what `compose_view` made, with the codes of depth beside a depth image,
/// which has `planar_m`. Other kinds look at no depth.
[[nodiscard]] ByteImage shown_bytes(const View& view, const Image& picture, double exposure_ev,
                                    const Image& planar_m);

/// One eye's panorama of those that stand one above the other, counted from the left; of other views'
/// pictures the whole.
[[nodiscard]] ByteImage eye_of(const View& view, const ByteImage& all_eyes, int eye);

/// Which object a click means, of the click map of a view's camera (0 background, objects from 1). Where one
/// pixel shows several eyes, the object that most of them see there, the left one of equals; the background
/// only where all see it. Depth beside a picture is background: nothing is chosen there.
[[nodiscard]] ByteImage view_click_map(const View& view, const ByteImage& all_eyes);

}  // namespace seamline::renderer
