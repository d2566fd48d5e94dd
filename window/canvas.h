#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "window/geometry.h"
#include "window/type/find_font.h"
#include "window/window_texture.h"

namespace seamline::inline window {

enum class Font { body, heading, small };

/// Draws shapes, texts and pictures through Dear ImGui's renderer: the only Dear ImGui in Seamline. A frame
/// is whatever is drawn between `begin` and `end`. Needs the window's OpenGL context.
class Canvas {
 public:
  Canvas();
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Loads the fonts: the one asked for, and for characters that it lacks those of their scripts. Throws
  /// InputError when a file is no font, is damaged where the texts need it, or none has a character of
  /// theirs.
  void set_font(const FontRequest& request);

  void begin(Size framebuffer_px);
  /// Puts the frame into the framebuffer.
  void end();
  /// Forgets the frame.
  void discard();

  void fill(const Rect& rect, Colour colour, double rounding_px = 0);
  void outline(const Rect& rect, Colour colour, double thickness_px, double rounding_px = 0);
  void line(Point from, Point to, Colour colour, double thickness_px);
  /// The picture, each of its pixels on one of the screen's when `rect` has its size and integer corners.
  void picture(const WindowTexture& texture, const Rect& rect);
  /// Text from its top left corner, broken into lines of at most `wrap_px` (0: not broken). Of languages that
  /// run from right to left, lines stand at the right of `wrap_px`.
  void text(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px = 0);
  /// The same in a room of `wrap_px`, in which each line stands at `share` of what it leaves: 0 left, 0.5 in
  /// the middle, 1 right.
  void text_in(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px, double share);
  [[nodiscard]] Size measure(Font font, std::string_view text, double wrap_px = 0) const;
  [[nodiscard]] double size_px(Font font) const;
  /// Whether pages are laid out from right to left.
  [[nodiscard]] bool right_to_left() const;

  void clip(const Rect& rect);
  void unclip();

 private:
  struct State;
  void draw(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px,
            std::optional<double> share);

  std::unique_ptr<State> state_;
};

}  // namespace seamline::inline window
