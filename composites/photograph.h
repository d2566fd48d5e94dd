#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/panorama_camera.h"
#include "sensors/camera/fisheye_camera.h"
#include "sensors/camera/pinhole_camera.h"
#include "support/files/picture_file.h"

namespace seamline::renderer {

/// What the pixels of a photograph are directions of.
enum class Projection {
  perspective,  ///< a pinhole, or a lens
  panorama      ///< all directions, equirectangular: the middle column looks along -Z, the right half is +X
};

struct Photograph {
  Image radiance;  ///< three channels, linear; whatever unit the file has
  Projection projection = Projection::perspective;
  int orientation = 1;     ///< that EXIF gave (1 to 8; 1: upright); it is turned already
  bool was_codes = false;  ///< whole numbers, taken as sRGB: light above white is lost
  /// Of the pixels: white in some channel (1 of whole numbers, else the largest value of all).
  double clipped_share = 0;
  int width_px = 0, height_px = 0;                    ///< of the file, upright, whatever view of it is taken
  std::shared_ptr<const ColourProfile> profile = {};  ///< of the file, if it is another than sRGB
  std::vector<std::string> notes = {};                ///< what is to be said of the file, without its name
};

/// Reads a photograph and turns it upright as its EXIF orientation says. `projection`: none: a picture twice
/// as wide as high is a panorama. `layer`: of an EXR file of several (`read_picture`). Throws InputError
/// naming the file where it has no colour or a pixel that is no number, and where a panorama is of another
/// shape.
[[nodiscard]] Photograph read_photograph(const std::filesystem::path& path,
                                         const std::optional<Projection>& projection,
                                         const std::string& layer = {});

/// One sentence about a photograph of whole numbers (which curve was taken, and what is lost), or about one
/// that was clipped; else empty.
[[nodiscard]] std::string codes_warning(const Photograph& photograph, const std::string& file);

/// A lens that looks whither `view` does. A panorama's camera: raytracer/scene/panorama_camera.h.
[[nodiscard]] Camera lens_camera(const sensors::PinholeCamera& lens, const Camera& view);
[[nodiscard]] Camera lens_camera(const sensors::FisheyeCamera& lens, const Camera& view);

/// What a panorama shows in a direction, bilinear.
[[nodiscard]] Rgb panorama_radiance(const Image& panorama, const Eigen::Vector3f& direction);
/// What a camera in its middle sees of a panorama: 16 directions a pixel.
[[nodiscard]] Image view_of_panorama(const Image& panorama, const Camera& camera, int threads);

/// A photograph beside the panorama around it, in the photograph's view.
struct ViewMatch {
  double likeness =
      0;             ///< correlation of the logarithms of their luminance, -1 to 1, which no exposure changes
  double scale = 1;  ///< by which the panorama is as bright as the photograph, in the mean of the logarithms
};
[[nodiscard]] ViewMatch match_view(const Image& photograph, const Camera& camera, const Image& panorama);

}  // namespace seamline::renderer
