#pragma once
#include "live/frame/live_eye.h"

namespace seamline::live {

/// The real world from another eye (paper 000, section 3.2): the local scene, on which the colour picture is
/// projected. Each pixel shows what the colour camera saw of its point, linear between two pixels; black
/// where there is no local scene, or where the colour camera shows nothing. `eye.view` says which eye: it
/// lies beside the camera and looks the same way (`eye_view`), so that a point keeps its row. `eye.real`
/// becomes the local scene's depth.
void draw_other_eye(const renderer::TriangleSpan& local_scene, const renderer::DrawView& colour_view,
                    const ByteImage& colour, int threads, LiveEye& eye);

}  // namespace seamline::live
