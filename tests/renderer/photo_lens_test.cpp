// The photograph's camera as a file states it: pose and roll are used, and a fisheye's depth lies around it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "composites/photo_depth.h"
#include "renderer/depth/depth_map.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"

namespace seamline::renderer {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class PhotoLensFiles : public ::testing::Test {
 protected:
  PhotoLensFiles() {
    photograph_.radiance = Image(64, 48, 3, 0.5F);
    photograph_.width_px = 64;
    photograph_.height_px = 48;
  }

  PhotoLens lens_of(const std::string& more) {
    write_file_atomically(folder_ / "camera.toml", "format = \"seamline camera 1\"\n" + more);
    request_.camera = (folder_ / "camera.toml").string();
    return photograph_lens(request_, photograph_, "photo").value();
  }
  PhotoLens pinhole_with(const std::string& before, const std::string& pose) {
    return lens_of(before +
                   "[colour]\nwidth_px = 64\nheight_px = 48\nfx_px = 50\nfy_px = 50\ncx_px = 32\ncy_px = 24\n"
                   "[world_from_colour]\n" +
                   pose);
  }

  TemporaryFolder folder_;
  Photograph photograph_;
  PhotoDepthRequest request_;
};

TEST_F(PhotoLensFiles, PoseAndRollAreUsed) {
  // It looks along -Z and lies on its side: the picture's right is up.
  const PhotoLens lens = pinhole_with("up = [0, 1, 0]\n",
                                      "translation_m = [1, 2, 3]\nrotation = [0, 1, 0, 1, 0, 0, 0, 0, -1]\n");
  ASSERT_TRUE(lens.world_from_camera);
  EXPECT_EQ(lens.world_from_camera->translation(), Eigen::Vector3d(1, 2, 3));
  const Camera camera = camera_of_lens(lens, {});
  EXPECT_LT((camera.direction(32, 24) - Eigen::Vector3f(0, 0, -1)).norm(), 1e-6F);
  EXPECT_GT(camera.direction(64, 24).y(), 0.5F);
  EXPECT_LT(std::abs(camera.direction(64, 24).x()), 1e-6F);
  EXPECT_THAT(lens.notes, Contains(HasSubstr("stands at 1.000 2.000 3.000 m")));
}

TEST_F(PhotoLensFiles, AWorldWhoseYPointsDownIsTurned) {
  const PhotoLens lens = pinhole_with("", "translation_m = [5, 1, 2]\n");
  EXPECT_LT((lens.world_from_camera->translation() - Eigen::Vector3d(5, -1, -2)).norm(), 1e-12);
  EXPECT_THAT(lens.notes, Contains(HasSubstr("would stand on its head")));
  const Camera camera = camera_of_lens(lens, {});
  EXPECT_LT((camera.direction(32, 24) - Eigen::Vector3f(0, 0, -1)).norm(), 1e-6F);
  EXPECT_GT(camera.direction(32, 0).y(), 0);
  // Another axis that is up, as of a robot's world: z.
  const PhotoLens robot = pinhole_with("up = [0, 0, 1]\n", "translation_m = [0, 0, 7]\n");
  EXPECT_LT((robot.world_from_camera->translation() - Eigen::Vector3d(0, 7, 0)).norm(), 1e-12);
}

TEST_F(PhotoLensFiles, DepthOfAFisheyeLiesAroundIt) {
  const PhotoLens lens = lens_of(
      "[colour]\nlens = \"fisheye\"\nwidth_px = 64\nheight_px = 48\nfx_px = 20\nfy_px = 20\ncx_px = 32\ncy_px = 24\n"
      "k1 = 0.01\n");
  write_exr(folder_ / "depth.exr", Image(64, 48, 1, 2.5F));
  request_.file = (folder_ / "depth.exr").string();
  const Camera camera = camera_of_lens(lens, {});
  const PhotoDepth depth = read_photo_depth(request_, photograph_, lens, camera, 60);
  ASSERT_TRUE(depth.map);
  EXPECT_EQ(depth.map->width_px, 2 * depth.map->height_px);
  int seen = 0;
  for (int y = 0; y < depth.map->height_px; ++y)
    for (int x = 0; x < depth.map->width_px; ++x) {
      const Eigen::Vector3d direction =
          panorama_direction(x + 0.5, y + 0.5, depth.map->width_px, depth.map->height_px);
      const auto place_px = sensors::project(std::get<sensors::FisheyeCamera>(lens.camera),
                                             {direction.x(), -direction.y(), -direction.z()});
      const bool inside =
          place_px && place_px->x() >= 0 && place_px->x() < 64 && place_px->y() >= 0 && place_px->y() < 48;
      const float found = depth.map->distance_m[static_cast<std::size_t>(y * depth.map->width_px + x)];
      EXPECT_EQ(found, inside ? 2.5F : sensors::hole);
      seen += inside ? 1 : 0;
    }
  EXPECT_GT(seen, depth.map->width_px * depth.map->height_px / 4);
  EXPECT_THAT(depth.notes, Contains(HasSubstr("depth of a fisheye")));
}

TEST_F(PhotoLensFiles, WholeNumbersTakeTheCameraFilesUnit) {
  const PhotoLens lens = lens_of(
      "depth_unit = \"kitti\"\n[colour]\nwidth_px = 64\nheight_px = 48\nfx_px = 50\nfy_px = 50\ncx_px = 32\ncy_px = 24\n");
  std::string pgm = "P5\n64 48\n65535\n";
  for (int i = 0; i < 64 * 48; ++i) pgm += {'\x02', '\x00'};
  write_file_atomically(folder_ / "depth.pgm", pgm);
  request_.file = (folder_ / "depth.pgm").string();
  const PhotoDepth depth = read_photo_depth(request_, photograph_, lens, camera_of_lens(lens, {}), 60);
  EXPECT_EQ(depth.frame->depth_m.front(), 2);
}

}  // namespace
}  // namespace seamline::renderer
