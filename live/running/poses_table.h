#pragma once
#include <filesystem>
#include <vector>

#include "live/physics/falling_bodies.h"
#include "live/running/live_request.h"
#include "live/running/times_table.h"
#include "support/text/csv.h"

namespace seamline::live {

/// Where the things that fall were in each frame that was shown; a row for each of them.
class PosesTable {
 public:
  /// `time_s`: the frame's, of the recording.
  void add(std::size_t frame_index, double time_s, const FallingBodies& bodies);
  [[nodiscard]] const CsvTable& table() const { return table_; }

 private:
  CsvTable table_ = empty_table();
  std::int64_t shown_ = 0;

  [[nodiscard]] static CsvTable empty_table();
};

/// Writes the times into `request.csv` and the poses, where things fall, beside it; nothing where that is
/// empty.
void write_tables(const LiveRequest& request, const std::vector<TimedFrame>& timed, const PosesTable& poses);

/// times.csv: times_poses.csv, in the same folder.
[[nodiscard]] std::filesystem::path poses_file(const std::filesystem::path& times_file);

}  // namespace seamline::live
