#pragma once
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "composites/photo_composite.h"
#include "composites/photo_world.h"
#include "composites/view/standing_place.h"

namespace seamline::renderer {

/// A picture made smaller: each pixel is the mean over what it covers.
[[nodiscard]] Image photograph_sized(const Image& image, int width_px, int height_px);

/// What the window shows while objects are being placed: composites by paths, coarse at once, then finer,
/// then with more and more samples. They are those of `composite`, but for their size and noise.
class PlacePreview {
 public:
  /// `world` and what it holds stay alive. `width_px`: of the finest picture.
  PlacePreview(const PhotoWorld& world, int width_px, int threads);

  /// Gives objects without a place one in the view (`stand_in_view`), where it shows a surface.
  [[nodiscard]] std::vector<std::string> stand(std::vector<PlacedModel>& models);
  /// Begins again with objects as they stand now. Throws InputError as `place_objects` does.
  void set_objects(const std::vector<PlacedModel>& models);
  /// One more picture: a finer one, or one of more samples. Returns whether there is anything left to do.
  bool refine();
  /// The picture so far, linear; the photograph alone before the first.
  [[nodiscard]] const Image& picture() const { return picture_; }
  /// The floor that the view shows, and the flags of a grid on it, of `spacing_m`, in the finest picture's
  /// pixels (`floor_grid`).
  [[nodiscard]] std::optional<FloorInView> floor() const;
  [[nodiscard]] std::vector<std::uint8_t> grid_on(const FloorInView& floor, double spacing_m) const;
  [[nodiscard]] int finest_width_px() const { return levels_.back().camera.width_px; }
  [[nodiscard]] int finest_height_px() const { return levels_.back().camera.height_px; }

  /// What is seen through a place of the picture, in shares of its width and height.
  struct Sight {
    std::optional<std::size_t> object;              ///< where one is before everything else
    std::optional<Eigen::Vector3d> real_m, normal;  ///< of the real surface there, objects left out
  };
  [[nodiscard]] Sight look(double x_share, double y_share) const;
  /// Half of an object's larger side across.
  [[nodiscard]] double half_width_m(std::size_t object) const;

 private:
  /// Camera and photograph of one fineness.
  struct Level {
    Camera camera;
    Image photograph;
  };

  const PhotoWorld& world_;
  int threads_;
  std::vector<Level> levels_;  ///< coarse to fine
  KnownModels known_;
  PhotoObjects placed_;
  std::unique_ptr<Geometry> objects_;
  std::size_t level_ = 0;
  std::optional<PhotoSums> sums_;  ///< of the finest level
  Image picture_;
};

}  // namespace seamline::renderer
