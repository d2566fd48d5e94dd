#pragma once
#include <array>
#include <compare>
#include <string>
#include <string_view>

namespace seamline::inline stimuli {

/// How a picture is shown (paper 000, section 3). Every kind fills the picture of the study, in its width and
/// height. `side_by_side`: left eye, right eye, each squeezed to half the width, as stereoscopic screens take
/// it. `anaglyph`: both in one, told apart by colour. `interleaved`: the sub-pixels of a screen under a lens
/// sheet belong to N views in turn (section 3.2). `depth_image`: the picture and its depth, each squeezed to
/// half the width; the screen makes its views of it (2D-plus-depth, section 3.1). `omnidirectional`: of
/// panoramas only, a whole one for each eye, for headsets.
enum class ViewKind { mono, side_by_side, anaglyph, interleaved, depth_image, omnidirectional };

/// Where panoramas of several eyes have their parallax from. `truth`: each eye has a photograph of its own.
/// `depth`: there is one photograph, from the middle between the eyes, and each eye sees it painted on the
/// local scene, as who has one panorama and its depth map shows it.
enum class Parallax { truth, depth };

/// What an anaglyph for red and cyan glasses shows of the two eyes, of linear colour. `colour`: the left
/// eye's red, the right eye's green and blue. `half_colour`: the left eye's luminance in red. `grey`: the
/// luminances of both. `dubois`: the matrices of Dubois (2001), fitted to glasses and a screen.
enum class AnaglyphMatrix { colour, half_colour, grey, dubois };

/// Which sub-pixel of a screen belongs to which view: slanted lenses over it, each as wide as all views
/// (van Berkel, "Image preparation for 3D-LCD", 1999).
struct LensSheet {
  double pitch_subpixels = 5;  ///< of the lenses, along a row
  double slant_deg = 0;  ///< of the lenses from the vertical; positive: they lean to the right downwards
  double offset_subpixels = 0;  ///< of a lens' left edge in the screen's first row, to the left

  auto operator<=>(const LensSheet&) const = default;
};

/// Five views under lenses of five sub-pixels that move one sub-pixel a row: paper 000 names a screen of five
/// views and gives no layout.
inline constexpr LensSheet five_views_sheet{.pitch_subpixels = 5, .slant_deg = 18.43494882292201};

/// How the pictures of a condition are shown. The eyes stand along the camera's right vector, around the
/// camera's place, which is also where the depth map's own centre stays. Those of panoramas stand to the
/// right and left of every direction that they look at (raytracer/scene/eyes.h).
struct View {
  ViewKind kind = ViewKind::mono;
  int views = 2;                ///< from the left to the right
  double separation_m = 0.065;  ///< of neighbouring eyes
  /// Distance from the camera's plane at which all eyes see a thing at the same place of the picture: where
  /// the screen seems to be.
  double zero_parallax_m = 0;
  AnaglyphMatrix matrix = AnaglyphMatrix::dubois;  ///< of anaglyphs only
  Parallax parallax = Parallax::truth;             ///< of real surfaces; of omnidirectional views only
  LensSheet sheet = {};                            ///< of interleaved views only
  double max_depth_m = 0;                          ///< of depth images only: what the depth 1 stands for
  std::array<int, 2> panel_px = {0, 0};            ///< width, height of the screen; 0: any

  [[nodiscard]] bool is_mono() const { return kind == ViewKind::mono; }
  /// How many eyes look: 1 of a picture with depth.
  [[nodiscard]] int eyes() const {
    return kind == ViewKind::mono || kind == ViewKind::depth_image ? 1 : views;
  }
  /// How many panoramas its camera takes: those of the eyes, and the one that they are painted with.
  [[nodiscard]] int panoramas() const { return views + (parallax == Parallax::depth ? 1 : 0); }
  /// How many columns of the study's picture one column of an eye's picture fills.
  [[nodiscard]] int squeeze() const {
    return kind == ViewKind::side_by_side || kind == ViewKind::depth_image ? 2 : 1;
  }
  /// Whether the screen is stated.
  [[nodiscard]] bool names_panel() const { return panel_px[0] > 0; }
  /// Where a picture's upper left corner stands on the stated screen: in the middle of its first rows.
  [[nodiscard]] std::array<int, 2> place_on_panel_px(int picture_width_px) const {
    return {(panel_px[0] - picture_width_px) / 2, 0};
  }

  auto operator<=>(const View&) const = default;
};

[[nodiscard]] std::string_view word(ViewKind kind);
[[nodiscard]] std::string_view word(AnaglyphMatrix matrix);

/// Whether a kind has a use for the setting of this key (`separation_m`; study_file_view.h has them all). No
/// kind ignores one in silence.
[[nodiscard]] bool uses(ViewKind kind, std::string_view key);

/// `"side_by_side" or "anaglyph"`: the kinds that do.
[[nodiscard]] std::string kinds_that_use(std::string_view key);

/// "side_by_side, 2 views 0.065 m apart, zero parallax 2.5 m": what has a meaning for the kind; empty for
/// mono.
[[nodiscard]] std::string canonical_text(const View& view);

}  // namespace seamline::inline stimuli
