#include "live/physics/falling_bodies.h"

#include <cmath>
#include <utility>

#include "physics/body_shape.h"
#include "physics/settle.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::live {

std::vector<FallingBody> falling_bodies(const std::vector<renderer::PlacedModel>& models) {
  std::vector<FallingBody> bodies;
  renderer::KnownModels known;
  for (const renderer::PlacedModel& model : models) {
    FallingBody body{.name = model.file, .shape = {}};
    body.world_from_placed.linear() = renderer::object_placement({.name = {},
                                                                  .file = {},
                                                                  .path = {},
                                                                  .position_m = Eigen::Vector3d::Zero(),
                                                                  .rotation_deg = model.rotation_deg,
                                                                  .scale = 1})
                                          .linear();
    body.world_from_placed.translation() = model.position_m;
    // About its place, so that single precision is fine enough.
    const renderer::PhotoObjects placed = renderer::place_objects({model}, model.position_m, nullptr, known);
    std::vector<Eigen::Vector3d> vertices_m;
    for (const auto& mesh : placed.meshes)
      for (const Eigen::Vector3f& place_m : mesh->positions_m)
        vertices_m.emplace_back(body.world_from_placed.linear().transpose() * place_m.cast<double>());
    body.shape =
        renderer::coarser(renderer::body_shape_of(vertices_m, request_name("physics") + " of " + model.file));
    bodies.push_back(std::move(body));
  }
  return bodies;
}

FallingBodies::FallingBodies(std::vector<FallingBody> bodies, DepthGround ground, double drop_m)
    : bodies_(std::move(bodies)), ground_(std::move(ground)), drop_m_(drop_m) {}

Eigen::Isometry3d FallingBodies::start_of(const FallingBody& body) const {
  return Eigen::Translation3d(0, drop_m_, 0) * body.world_from_placed;
}

void FallingBodies::begin(const DepthPoints& points, const std::vector<float>& depth_m,
                          const Eigen::Isometry3d& world_from_colour) {
  (void)ground_.take(points, depth_m, world_from_colour);
  const renderer::Ground& ground = ground_.ground();
  if (ground.triangles.empty())
    throw input_error({.field = request_name("physics"),
                       .wanted = "a first frame with depth, on which things can fall",
                       .found = "no three neighbours that have one"});
  for (const FallingBody& body : bodies_) {
    const std::string what = request_name("physics") + " of " + body.name;
    worlds_.emplace_back(ground, body.shape, start_of(body), settings_);
    renderer::require_free_start(worlds_.back(), ground, body.shape, what);
    if (!has_surface_below(ground, worlds_.back().body().middle_m))
      throw input_error({.field = what,
                         .wanted = "a surface that the first frame shows straight below it",
                         .found = "none"});
    poses_.push_back({.world_from_body = start_of(body)});
  }
}

void FallingBodies::fit_ground(DepthGround::Change change) {
  for (renderer::RigidWorld& world : worlds_) {
    switch (change) {
      case DepthGround::Change::none:
        break;
      case DepthGround::Change::moved:
        world.move_ground(ground_.ground().vertices_m);
        break;
      case DepthGround::Change::triangles:
        world.set_ground(ground_.ground());
        break;
    }
  }
}

void FallingBodies::advance(const DepthPoints& points, const std::vector<float>& depth_m,
                            const Eigen::Isometry3d& world_from_colour, double interval_s) {
  const DepthGround::Change change = ground_.take(points, depth_m, world_from_colour);
  const bool has_ground = !ground_.ground().triangles.empty();
  if (has_ground) fit_ground(change);
  simulated_s_ += interval_s;
  const std::int64_t until = std::llround(simulated_s_ * settings_.steps_per_s);
  const std::int64_t steps = until - std::exchange(steps_, until);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyPose& pose = poses_[i];
    pose.is_held = !has_ground || !has_surface_below(ground_.ground(), worlds_[i].body().middle_m);
    for (std::int64_t step = 0; step < steps && !pose.is_held; ++step) {
      stop_if_interrupted();
      worlds_[i].step();
    }
    const renderer::BodyState body = worlds_[i].body();
    pose.world_from_body = body.world_from_body;
    pose.speed_m_s = pose.is_held ? 0 : body.speed_m_s;
  }
}

void FallingBodies::let_go() {
  if (ground_.ground().triangles.empty()) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    worlds_[i] = renderer::RigidWorld(ground_.ground(), bodies_[i].shape, start_of(bodies_[i]), settings_);
    poses_[i] = {.world_from_body = start_of(bodies_[i]), .times_let_go = poses_[i].times_let_go + 1};
  }
}

std::vector<Eigen::Isometry3d> FallingBodies::moves() const {
  std::vector<Eigen::Isometry3d> moves;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    moves.push_back(poses_[i].world_from_body * bodies_[i].world_from_placed.inverse());
  return moves;
}

}  // namespace seamline::live
