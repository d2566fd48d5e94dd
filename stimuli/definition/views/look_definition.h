#pragma once
#include <array>
#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace seamline::inline stimuli {

/// How a participant's view of a panorama moves. `fixed`: it does not. `mouse`: by dragging it, and by the
/// arrow keys. `head`: as the head turns in a headset that the browser knows (WebXR).
enum class LookKind { fixed, mouse, head };

/// What people see of a stimulus in all directions: a perspective view from its centre, like a pinhole
/// camera's. Angles: yaw to the right from the scene camera's direction, pitch up from the horizon.
struct LookDefinition {
  LookKind kind = LookKind::fixed;
  std::array<int, 2> view_px = {960, 540};  ///< the view's width and height on the screen
  double horizontal_fov_deg = 60;           ///< of the view; of a headset its own
  std::optional<std::array<double, 2>> start_deg =
      {};                       ///< yaw, pitch; none: whither the scene's camera looks
  double start_spread_deg = 0;  ///< each trial begins at most so far to the left or right of it, as drawn
  std::array<double, 2> yaw_deg = {-180, 180};  ///< between which it can be turned; all round
  std::array<double, 2> pitch_deg = {-90, 90};
  /// The least and the largest field that keys lead to; none: it stays.
  std::optional<std::array<double, 2>> fov_limits_deg = {};
  /// Whether a view that the mouse turns is also turned by a phone or tablet that is turned itself, in pages.
  bool follows_device = false;
  /// Beside the question, of a view that turns. Not part of the meaning: it can be edited in a rendered set.
  std::string hint =
      "Drag, or press arrow keys, to look round. Click an object, or put the cross on it and press Enter.";
  /// Asked at every break, with one of five answers, which the log keeps; empty: nothing is asked. Not part
  /// of the meaning either.
  std::string comfort_question = {};
  std::array<std::string, 5> comfort_labels = {"Not at all", "A little", "Moderately", "Strongly",
                                               "Very strongly"};

  [[nodiscard]] bool is_all_round() const { return yaw_deg[1] - yaw_deg[0] >= 360; }
  auto operator<=>(const LookDefinition&) const = default;
};

[[nodiscard]] std::string_view word(LookKind kind);
/// "mouse, view 960 x 540 px, 60 degrees, ...": the whole meaning.
[[nodiscard]] std::string canonical_text(const LookDefinition& look);

}  // namespace seamline::inline stimuli
