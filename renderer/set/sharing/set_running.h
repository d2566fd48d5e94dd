#pragma once
#include <chrono>
#include <filesystem>
#include <string>

namespace seamline::renderer {

/// This process' mark in `SET/records/running/NAME.json`: host, how many of its stimuli are done. Written
/// again at least every ten seconds while work goes on, so that an old mark is a process that died; removed
/// at the end, also of an interrupted job; what ends with a complaint leaves it there, with the complaint.
class RunningMark {
 public:
  /// `name` is the element's, or a random one; `stimuli` is how many it has to do.
  RunningMark(const std::filesystem::path& set_folder, std::string name, int stimuli);
  ~RunningMark();
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;

  void finished_one();
  /// Cheap enough to be called for every tile.
  void alive();
  /// Leaves the mark, with why the work failed.
  void failed(const std::string& complaint);

 private:
  void write(const std::string& complaint);

  std::filesystem::path path_;
  std::string name_;
  int stimuli_;
  int done_ = 0;
  bool failed_ = false;
  std::chrono::steady_clock::time_point written_{};
};

/// A mark's age in seconds from which on its process is taken for dead.
inline constexpr double dead_after_s = 90;

}  // namespace seamline::renderer
