#include "laboratory/settling/shake.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "laboratory/settling/frame_ground.h"
#include "physics/settle.h"
#include "support/arithmetic/units.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr double lost_below_m = 1;

double root_mean(double sum, std::size_t count) {
  return count > 0 ? std::sqrt(sum / count) : 0;
}

void measure(const std::vector<Eigen::Vector3d>& middles_m, Fall& fall) {
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& middle_m : middles_m)
    mean_m += middle_m / static_cast<double>(middles_m.size());
  double squares = 0, upright = 0, jumps = 0, turns = 0;
  const std::size_t first = fall.poses.size() - middles_m.size();
  for (std::size_t i = 0; i < middles_m.size(); ++i) {
    const Eigen::Vector3d away_m = middles_m[i] - mean_m;
    fall.away_mm.push_back(mm_per_m * away_m.norm());
    squares += away_m.squaredNorm();
    upright += away_m.y() * away_m.y();
    if (i == 0) continue;
    jumps += (middles_m[i] - middles_m[i - 1]).squaredNorm();
    const Eigen::Quaterniond before(fall.poses[first + i - 1].linear()), now(fall.poses[first + i].linear());
    const double turn_deg = before.angularDistance(now) * 180 / std::numbers::pi;
    turns += turn_deg * turn_deg;
  }
  fall.shake_mm = mm_per_m * root_mean(squares, middles_m.size());
  fall.height_mm = mm_per_m * root_mean(upright, middles_m.size());
  fall.jump_mm = mm_per_m * root_mean(jumps, middles_m.size() - 1);
  fall.turn_deg = root_mean(turns, middles_m.size() - 1);
}

}  // namespace

Fall fall_on(const DepthSequence& depth, const FallRequest& request,
             const std::function<void()>& after_frame) {
  Fall fall{.name = request.name};
  FrameGround ground(request.world_from_depth);
  std::optional<RigidWorld> world;
  std::vector<Eigen::Vector3d> middles_m;
  const int steps = request.physics.steps_per_s / request.frames_per_s;
  const std::string what = "the body on " + request.name + " depth";
  for (int frame = 0; frame < request.frames_to_rest + request.frames; ++frame) {
    const FrameGround::Change change = ground.take(depth(frame));
    if (!world) {
      if (ground.ground().triangles.empty())
        throw input_error(
            {.field = request.name + " depth", .wanted = "three neighbours with a depth", .found = "none"});
      world.emplace(ground.ground(), request.shape, request.world_from_body, request.physics);
      require_free_start(*world, ground.ground(), request.shape, what);
    } else if (change == FrameGround::Change::triangles) {
      world->set_ground(ground.ground());
    } else if (change == FrameGround::Change::moved) {
      world->move_ground(ground.ground().vertices_m);
    }
    for (int i = 0; i < steps; ++i) {
      stop_if_interrupted();
      world->step();
    }
    const BodyState body = world->body();
    if (!(body.middle_m.y() > lowest_m(ground.ground()) - lost_below_m))
      throw input_error({.field = what,
                         .wanted = "a surface below it that holds it",
                         .found = fmt::format("that it falls out of the scene in frame {}{}", frame,
                                              request.when_lost.empty() ? "" : ": " + request.when_lost)});
    fall.poses.push_back(body.world_from_body);
    if (frame >= request.frames_to_rest) middles_m.push_back(body.middle_m);
    after_frame();
  }
  fall.triangles = ground.ground().triangles.size();
  measure(middles_m, fall);
  return fall;
}

}  // namespace seamline::renderer
