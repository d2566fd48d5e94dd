// Cameras of another person: what was read is written and read as the same.
#include "fuzz/fuzz_target.h"
#include "registration/files/other_cameras.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  using namespace seamline::registration;
  return fuzz::only_input_errors([&] {
    const std::string given(fuzz::text_of(data, size));
    const bool other = is_other_camera(given);
    const CameraFile cameras = other ? parse_other_camera(given, "camera", std::pair{640, 480})
                                     : parse_camera_file(given, "camera.toml");
    if (cameras.fisheye) (void)sensors::direction_through(*cameras.fisheye, {0.5, 0.5});
    if (other && cameras.colour) (void)sensors::project(*cameras.colour, {0.1, 0.2, 1});
    const std::string text = camera_file_text(cameras, "again");
    if (camera_file_text(parse_camera_file(text, "again.toml"), "again") != text) abort();
    const RegistrationRig rig = registration_rig(cameras, "camera.toml");
    (void)sensors::project(rig.colour, rig.colour_from_depth * Eigen::Vector3d(0.1, 0.2, 1));
    (void)sensors::direction_through(rig.depth_form.camera, {0.5, 0.5});
  });
}
