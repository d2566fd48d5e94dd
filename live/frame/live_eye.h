#pragma once
#include <cstdint>
#include <vector>

#include "live/frame/methods.h"
#include "live/frame/shadow_answers.h"
#include "renderer/realtime/depth_picture.h"
#include "sensors/camera/pinhole_camera.h"
#include "support/files/image.h"

namespace seamline::live {

/// A picture of the real world from an eye, into which virtual things are put.
struct LiveEye {
  renderer::DrawView view;            ///< of the eye, in the frame of the scene
  renderer::DepthPicture real;        ///< planar depth of what its pixels show; infinity: not known
  renderer::DepthPicture ghosts;      ///< the same of the local scene, where `Occlusion::ghosts` asks for it
  ByteImage codes;                    ///< sRGB, 3 channels
  std::vector<std::uint8_t> covered;  ///< 1 where a pixel shows a virtual thing
};

/// The view of a camera without a lens, moved to the right by `right_m`. What is `zero_parallax_m` away keeps
/// its pixel (an off-axis frustum; infinity: parallel eyes).
[[nodiscard]] renderer::DrawView eye_view(const sensors::PinholeCamera& camera,
                                          const Eigen::Isometry3d& world_from_camera, double right_m,
                                          double zero_parallax_m);

/// What virtual things look like, and who hides them.
struct ObjectPass {
  const LiveScene& scene;
  const ShadowAnswers& shadows;
  Occlusion occlusion = Occlusion::depth_test;
  const renderer::Geometry* local_scene = nullptr;  ///< of `Occlusion::mesh`
  int threads = 1;
};

/// Draws the virtual things: a ray through each pixel's centre, of those pixels in which their boxes lie;
/// diffuse, lit by suns and lamps as far as the shadows let them, and by the sky from everywhere. Fills
/// `covered`.
void draw_objects(const ObjectPass& pass, LiveEye& eye);

/// Darkens real surfaces where a virtual thing takes away their light: times
///
///     (ambient + sum of lights that pass both) / (ambient + sum of lights that pass the real world)
///
/// with ambient = pi times the sky's radiance. Only pixels that a light sees behind the objects are looked
/// at. A shadow falls on the plane that fits the depths up to `surface_reach_px` beside a pixel
/// (`fitted_surface`); at 1, on the pixel's own depth with the cross product of its neighbours', as paper 001
/// (section 5.2) has it, where noise gives the shadow ragged edges and turns surfaces away from a low sun.
struct ShadowPass {
  const LiveScene& scene;
  const ShadowAnswers& shadows;
  int surface_reach_px = 8;
  int threads = 1;
};
void darken_shadows(const ShadowPass& pass, LiveEye& eye);

}  // namespace seamline::live
