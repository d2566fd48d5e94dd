// The only file that includes Bullet.
#include "renderer/physics/rigid_world.h"

#include "support/text/error.h"

#ifdef SEAMLINE_HAS_BULLET
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <LinearMath/btConvexHullComputer.h>
#include <btBulletDynamicsCommon.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#endif

namespace seamline::renderer {

#ifdef SEAMLINE_HAS_BULLET

namespace {

constexpr int solver_iterations = 30;

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Eigen::Vector3d from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

btTransform to_bullet(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d r = pose.linear();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      to_bullet(pose.translation()));
}

Eigen::Isometry3d from_bullet(const btTransform& pose) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out.linear()(row, column) = pose.getBasis()[row][column];
  out.translation() = from_bullet(pose.getOrigin());
  return out;
}

/// A shape for Bullet, about the centre of mass and along the principal axes.
struct MassedShape {
  std::unique_ptr<btConvexInternalShape> shape;
  Eigen::Isometry3d body_from_principal = Eigen::Isometry3d::Identity();
  Eigen::Vector3d inertia_m2 = Eigen::Vector3d::Ones();  ///< of a kilogram
};

/// Volume, centre and second moments of the solid between triangles, wound outwards.
struct Moments {
  double volume_m3 = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double volume = a.dot(b.cross(c)) / 6;
    const Eigen::Vector3d sum = a + b + c;
    volume_m3 += volume;
    first += volume / 4 * sum;
    second +=
        volume / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
};

Moments moments_of(btConvexHullComputer& hull) {
  Moments moments;
  for (int face = 0; face < hull.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[face]];
    const Eigen::Vector3d a = from_bullet(hull.vertices[first->getSourceVertex()]);
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
         edge = edge->getNextEdgeOfFace())
      moments.add(a, from_bullet(hull.vertices[edge->getSourceVertex()]),
                  from_bullet(hull.vertices[edge->getTargetVertex()]));
  }
  return moments;
}

InputError flat_shape() {
  return input_error(
      {.field = "a body that falls", .wanted = "an object with a volume", .found = "a flat one"});
}

/// The hull's faces are moved inwards by the margin, which Bullet adds again on every side.
MassedShape massed(const HullShape& hull, double margin_m) {
  btConvexHullComputer whole;
  whole.compute(hull.points_m.front().data(), sizeof(Eigen::Vector3d), static_cast<int>(hull.points_m.size()),
                0, 0);
  const Moments moments = moments_of(whole);
  if (!(std::abs(moments.volume_m3) > 1e-12)) throw flat_shape();
  MassedShape out;
  const Eigen::Vector3d middle = moments.first / moments.volume_m3;
  const Eigen::Matrix3d second = moments.second / moments.volume_m3 - middle * middle.transpose();
  const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  out.inertia_m2 = axes.eigenvalues();
  Eigen::Matrix3d turn = axes.eigenvectors();
  if (turn.determinant() < 0) turn.col(2) = -turn.col(2);
  out.body_from_principal.linear() = turn;
  out.body_from_principal.translation() = middle;
  btConvexHullComputer shrunk;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < whole.vertices.size(); ++i)
    points.push_back(out.body_from_principal.inverse() * from_bullet(whole.vertices[i]));
  shrunk.compute(points.front().data(), sizeof(Eigen::Vector3d), static_cast<int>(points.size()), margin_m,
                 0.25);
  auto shape = std::make_unique<btConvexHullShape>();
  for (int i = 0; i < shrunk.vertices.size(); ++i) shape->addPoint(shrunk.vertices[i], false);
  shape->recalcLocalAabb();
  shape->setMargin(margin_m);
  out.shape = std::move(shape);
  return out;
}

MassedShape massed(const BallShape& ball, double) {
  if (!(ball.radius_m > 0)) throw flat_shape();
  MassedShape out;
  out.body_from_principal.translation() = ball.centre_m;
  out.inertia_m2 = Eigen::Vector3d::Constant(0.4 * ball.radius_m * ball.radius_m);
  out.shape = std::make_unique<btSphereShape>(ball.radius_m);
  return out;
}

/// Across each edge of a triangle, from its corner i to its corner i + 1: the neighbour, and the neighbour's
/// third corner. An edge that has no other triangle, or several, has none.
struct Neighbour {
  int triangle = -1;
  std::uint32_t third = 0;
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighbours_of(const Ground& ground) {
  struct Side {
    std::uint64_t edge;
    int triangle, side;
  };
  std::vector<Side> sides;
  sides.reserve(3 * ground.triangles.size());
  for (std::size_t t = 0; t < ground.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const std::uint64_t a = ground.triangles[t][static_cast<std::size_t>(side)],
                          b = ground.triangles[t][static_cast<std::size_t>((side + 1) % 3)];
      sides.push_back({std::min(a, b) << 32U | std::max(a, b), static_cast<int>(t), side});
    }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  Neighbours neighbours(ground.triangles.size());
  const auto third = [&](const Side& s) {
    return ground.triangles[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>((s.side + 2) % 3)];
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].edge == sides[i].edge) ++end;
    if (end != i + 2) continue;
    const Side &one = sides[i], &other = sides[i + 1];
    neighbours[static_cast<std::size_t>(one.triangle)][static_cast<std::size_t>(one.side)] = {other.triangle,
                                                                                              third(other)};
    neighbours[static_cast<std::size_t>(other.triangle)][static_cast<std::size_t>(other.side)] = {
        one.triangle, third(one)};
  }
  return neighbours;
}

/// A ground and who is whose neighbour there.
struct JoinedGround {
  Ground ground;
  Neighbours neighbours;
};

constexpr double flat_cosine = 0.97;  ///< of 14 degrees

/// The direction in which a triangle pushes at a point, unit. Bullet asks each triangle alone, so that bodies
/// catch on the edges inside a flat floor: a triangle that goes on beyond its nearest edge, nearly in its
/// plane, pushes along its normal. Elsewhere Bullet's own direction stays.
Eigen::Vector3d push_of(const JoinedGround& joined, std::size_t triangle, const Eigen::Vector3d& at_m,
                        const Eigen::Vector3d& push) {
  const auto& corners = joined.ground.triangles[triangle];
  const auto place_m = [&](std::size_t i) -> const Eigen::Vector3d& {
    return joined.ground.vertices_m[corners[i % 3]];
  };
  Eigen::Vector3d normal = (place_m(1) - place_m(0)).cross(place_m(2) - place_m(0)).normalized();
  if (normal.dot(push) < 0) normal = -normal;
  if (!normal.allFinite() || normal.isZero() || normal.dot(push) > 1 - 1e-9) return push;
  std::size_t nearest = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d along = (place_m(i + 1) - place_m(i)).normalized();
    const double distance_m = (at_m - place_m(i)).cross(along).norm();
    if (distance_m < nearest_m) nearest = i, nearest_m = distance_m;
  }
  const Neighbour& neighbour = joined.neighbours[triangle][nearest];
  if (neighbour.triangle < 0) return push;
  const Eigen::Vector3d& third_m = joined.ground.vertices_m[neighbour.third];
  const Eigen::Vector3d other =
      (place_m(nearest + 1) - place_m(nearest)).cross(third_m - place_m(nearest)).normalized();
  return std::abs(normal.dot(other)) > flat_cosine ? normal : push;
}

bool correct_push(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int first_index,
                  const btCollisionObjectWrapper* second, int, int second_index) {
  const bool ground_is_second = second->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE;
  const btCollisionObjectWrapper* triangle = ground_is_second ? second : first;
  const auto* joined = static_cast<const JoinedGround*>(triangle->getCollisionObject()->getUserPointer());
  if (joined == nullptr) return false;
  const int index = ground_is_second ? second_index : first_index;
  const double sign = ground_is_second ? 1 : -1;
  const btVector3& at = ground_is_second ? point.m_positionWorldOnB : point.m_positionWorldOnA;
  const Eigen::Vector3d push = sign * push_of(*joined, static_cast<std::size_t>(index), from_bullet(at),
                                              sign * from_bullet(point.m_normalWorldOnB));
  point.m_normalWorldOnB = to_bullet(push);
  return true;
}

struct DeepestContact : btCollisionWorld::ContactResultCallback {
  double deepest_m = 0;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    deepest_m = std::max(deepest_m, static_cast<double>(-point.getDistance()));
    return 0;
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
  std::unique_ptr<btCollisionObject> ground_object;
  MassedShape body_shape;
  std::unique_ptr<btRigidBody> body;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

  Bullet(Ground on, const BodyShape& shape, const Eigen::Isometry3d& world_from_body,
         const PhysicsSettings& how)
      : settings(how), joined{std::move(on), {}} {
    static const bool callback_is_set = (gContactAddedCallback = correct_push, true);
    static_cast<void>(callback_is_set);
    world.setGravity({0, -settings.gravity_m_s2, 0});
    world.getSolverInfo().m_numIterations = solver_iterations;
    // With one direction of friction, boxes on fine meshes tremble a thousand times more.
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    add_ground();
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
    if (body) world.removeRigidBody(body.get());
    if (ground_object) world.removeCollisionObject(ground_object.get());
  }

  void add_ground() {
    joined.neighbours = neighbours_of(joined.ground);
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
    ground_shape->setMargin(settings.margin_m);
    ground_object = std::make_unique<btCollisionObject>();
    ground_object->setCollisionShape(ground_shape.get());
    ground_object->setFriction(1);
    ground_object->setUserPointer(&joined);
    ground_object->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT |
                                     btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    world.addCollisionObject(ground_object.get());
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
  b.ground_shape->refitTree(to_bullet(box.min()), to_bullet(box.max()));
  b.world.updateSingleAabb(b.ground_object.get());
  b.broadphase.getOverlappingPairCache()->cleanProxyFromPairs(b.ground_object->getBroadphaseHandle(),
                                                              &b.dispatcher);
}

void RigidWorld::set_ground(Ground ground) {
  Bullet& b = *bullet_;
  b.world.removeCollisionObject(b.ground_object.get());
  b.joined.ground = std::move(ground);
  b.add_ground();
}

void RigidWorld::step() {
  bullet_->world.stepSimulation(1.0 / bullet_->settings.steps_per_s, 0);
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

double RigidWorld::overlap_m() const {
  DeepestContact contact;
  bullet_->world.contactPairTest(bullet_->body.get(), bullet_->ground_object.get(), contact);
  return contact.deepest_m;
}

#else

bool has_physics() {
  return false;
}

void require_physics() {
  throw input_error({.field = "falling bodies",
                     .wanted = "Seamline built with Bullet (Debian: libbullet-dev)",
                     .found = "a build without it"});
}

struct RigidWorld::Bullet {};

RigidWorld::RigidWorld(Ground, const BodyShape&, const Eigen::Isometry3d&, const PhysicsSettings&) {
  require_physics();
}
void RigidWorld::move_ground(std::span<const Eigen::Vector3d>) {}
void RigidWorld::set_ground(Ground) {}
void RigidWorld::step() {}
BodyState RigidWorld::body() const {
  return {};
}
double RigidWorld::overlap_m() const {
  return 0;
}

#endif

RigidWorld::~RigidWorld() = default;
RigidWorld::RigidWorld(RigidWorld&&) noexcept = default;
RigidWorld& RigidWorld::operator=(RigidWorld&&) noexcept = default;

}  // namespace seamline::renderer
