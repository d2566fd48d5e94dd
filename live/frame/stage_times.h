#pragma once
#include <array>
#include <chrono>
#include <string_view>

namespace seamline::live {

/// What a frame's time goes into, in the order in which it is done.
enum class FrameStage {
  tracking,     ///< where the camera stands, where the recording does not say it
  physics,      ///< virtual things fall (only where that is asked for)
  local_scene,  ///< the mesh of the depth pixels
  mapping,      ///< depth brought into the picture's pixels
  tree,         ///< what rays into the local scene need
  maps,         ///< shadow maps of object and local scene
  views,        ///< the picture as other eyes see it
  object,       ///< virtual things: rays, who is in front, their light
  shadow,       ///< their shadow on real surfaces
  show          ///< into the window
};
inline constexpr std::size_t stage_count = 10;

[[nodiscard]] std::string_view word(FrameStage stage);

/// Milliseconds of each stage of a frame.
struct StageTimes {
  std::array<double, stage_count> ms{};

  [[nodiscard]] double of(FrameStage stage) const { return ms[static_cast<std::size_t>(stage)]; }
  void add(FrameStage stage, double more_ms) { ms[static_cast<std::size_t>(stage)] += more_ms; }
  [[nodiscard]] double total_ms() const;
};

/// Adds the time until it ends to a stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, FrameStage stage) : times_(times), stage_(stage) {}
  ~StageTimer() {
    times_.add(stage_, std::chrono::duration<double, std::milli>(Clock::now() - begun_).count());
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  StageTimes& times_;
  FrameStage stage_;
  Clock::time_point begun_ = Clock::now();
};

}  // namespace seamline::live
