#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "window/canvas.h"
#include "window/geometry.h"
#include "window/input.h"

namespace seamline::inline window {

/// Something on the page that can be used, as the last frame laid it out.
struct UiItem {
  std::string id;
  Rect rect;
  bool operator==(const UiItem&) const = default;
};

/// A page of text and controls on a card in the middle of the screen, mirrored where texts run from right to
/// left. Tab and Shift-Tab move the focus, Enter and Space use what has it, arrows change it; a page that is
/// longer than the screen scrolls.
///
/// Controls return what happened in this frame. The page is laid out from the heights of the frame before,
/// and what was drawn above a control does not know yet that it was used, so a page that `changed()` must be
/// laid out once more before it is shown.
class Ui {
 public:
  explicit Ui(Canvas& canvas) : canvas_(canvas) {}

  void begin(const FrameInput& input, Size framebuffer_px);
  void end();
  /// A new page: nothing has the focus, and the page is at its top.
  void reset();
  [[nodiscard]] bool changed() const { return changed_; }
  /// Where nothing has the focus yet, this does.
  void prefer(const std::string& id) {
    if (focus_.empty()) focus_ = id;
  }

  void begin_card(double width_em);
  void end_card();

  void heading(std::string_view text);
  void paragraph(std::string_view text);
  void label(std::string_view text);  ///< right above a control
  void note(std::string_view text);
  void problem(std::string_view text);
  void gap(double em);
  void picture(const WindowTexture& texture);
  /// Room for something that the caller draws.
  [[nodiscard]] Rect room(double width_px, double height_px);

  enum class ButtonKind { quiet, leading };
  struct ButtonText {
    std::string id, text;
    ButtonKind kind = ButtonKind::quiet;
  };
  /// Buttons side by side, where lines end; returns the one that was used. Where nothing has the focus, Enter
  /// uses the only leading one if `enter_leads`.
  [[nodiscard]] std::optional<int> buttons(std::span<const ButtonText> texts, bool enter_leads = true);

  /// One button that is not on a card; returns whether it was used.
  [[nodiscard]] bool button_in(const ButtonText& text, const Point& middle);

  /// Options of which at most one is chosen (-1: none); returns the new choice.
  [[nodiscard]] int choice(const std::string& id, std::span<const std::string> options, int chosen,
                           Font font = Font::body);
  /// A line for a number; returns whether it was changed.
  bool number(const std::string& id, std::string& text, double width_em);
  /// A value on a line; arrows change it by a step, with Shift by ten. Returns whether it was changed.
  bool slider(const std::string& id, double& value, double least, double most, double step);
  bool checkbox(const std::string& id, std::string_view text, bool& on);

  /// Something that the page draws and handles itself, for traces.
  void mark(const std::string& id, const Rect& rect) { items_.push_back({id, rect}); }

  [[nodiscard]] double em() const { return canvas_.size_px(Font::body); }
  [[nodiscard]] Canvas& canvas() { return canvas_; }
  [[nodiscard]] const std::vector<UiItem>& items() const { return items_; }

 private:
  struct Use {
    bool hovered = false, focused = false, used = false;
  };
  Use item(const std::string& id, const Rect& rect);
  /// What was drawn so far may be of before. Returns `acted`.
  bool acts(bool acted);
  [[nodiscard]] double button_width_px(const ButtonText& text) const;
  /// Draws a button; returns whether it was used. `enter_leads`: Enter uses it where nothing has the focus.
  bool button(const ButtonText& text, const Rect& rect, bool enter_leads);
  void ring(const Rect& rect);
  void write(Font font, std::string_view text, Colour colour);
  /// On the page's other side where it is read from right to left.
  [[nodiscard]] Rect on_its_side(const Rect& rect) const;
  [[nodiscard]] bool activates() const;
  void move_focus(int step);

  Canvas& canvas_;
  FrameInput input_;
  Size screen_;
  Rect card_;              ///< inside of its padding
  double y_px_ = 0;        ///< where the next thing goes
  double content_px_ = 0;  ///< height of the last frame's card
  double scroll_px_ = 0;
  bool card_open_ = false, changed_ = false;
  std::string focus_, held_;  ///< ids: has the keyboard; was pressed and not yet released
  bool key_taken_ = false;
  std::vector<UiItem> items_, last_items_;
};

}  // namespace seamline::inline window
