// This file and massed_shape.* are the only ones that include Bullet.
#ifdef SEAMLINE_HAS_BULLET
#include "physics/rigid_world.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/ground_edges.h"
#include "physics/massed_shape.h"
#include "physics/touching.h"

namespace seamline::renderer {
namespace {

constexpr int solver_iterations = 30;
constexpr double nearest_m = 0.003;        ///< what is so near to a body at rest may touch it
constexpr double cells_per_reach = 0.125;  ///< touches are so far from each other, in reaches of the body

struct ClosestPoint : btDiscreteCollisionDetectorInterface::Result {
  bool is_found = false;
  Eigen::Vector3d push = Eigen::Vector3d::Zero(), on_ground_m = Eigen::Vector3d::Zero();
  double distance_m = 0;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& push_out, const btVector3& at, btScalar distance) override {
    is_found = true;
    push = from_bullet(push_out);
    on_ground_m = from_bullet(at);
    distance_m = distance;
  }
};

/// Asks triangles one by one how near a body is: at its nearest point, and at each corner of a hull that lies
/// over the triangle.
struct TouchSearch : btTriangleCallback {
  const MassedShape& shape;
  const JoinedGround& joined;
  btTransform pose;
  double margin_m, near_m;
  std::vector<Touch> touches;
  Eigen::Isometry3d principal_from_world;
  std::vector<Eigen::Vector3d> corners_m;  ///< in the world
  std::size_t last_face = 0;               ///< that had a triangle before it
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;

  TouchSearch(const MassedShape& of, const JoinedGround& on, const btTransform& at, double margin,
              double nearer_than)
      : shape(of), joined(on), pose(at), margin_m(margin), near_m(nearer_than) {
    principal_from_world = from_bullet(pose).inverse();
    for (const Eigen::Vector3d& corner_m : shape.corners_m) corners_m.push_back(from_bullet(pose) * corner_m);
  }

  void processTriangle(btVector3* triangle, int, int index) override {
    const std::array<Eigen::Vector3d, 3> at_m = {from_bullet(triangle[0]), from_bullet(triangle[1]),
                                                 from_bullet(triangle[2])};
    if (is_far(at_m)) return;
    btTriangleShape one(triangle[0], triangle[1], triangle[2]);
    one.setMargin(margin_m);
    btGjkPairDetector detector(shape.shape.get(), &one, &simplex, &penetration);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pose;
    input.m_transformB.setIdentity();
    const double widest_m = shape.shape->getMargin() + margin_m + near_m;
    input.m_maximumDistanceSquared = widest_m * widest_m;
    ClosestPoint closest;
    detector.getClosestPoints(input, closest, nullptr);
    if (!closest.is_found || closest.distance_m > near_m) return;
    add_corners(at_m, static_cast<std::size_t>(index), closest);
    const Eigen::Vector3d push =
        push_of(joined, static_cast<std::size_t>(index), closest.on_ground_m, closest.push);
    add(closest.on_ground_m, push, closest.distance_m, false);
  }

  void add(const Eigen::Vector3d& on_ground_m, const Eigen::Vector3d& push, double distance_m,
           bool is_corner) {
    touches.push_back({.on_body_m = principal_from_world * (on_ground_m + distance_m * push),
                       .on_ground_m = on_ground_m,
                       .push = push,
                       .distance_m = distance_m,
                       .is_corner = is_corner});
  }

  /// Whether a face of the hull has the whole triangle before it. Most often that of the triangle before.
  bool is_far(const std::array<Eigen::Vector3d, 3>& at_m) {
    std::array<Eigen::Vector3d, 3> here_m;
    for (std::size_t i = 0; i < 3; ++i) here_m[i] = principal_from_world * at_m[i];
    const double away_m = near_m + 2 * margin_m;
    const auto is_before = [&](const auto& face) {
      return std::all_of(here_m.begin(), here_m.end(), [&](const Eigen::Vector3d& corner_m) {
        return face.first.dot(corner_m) > face.second + away_m;
      });
    };
    if (last_face < shape.faces.size() && is_before(shape.faces[last_face])) return true;
    const auto found = std::find_if(shape.faces.begin(), shape.faces.end(), is_before);
    last_face = static_cast<std::size_t>(found - shape.faces.begin());
    return found != shape.faces.end();
  }

  void add_corners(const std::array<Eigen::Vector3d, 3>& at_m, std::size_t index,
                   const ClosestPoint& closest) {
    const Eigen::Vector3d normal = ground_normal(joined.ground, index, closest.push);
    if (!(normal.dot(closest.push) > 0.5)) return;
    for (const Eigen::Vector3d& corner_m : corners_m) {
      const double distance_m = normal.dot(corner_m - at_m[0]) - 2 * margin_m;
      if (distance_m > near_m || distance_m < closest.distance_m - near_m) continue;
      const auto is_left_of = [&](std::size_t i) {
        const Eigen::Vector3d& a = at_m[i];
        return normal.dot((at_m[(i + 1) % 3] - a).cross(corner_m - a));
      };
      const double one = is_left_of(0), two = is_left_of(1), three = is_left_of(2);
      if (!((one >= 0 && two >= 0 && three >= 0) || (one <= 0 && two <= 0 && three <= 0))) continue;
      add(corner_m - (distance_m + margin_m) * normal, normal, distance_m, true);
    }
  }
};

}  // namespace

bool has_physics() {
  return true;
}

void require_physics() {}

/// Members in the order in which Bullet needs them.
struct RigidWorld::Bullet {
  PhysicsSettings settings;
  JoinedGround joined;
  std::unique_ptr<btTriangleIndexVertexArray> triangles;
  std::unique_ptr<btBvhTriangleMeshShape> ground_shape;
  btCollisionObject ground_object;
  MassedShape body_shape;
  std::unique_ptr<btRigidBody> body;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<btPersistentManifold*> manifolds = {};  ///< of the touches, four in each; the dispatcher's
  std::vector<Touch> touched = {};

  Bullet(Ground on, const BodyShape& shape, const Eigen::Isometry3d& world_from_body,
         const PhysicsSettings& how)
      : settings(how) {
    world.setGravity({0, -settings.gravity_m_s2, 0});
    world.getSolverInfo().m_numIterations = solver_iterations;
    // With one direction of friction, boxes on fine meshes tremble a thousand times more.
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    // Else what reaches less than 4 cm into the ground is pushed out with a speed, which it keeps.
    world.getSolverInfo().m_splitImpulsePenetrationThreshold = std::numeric_limits<btScalar>::max();
    set_ground(std::move(on));
    body_shape = std::visit([&](const auto& s) { return massed(s, settings.margin_m); }, shape);
    btRigidBody::btRigidBodyConstructionInfo facts(1, nullptr, body_shape.shape.get(),
                                                   to_bullet(body_shape.inertia_m2));
    facts.m_friction = settings.friction;
    facts.m_rollingFriction = settings.rolling_friction_m;
    facts.m_startWorldTransform = to_bullet(world_from_body * body_shape.body_from_principal);
    body = std::make_unique<btRigidBody>(facts);
    body->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(body.get());
  }
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;
  ~Bullet() {
    for (btPersistentManifold* manifold : manifolds) dispatcher.releaseManifold(manifold);
    if (body) world.removeRigidBody(body.get());
  }

  /// The ground is not part of Bullet's world: it gives its touches by itself.
  void set_ground(Ground on) {
    joined = joined_ground(std::move(on));
    const Ground& ground = joined.ground;
    btIndexedMesh mesh;
    mesh.m_numTriangles = static_cast<int>(ground.triangles.size());
    mesh.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(ground.triangles.data());
    mesh.m_triangleIndexStride = sizeof(ground.triangles[0]);
    mesh.m_numVertices = static_cast<int>(ground.vertices_m.size());
    mesh.m_vertexBase = reinterpret_cast<const unsigned char*>(ground.vertices_m.data());
    mesh.m_vertexStride = sizeof(Eigen::Vector3d);
    mesh.m_vertexType = PHY_DOUBLE;
    triangles = std::make_unique<btTriangleIndexVertexArray>();
    triangles->addIndexedMesh(mesh, PHY_INTEGER);
    ground_shape = std::make_unique<btBvhTriangleMeshShape>(triangles.get(), true);
    ground_object.setCollisionShape(ground_shape.get());
    ground_object.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
  }

  /// Where the body is nearer to the ground than `near_m`.
  std::vector<Touch> touches(double near_m) const {
    TouchSearch search(body_shape, joined, body->getCenterOfMassTransform(), settings.margin_m, near_m);
    btVector3 low, high;
    body_shape.shape->getAabb(search.pose, low, high);
    const btScalar wider_m = near_m + settings.margin_m;
    ground_shape->processAllTriangles(&search, low - btVector3(wider_m, wider_m, wider_m),
                                      high + btVector3(wider_m, wider_m, wider_m));
    return std::move(search.touches);
  }

  /// Gives Bullet's solver the touches of this moment, with the impulses of the last.
  void touch() {
    const double step_s = 1.0 / settings.steps_per_s;
    const double speed_m_s = body->getLinearVelocity().length() +
                             body->getAngularVelocity().length() * body_shape.reach_m +
                             settings.gravity_m_s2 * step_s;
    const double cell_m = cells_per_reach * body_shape.reach_m;
    std::vector<Touch> now = spread_touches(touches(nearest_m + 1.5 * speed_m_s * step_s), cell_m);
    keep_impulses(touched, cell_m, now);
    for (btPersistentManifold* manifold : manifolds) manifold->clearManifold();
    while (manifolds.size() * MANIFOLD_CACHE_SIZE < now.size())
      manifolds.push_back(dispatcher.getNewManifold(body.get(), &ground_object));
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Touch& touch = now[i];
      btManifoldPoint point(to_bullet(touch.on_body_m), to_bullet(touch.on_ground_m), to_bullet(touch.push),
                            touch.distance_m);
      point.m_positionWorldOnB = to_bullet(touch.on_ground_m);
      point.m_positionWorldOnA = to_bullet(touch.on_ground_m + touch.distance_m * touch.push);
      point.m_combinedFriction = settings.friction;
      point.m_combinedRollingFriction = settings.rolling_friction_m;
      point.m_appliedImpulse = touch.impulse;
      manifolds[i / MANIFOLD_CACHE_SIZE]->addManifoldPoint(point);
    }
    touched = std::move(now);
  }

  void step() {
    touch();
    world.stepSimulation(1.0 / settings.steps_per_s, 0);
    for (std::size_t i = 0; i < touched.size(); ++i)
      touched[i].impulse = manifolds[i / MANIFOLD_CACHE_SIZE]
                               ->getContactPoint(static_cast<int>(i % MANIFOLD_CACHE_SIZE))
                               .m_appliedImpulse;
  }
};

RigidWorld::RigidWorld(Ground ground, const BodyShape& shape, const Eigen::Isometry3d& world_from_body,
                       const PhysicsSettings& settings)
    : bullet_(std::make_unique<Bullet>(std::move(ground), shape, world_from_body, settings)) {}

void RigidWorld::move_ground(std::span<const Eigen::Vector3d> vertices_m) {
  Bullet& b = *bullet_;
  std::copy(vertices_m.begin(), vertices_m.end(), b.joined.ground.vertices_m.begin());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex_m : b.joined.ground.vertices_m) box.extend(vertex_m);
  // Not by `refitTree`, which then looks for the mesh's box, that nobody asks for, in as much time again.
  b.ground_shape->getOptimizedBvh()->refit(b.triangles.get(), to_bullet(box.min()), to_bullet(box.max()));
}

void RigidWorld::set_ground(Ground ground) {
  bullet_->set_ground(std::move(ground));
}

void RigidWorld::step() {
  bullet_->step();
}

BodyState RigidWorld::body() const {
  const btRigidBody& body = *bullet_->body;
  const btTransform& pose = body.getCenterOfMassTransform();
  BodyState state;
  state.world_from_body = from_bullet(pose) * bullet_->body_shape.body_from_principal.inverse();
  state.middle_m = from_bullet(pose.getOrigin());
  const Eigen::Vector3d velocity = from_bullet(body.getLinearVelocity());
  const Eigen::Vector3d spin = from_bullet(body.getAngularVelocity());
  const Eigen::Vector3d spin_here = from_bullet(pose).linear().transpose() * spin;
  state.speed_m_s = velocity.norm();
  state.spin_rad_s = spin.norm();
  state.energy_j_kg = 0.5 * velocity.squaredNorm() +
                      0.5 * spin_here.cwiseAbs2().dot(bullet_->body_shape.inertia_m2) +
                      bullet_->settings.gravity_m_s2 * state.middle_m.y();
  return state;
}

Overlap RigidWorld::deepest_overlap() const {
  Overlap deepest;
  for (const Touch& touch : bullet_->touches(0))
    if (!touch.is_corner && -touch.distance_m > deepest.depth_m)
      deepest = {.depth_m = -touch.distance_m, .where_m = touch.on_ground_m};
  return deepest;
}

RigidWorld::~RigidWorld() = default;
RigidWorld::RigidWorld(RigidWorld&&) noexcept = default;
RigidWorld& RigidWorld::operator=(RigidWorld&&) noexcept = default;

}  // namespace seamline::renderer
#endif
