#pragma once
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "study/trials/trial_clip.h"

namespace seamline::study::app {

/// How a clip was shown.
struct ClipShowing {
  std::int64_t shown = 0;    ///< frames that stood on the screen
  std::int64_t late = 0;     ///< of these, those that came more than two refreshes after their time
  std::int64_t dropped = 0;  ///< frames that never stood there, because the next one's time had come

  bool operator==(const ClipShowing&) const = default;
};

/// Shows the frames of one clip at their times: frame k from k / frames_per_s after the onset. Frames are
/// decoded ahead on a thread, at most `most_ahead` of them. Pure but for the thread: the clock is the
/// caller's.
class ClipPlayer {
 public:
  /// Frame 0 is on the screen already, as the trial's picture. `loops`: after the last frame comes the first.
  ClipPlayer(TrialClip clip, bool loops);
  ~ClipPlayer();
  ClipPlayer(const ClipPlayer&) = delete;
  ClipPlayer& operator=(const ClipPlayer&) = delete;

  /// The frame that is to replace the one on the screen at `now_ns` after the onset, if there is one; counts
  /// those that it passes over. Throws what decoding threw.
  [[nodiscard]] std::optional<ByteImage> take(std::int64_t now_ns);

  /// A swap has shown the frame taken last, `now_ns` after the onset; `refresh_ns` is the screen's.
  void note_shown(std::int64_t now_ns, std::int64_t refresh_ns);

  /// When the next frame is due, after the onset; none after the last.
  [[nodiscard]] std::optional<std::int64_t> next_due_ns() const;
  [[nodiscard]] int frame_on_screen() const { return static_cast<int>(on_screen_ % frames_); }
  [[nodiscard]] const ClipShowing& showing() const { return showing_; }

  static constexpr std::size_t most_ahead = 8;

 private:
  void decode_ahead();
  [[nodiscard]] std::int64_t time_of_ns(std::int64_t frame) const;

  TrialClip clip_;  ///< of the thread
  std::int64_t frames_;
  double frames_per_s_;
  bool loops_;
  std::int64_t on_screen_ = 0;  ///< counted on through repetitions
  bool is_new_ = false;         ///< it has been taken, and no swap has shown it yet
  ClipShowing showing_{.shown = 1};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<ByteImage> ahead_;  ///< the first follows the one on the screen
  std::exception_ptr failure_ = {};
  bool over_ = false;
  std::thread thread_;
};

}  // namespace seamline::study::app
