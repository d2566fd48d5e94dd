// The only file that includes Dear ImGui.
#include "window/canvas.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "support/text/error.h"
#include "window/type/open_fonts.h"
#include "window/type/paragraph.h"
#include "window/type/text_direction.h"

namespace seamline::inline window {
namespace {

ImVec2 vector(double x_px, double y_px) {
  return {static_cast<float>(x_px), static_cast<float>(y_px)};
}

ImU32 code(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

ImTextureID name_of(const WindowTexture& texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.name()));
}

std::size_t place(Font font) {
  return static_cast<std::size_t>(font);
}

/// What is always there: texts that come with the window, numbers, names of files.
std::string common_characters() {
  std::string text = "\u2013\u2014\u2018\u2019\u201C\u201D\u2022\u2026";
  for (char letter = ' '; letter <= '~'; ++letter) text += letter;
  return text;
}

}  // namespace

struct Canvas::State {
  /// A text as it was last arranged. Its lines are drawn when they are first seen.
  struct KeptText {
    ArrangedText arranged;
    std::vector<std::optional<WindowTexture>> textures = {};
    std::vector<Coverage> frames = {};  ///< of the textures
    std::int64_t frame = 0;             ///< in which it was last asked for
  };
  using TextKey = std::tuple<Font, double, std::string>;

  FontStack text_fonts, heading_fonts;
  std::array<TypeStyle, 3> styles{};
  std::map<TextKey, KeptText> texts;
  std::int64_t frame = 0;
  bool renderer = false;

  [[nodiscard]] const TypeStyle& style(Font which) const { return styles.at(place(which)); }

  KeptText& text(Font font, std::string_view utf8, double wrap_px) {
    const auto [at, is_new] = texts.try_emplace({font, wrap_px, std::string(utf8)});
    KeptText& kept = at->second;
    if (is_new) {
      kept.arranged = arrange(style(font), utf8, wrap_px);
      kept.textures.resize(kept.arranged.lines.size());
      kept.frames.resize(kept.arranged.lines.size());
    }
    kept.frame = frame;
    return kept;
  }

  /// Texts that change in every frame would fill the memory.
  void forget_old_texts() {
    constexpr std::size_t enough = 512;
    ++frame;
    if (texts.size() > enough)
      std::erase_if(texts, [&](const auto& text) { return text.second.frame + 2 < frame; });
  }
};

Canvas::Canvas() : state_(std::make_unique<State>()) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing of a session is kept on the side
  io.LogFilename = nullptr;
  io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors;  // its own font is never seen
  state_->renderer = ImGui_ImplOpenGL3_Init("#version 130");
  if (!state_->renderer)
    throw input_error({.field = "display", .wanted = "OpenGL 3", .found = "an older one"});
}

Canvas::~Canvas() {
  if (state_->renderer) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Canvas::set_font(const FontRequest& request) {
  State& state = *state_;
  state.texts.clear();
  std::vector<std::string> texts = request.texts;
  texts.push_back(common_characters());
  const std::vector<FontFiles> files = files_for(request.files, texts);
  state.text_fonts = open_fonts(files, &FontFiles::text);
  state.heading_fonts = open_fonts(files, &FontFiles::heading);
  const auto style = [&](const FontStack& fonts, double scale) {
    return TypeStyle{.fonts = &fonts,
                     .size_px = std::round(request.body_px * scale),
                     .language = request.language,
                     .right_to_left = runs_right_to_left(request.language)};
  };
  state.styles = {style(state.text_fonts, 1), style(state.heading_fonts, 1.5), style(state.text_fonts, 0.8)};
  for (const std::string& text : texts)
    for (const FontStack* fonts : {&state.text_fonts, &state.heading_fonts})
      require_shapes({.fonts = fonts}, text);
}

void Canvas::begin(Size framebuffer_px) {
  state_->forget_old_texts();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = vector(framebuffer_px.width_px, framebuffer_px.height_px);
  io.DisplayFramebufferScale = {1, 1};
  io.DeltaTime = 1.0F / 60;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Canvas::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Canvas::discard() {
  ImGui::EndFrame();
}

void Canvas::fill(const Rect& rect, Colour colour, double rounding_px) {
  ImGui::GetBackgroundDrawList()->AddRectFilled(vector(rect.x_px, rect.y_px),
                                                vector(rect.right_px(), rect.bottom_px()), code(colour),
                                                static_cast<float>(rounding_px));
}

void Canvas::outline(const Rect& rect, Colour colour, double thickness_px, double rounding_px) {
  ImGui::GetBackgroundDrawList()->AddRect(
      vector(rect.x_px, rect.y_px), vector(rect.right_px(), rect.bottom_px()), code(colour),
      static_cast<float>(rounding_px), 0, static_cast<float>(thickness_px));
}

void Canvas::line(Point from, Point to, Colour colour, double thickness_px) {
  ImGui::GetBackgroundDrawList()->AddLine(vector(from.x_px, from.y_px), vector(to.x_px, to.y_px),
                                          code(colour), static_cast<float>(thickness_px));
}

void Canvas::picture(const WindowTexture& texture, const Rect& rect) {
  ImGui::GetBackgroundDrawList()->AddImage(name_of(texture), vector(rect.x_px, rect.y_px),
                                           vector(rect.right_px(), rect.bottom_px()));
}

void Canvas::text(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px) {
  draw(font, top_left, text, colour, wrap_px, std::nullopt);
}

void Canvas::text_in(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px,
                     double share) {
  draw(font, top_left, text, colour, wrap_px, share);
}

void Canvas::draw(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px,
                  std::optional<double> share) {
  constexpr int most_width_px = 8192;  // that every graphics memory has as a texture
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  State::KeptText& kept = state_->text(font, text, wrap_px);
  for (std::size_t i = 0; i < kept.textures.size(); ++i) {
    const TextLine& line = kept.arranged.lines[i];
    const double left_in_room_px = share ? std::round(*share * (wrap_px - line.width_px)) : line.left_px;
    const double x_px = std::round(top_left.x_px) + left_in_room_px,
                 y_px = std::round(top_left.y_px + line.top_px);
    const double far_px = 2 * largest_shape_em * size_px(font);
    if (y_px > static_cast<double>(screen.y) + far_px || y_px < -far_px) continue;
    if (!kept.textures[i]) {
      kept.frames[i] = draw_line(state_->style(font), line, most_width_px);
      kept.textures[i].emplace().upload_coverage(kept.frames[i].width_px, kept.frames[i].height_px,
                                                 kept.frames[i].values);
      kept.frames[i].values.clear();
    }
    const Coverage& frame = kept.frames[i];
    if (frame.width_px == 0) continue;
    const double left_px = x_px + frame.left_px, top_px = y_px + frame.top_px;
    ImGui::GetBackgroundDrawList()->AddImage(name_of(*kept.textures[i]), vector(left_px, top_px),
                                             vector(left_px + frame.width_px, top_px + frame.height_px),
                                             {0, 0}, {1, 1}, code(colour));
  }
}

Size Canvas::measure(Font font, std::string_view text, double wrap_px) const {
  const ArrangedText& arranged = state_->text(font, text, wrap_px).arranged;
  return {arranged.width_px, arranged.height_px};
}

double Canvas::size_px(Font font) const {
  return state_->style(font).size_px;
}

bool Canvas::right_to_left() const {
  return state_->style(Font::body).right_to_left;
}

void Canvas::clip(const Rect& rect) {
  ImGui::GetBackgroundDrawList()->PushClipRect(vector(rect.x_px, rect.y_px),
                                               vector(rect.right_px(), rect.bottom_px()), true);
}

void Canvas::unclip() {
  ImGui::GetBackgroundDrawList()->PopClipRect();
}

}  // namespace seamline::inline window
