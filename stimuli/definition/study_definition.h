#pragma once
#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "stimuli/definition/axis.h"
#include "stimuli/definition/consent_definition.h"
#include "stimuli/definition/depth_chain.h"
#include "stimuli/definition/form_definition.h"
#include "stimuli/definition/instructions_definition.h"
#include "stimuli/definition/interface_texts.h"
#include "stimuli/definition/light_definition.h"
#include "stimuli/definition/methods/pipeline.h"
#include "stimuli/definition/mitigation.h"
#include "stimuli/definition/procedure_definition.h"
#include "stimuli/definition/quantity.h"
#include "stimuli/definition/session_definition.h"
#include "stimuli/definition/surface/material_model.h"
#include "stimuli/definition/surface/mesh_albedo.h"
#include "stimuli/definition/views/view.h"

namespace seamline::inline stimuli {

// Parts that most studies do not name. Each is described in a header of its own and is held by a pointer, so
// that a change of one part meets only the files that use it.
struct ClipDefinition;         // clip_definition.h
struct LanguageDefinitions;    // language_definition.h
struct LookDefinition;         // look_definition.h
struct RecruitmentDefinition;  // recruitment_definition.h
struct TaskDefinition;         // task_definition.h

/// An object put into a scene: which file, and where. Applied to the file's vertices as
/// position + R(rotation) * (scale * vertex), R = Ry(yaw) Rx(pitch) Rz(roll), right-handed, +Y up.
struct ObjectDefinition {
  std::string name;            ///< unique in its scene; part of stimulus ids
  std::string file;            ///< as written: `builtin:statue` or a path beside the study file
  std::filesystem::path path;  ///< resolved
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_deg = Eigen::Vector3d::Zero();  ///< pitch about X, yaw about Y, roll about Z
  double scale = 1.0;
  bool exempt_from_shape_rules = false;  ///< `check` leaves out area and silhouette rules (paper: the teapot)
  bool rest = false;  ///< it is let down from there, and stands where it comes to rest on the background
};

enum class MeshDensity { adaptive, full };

/// How the depth map of a stimulus is captured, and the mesh rebuilt from it.
struct DepthSettings {
  int width_px = 0;       ///< W of the panorama, or of the (first) sensor; even
  double yaw_texels = 0;  ///< the panorama is turned by so many of its own texels; their fraction is the
                          ///< phase of the sampling grid
  MeshDensity mesh = MeshDensity::adaptive;
  double mesh_tolerance = 1e-4;          ///< relative error along the ray that the adaptive mesh may make
  std::optional<DepthChain> chain = {};  ///< none: the paper's exact panorama
  MeshAlbedo albedo = MeshAlbedo::constant;
  Mitigation mitigation = {};
  Pipeline pipeline = {};

  [[nodiscard]] int height_px() const;  ///< of the panorama W / 2
  auto operator<=>(const DepthSettings&) const = default;
};

/// A pinhole camera. Its position is also the centre of the panoramic depth maps.
struct CameraDefinition {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d look_at_m = -Eigen::Vector3d::UnitZ();
  double horizontal_fov_deg = 60.0;
};

/// A background with three objects, and what light does in it.
struct SceneDefinition {
  std::string name;
  std::string file;
  std::filesystem::path path;
  std::vector<Artifact> artifacts;
  std::vector<ObjectDefinition> objects;                   ///< left, middle, right
  std::optional<SunDefinition> sun;                        ///< none: the scene file's own
  std::optional<std::vector<SunDefinition>> suns;          ///< several, in place of `sun`; none: likewise
  std::optional<std::vector<LampDefinition>> lamps;        ///< none: the scene file's own
  std::optional<EnvironmentDefinition> environment;        ///< none: constant
  std::optional<CameraDefinition> camera;                  ///< none: the scene file's own (its first camera)
  std::array<double, 3> environment_radiance = {1, 1, 1};  ///< constant environment, W/m2/sr, linear RGB
  bool ambient_occlusion = false;  ///< no sun, no bounce; visibility up to ao_distance_m
  double ao_distance_m = 2.0;
  int bounces = 4;           ///< further diffuse scatterings after the first
  double albedo = 0.5;       ///< of the depth mesh, and of meshes without a material
  double exposure_ev = 0.0;  ///< display = linear * 2^exposure_ev
  MaterialModel materials = MaterialModel::diffuse;
  /// Of all virtual objects, in place of their files' own; with the glTF model only.
  std::optional<double> object_metallic = {}, object_roughness = {};
  /// Of every sun of the scene, in place of its own; none: its own (0 for those of a scene file).
  std::optional<double> sun_radius_deg = {};
  View view = {};  ///< how its pictures are shown
  /// Names the scene with this light among the truths of a study (`list_truths`): the scene's name, followed
  /// by condition and level where these change the light. Empty in a study's own list of scenes.
  std::string truth = {};
};

/// A picture shown pixel for pixel on a full-HD screen 0.531 m wide (24 inches) from 0.6 m, rounded.
inline constexpr double default_pixels_per_degree = 38;

/// What the simulated observers `threshold` and `image` are made of. The planted widths are not the paper's.
struct ObserverDefinition {
  /// In the level's unit. An artifact without one cannot be simulated.
  std::map<Artifact, double> midpoint = {{Artifact::receiver, 300},  {Artifact::shadow, 180},
                                         {Artifact::occlusion, 620}, {Artifact::overlap, 900},
                                         {Artifact::bounce, 150},    {Artifact::all, 900},
                                         {Artifact::none, 1}};
  /// Of conditions that have midpoints of their own, whole.
  std::map<std::string, std::map<Artifact, double>> condition_midpoint = {};
  /// P(seen) = 1 / (1 + exp((x - m - shift) / scale)), where x and m are level and midpoint on the level's
  /// axis.
  double scale_octaves = 0.5;
  double scale_linear = 1;  ///< the same on linear axes, in the level's unit
  /// `increasing`: the `threshold` observer sees with 1 / (1 + exp(-(x - m - shift) / scale)).
  Direction direction = Direction::decreasing;
  double people_sd_octaves = 0.5;  ///< standard deviation of a person's shift
  double people_sd_linear = 1;     ///< the same on linear axes, in the level's unit
  /// `image` sees with P = 1 / (1 + exp(-(log2(gain F) + shift) / scale)), F the visible difference of
  /// stimulus and reference (stimuli/pictures/visible_difference.h); 1 / gain is what is seen half of the
  /// time. None: `seamline predict` takes that of published
  /// detection thresholds (documentation/how-to/predict_and_plan.md).
  std::optional<double> image_gain = {};
  double pixels_per_degree = default_pixels_per_degree;  ///< at which people see the pictures
};

/// How light is computed: `path` traces every path to its end and is the reference; `fast` shares between
/// stimuli and filters bounce light, with its bias in the reported error.
enum class Estimator { fast, path };

/// What the curves of a study run over.
struct LevelDefinition {
  Quantity quantity = Quantity::depth_width_px;
  std::vector<double> values;                       ///< rising, each once
  Direction noticeability = Direction::decreasing;  ///< as the level grows

  [[nodiscard]] Axis axis() const { return facts(quantity).axis; }
};

/// A named set of settings. Everything else is the study's own, or the level's.
struct ConditionDefinition {
  std::string name;  ///< unique; lower-case letters, digits and _
  Isolation isolation = Isolation::query;
  DepthSettings depth;
  std::vector<SceneDefinition> scenes;              ///< the study's, with this condition's light
  std::shared_ptr<const TaskDefinition> task = {};  ///< none: the study's
  std::shared_ptr<const LookDefinition> look = {};  ///< none: the study's
  std::string instructions = {};                    ///< read before its block of trials; empty: nothing
};

/// A whole study: everything that decides what people are shown. Defaults are the paper's where it has any.
struct StudyDefinition {
  std::string name;
  std::filesystem::path file;  ///< where it was read from
  Isolation isolation = Isolation::query;
  int width_px = 960;
  int height_px = 540;
  int samples_per_pixel = 64;
  std::uint64_t seed = 1;
  DepthSettings depth;  ///< the width is 0 where it is the level
  LevelDefinition level;
  std::vector<SceneDefinition> scenes;
  std::vector<ConditionDefinition> conditions;  ///< none: the study's own settings alone
  SessionDefinition session;
  ProcedureDefinition procedure;
  ObserverDefinition observer;
  CatchDefinition catches;
  TrainingDefinition training;
  ConsentDefinition consent = default_consent();
  std::vector<FormField> form = default_form();
  std::vector<InstructionPage> instructions = default_instructions();
  InterfaceTexts texts;
  std::shared_ptr<const TaskDefinition> task = {};  ///< none: which of three objects was inserted
  std::shared_ptr<const ClipDefinition> clip = {};  ///< none: stills
  std::shared_ptr<const LookDefinition> look = {};  ///< none: one fixed view
  std::shared_ptr<const RecruitmentDefinition> recruitment = {};  ///< none: nobody is matched or sent back
  std::shared_ptr<const LanguageDefinitions> languages = {};      ///< none: one language, `texts`
};

[[nodiscard]] std::string_view word(MeshDensity density);
[[nodiscard]] std::string_view word(Estimator estimator);

/// The conditions of a study: those it names, or its own settings as one without a name.
[[nodiscard]] std::vector<ConditionDefinition> list_conditions(const StudyDefinition& study);

/// The view whose screen the pictures of a study are made for, an interleaved one before others; none: any
/// screen.
[[nodiscard]] std::optional<View> panel_view(const StudyDefinition& study);

/// The meaning of a study as text, independent of layout, order of keys and where its files lie; what its
/// hash is over.
[[nodiscard]] std::string canonical_text(const StudyDefinition& study);

/// The same for one scene: what its pictures depend on, besides the bytes of its files.
[[nodiscard]] std::string canonical_text(const SceneDefinition& scene);

/// SHA-256 of `canonical_text`.
[[nodiscard]] std::string study_hash(const StudyDefinition& study);

}  // namespace seamline::inline stimuli
