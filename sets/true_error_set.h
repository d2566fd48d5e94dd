#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// What `seamline render --true-error` was asked for.
struct TrueErrorRequest {
  std::filesystem::path set_folder;
  std::string pattern = {};  ///< of stimulus ids
  int spp = 64;              ///< of the references
  int threads = 0;           ///< 0: one for each core
  std::optional<MeshDensity> mesh = {};
};

/// The true error of a stimulus, display units, as `SET/true_errors.json` keeps it.
struct TrueErrorRecord {
  double rmse = 0;
  double standard_error = 0;
  double worst_tile = 0;         ///< of the worst 32 x 32 tile
  bool noisy_reference = false;  ///< `TrueError::reference_is_noisy`
  int reference_spp = 0;         ///< of the `path` reference it was measured against
  std::string picture_sha256;    ///< of the picture that was measured
};
using TrueErrors = std::map<std::string, TrueErrorRecord>;  ///< by stimulus id

/// Renders the finished stimuli of a set that match once more by the `path` estimator with another seed, and
/// measures each picture against that. Writes `SET/true_errors.json` after every stimulus, so that an
/// interrupted job continues, and `SET/worst-tile-ID.png`: the worst tile, the same tile of the reference,
/// and their difference. Results for unchanged pictures are kept. Throws InputError when no finished stimulus
/// matches, Interrupted when the person stopped it.
void measure_true_errors(const StudyDefinition& study, const TrueErrorRequest& request);

/// What `SET/true_errors.json` holds; empty when there is none or it cannot be read.
[[nodiscard]] TrueErrors read_true_errors(const std::filesystem::path& set_folder);
void write_true_errors(const std::filesystem::path& set_folder, const TrueErrors& errors);

}  // namespace seamline::renderer
