#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "physics/rigid_world.h"
#include "sensors/frame/depth_frame.h"

namespace seamline::renderer {

/// Depth frames, one after another, as a ground whose vertices move: each pixel is a vertex, each cell
/// between four pixels that have been measured two triangles, also where depth jumps (one mesh, as paper 000
/// has it). A pixel that is a hole now keeps its last depth.
class FrameGround {
 public:
  explicit FrameGround(const Eigen::Isometry3d& world_from_depth) : world_from_depth_(world_from_depth) {}

  enum class Change {
    none,      ///< every vertex is where it was
    moved,     ///< the triangles are those of before
    triangles  ///< pixels got a depth that never had one
  };
  /// Takes the next frame, which is of the size of those before.
  Change take(const sensors::DepthFrame& frame);
  [[nodiscard]] const Ground& ground() const { return ground_; }

 private:
  void join(int width_px, int height_px);

  Eigen::Isometry3d world_from_depth_;
  Ground ground_;
  std::vector<std::uint8_t> is_measured_;
};

}  // namespace seamline::renderer
