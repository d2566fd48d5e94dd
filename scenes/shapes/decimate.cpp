#include "scenes/shapes/decimate.h"

#include <Eigen/LU>
#include <algorithm>
#include <queue>

namespace seamline::scenes {
namespace {

using Matrix3d = Eigen::Matrix3d;
using Vector3d = Eigen::Vector3d;
using Index = std::uint32_t;

/// The sum of squared distances to planes: p'Ap + 2b'p + c.
struct Quadric {
  Matrix3d A = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  double c = 0;

  void add(const Quadric& other) {
    A += other.A;
    b += other.b;
    c += other.c;
  }
  [[nodiscard]] double at(const Vector3d& p) const { return p.dot(A * p) + 2 * b.dot(p) + c; }
};

/// An edge that may collapse to `place`; out of date when either end has changed since.
struct Candidate {
  double error = 0;
  Index keep = 0;
  Index drop = 0;
  unsigned keep_stamp = 0;
  unsigned drop_stamp = 0;
  Vector3d place = Vector3d::Zero();
};
struct Later {
  bool operator()(const Candidate& a, const Candidate& b) const {
    if (a.error != b.error) return a.error > b.error;
    return a.keep != b.keep ? a.keep > b.keep : a.drop > b.drop;
  }
};

/// A mesh on the way down: which triangles use a vertex, and its quadric.
struct Shrinking {
  TriangleMesh mesh;
  std::vector<std::vector<Index>> users;
  std::vector<Quadric> quadrics;
  std::vector<unsigned> stamps;
  std::vector<bool> gone;  ///< one a triangle
  std::priority_queue<Candidate, std::vector<Candidate>, Later> queue;
};

Vector3d scaled_normal(const TriangleMesh& mesh, const std::array<Index, 3>& t) {
  const Vector3d& a = mesh.positions_m[t[0]];
  return (mesh.positions_m[t[1]] - a).cross(mesh.positions_m[t[2]] - a);
}

std::vector<Index> neighbours(const Shrinking& s, Index vertex) {
  std::vector<Index> around;
  for (const Index user : s.users[vertex])
    for (const Index corner : s.mesh.triangles[user])
      if (corner != vertex) around.push_back(corner);
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

void consider(Shrinking& s, Index a, Index b) {
  if (a > b) std::swap(a, b);
  Quadric sum = s.quadrics[a];
  sum.add(s.quadrics[b]);
  const Vector3d& pa = s.mesh.positions_m[a];
  const Vector3d& pb = s.mesh.positions_m[b];
  const Vector3d middle = (pa + pb) / 2;
  // The best place; directions in which the quadric is flat are left at the middle.
  const double soften = 1e-3 * sum.A.trace() + 1e-15;
  const Vector3d place =
      middle - (sum.A + soften * Matrix3d::Identity()).inverse() * (sum.A * middle + sum.b);
  const double length2 = (pa - pb).squaredNorm();
  if ((place - middle).squaredNorm() > length2) return;
  const double error = std::max(sum.at(place), 0.0) + 1e-4 * sum.A.trace() * length2;
  s.queue.push({.error = error,
                .keep = a,
                .drop = b,
                .keep_stamp = s.stamps[a],
                .drop_stamp = s.stamps[b],
                .place = place});
}

Shrinking prepare(const TriangleMesh& mesh) {
  Shrinking s{.mesh = mesh, .users = {}, .quadrics = {}, .stamps = {}, .gone = {}, .queue = {}};
  const std::size_t count = mesh.positions_m.size();
  s.users.resize(count);
  s.quadrics.resize(count);
  s.stamps.resize(count, 0);
  s.gone.resize(mesh.triangles.size(), false);
  for (Index i = 0; i < mesh.triangles.size(); ++i) {
    const Vector3d normal = scaled_normal(mesh, mesh.triangles[i]);
    const double twice_area = normal.norm();
    const Vector3d n = twice_area > 0 ? Vector3d(normal / twice_area) : Vector3d::Zero();
    const double offset = -n.dot(mesh.positions_m[mesh.triangles[i][0]]);
    const Quadric plane{
        .A = twice_area * n * n.transpose(), .b = twice_area * offset * n, .c = twice_area * offset * offset};
    for (const Index corner : mesh.triangles[i]) {
      s.users[corner].push_back(i);
      s.quadrics[corner].add(plane);
    }
  }
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3]) consider(s, t[i], t[(i + 1) % 3]);
  return s;
}

/// Whether moving `vertex` to `place` keeps its triangles, those that also use `other` left out, facing as
/// they did.
bool keeps_facing(const Shrinking& s, Index vertex, Index other, const Vector3d& place) {
  for (const Index user : s.users[vertex]) {
    const auto& t = s.mesh.triangles[user];
    if (t[0] == other || t[1] == other || t[2] == other) continue;
    std::array<Vector3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = t[i] == vertex ? place : s.mesh.positions_m[t[i]];
    const Vector3d before = scaled_normal(s.mesh, t);
    const Vector3d after = (p[1] - p[0]).cross(p[2] - p[0]);
    if (after.dot(before) < 0.3 * after.norm() * before.norm() || after.norm() <= 1e-12) return false;
  }
  return true;
}

/// The link condition: the ends share exactly the two vertices opposite the edge, else the surface would
/// pinch.
bool stays_manifold(const Shrinking& s, const Candidate& c) {
  const std::vector<Index> a = neighbours(s, c.keep);
  const std::vector<Index> b = neighbours(s, c.drop);
  std::vector<Index> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  return shared.size() == 2 && a.size() + b.size() > 7;
}

/// Moves `keep` and hands it the triangles of `drop`; returns how many triangles vanished.
std::size_t collapse(Shrinking& s, const Candidate& c) {
  s.mesh.positions_m[c.keep] = c.place;
  s.quadrics[c.keep].add(s.quadrics[c.drop]);
  std::size_t vanished = 0;
  for (const Index user : s.users[c.drop]) {
    auto& t = s.mesh.triangles[user];
    if (t[0] == c.keep || t[1] == c.keep || t[2] == c.keep) {
      s.gone[user] = true;
      ++vanished;
      for (const Index corner : t) std::erase(s.users[corner == c.drop ? c.keep : corner], user);
      continue;
    }
    std::replace(t.begin(), t.end(), c.drop, c.keep);
    s.users[c.keep].push_back(user);
  }
  s.users[c.drop].clear();
  ++s.stamps[c.drop];
  ++s.stamps[c.keep];
  for (const Index other : neighbours(s, c.keep)) consider(s, c.keep, other);
  return vanished;
}

}  // namespace

TriangleMesh decimated(const TriangleMesh& mesh, std::size_t triangles) {
  Shrinking s = prepare(mesh);
  std::size_t left = mesh.triangles.size();
  while (left > triangles && !s.queue.empty()) {
    const Candidate c = s.queue.top();
    s.queue.pop();
    if (s.stamps[c.keep] != c.keep_stamp || s.stamps[c.drop] != c.drop_stamp) continue;
    if (!stays_manifold(s, c) || !keeps_facing(s, c.keep, c.drop, c.place) ||
        !keeps_facing(s, c.drop, c.keep, c.place))
      continue;
    left -= collapse(s, c);
  }
  TriangleMesh kept{.positions_m = s.mesh.positions_m, .normals = s.mesh.normals, .triangles = {}};
  for (std::size_t i = 0; i < s.gone.size(); ++i)
    if (!s.gone[i]) kept.triangles.push_back(s.mesh.triangles[i]);
  return largest_piece(kept);
}

}  // namespace seamline::scenes
