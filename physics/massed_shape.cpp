#ifdef SEAMLINE_HAS_BULLET
#include "physics/massed_shape.h"

#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <LinearMath/btAabbUtil2.h>
#include <LinearMath/btConvexHullComputer.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "physics/solid.h"
#include "physics/support_table.h"
#include "support/text/error.h"

namespace seamline::renderer {

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

namespace {

/// A hull as `btConvexHullShape`, with the same answers: that one asks all its points each time, which is
/// half of the time of bodies that touch.
class TabledHull : public btConvexInternalShape {
 public:
  TabledHull(const std::vector<Eigen::Vector3d>& corners_m, double margin_m) : table_(corners_m) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin_m);
    for (const Eigen::Vector3d& corner_m : corners_m) box_m_.extend(corner_m);
  }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    return to_bullet(table_.farthest(from_bullet(direction)));
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* out,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) out[i] = localGetSupportingVertexWithoutMargin(directions[i]);
  }
  void getAabb(const btTransform& pose, btVector3& low, btVector3& high) const override {
    const btVector3 margin(getMargin(), getMargin(), getMargin());
    btTransformAabb(to_bullet(box_m_.min()) - margin, to_bullet(box_m_.max()) + margin, getMargin(), pose,
                    low, high);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "hull"; }

 private:
  SupportTable table_;
  Eigen::AlignedBox3d box_m_;
};

Solid solid_of(btConvexHullComputer& hull) {
  Solid solid;
  for (int i = 0; i < hull.vertices.size(); ++i) solid.corners_m.push_back(from_bullet(hull.vertices[i]));
  for (int face = 0; face < hull.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[face]];
    const int start = first->getSourceVertex();
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != start;
         edge = edge->getNextEdgeOfFace())
      solid.triangles.push_back({start, edge->getSourceVertex(), edge->getTargetVertex()});
  }
  return solid;
}

InputError flat_shape() {
  return input_error(
      {.field = "a body that falls", .wanted = "an object with a volume", .found = "a flat one"});
}

}  // namespace

MassedShape massed(const HullShape& hull, double margin_m) {
  btConvexHullComputer whole;
  whole.compute(hull.points_m.front().data(), sizeof(Eigen::Vector3d), static_cast<int>(hull.points_m.size()),
                0, 0);
  const VolumeMoments moments = moments_of(solid_of(whole));
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
  for (int i = 0; i < shrunk.vertices.size(); ++i) {
    out.corners_m.push_back(from_bullet(shrunk.vertices[i]));
    out.reach_m = std::max(out.reach_m, out.corners_m.back().norm() + margin_m);
  }
  out.faces = faces_of(solid_of(shrunk));
  out.shape = std::make_unique<TabledHull>(out.corners_m, margin_m);
  return out;
}

MassedShape massed(const BallShape& ball, double) {
  if (!(ball.radius_m > 0)) throw flat_shape();
  MassedShape out;
  out.body_from_principal.translation() = ball.centre_m;
  out.inertia_m2 = Eigen::Vector3d::Constant(0.4 * ball.radius_m * ball.radius_m);
  out.shape = std::make_unique<btSphereShape>(ball.radius_m);
  out.reach_m = ball.radius_m;
  return out;
}

}  // namespace seamline::renderer
#endif
