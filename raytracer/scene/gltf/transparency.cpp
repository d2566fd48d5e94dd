#include "raytracer/scene/gltf/transparency.h"

#include <algorithm>

#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

constexpr float opaque_from = 0.99F, clear_to = 0.01F;
constexpr float nearly = 0.05F;  ///< clear or opaque beside an edge, after JPEG and scaling
constexpr int edge_reach_px = 3;
constexpr double most_soft_share = 0.01;  ///< of a picture's texels, for specks that are no edge

/// Alpha of a picture, texel by texel.
class AlphaPicture {
 public:
  AlphaPicture(const ByteImage& picture, float factor) : picture_(picture), factor_(factor) {}

  [[nodiscard]] float at(int x, int y) const {
    const auto channels = static_cast<std::size_t>(picture_.channels);
    const std::size_t texel = grid_index(y, x, picture_.width_px);
    return factor_ * static_cast<float>(picture_.values[texel * channels + channels - 1]) / 255.0F;
  }

  /// Whether a texel lies between a clear and an opaque one.
  [[nodiscard]] bool is_edge(int x, int y) const {
    bool has_clear = false, has_opaque = false;
    for (int row = std::max(0, y - edge_reach_px); row <= std::min(picture_.height_px - 1, y + edge_reach_px);
         ++row)
      for (int column = std::max(0, x - edge_reach_px);
           column <= std::min(picture_.width_px - 1, x + edge_reach_px); ++column) {
        const float alpha = at(column, row);
        has_clear = has_clear || alpha <= nearly;
        has_opaque = has_opaque || alpha >= 1.0F - nearly;
      }
    return has_clear && has_opaque;
  }

 private:
  const ByteImage& picture_;
  float factor_;
};

AlphaKind kind_of_number(float alpha) {
  if (alpha >= opaque_from) return AlphaKind::opaque;
  return alpha <= clear_to ? AlphaKind::cut_out : AlphaKind::partial;
}

}  // namespace

std::optional<Transparency> transparency_of(std::string_view word) {
  if (word == "opaque") return Transparency::opaque;
  if (word == "mask") return Transparency::mask;
  if (word == "leave-out") return Transparency::left_out;
  return std::nullopt;
}

const char* word(Transparency transparency) {
  switch (transparency) {
    case Transparency::opaque:
      return "opaque";
    case Transparency::mask:
      return "mask";
    case Transparency::left_out:
      return "leave-out";
    case Transparency::refused:
      break;
  }
  return "refused";
}

AlphaKind alpha_kind(float factor, const std::optional<Texture>& texture) {
  if (!texture || !texture->has_alpha()) return kind_of_number(factor);
  const AlphaPicture alpha(*texture->picture, factor);
  const int width_px = texture->picture->width_px, height_px = texture->picture->height_px;
  bool is_opaque = true;
  std::int64_t soft = 0;
  const auto most_soft =
      static_cast<std::int64_t>(most_soft_share * static_cast<double>(width_px) * height_px);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const AlphaKind kind = kind_of_number(alpha.at(x, y));
      is_opaque = is_opaque && kind == AlphaKind::opaque;
      if (kind != AlphaKind::partial || alpha.is_edge(x, y)) continue;
      if (++soft > most_soft) return AlphaKind::partial;
    }
  return is_opaque ? AlphaKind::opaque : AlphaKind::cut_out;
}

AlphaKind alpha_kind(const std::vector<Eigen::Array4f>& colours) {
  if (colours.empty()) return AlphaKind::opaque;
  const AlphaKind first = kind_of_number(colours.front()[3]);
  const bool is_even = std::all_of(colours.begin(), colours.end(), [&](const Eigen::Array4f& colour) {
    return kind_of_number(colour[3]) == first;
  });
  return is_even ? first : AlphaKind::partial;
}

}  // namespace seamline::renderer
