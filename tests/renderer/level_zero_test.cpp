// A level of 0 is the end of its axis and no other instrument: what it rebuilds is what small levels rebuild.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "renderer/depth/local_scene.h"
#include "stimuli/set/level_notes.h"
#include "stimuli/study_file/study_file.h"
#include "tests/renderer/shapes.h"
#include "tests/stimuli/study_of_no_files.h"

namespace seamline::renderer {
namespace {

/// A room in which a dark box and the far corners send too little light back.
Geometry room_with_dark_things() {
  return Geometry(std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-3, -1.5F, -6}, {3, 2.5F, 4}, 0.6F),
      test::box({-1.6F, -1.5F, -4.5F}, {-0.6F, 0.2F, -3.5F}, 0.02F),
      test::sphere({0.9F, -0.6F, -3.2F}, 0.7F, 48, 0.8F)});
}

struct ZeroCase {
  Quantity quantity = Quantity::depth_noise;
  double small = 1e-4;  ///< the smallest level that ids tell from 0
  std::string depth;    ///< beside size and field of view
};

void PrintTo(const ZeroCase& one, std::ostream* out) {
  *out << facts(one.quantity).key << ", " << one.depth;
}

std::vector<LocalScene> local_scenes(const ZeroCase& one, const Geometry& truth) {
  const std::string key(facts(one.quantity).key);
  std::string text = test::study_of_no_files(
      "", "[level]\nquantity = \"" + key + "\"\nvalues = [0, " + fmt::format("{}", one.small) +
              "]\n[depth]\nsource = \"pinhole\"\nsize_px = [120, 90]\nfield_of_view_deg = 60\n" + one.depth);
  const std::string widths = "depth_width_px = [64, 4096]\n";
  text.erase(text.find(widths), widths.size());
  const StudyDefinition study = read_study_text(text, "study.toml");
  std::vector<LocalScene> scenes;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (stimulus.object_index == 1)
      scenes.push_back(make_local_scene(truth, stimulus.depth, {.photograph = Camera{}}));
  return scenes;
}

/// Share of the view's rays that meet both at the same distance, or neither.
double share_of_same_rays(const Geometry& a, const Geometry& b) {
  constexpr int side = 101;
  int alike = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Eigen::Vector3f direction(1.2F * (x + 0.5F) / side - 0.6F, 0.9F * (y + 0.5F) / side - 0.45F, -1);
      const Ray ray{Eigen::Vector3f::Zero(), direction.normalized()};
      const auto hit_a = a.nearest(ray), hit_b = b.nearest(ray);
      alike += hit_a.has_value() == hit_b.has_value() &&
                       (!hit_a || std::abs(hit_a->distance_m - hit_b->distance_m) < 2e-3F * hit_a->distance_m)
                   ? 1
                   : 0;
    }
  return static_cast<double>(alike) / (side * side);
}

class LevelZero : public testing::TestWithParam<ZeroCase> {};

TEST_P(LevelZero, IsTheLimitOfSmallLevels) {
  const std::vector<LocalScene> scenes = local_scenes(GetParam(), room_with_dark_things());
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_GT(share_of_same_rays(scenes[0].geometry, scenes[1].geometry), 0.995);
  ASSERT_TRUE(scenes[0].mesh.sensor && scenes[1].mesh.sensor);
  EXPECT_NEAR(static_cast<double>(scenes[0].mesh.sensor->holes),
              static_cast<double>(scenes[1].mesh.sensor->holes), 2);
}

constexpr const char* zero_flight = "noise = { model = \"time_of_flight\", weakest_amplitude_e = 300 }\n";
constexpr const char* zero_light =
    "projector_m = [0.075, 0, 0]\nnoise = { model = \"structured_light\", baseline_m = 0.075 }\n";
constexpr const char* zero_generic =
    "noise = { model = \"generic\", relative_sigma = 0.02, dropout_share = 0.1 }\n";
const std::string zero_exact,
    zero_by_mesh = "pose = { position_m = [0.05, 0, 0] }\nregistration = \"mesh\"\n";

INSTANTIATE_TEST_SUITE_P(
    Every, LevelZero,
    testing::Values(ZeroCase{Quantity::depth_noise, 1e-4, zero_flight},
                    ZeroCase{Quantity::depth_noise, 1e-4, zero_light},
                    ZeroCase{Quantity::depth_noise, 1e-4, zero_generic},
                    ZeroCase{Quantity::outlier_share, 1e-7, zero_flight},
                    ZeroCase{Quantity::outlier_share, 1e-7, zero_light},
                    ZeroCase{Quantity::calibration_error_deg, 1e-4, zero_exact},
                    ZeroCase{Quantity::calibration_error_deg, 1e-4, zero_by_mesh},
                    ZeroCase{Quantity::calibration_error_m, 1e-5, zero_exact},
                    ZeroCase{Quantity::calibration_error_m, 1e-5, zero_by_mesh},
                    ZeroCase{Quantity::depth_delay_ms, 0.01, "velocity_m_s = [1, 0, 0]\n"},
                    ZeroCase{Quantity::depth_delay_ms, 0.01, zero_by_mesh + "velocity_m_s = [1, 0, 0]\n"},
                    ZeroCase{Quantity::mesh_tolerance, 1e-9, zero_exact}));

TEST(LevelNotes, SayWhereLevelsDifferInHoles) {
  std::vector<LevelHoles> holes;
  const auto add = [&](double level, std::int64_t of, const std::string& condition) {
    Stimulus stimulus;
    stimulus.scene = "cafe";
    stimulus.condition = condition;
    stimulus.quantity = Quantity::depth_noise;
    stimulus.level = level;
    add_holes(holes, stimulus, {.measured = 1000 - of, .holes = of});
  };
  add(0, 45, "sun"), add(1, 270, "sun"), add(1, 270, "dusk"), add(0, 270, "dusk"), add(1, 272, "rain"),
      add(0, 270, "rain");
  EXPECT_EQ(
      sentences(holes),
      (std::vector<std::string>{
          "cafe, sun: holes in the depth pictures: 4.5 % at none, 27 % at 1. The levels differ in holes: "
          "a threshold of the depth noise over them is one of holes too.",
          "cafe, dusk: holes in the depth pictures: 27 % at every level.",
          "cafe, rain: holes in the depth pictures: 27 % at none, 27.2 % at 1."}));
  EXPECT_TRUE(sentences({}).empty());
}

}  // namespace
}  // namespace seamline::renderer
