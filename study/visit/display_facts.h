#pragma once
#include <cstdint>
#include <string>

namespace seamline::study {

/// What the pictures of a session were shown on, as the display check found it.
struct DisplayFacts {
  std::string machine = {};   ///< host name
  std::string monitor = {};   ///< as the window system names it
  std::string renderer = {};  ///< of OpenGL
  int mode_width_px = 0, mode_height_px = 0;
  double refresh_hz = 0;
  double content_scale = 1;  ///< of the window system; 1: a screen unit is a pixel
  int framebuffer_width_px = 0, framebuffer_height_px = 0;
  double mm_per_px = 0;                  ///< measured against a bank card
  double viewing_distance_mm = 0;        ///< as entered
  double pixels_per_degree = 0;          ///< at the middle of the screen; see `pixels_per_degree_of`
  bool gamma_confirmed = false;          ///< the pattern looked as it should
  std::int64_t read_back_bytes = 0;      ///< compared between a test image and what the framebuffer holds
  std::int64_t read_back_different = 0;  ///< of those; 0: the screen gets exactly the picture's bytes
  bool scaling_allowed = false;          ///< `--allow-scaling`
  double image_scale = 1;                ///< screen pixels a picture pixel; 1 unless scaling was allowed
  bool operator==(const DisplayFacts&) const = default;
};

/// Pixels that one degree of the visual field covers around the middle of the screen:
/// 2 distance tan(0.5 deg) / mm_per_px.
[[nodiscard]] double pixels_per_degree_of(double mm_per_px, double viewing_distance_mm);

}  // namespace seamline::study
