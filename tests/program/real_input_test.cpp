// Real meshes through the whole renderer: Sponza with scanned statues, placed by a study file. The pictures
// are kept in the build folder under test-output/real_input/set for people to look at.
#include <gtest/gtest.h>

#include "run_program.h"
#include "stimuli/set/manifest.h"
#include "support/files/image.h"

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
  const fs::path meshes = fs::path(SEAMLINE_SOURCE_DIR).parent_path() / "shared" / "assets" / "meshes";
  if (!fs::exists(meshes / "sponza.glb")) GTEST_SKIP() << "the real meshes are not at " << meshes;
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

}  // namespace
}  // namespace seamline
