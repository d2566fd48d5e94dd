#pragma once
#include <filesystem>
#include <string>

#include "support/files/temporary_folder.h"
#include "x3d/x3d_page.h"

namespace seamline::renderer {

/// Pictures as X3DOM's textures: inside the page, not scaled, read texel by texel.
class X3dTextures {
 public:
  /// `name`: by which it may be used again.
  [[nodiscard]] std::string texture(const ByteImage& picture, const std::string& name = {});

 private:
  TemporaryFolder folder_;
  int number_ = 0;
};

/// Both parts of a shader of ours; what its fragments share with others (`light.frag`) and `constants` come
/// before its own fragments' text. `folder`: where the shaders are.
[[nodiscard]] std::string shader_parts(const std::filesystem::path& folder, const std::string& name,
                                       const std::string& constants = {});

/// Fields of `light.frag`: sun, sky and what the maps cover.
[[nodiscard]] std::string light_fields(const X3dPage& page);

/// Tangents of half a pinhole's angles of view, across and up.
[[nodiscard]] Eigen::Vector2d tangents_of(const Camera& camera);

/// Depth, colour and shadow of the real world in every fragment of the window (001, sections 5.1 and 5.3).
/// `folder`: where the shaders are.
[[nodiscard]] std::string depth_background(const X3dPage& page, X3dTextures& textures,
                                           const std::filesystem::path& folder);

/// What stands for the depth image where there is no WebGL 2 (001, section 5.1, "ghosting"): the photograph,
/// which leaves no depth, and then the geometry of the real world, which leaves its depth and no colour.
[[nodiscard]] std::string ghost_template(const X3dPage& page, X3dTextures& textures,
                                         const std::filesystem::path& folder);

}  // namespace seamline::renderer
