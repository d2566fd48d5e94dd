#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "composites/photo_depth.h"
#include "composites/photograph.h"
#include "sensors/frame/depth_test.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// Whose light falls into the photograph.
struct PhotoLightRequest {
  /// Suns, lamps and environment that were given; its environment is black where none was.
  SceneDefinition given;
  bool has_given = false;
  bool from_photograph = false;  ///< also where something was given
  std::string panorama;          ///< taken at the photograph's place; empty: the photograph itself
  bool splits_sun = true;        ///< of a panorama that is the light
  /// How many times as bright a panorama's clipped light sources are; none: so that no surface has to be
  /// more than white (`find_clipped_sources`).
  std::optional<double> clipped_factor = {};
  /// Light that exists only with the objects, and falls on real surfaces too; its environment says nothing.
  SceneDefinition added = {};
};

/// Everything that a composite is made from. documentation/how-to/composite.md says what each means.
struct CompositeRequest {
  std::string photograph;
  std::string layer;                     ///< of an EXR photograph with several; empty: by its name
  std::optional<Projection> projection;  ///< none: by its shape
  PhotoDepthRequest depth;
  std::string repair;  ///< of depth of the photograph's own view, as of `register`; empty: none
  std::vector<PlacedModel> objects;
  std::string scene_file;  ///< glTF: camera, suns and lamps; empty: none

  std::optional<std::pair<int, int>> view_px;  ///< of a panorama; none: the panorama itself
  std::optional<Eigen::Vector3d> look_at_m;    ///< none: (0, 0, -1)
  std::optional<double> fov_deg;               ///< horizontal; none: 60
  double roll_deg = 0;  ///< by which the camera is turned about its axis, clockwise as seen from behind it

  PhotoLightRequest light;
  double albedo = 0.5;  ///< of the local scene
  int bounces = 4;

  Occlusion occlusion = Occlusion::mesh;  ///< or `depth_test`, `depth_buffer`, `nobody`
  sensors::DepthBuffer buffer;
  std::string occlusion_mask, shadow_matte;  ///< files; empty: none
  bool shadows = true;  ///< that objects cast onto real surfaces; else these keep the photograph's bytes

  std::optional<int>
      depth_width_px;  ///< of the panorama that the local scene is seen through; none: all of it
  /// In place of a width: samples spent where wrong depth would show; none: by width.
  std::optional<std::int64_t> depth_samples;
  bool seamless = false;              ///< that width is chosen by thresholds
  std::string thresholds, condition;  ///< `thresholds.json`; empty: the paper's

  std::optional<Estimator> estimator;  ///< none: fast where it can
  std::optional<double> error;
  int spp = 64;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one for each core
  bool additive = false;

  std::string out, layers, report, local_scene, samples_picture;  ///< files; empty: not written
  double exposure_ev = 0;
  double pixels_per_degree = default_pixels_per_degree;  ///< for FLIP in the report
};

/// Who is told what, as soon as it is known; empty: nobody.
struct CompositeListener {
  std::function<void(const std::string&)> line;  ///< what is made, and of what
  std::function<void(const std::string&)> note;  ///< what whoever uses the picture must know
};

/// Makes the composite and writes its files. Throws InputError with one sentence where something is wrong,
/// and where not one pixel would change.
void make_composite(const CompositeRequest& request, const CompositeListener& listener = {});

}  // namespace seamline::renderer
