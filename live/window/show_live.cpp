#include "live/window/show_live.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <deque>

#include "live/running/live_session.h"
#include "live/running/poses_table.h"
#include "support/running/interrupt.h"
#include "window/canvas.h"
#include "window/look.h"
#include "window/type/find_font.h"
#include "window/window.h"
#include "window/window_texture.h"

namespace seamline::live {
namespace {

constexpr int panel_width_px = 330, least_height_px = 560, widest_picture_px = 1280;
constexpr double longest_wait_s = 0.1, type_px = 16, margin_px = 18;
constexpr std::size_t frames_in_mean = 15;  ///< of the times on the screen, so that they can be read

template <class Values>
void go_on(typename Values::value_type& value, const Values& every) {
  const auto at = std::find(every.begin(), every.end(), value);
  value = at == every.end() || at + 1 == every.end() ? every.front() : *(at + 1);
}

/// The window, its type, and where things are.
class LiveWindow {
 public:
  explicit LiveWindow(const LiveRequest& request)
      : request_(request),
        methods_(request.methods),
        session_(request),
        scale_(std::min(1.0, static_cast<double>(widest_picture_px) / pictures_width_px())),
        window_({.title = "Seamline live",
                 .fullscreen = false,
                 .width_px = static_cast<int>(pictures_width_px() * scale_) + panel_width_px,
                 .height_px = std::max(least_height_px,
                                       static_cast<int>(session_.recording().view.height_px * scale_))}),
        textures_(static_cast<std::size_t>(request.settings.views)) {
    FontRequest font = find_font({});
    font.body_px = type_px;
    canvas_.set_font(font);
  }

  void run() {
    while (!leaves_ && (request_.frames == 0 || shown_ < request_.frames)) {
      stop_if_interrupted();
      react(window_.next_input(waits_ ? longest_wait_s : wait_s()));
      if (leaves_) break;
      if (is_due()) show_frame();
    }
    write_tables(request_, timed_, poses_);
  }

 private:
  [[nodiscard]] double pictures_width_px() const {
    return static_cast<double>(session_.recording().view.width_px) * request_.settings.views;
  }

  void react(const FrameInput& input) {
    if (input.close || input.pressed(Key::escape)) leaves_ = true;
    if (input.pressed(Key::space)) waits_ = !waits_, due_ns_ = monotonic_ns();
    if (input.pressed(Key::letter) && !input.key->repeated) {
      const char letter = input.key->letter;
      if (letter == 'q') leaves_ = true;
      if (letter == 'm') go_on(methods_.mapping, every_mapping);
      if (letter == 'o') go_on(methods_.occlusion, every_occlusion);
      if (letter == 's') go_on(methods_.shadows, every_shadows);
      if (request_.physics && letter == 'd') session_.let_go(), redraws_ = true;
      if (request_.physics && letter == 'p')
        holds_bodies_ = !holds_bodies_, session_.hold_bodies(holds_bodies_), redraws_ = true;
      if (letter == 'm' || letter == 'o' || letter == 's') redraws_ = true, recent_.clear();
    }
    if (input.pressed(Key::right)) waits_ = true, steps_ = true;
    redraws_ = redraws_ || (waits_ && input.anything);
  }

  [[nodiscard]] double wait_s() const {
    return std::clamp(static_cast<double>(due_ns_ - monotonic_ns()) * 1e-9, 0.0, longest_wait_s);
  }
  [[nodiscard]] bool is_due() const { return redraws_ || steps_ || (!waits_ && monotonic_ns() >= due_ns_); }

  void show_frame() {
    const bool moves_on =
        shown_ == 0 || steps_ || (!waits_ && !redraws_) || (!waits_ && monotonic_ns() >= due_ns_);
    const std::int64_t frame_begun_ns = monotonic_ns();
    const LiveSession::Step step = moves_on ? session_.next(methods_) : session_.again(methods_);
    steps_ = redraws_ = false;
    {
      const StageTimer timer(step.frame.times, FrameStage::show);
      draw(step);
      window_.clear(look::background);
      canvas_.end();
      window_.show();
    }
    if (!moves_on) return;
    ++shown_;
    keep(step);
    const auto& frames = session_.recording().frames;
    const std::size_t next = step.frame_index + 1;
    const double until_next_s =
        next < frames.size() ? frames[next].time_s - frames[step.frame_index].time_s : 0;
    due_ns_ = frame_begun_ns + static_cast<std::int64_t>(until_next_s * 1e9);
  }

  void keep(const LiveSession::Step& step) {
    const TimedFrame timed{.frame_index = step.frame_index,
                           .time_s = session_.recording().frames[step.frame_index].time_s,
                           .methods = methods_,
                           .times = step.frame.times,
                           .is_tracked = step.pose.is_found};
    if (!request_.csv.empty()) {
      timed_.push_back(timed);
      if (session_.bodies() != nullptr) poses_.add(timed.frame_index, timed.time_s, *session_.bodies());
    }
    recent_.push_back(timed);
    if (recent_.size() > frames_in_mean) recent_.pop_front();
  }

  void draw(const LiveSession::Step& step) {
    canvas_.begin(window_.framebuffer_px());
    double left_px = 0;
    for (std::size_t i = 0; i < textures_.size(); ++i) {
      textures_[i].upload(step.frame.eyes[i].codes);
      textures_[i].smooth(scale_ < 1);
      const Rect place{left_px, 0, std::round(textures_[i].width_px() * scale_),
                       std::round(textures_[i].height_px() * scale_)};
      canvas_.picture(textures_[i], place);
      left_px = place.right_px();
    }
    draw_panel({left_px, 0, static_cast<double>(panel_width_px), window_.framebuffer_px().height_px}, step);
  }

  void line(const Rect& panel, double& y_px, const std::string& left, const std::string& right, Font font) {
    canvas_.text(font, {panel.x_px + margin_px, y_px}, left, look::ink);
    const double width_px = canvas_.measure(font, right).width_px;
    canvas_.text(font, {panel.right_px() - margin_px - width_px, y_px}, right, look::ink);
    y_px += 1.35 * canvas_.size_px(font);
  }

  void draw_panel(const Rect& panel, const LiveSession::Step& step) {
    canvas_.fill(panel, look::card);
    double y_px = margin_px;
    line(panel, y_px, fmt::format("frame {} of {}", step.frame_index + 1, session_.recording().frames.size()),
         waits_ ? "paused" : "", Font::heading);
    y_px += 8;
    line(panel, y_px, "m  mapping", std::string(word(methods_.mapping)), Font::body);
    line(panel, y_px, "o  occlusion", std::string(word(methods_.occlusion)), Font::body);
    line(panel, y_px, "s  shadows", std::string(word(methods_.shadows)), Font::body);
    if (request_.physics) {
      line(panel, y_px, "d  drop again", fmt::format("{:.1f} s", session_.bodies()->simulated_s()),
           Font::body);
      line(panel, y_px, "p  physics", holds_bodies_ ? "stopped" : "on", Font::body);
    }
    y_px += 12;
    draw_times(panel, y_px);
    y_px += 12;
    line(panel, y_px, "local scene", fmt::format("{} triangles", step.frame.triangles), Font::small);
    line(panel, y_px, "virtual", fmt::format("{} triangles", session_.virtual_triangles()), Font::small);
    if (request_.tracking == Tracking::features || request_.tracking == Tracking::marker)
      line(panel, y_px, std::string("camera by ") + std::string(word(request_.tracking)),
           !step.pose.is_found                       ? "lost"
           : request_.tracking == Tracking::features ? fmt::format("{} corners", step.pose.features)
                                                     : "found",
           Font::small);
    y_px = panel.bottom_px() - margin_px - 3 * 1.35 * canvas_.size_px(Font::small);
    line(panel, y_px, "space", "pause", Font::small);
    line(panel, y_px, "right arrow", "one frame", Font::small);
    line(panel, y_px, "Esc", "leave", Font::small);
  }

  /// Means over the last frames.
  void draw_times(const Rect& panel, double& y_px) {
    if (recent_.empty()) return;
    double total_ms = 0;
    for (std::size_t i = 0; i < stage_count; ++i) {
      double ms = 0;
      for (const TimedFrame& frame : recent_) ms += frame.times.ms[i] / recent_.size();
      total_ms += ms;
      if (ms > 0)
        line(panel, y_px, std::string(word(static_cast<FrameStage>(i))), fmt::format("{:.1f} ms", ms),
             Font::body);
    }
    line(panel, y_px, "sum", fmt::format("{:.1f} ms, {:.0f} a second", total_ms, 1000 / total_ms),
         Font::body);
  }

  const LiveRequest& request_;
  Methods methods_;
  LiveSession session_;
  double scale_;
  Window window_;
  Canvas canvas_;
  std::vector<WindowTexture> textures_;
  std::deque<TimedFrame> recent_;
  std::vector<TimedFrame> timed_;
  PosesTable poses_;
  std::int64_t due_ns_ = 0;
  int shown_ = 0;
  bool leaves_ = false, waits_ = false, steps_ = false, redraws_ = false, holds_bodies_ = false;
};

}  // namespace

void show_live(const LiveRequest& request) {
  require_display();
  LiveWindow(request).run();
}

}  // namespace seamline::live
