#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "window/geometry.h"
#include "window/texture.h"

namespace seamline::inline window {

enum class Font { body, heading, small };

/// The type that texts are set in.
struct FontRequest {
  std::filesystem::path file;          ///< TrueType
  std::filesystem::path heading_file;  ///< the same, or its bold
  double body_px = 22;
  std::string characters;  ///< UTF-8: every character that will be shown
};

/// Draws shapes, texts and pictures through Dear ImGui's renderer: the only Dear ImGui in Seamline. A frame
/// is whatever is drawn between `begin` and `end`. Needs the window's OpenGL context.
class Canvas {
 public:
  Canvas();
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Loads the fonts. Throws InputError when the file is no font or lacks a character of the texts.
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
  void picture(const Texture& texture, const Rect& rect);
  /// Text from its top left corner, broken into lines of at most `wrap_px` (0: not broken).
  void text(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px = 0);
  [[nodiscard]] Size measure(Font font, std::string_view text, double wrap_px = 0) const;
  [[nodiscard]] double size_px(Font font) const;

  void clip(const Rect& rect);
  void unclip();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace seamline::inline window
