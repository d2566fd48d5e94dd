#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "renderer/transport/omissions.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// How a set is rendered: the study's own settings with what the command line overrides.
struct RenderSettings {
  int spp = 64;
  std::uint64_t seed = 1;
  std::optional<MeshDensity> mesh = {};  ///< in place of each stimulus' own
  Estimator estimator = Estimator::fast;
  std::optional<double> error = {};  ///< display units; instead of a number of samples
  Omissions omit = {};
};

/// A hash over everything a picture depends on: program, instruction set, scene, the bytes of its files,
/// settings. A finished picture whose inputs hash the same is not rendered again.
class InputHashes {
 public:
  InputHashes(const StudyDefinition& study, const RenderSettings& settings);
  [[nodiscard]] std::string of_stimulus(const Stimulus& stimulus) const;
  [[nodiscard]] std::string of_reference(const std::string& truth) const;
  [[nodiscard]] std::string of_set() const;  ///< over everything that any of its pictures depends on

 private:
  std::string common_;
  [[nodiscard]] std::string isolation_and_mesh(const Stimulus& stimulus) const;

  std::optional<MeshDensity> mesh_;
  std::set<std::string> settings_;                            ///< isolations and meshes of the study
  std::map<std::string, std::string> truths_;                 ///< scenes and their files, by truth
  std::map<std::filesystem::path, std::string> depth_files_;  ///< hashes of depth maps that lie in files
  std::map<std::string, std::string> captured_;  ///< scenes that late depth is of, by stimulus id
};

/// Finished pieces of a set, one small file each in `SET/records/`: what lets an interrupted job continue.
class SetRecords {
 public:
  explicit SetRecords(std::filesystem::path set_folder);

  /// The record of a finished stimulus whose inputs hash to `inputs` and whose picture still has its recorded
  /// hash.
  [[nodiscard]] std::optional<ManifestStimulus> finished(const std::string& id,
                                                         const std::string& inputs) const;
  void finish(const ManifestStimulus& record, const std::string& inputs) const;

  [[nodiscard]] std::optional<ManifestReference> finished_reference(const std::string& truth,
                                                                    const std::string& inputs) const;
  void finish_reference(const ManifestReference& reference, const std::string& inputs) const;

 private:
  std::filesystem::path set_folder_;
};

}  // namespace seamline::renderer
