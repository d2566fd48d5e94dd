#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sets/true_error_set.h"
#include "stimuli/set/manifest.h"
#include "support/text/csv.h"

namespace seamline::renderer {

/// What is known of one stimulus: what it cost and how wrong it is (display units, 0 to 1).
struct StimulusErrorRow {
  std::string id;
  Artifact artifact = Artifact::none;
  std::optional<double> seconds;  ///< of its own pass; what it shares with others is in `SetSeconds`
  std::int64_t rays = 0;
  int spp = 0;
  std::optional<double> estimated, estimated_worst_tile;
  std::optional<double> rare_light;    ///< `rare_light_share`
  std::optional<double> change = {};   ///< of a clip: estimated, of the change from frame to frame
  int changes_known = 0, changes = 0;  ///< how many of its changes that is known of
  std::optional<TrueErrorRecord> measured;
};

/// Where a set's time went. Pieces that other processes made (shards) are summed.
struct SetSeconds {
  double references = 0;  ///< pictures with all objects in place, and what their scenes share
  double truth = 0;       ///< of one object each
  double meshes = 0;      ///< depth maps, meshes and their hierarchies
  double stimuli = 0;
  [[nodiscard]] double total() const { return references + truth + meshes + stimuli; }
};

struct SetErrors {
  std::string study_name;
  int width_px = 0, height_px = 0;
  int threads = 0;
  std::string machine;
  SetSeconds seconds;
  std::int64_t rays = 0;  ///< of everything
  std::vector<StimulusErrorRow> rows;
  bool of_clips = false;

  [[nodiscard]] int measured() const;
  [[nodiscard]] int above_estimate() const;          ///< of the measured: the true error exceeds the estimate
  [[nodiscard]] int clearly_above_estimate() const;  ///< by more than two standard errors
};

/// Reads what a rendered set says of itself: manifest, timings, true errors.
[[nodiscard]] SetErrors read_set_errors(const std::filesystem::path& set_folder);

/// Whether stimuli ended above the error that was asked for (`--error`: over the picture, and three times
/// that in its worst tile), which ones and by how much. More samples do not lower every error, and a picture
/// gets only so many. Empty where none did.
[[nodiscard]] std::vector<std::string> sentences_on_missed(const SetErrors& errors, double asked);

/// Which stimuli's estimated errors hang on a few pixels (`much_rare_light`), and what to do. Empty where
/// none do.
[[nodiscard]] std::vector<std::string> sentences_on_rare_light(const SetErrors& errors);

/// Which true errors are too large, because their references have too few samples, and what to do. Empty
/// where none are.
[[nodiscard]] std::vector<std::string> sentences_on_noisy_references(const SetErrors& errors);

/// What is known of the error of clips, over their frames and of the changes between them. Empty of stills.
[[nodiscard]] std::vector<std::string> sentences_on_changes(const SetErrors& errors);

/// One row a stimulus.
[[nodiscard]] CsvTable errors_table(const SetErrors& errors);

}  // namespace seamline::renderer
