#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace seamline::renderer {

/// What else is known of a stimulus' estimated error.
struct ErrorNotes {
  std::optional<double> worst_tile = {};
  std::optional<double> rare_light = {};       ///< `rare_light_share`, where an error was asked for
  std::map<std::string, double> changes = {};  ///< of a clip's frame: `FrameChanges::add`
};

/// `SET/timings.json`: how long each piece of a set took, on which machine, and a stimulus' estimated error
/// in its worst tile. Not part of the manifest, because it differs from run to run.
class Timings {
 public:
  /// A process that renders a part of the set writes `timings-PART.json` of its own, because parts are
  /// rendered at once; `part` is empty for the whole.
  Timings(const std::filesystem::path& set_folder, int threads, const std::string& part)
      : path_(set_folder / ("timings" + (part.empty() ? part : "-" + part) + ".json")), threads_(threads) {}
  void add(const std::string& piece, double seconds, std::int64_t rays, const ErrorNotes& notes = {}) {
    pieces_.push_back({piece, seconds, rays, notes});
  }
  /// Adds this run's pieces to those of earlier runs, newer ones replacing older.
  void write(double total_seconds) const;

 private:
  struct Piece {
    std::string name;
    double seconds;
    std::int64_t rays;
    ErrorNotes notes;
  };
  std::filesystem::path path_;
  int threads_;
  std::vector<Piece> pieces_;
};

}  // namespace seamline::renderer
