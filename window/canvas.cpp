// The only file that includes Dear ImGui.
#include "window/canvas.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "window/characters.h"
#include "window/glyphs.h"

namespace seamline::inline window {
namespace {

ImVec2 vector(double x_px, double y_px) {
  return {static_cast<float>(x_px), static_cast<float>(y_px)};
}

ImU32 code(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

std::size_t place(Font font) {
  return static_cast<std::size_t>(font);
}

/// Texts that come with the window, what people may type, and those of the study.
std::u32string characters_to_set(const std::string& of_study) {
  std::u32string characters = U"\u2013\u2014\u2018\u2019\u201C\u201D\u2022\u2026";
  for (char32_t latin = 0x20; latin <= 0xFF; ++latin) characters += latin;
  for (const char32_t character : characters_of(of_study))
    if (character > 0xFF && character <= IM_UNICODE_CODEPOINT_MAX) characters += character;
  return characters;
}

/// A shape, and the number of its place in the texture.
struct PlacedGlyph {
  Glyph glyph;
  int place = 0;
};

/// Enough for all shapes in a texture that is about as high as wide.
int texture_width_px(const std::vector<PlacedGlyph>& placed) {
  std::int64_t area = 0, width = 512;
  for (const PlacedGlyph& one : placed)
    area += std::int64_t{one.glyph.width_px + 1} * (one.glyph.height_px + 1);
  while (width < 8192 && width * width < area * 5 / 4) width *= 2;
  return static_cast<int>(width);
}

/// Dear ImGui arranges the shapes and draws them, but never sees the font: it opens its own small one, of
/// which nothing but the height of the line is used.
ImFont* add_font(ImFontAtlas& atlas, const std::filesystem::path& file, const std::u32string& characters,
                 double size_px, std::vector<PlacedGlyph>& placed) {
  static constexpr std::array<ImWchar, 3> space_alone = {' ', ' ', 0};
  ImFontConfig config;
  config.SizePixels = static_cast<float>(std::round(size_px));
  config.GlyphRanges = space_alone.data();
  ImFont* font = atlas.AddFontDefault(&config);
  for (Glyph& glyph : glyphs_of(read_file(file, largest_font_bytes), file.string(), characters,
                                static_cast<int>(std::round(size_px)))) {
    // A row and a column more, so that no neighbour in the texture shows.
    const int place = atlas.AddCustomRectFontGlyph(
        font, static_cast<ImWchar>(glyph.character), glyph.width_px + 1, glyph.height_px + 1,
        static_cast<float>(glyph.advance_px), vector(glyph.left_px, glyph.top_px));
    placed.push_back({std::move(glyph), place});
  }
  return font;
}

/// Puts the shapes into the texture; false when it has no room for them.
bool fill_texture(ImFontAtlas& atlas, const std::vector<PlacedGlyph>& placed) {
  unsigned char* texels = nullptr;
  int width_px = 0, height_px = 0;
  atlas.TexDesiredWidth = texture_width_px(placed);
  if (!atlas.Build()) return false;
  atlas.GetTexDataAsAlpha8(&texels, &width_px, &height_px);
  for (const auto& [glyph, place] : placed) {
    const ImFontAtlasCustomRect& rect = *atlas.GetCustomRectByIndex(place);
    if (!rect.IsPacked() || rect.X + glyph.width_px >= width_px || rect.Y + glyph.height_px >= height_px)
      return false;
    for (int y = 0; y < glyph.height_px; ++y)
      std::copy_n(glyph.coverage.begin() + std::ptrdiff_t{y} * glyph.width_px, glyph.width_px,
                  texels + std::ptrdiff_t{rect.Y + y} * width_px + rect.X);
  }
  return true;
}

/// The first character of the text that the font has no shape for, or 0.
char32_t missing_character(const ImFont& font, const std::string& text) {
  for (const char32_t character : characters_of(text)) {
    if (character < 0x20) continue;
    if (character > IM_UNICODE_CODEPOINT_MAX) return character;
    if (font.FindGlyphNoFallback(static_cast<ImWchar>(character)) == nullptr) return character;
  }
  return 0;
}

/// The lines of a text: as they are written, and broken between words where they are longer than `wrap_px`.
std::vector<std::string_view> broken_lines(const ImFont& font, std::string_view text, double wrap_px) {
  std::vector<std::string_view> lines;
  while (true) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    while (wrap_px > 0 && !line.empty()) {
      const char* stop = font.CalcWordWrapPositionA(1.0F, line.data(), line.data() + line.size(),
                                                    static_cast<float>(wrap_px));
      const std::size_t length = std::max<std::size_t>(1, static_cast<std::size_t>(stop - line.data()));
      if (length >= line.size()) break;
      lines.push_back(line.substr(0, length));
      line.remove_prefix(length);
      line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    }
    lines.push_back(line);
    if (end == text.size()) return lines;
    text.remove_prefix(end + 1);
  }
}

/// Paragraphs are set with room between their lines, and half a line between them; labels are not.
double line_px(const ImFont& font, std::string_view line, double wrap_px) {
  const double size_px = static_cast<double>(font.FontSize);
  if (wrap_px <= 0) return size_px;
  return std::round(line.empty() ? 0.6 * size_px : 1.32 * size_px);
}

}  // namespace

struct Canvas::State {
  std::array<ImFont*, 3> fonts{};
  bool renderer = false;

  [[nodiscard]] ImFont* font(Font which) const { return fonts.at(place(which)); }
};

Canvas::Canvas() : state_(std::make_unique<State>()) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing of a session is kept on the side
  io.LogFilename = nullptr;
  state_->renderer = ImGui_ImplOpenGL3_Init("#version 130");
  if (!state_->renderer)
    throw input_error({.field = "display", .wanted = "OpenGL 3", .found = "an older one"});
}

Canvas::~Canvas() {
  if (state_->renderer) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Canvas::set_font(const FontRequest& request) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
  const std::u32string characters = characters_to_set(request.characters);
  std::vector<PlacedGlyph> placed;
  const auto add = [&](const std::filesystem::path& file, double size_px) {
    return add_font(atlas, file, characters, size_px, placed);
  };
  state_->fonts = {add(request.file, request.body_px), add(request.heading_file, request.body_px * 1.5),
                   add(request.file, request.body_px * 0.8)};
  if (!fill_texture(atlas, placed))
    throw input_error({.file = request.file.string(),
                       .wanted = "texts and a size whose letters fit into one texture",
                       .found = fmt::format("{} letters of {} px", placed.size(), request.body_px)});
  ImGui_ImplOpenGL3_DestroyDeviceObjects();  // the next frame makes them again, with the new type
  for (const ImFont* font : state_->fonts)
    if (const char32_t missing = missing_character(*font, request.characters); missing != 0)
      throw input_error({.file = request.file.string(),
                         .wanted = "a font with every character of the study's texts",
                         .found = fmt::format("none for U+{:04X} (name another in session.font, or show such "
                                              "texts as pictures)",
                                              static_cast<unsigned>(missing))});
}

void Canvas::begin(Size framebuffer_px) {
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

void Canvas::picture(const Texture& texture, const Rect& rect) {
  const auto name = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.name()));
  ImGui::GetBackgroundDrawList()->AddImage(name, vector(rect.x_px, rect.y_px),
                                           vector(rect.right_px(), rect.bottom_px()));
}

void Canvas::text(Font font, Point top_left, std::string_view text, Colour colour, double wrap_px) {
  const ImFont* type = state_->font(font);
  double y_px = top_left.y_px;
  for (const std::string_view line : broken_lines(*type, text, wrap_px)) {
    ImGui::GetBackgroundDrawList()->AddText(type, type->FontSize,
                                            vector(std::round(top_left.x_px), std::round(y_px)), code(colour),
                                            line.data(), line.data() + line.size());
    y_px += line_px(*type, line, wrap_px);
  }
}

Size Canvas::measure(Font font, std::string_view text, double wrap_px) const {
  const ImFont* type = state_->font(font);
  Size size;
  for (const std::string_view line : broken_lines(*type, text, wrap_px)) {
    const ImVec2 extent =
        type->CalcTextSizeA(type->FontSize, 1e6F, 0, line.data(), line.data() + line.size());
    size.width_px = std::max(size.width_px, static_cast<double>(extent.x));
    size.height_px += line_px(*type, line, wrap_px);
  }
  return size;
}

double Canvas::size_px(Font font) const {
  return static_cast<double>(state_->font(font)->FontSize);
}

void Canvas::clip(const Rect& rect) {
  ImGui::GetBackgroundDrawList()->PushClipRect(vector(rect.x_px, rect.y_px),
                                               vector(rect.right_px(), rect.bottom_px()), true);
}

void Canvas::unclip() {
  ImGui::GetBackgroundDrawList()->PopClipRect();
}

}  // namespace seamline::inline window
