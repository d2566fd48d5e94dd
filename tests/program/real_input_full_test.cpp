// Real meshes through the whole renderer: Sponza with scanned statues, placed by a study file, a scan in a
// panorama, frames of a Kinect. The pictures are kept in the build folder under test-output/real_input/set
// and test-output/register for people to look at.
#include <gtest/gtest.h>

#include "run_program.h"
#include "stimuli/set/manifest.h"
#include "support/files/image.h"
#include "tests/real_data.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

constexpr const char* study_of_each_artifact = R"(
format = "seamline study 1"
name = "real_input"
isolation = "query"
width_px = 240
height_px = 135
samples_per_pixel = 8
mesh_tolerance = 1e-3
depth_width_px = [256]

[[scene]]
name = "hall"
file = "MESHES/sponza.glb"
artifacts = ["receiver", "shadow", "overlap"]
environment_radiance = [0.5, 0.55, 0.65]
exposure_ev = -1.5
  [scene.sun]
  to_sun = [0.45, 1.0, 0.12]
  irradiance_w_m2 = [9.0, 8.5, 8.0]
  [scene.camera]
  position_m = [-8.6, 2.3, 0.2]
  look_at_m = [-3.0, 0.7, 0.0]
  horizontal_fov_deg = 60
  [[scene.object]]
  name = "nefertiti"
  file = "MESHES/nefertiti-lowres.glb"
  position_m = [-4.6, 0.79, -1.3]
  rotation_deg = [0, -90, 0]
  scale = 0.0032
  [[scene.object]]
  name = "armadillo"
  file = "MESHES/armadillo_29k.glb"
  position_m = [-3.8, 1.0, 0.0]
  rotation_deg = [0, -90, 0]
  scale = 1.8
  [[scene.object]]
  name = "lion"
  file = "MESHES/lionstatue.glb"
  position_m = [-4.2, 0.0, 1.6]
  rotation_deg = [0, 60, 0]
  scale = 0.9

[[scene]]
name = "arcade"
file = "MESHES/sponza.glb"
artifacts = ["occlusion"]
ambient_occlusion = true
  [scene.camera]
  position_m = [-3.0, 1.7, 0.5]
  look_at_m = [0.0, 1.2, -5.0]
  horizontal_fov_deg = 70
  [[scene.object]]
  name = "teapot_left"
  file = "MESHES/teapot.glb"
  position_m = [-3.0, 0.0, -4.5]
  scale = 0.3
  [[scene.object]]
  name = "teapot_middle"
  file = "MESHES/teapot.glb"
  position_m = [-0.6, 0.0, -4.5]
  scale = 0.3
  [[scene.object]]
  name = "armadillo"
  file = "MESHES/armadillo_29k.glb"
  position_m = [0.9, 0.6, -4.4]
  scale = 1.1
)";

std::string with_meshes(const fs::path& meshes) {
  std::string text = study_of_each_artifact;
  for (std::size_t at = text.find("MESHES"); at != std::string::npos; at = text.find("MESHES"))
    text.replace(at, 6, meshes.string());
  return text;
}

TEST(RealInput, OneStimulusOfEachArtifactFromScannedMeshes) {
  SKIP_WITHOUT_REAL_DATA();
  const fs::path meshes = test::real_data() / "meshes";
  const fs::path folder = test::fresh_folder("real_input");
  test::write_text(folder / "study.toml", with_meshes(meshes));
  const fs::path set = folder / "set";
  for (const char* only : {"hall-receiver-armadillo-0256", "hall-shadow-lion-0256",
                           "hall-overlap-nefertiti-0256", "arcade-occlusion-teapot_middle-0256"}) {
    const test::Outcome outcome =
        test::run_seamline("render " + (folder / "study.toml").string() + " --out " + set.string() +
                           " --only " + only + " --asset-root " + meshes.string());
    ASSERT_EQ(outcome.status, 0) << outcome.output;
  }
  const Manifest manifest = read_manifest(set);
  ASSERT_EQ(manifest.stimuli.size(), 4U);
  for (const ManifestStimulus& stimulus : manifest.stimuli) {
    const ByteImage picture = read_bytes_image(set / stimulus.image),
                    reference = read_bytes_image(set / stimulus.reference);
    int visible = 0, light = 0;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
      visible += std::abs(int{picture.values[i]} - int{reference.values[i]}) > 10 ? 1 : 0;
      light += picture.values[i] > 40 ? 1 : 0;
    }
    const double share = static_cast<double>(visible) / static_cast<double>(picture.values.size());
    EXPECT_GT(visible, 15) << stimulus.id << ": the artifact does not show";
    EXPECT_LT(share, 0.2) << stimulus.id << ": more than an artifact differs";
    EXPECT_GT(light, 5000) << stimulus.id << ": the picture is dark";
    EXPECT_LT(stimulus.clipped_share, 0.25) << stimulus.id;
  }
  EXPECT_EQ(test::run_seamline("verify " + set.string()).status, 0);
}

TEST(RealInput, ARealPanoramaLightsAScan) {
  SKIP_WITHOUT_REAL_DATA();
  const fs::path folder = test::fresh_folder("real_panorama");
  write_exr(folder / "closed.exr", Image(64, 32, 1, 3));  // a ball of a room
  const test::Outcome outcome = test::run_seamline(
      "composite --background " + (test::real_data() / "environments/leadenhall_market_1k.hdr").string() +
      " --depth " + (folder / "closed.exr").string() + " --object " +
      (test::real_data() / "meshes/nefertiti-lowres.glb").string() +
      " --position 0 -1 -2 --height 1 --view 96x96 --look-at 0 -0.25 -1 --fov 40 --spp 16 --bounces 1 "
      "--tolerance 1e-2 --out " +
      (folder / "out.exr").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  // A bust of albedo 0.5 in the middle is neither black nor brighter than the sky over the market.
  const Image made = read_image(folder / "out.exr");
  double sum = 0;
  for (int y = 40; y < 60; ++y)
    for (int x = 42; x < 54; ++x) sum += double{made.rgb(x, y).mean()} / (20 * 12);
  EXPECT_GT(sum, 0.05);
  EXPECT_LT(sum, 1.5);
}

TEST(RegisterRealFrames, FiveKinectFramesAreRegisteredAlready) {
  SKIP_WITHOUT_REAL_DATA();
  const fs::path rgbd = test::real_data() / "rgbd";
  const fs::path folder = test::fresh_folder("register");
  const std::string camera =
      "width_px = 640\nheight_px = 480\nfx_px = 518\nfy_px = 519\ncx_px = 325.5\n"
      "cy_px = 253.5\n";
  test::write_text(folder / "kinect.toml",
                   "format = \"seamline camera 1\"\nconvention = \"planar\"\nmetres_per_step = 0.001\n"
                   "pixel_centres = \"integer\"\n[depth]\n" +
                       camera + "[colour]\n" + camera + "[colour_from_depth]\ntranslation_m = [0, 0, 0]\n");
  for (int frame = 1; frame <= 5; ++frame) {
    const std::string number = std::to_string(frame);
    const fs::path out = folder / number;
    const test::Outcome outcome = test::run_seamline(
        "register --depth " + (rgbd / ("slambook_depth_" + number + ".pgm")).string() + " --colour " +
        (rgbd / ("slambook_color_" + number + ".png")).string() + " --camera " +
        (folder / "kinect.toml").string() + " --by points --out " + out.string());
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    // Point by point through one and the same camera every depth stays where it is.
    const auto count = [&](const std::string& what) {
      const std::size_t at = outcome.output.find("  " + what + " ");
      return std::stol(outcome.output.substr(at + 2 + what.size()));
    };
    EXPECT_EQ(count("measured"), count("registered"));
    EXPECT_EQ(count("holes"), count("without depth"));
    EXPECT_GT(count("measured"), 640 * 480 / 2);
  }
}

}  // namespace
}  // namespace seamline
