#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sensors/files/depth_file.h"
#include "sensors/files/estimated_depth.h"
#include "sensors/frame/depth_test.h"
#include "sensors/frame/jumps.h"
#include "sensors/noise/measurement.h"
#include "sensors/repair/repair.h"
#include "stimuli/definition/methods/occlusion.h"

namespace seamline::inline stimuli {

/// What a sensor makes of what it sees. `scale` multiplies the model's errors (sensors/noise/measurement.h);
/// at 0 the instrument stays, with its holes and flying pixels.
struct SourceNoise {
  sensors::NoiseModel model;
  double scale = 1;

  auto operator<=>(const SourceNoise&) const = default;
};

/// Where a sensor is in the photograph's camera (x right, y down, z forward). Rotations as of objects: roll
/// about z first, then pitch about x, then yaw about y.
struct SensorPose {
  std::array<double, 3> position_m = {0, 0, 0};
  std::array<double, 3> rotation_deg = {0, 0, 0};  ///< pitch about x, yaw about y, roll about z

  auto operator<=>(const SensorPose&) const = default;
};

/// How a texel stands for the texels of a finer map under it: the one ray through its centre, or the nearest,
/// the farthest or the middle one of them (lower median); or, where they part into near and far at a jump by
/// more than a tenth, the middle one of the larger side (of equal sides the near one), so that no texel
/// stands for a distance between two things. Holes are farther than anything. `boxes`: planes and boxes are
/// fitted to the finer map, and texels stand only for what they do not explain.
/// `jumps` and `budgeted`: as many samples as the map has texels, spent where depth jumps, or where it would
/// show if depth were wrong (renderer/depth/budget).
enum class Reduction { sample, minimum, maximum, median, edge_aware, boxes, jumps, budgeted };

/// Where an estimate's scale and shift come from: stated, or least squares on the true depth, as estimators
/// of relative depth are judged (Ranftl et al. 2020, Eq. 4).
enum class EstimateAlignment { stated, least_squares };

/// What a file's values are, where they are estimated, and how much of them is taken: with t the true
/// distance and e the estimated one, 1 / d = (1 - share) / t + share / e (sensors/files/estimate_error.h).
struct FileEstimate {
  sensors::DepthValue value = sensors::DepthValue::metres;
  EstimateAlignment align = EstimateAlignment::stated;
  std::optional<double> scale = {};  ///< stated: required of values that are no metres
  double shift = 0;                  ///< stated
  double share = 1;

  auto operator<=>(const FileEstimate&) const = default;
};

/// A panorama that lies in a file, of the width of the depth settings. `{scene}` and `{object}` in its name
/// stand for a stimulus's own (depth_file_names.h).
struct PanoramaFile {
  std::string file;            ///< as written
  std::filesystem::path path;  ///< resolved; empty where files are not needed
  std::optional<double> metres_per_step;
  sensors::DepthPacking packing = sensors::DepthPacking::whole;
  FileEstimate estimate;

  auto operator<=>(const PanoramaFile&) const = default;
};

/// A panorama from the photograph's own position, radial; its width is that of the depth settings.
struct PanoramaSource {
  Reduction reduction = Reduction::sample;
  int reduction_factor = 1;  ///< the finer map has so many times the width; 1 with `sample`
  double lowest_elevation_deg = -90, highest_elevation_deg = 90;  ///< of texel centres; holes outside
  sensors::SensorRange range;
  std::optional<SourceNoise> noise;       ///< the generic model
  std::optional<PanoramaFile> file = {};  ///< none: captured from the truth

  auto operator<=>(const PanoramaSource&) const = default;
};

/// A depth camera that looks at the truth.
struct PinholeSource {
  sensors::PinholeCamera camera;
  /// Of values without noise, and of the generic model; the other models have their own.
  sensors::DepthConvention convention = sensors::DepthConvention::planar;
  sensors::SensorRange range;
  SensorPose pose;
  std::optional<SourceNoise> noise;
  std::optional<std::array<double, 3>> projector_m;  ///< in the sensor's frame; structured light only

  auto operator<=>(const PinholeSource&) const = default;
};

/// A depth map that lies in a file, and what the file does not say of itself. Its name as of PanoramaFile.
struct FileSource {
  std::string file;            ///< as written
  std::filesystem::path path;  ///< resolved; empty where files are not needed
  sensors::PinholeCamera camera;
  sensors::DepthConvention convention = sensors::DepthConvention::planar;
  sensors::SensorRange range;
  SensorPose pose;
  std::optional<double> metres_per_step;
  sensors::DepthPacking packing = sensors::DepthPacking::whole;
  std::optional<FileEstimate> estimate = {};  ///< none: measured distances, which are compared with nothing

  auto operator<=>(const FileSource&) const = default;
};

/// Two cameras side by side whose pictures are rendered and matched (semi-global matching). Depth is that of
/// the left one, planar.
struct StereoSource {
  sensors::PinholeCamera camera;  ///< of both; without a lens
  sensors::SensorRange range;
  SensorPose pose;             ///< of the left one
  double baseline_m = 0;       ///< from the left one to its right
  int disparities_px = 64;     ///< that are searched, from 0: a multiple of 16. Nearer things are not found
  int block_px = 5;            ///< side of the compared blocks; odd
  int samples_per_pixel = 64;  ///< of the pictures
  double share = 1;            ///< as of FileEstimate

  auto operator<=>(const StereoSource&) const = default;
};

using DepthSource = std::variant<PanoramaSource, PinholeSource, FileSource, StereoSource>;

/// How depth is brought into the photograph's camera: not (the mesh is placed by the sensor's pose), point by
/// point, or as a mesh that is looked at from there.
enum class Registration { none, points, mesh };

/// What guides a joint bilateral repair: albedo times cosine as the sensor sees it, a picture in its own
/// light; or the photograph, in the sensor's pixels, as `seamline register` takes it.
enum class RepairGuide { own_light, photograph };

using sensors::Jumps;

/// How depth is captured and what becomes of it: source -> repair -> registration -> local scene. Values that
/// mean nothing beside the others have their defaults (`meaningful`), so that equal means the same.
struct DepthChain {
  std::vector<DepthSource> sources = {PanoramaSource{}};  ///< one at least; a panorama is the only one
  sensors::RepairMethod repair = sensors::NoRepair{};
  RepairGuide guide = RepairGuide::own_light;  ///< of a joint bilateral repair
  bool repair_after = false;                   ///< the registered picture is repaired (002), not the sensor's
  Registration registration = Registration::none;
  int border_extrusion_px = 0;  ///< of registration by mesh
  Jumps jumps = Jumps::stretch;
  double jump_ratio = 1.1;                ///< above 1
  int layer_px = 16;                      ///< how far behind an edge the second surface reaches, in pixels
  Occlusion occlusion = Occlusion::mesh;  ///< or by a test of pixels in the photograph's camera
  sensors::DepthBuffer buffer = {};       ///< of `depth_buffer` only
  /// The sensor is believed to be where it is not: turned by this angle and moved by this distance, about an
  /// axis and in a direction that the seed draws (registration/pose/pose.h).
  double calibration_error_deg = 0;
  double calibration_error_m = 0;
  /// Depth is so much older than the photograph, while the rig moves; in the photograph's camera.
  double delay_ms = 0;
  std::array<double, 3> velocity_m_s = {0, 0, 0};
  double noise_sigmas = 3;  ///< the adaptive mesh may err by so many standard deviations of the noise
  std::uint64_t seed = 0;   ///< of the noise and of the calibration error

  auto operator<=>(const DepthChain&) const = default;
};

[[nodiscard]] std::string_view word(Reduction reduction);
[[nodiscard]] std::string_view word(RepairGuide guide);
[[nodiscard]] std::string_view word(Registration registration);
[[nodiscard]] std::string_view word(Jumps jumps);
/// "panorama", "pinhole", "file", "stereo". A panorama in a file is a panorama.
[[nodiscard]] std::string_view kind_of(const DepthSource& source);
/// "none", "nearest", "median", "joint_bilateral", "planes".
[[nodiscard]] std::string_view word(const sensors::RepairMethod& repair);
/// "generic", "time_of_flight", "structured_light".
[[nodiscard]] std::string_view word(const sensors::NoiseModel& model);

[[nodiscard]] bool is_panorama(const DepthChain& chain);
/// Whether all depth is that of the photograph's own place, so that its pixels can be compared with the
/// photograph's: registered, or captured from there by a sensor that is believed to be there.
[[nodiscard]] bool is_in_photographs_place(const DepthChain& chain);
/// Whether its depth is estimated, mixed with the truth and judged by it.
[[nodiscard]] bool is_estimated(const DepthSource& source);
[[nodiscard]] bool is_estimated(const DepthChain& chain);
/// Whether a picture of the scene decides its depth.
[[nodiscard]] bool has_stereo(const DepthChain& chain);
/// Where the sensor is in the photograph's camera; of a panorama its origin.
[[nodiscard]] SensorPose pose_of(const DepthSource& source);
/// Camera of a pinhole, file or stereo; null of a panorama.
[[nodiscard]] const sensors::PinholeCamera* camera_of(const DepthSource& source);
/// Noise of a source, null where it has none.
[[nodiscard]] const SourceNoise* noise_of(const DepthSource& source);
[[nodiscard]] bool has_noise(const DepthChain& chain);  ///< whether any source errs: not at scale 0
/// Whether the photograph guides a repair.
[[nodiscard]] bool guided_by_photograph(const DepthChain& chain);
/// Whether planes and boxes stand for a panorama.
[[nodiscard]] bool has_boxes(const DepthChain& chain);
/// Whether samples of a panorama are spent unevenly: where depth jumps, or where it shows.
[[nodiscard]] bool is_budgeted(Reduction reduction);
[[nodiscard]] bool is_budgeted(const DepthChain& chain);

/// The same with defaults wherever a value has no meaning (a generic noise of scale 0 is none, a ratio of
/// jumps beside sheets); nothing when that is the paper's exact panorama.
[[nodiscard]] std::optional<DepthChain> meaningful(DepthChain chain);

/// The chain link by link as a text of one line, for hashes and the manifest; empty without a chain.
[[nodiscard]] std::string canonical_text(const std::optional<DepthChain>& chain);

/// The links for people, each with what it is: {"source", "pinhole 160 x 120 px, ..."}. Absent links say
/// "none".
using DepthLinks = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] DepthLinks depth_links(const std::optional<DepthChain>& chain, int panorama_width_px);

/// A pinhole with another field of view and as many texels per degree on its axis: its focal lengths stay,
/// its width is the nearest even number, its height keeps their proportion, its principal point its distance
/// from the middle.
[[nodiscard]] sensors::PinholeCamera with_field_of_view(const sensors::PinholeCamera& camera,
                                                        double horizontal_field_of_view_deg);

/// A picture of another size that shows the same.
[[nodiscard]] sensors::PinholeCamera resized(sensors::PinholeCamera camera, int width_px, int height_px);

/// The same view with so many texels per degree on the axis; to the nearest even width and whole height.
[[nodiscard]] sensors::PinholeCamera with_texels_per_degree(const sensors::PinholeCamera& camera,
                                                            double texels_per_degree);

}  // namespace seamline::inline stimuli
