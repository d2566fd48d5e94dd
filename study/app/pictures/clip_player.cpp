#include "study/app/pictures/clip_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seamline::study::app {

ClipPlayer::ClipPlayer(TrialClip clip, bool loops)
    : clip_(std::move(clip)),
      frames_(clip_.frames()),
      frames_per_s_(clip_.frames_per_s()),
      loops_(loops),
      thread_([this] { decode_ahead(); }) {}

ClipPlayer::~ClipPlayer() {
  {
    const std::scoped_lock lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ClipPlayer::decode_ahead() {
  try {
    static_cast<void>(clip_.next());  // frame 0 is shown already
    for (std::int64_t frame = 1; loops_ || frame < frames_; ++frame) {
      ByteImage picture = clip_.next();
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return over_ || ahead_.size() < most_ahead; });
      if (over_) return;
      ahead_.push_back(std::move(picture));
    }
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::current_exception();
  }
}

std::int64_t ClipPlayer::time_of_ns(std::int64_t frame) const {
  return std::llround(1e9 * frame / frames_per_s_);
}

std::optional<ByteImage> ClipPlayer::take(std::int64_t now_ns) {
  auto wanted = static_cast<std::int64_t>(std::floor(1e-9 * now_ns * frames_per_s_ + 1e-6));
  if (!loops_) wanted = std::min(wanted, frames_ - 1);
  std::optional<ByteImage> newest;
  const std::scoped_lock lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  while (on_screen_ < wanted && !ahead_.empty()) {
    if (newest || is_new_) ++showing_.dropped;
    newest = std::move(ahead_.front());
    ahead_.pop_front();
    ++on_screen_;
    is_new_ = false;
  }
  if (newest) {
    is_new_ = true;
    changed_.notify_all();
  }
  return newest;
}

void ClipPlayer::note_shown(std::int64_t now_ns, std::int64_t refresh_ns) {
  if (!is_new_) return;
  is_new_ = false;
  ++showing_.shown;
  if (now_ns - time_of_ns(on_screen_) > 2 * refresh_ns) ++showing_.late;
}

std::optional<std::int64_t> ClipPlayer::next_due_ns() const {
  if (!loops_ && on_screen_ + 1 >= frames_) return std::nullopt;
  return time_of_ns(on_screen_ + 1);
}

}  // namespace seamline::study::app
