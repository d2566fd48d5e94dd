#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "support/files/image.h"
#include "window/geometry.h"
#include "window/input.h"

namespace seamline::inline window {

/// What the pictures are shown on.
struct DisplayInfo {
  std::string monitor;                  ///< its name
  int mode_width = 0, mode_height = 0;  ///< of the monitor, in its own units
  int refresh_hz = 0;                   ///< 0: not known
  int physical_width_mm = 0;            ///< as the monitor says; 0: not known
  double content_scale = 1;             ///< the desktop's
  int framebuffer_width_px = 0, framebuffer_height_px = 0;
  std::string graphics;  ///< the renderer's name
};

struct WindowRequest {
  std::string title;
  bool fullscreen = true;
  int width_px = 1280, height_px = 800;  ///< of a window that is not fullscreen
  bool resizable = false;                ///< by the person
};

/// Monotonic nanoseconds of the clock that all of a session's times are read from.
[[nodiscard]] std::int64_t monotonic_ns();

/// Throws InputError when there is no screen at all.
void require_display();

/// The window and its OpenGL context: the only GLFW in Seamline. Throws InputError where there is no display
/// or no OpenGL 3.
class Window {
 public:
  explicit Window(const WindowRequest& request);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for input at most `timeout_s` (0: only looks; none: until something happens), and returns what the
  /// next frame reacts to. A window that waits uses no processor time.
  [[nodiscard]] FrameInput next_input(std::optional<double> timeout_s);

  [[nodiscard]] Size framebuffer_px() const;
  [[nodiscard]] DisplayInfo display() const;
  [[nodiscard]] bool focused() const;

  /// Fills the framebuffer.
  void clear(Colour colour);

  /// Shows what was drawn. Returns the time at which the swap was done.
  std::int64_t show();

  /// The bytes of the framebuffer that was drawn and not yet shown, rows from the top, 3 channels.
  [[nodiscard]] ByteImage read_back(int x_px, int y_px, int width_px, int height_px) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace seamline::inline window
