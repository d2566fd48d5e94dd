#include "composites/given_answers.h"

#include <fmt/core.h>

#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

GivenAnswers given_answers(const CompositeRequest& request, const SeenPhoto& seen, const PhotoDepth& depth) {
  GivenAnswers given;
  const Camera& camera = seen.camera;
  const bool whole =
      camera.directions && seen.photograph.projection == Projection::panorama && !request.view_px;
  const auto mask = [&](const std::string& file) {
    return file.empty() ? std::nullopt
                        : std::optional(read_mask(file, camera.width_px, camera.height_px, whole));
  };
  given.shadow_matte = mask(request.shadow_matte);
  if (!request.occlusion_mask.empty()) {
    given.test.emplace().mask = mask(request.occlusion_mask);
  } else if (tests_pixels(request.occlusion)) {
    given.test =
        OcclusionTest{.sights = {photo_sight(depth, request.depth, camera)}, .forward = -camera.axes.col(2)};
    if (request.occlusion == Occlusion::depth_buffer) {
      sensors::require_valid(request.buffer,
                             request_name("depth_buffer_near") + " and " + request_name("depth_buffer_far"));
      given.test->buffer = request.buffer;
    }
  }
  return given;
}

std::vector<std::string> answers_text(const CompositeRequest& request) {
  std::vector<std::string> text;
  if (!request.occlusion_mask.empty())
    text.push_back("who is in front: the mask " + printable(request.occlusion_mask));
  else if (request.occlusion == Occlusion::depth_test)
    text.push_back("who is in front: depth, looked up a sample in metres");
  else if (request.occlusion == Occlusion::depth_buffer)
    text.push_back(
        fmt::format("who is in front: depth, looked up a sample in a depth buffer of {} bits, {:g} to {:g} m",
                    request.buffer.bits, request.buffer.nearest_m, request.buffer.farthest_m));
  else if (request.occlusion == Occlusion::nobody)
    text.push_back("who is in front: the objects, always, and nothing real shades them");
  if (!request.shadow_matte.empty())
    text.push_back("which real surfaces suns reach: the matte " + printable(request.shadow_matte));
  if (!request.shadows) text.emplace_back("real surfaces: as the photograph shows them, without shadows");
  return text;
}

}  // namespace seamline::renderer
