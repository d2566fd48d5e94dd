#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "raytracer/material/texture.h"

namespace seamline::renderer {

/// What to do with half-transparent surfaces (alphaMode BLEND, transmission), which are not rendered.
enum class Transparency : std::uint8_t {
  refused,  ///< the file is complained about
  opaque,   ///< as if there were no alpha
  mask,     ///< holes where alpha is below a half
  left_out  ///< without those surfaces
};

/// The words of `--transparent` and of objects files, for all but `refused`.
inline constexpr const char* transparency_words = "opaque, mask or leave-out";
/// Of one of those words; none for another.
[[nodiscard]] std::optional<Transparency> transparency_of(std::string_view word);
[[nodiscard]] const char* word(Transparency transparency);

/// Where alpha cuts when a material that mixes is drawn as a mask.
inline constexpr float mask_cutoff = 0.5F;

/// What alpha does to a surface.
enum class AlphaKind : std::uint8_t {
  opaque,   ///< 0.99 and more everywhere: what a picture of 8 bits rounds
  cut_out,  ///< holes with sharp edges: a half-transparent texel has a clear one and an opaque one near it
  partial   ///< half transparent somewhere
};

/// Of a factor times a picture's alpha.
[[nodiscard]] AlphaKind alpha_kind(float factor, const std::optional<Texture>& texture);
/// Of the alpha of vertices: mixed between those that differ.
[[nodiscard]] AlphaKind alpha_kind(const std::vector<Eigen::Array4f>& colours);
/// Of both together.
[[nodiscard]] inline AlphaKind more_transparent(AlphaKind a, AlphaKind b) {
  return a < b ? b : a;
}

}  // namespace seamline::renderer
