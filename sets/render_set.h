#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "sets/set_records.h"

namespace seamline::renderer {

/// What one process of a job does (renderer/cluster). A whole render does all of it.
enum class JobPart {
  whole,
  truth,    ///< one truth: its reference, and its truth pass for the others
  stimuli,  ///< some stimuli; the set's manifest is left to `join`
  join      ///< nothing is rendered: the manifest of a set whose stimuli are all there
};

/// What `seamline render` was asked for.
struct RenderRequest {
  std::filesystem::path set_folder;
  std::string only = {};             ///< pattern of stimulus ids, `*` stands for any text; empty: all
  int threads = 0;                   ///< 0: one for each core
  std::optional<int> spp = {};       ///< overrides the study's samples_per_pixel
  std::optional<double> error = {};  ///< instead: sample until the estimated error is below (display units)
  Estimator estimator = Estimator::fast;
  Omissions omit = {};                   ///< what the fast estimator leaves out
  std::optional<MeshDensity> mesh = {};  ///< overrides the study's mesh
  int shard = 1, shard_count = 1;        ///< this process renders every shard_count-th object of a scene
  JobPart part = JobPart::whole;
  std::string element = {};        ///< its name, where the job has several
  std::string job = {};            ///< folder of the job that has it
  std::string truth = {};          ///< of `JobPart::truth`
  std::set<std::string> ids = {};  ///< only these stimuli; empty: all
  bool layers = false;             ///< also write the float EXR layers of every stimulus
  bool contact_sheet = false;      ///< also write one contact sheet for each artifact
};

struct RenderSummary {
  int rendered = 0;
  int already_finished = 0;
  double seconds = 0;
  std::vector<std::string> notes;                        ///< what whoever asked must know, a sentence each
  std::vector<std::pair<std::string, Savings>> savings;  ///< of each scene rendered
};

/// The study's own settings with what was asked for.
[[nodiscard]] RenderSettings render_settings(const StudyDefinition& study, const RenderRequest& request);

/// Renders a study into a set: references, stimuli, manifest. Stimuli that are finished already are kept.
/// Throws InputError for wrong input and Interrupted when the person stopped it; what was finished stays and
/// a rerun continues.
RenderSummary render_set(const StudyDefinition& study, const RenderRequest& request);

}  // namespace seamline::renderer
