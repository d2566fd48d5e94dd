#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"

namespace seamline::inline stimuli {

inline constexpr const char* manifest_format = "seamline set";
inline constexpr int manifest_version = 1;
/// Of a set whose levels are no widths, or that has conditions: an older program would take it for one of the
/// first kind.
inline constexpr int manifest_version_with_conditions = 2;

/// A picture of another eye than the left one, of panoramas for each eye.
struct EyePicture {
  std::string image, sha256;
};

struct TinyDenominators {
  std::int64_t floored_pixels = 0;  ///< ratio taken as 1, because S_no was under 1e-6 of the frame's median
  std::int64_t clamped_pixels = 0;  ///< ratio clamped to 0..4
  std::int64_t sealed_pixels =
      0;  ///< ratio faded towards 1, because the depth mesh is far darker than the photograph
  std::int64_t not_finite_pixels = 0;  ///< infinite or not a number: shown black or white, and counted
};

/// What became of the pixels of all sources of a mesh. Measured pixels, outliers and holes are all of them;
/// invented ones were holes, and have a depth that nobody measured.
struct SensorCounts {
  std::int64_t measured = 0;
  std::int64_t holes = 0;  ///< before any repair
  std::int64_t invented = 0;
  std::int64_t outliers = 0;
};

/// Planes and boxes that stand for a finer map, where a study reduces depth to them.
struct ModelRecord {
  int planes = 0;
  int boxes = 0;
  double explained_share = 0;    ///< of the solid angle in which there is depth; the rest follows the samples
  double relative_residual = 0;  ///< root mean square of (measured / model - 1) where it is explained
};

/// How far estimated depth is from the truth where both have a distance, before any repair: what the field of
/// depth estimation reports (sensors/files/estimate_error.h).
struct DepthErrorRecord {
  std::int64_t compared = 0;  ///< pixels
  double abs_rel = 0;         ///< mean of |d - d*| / d*
  double rmse_m = 0;          ///< root of the mean of (d - d*)^2
  double within_quarter = 0;  ///< "delta 1": share with max(d / d*, d* / d) < 1.25
};

struct MeshRecord {
  std::int64_t triangles = 0;
  double max_relative_error = 0;  ///< against what was captured, along its rays; 0 for the full mesh
  std::optional<SensorCounts> sensor = {};  ///< none of exact panoramas
  std::optional<ModelRecord> model = {};
  std::optional<DepthErrorRecord> depth_error = {};  ///< of estimated depth; of several sources together
};

/// One rendered stimulus as the manifest records it. Paths are relative to the set's folder.
struct ManifestStimulus {
  std::string id;
  Stimulus stimulus;
  Isolation isolation = Isolation::query;
  std::string image;
  std::string object_ids;  ///< 8-bit PNG: 0 background, objects from 1 on the left
  std::string reference;
  int spp = 0;
  std::int64_t rays = 0;       ///< traced for this stimulus
  std::optional<double> rmse;  ///< estimated noise, display units 0..1; none at 1 sample a pixel
  /// Of methods of real time: root mean square difference from the same stimulus traced, display units, with
  /// the noise of both.
  std::optional<double> pipeline_error = {};
  MeshRecord mesh;
  TinyDenominators tiny_denominators;
  double clipped_share = 0;  ///< share of channel values over display white
  std::string sha256;        ///< of the image file
  /// Of panoramas for each eye: `image` is the left eye's, these the others', from the left to the right.
  std::vector<EyePicture> more_eyes = {};
};

/// A reference picture and its click map: one for each truth, which is a scene with one light.
struct ManifestReference {
  std::string truth;  ///< as stimuli name it; the scene's name where the scene has one light
  std::string image, object_ids;
  std::string image_sha256, object_ids_sha256;
  std::vector<EyePicture> more_eyes = {};        ///< as of stimuli
  std::vector<EyePicture> more_object_ids = {};  ///< the click maps beside them
};

/// A rendered stimulus set: `SET/manifest.json`, byte-equal for equal input.
struct Manifest {
  std::string study_name;
  std::string study_hash;
  std::string study_file = "study.toml";  ///< copy of the study file, relative to the set
  std::string program_version;
  std::string instruction_set;        ///< Embree's; changes last bits
  std::vector<std::string> left_out;  ///< what was not computed, and why
  int width_px = 0, height_px = 0;
  std::vector<ManifestReference> references;
  std::vector<ManifestStimulus> stimuli;
};

/// The quantity of a set's levels; all its stimuli have one.
[[nodiscard]] Quantity level_quantity(const Manifest& manifest);

/// Throws InputError when there is no manifest, it is of another format or version, or a field is missing or
/// wrong.
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& set_folder);

/// Writes `manifest.json` atomically.
void write_manifest(const std::filesystem::path& set_folder, const Manifest& manifest);

/// One stimulus record as JSON text and back; what makes a finished stimulus known to a later run.
[[nodiscard]] std::string stimulus_record_text(const ManifestStimulus& record);
[[nodiscard]] ManifestStimulus stimulus_record_from_text(const std::string& text, const std::string& file);

/// SHA-256 of the manifest file's bytes: the set's identity in logs.
[[nodiscard]] std::string set_hash(const std::filesystem::path& set_folder);

}  // namespace seamline::inline stimuli
