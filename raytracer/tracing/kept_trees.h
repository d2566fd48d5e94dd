#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "raytracer/tracing/search_tree.h"

namespace seamline::renderer {

/// While one lives, each geometry of scene files is put together from search trees of its bodies: the
/// background, and each object. A body that was built before is not built again while its meshes live, so
/// that frames of a clip share what stands still. Which surface a ray meets does not depend on it. One at a
/// time; geometries may outlive it.
class KeptTrees {
 public:
  using Meshes = std::span<const std::shared_ptr<const SurfaceMesh>>;

  /// `tight` is what trees of tight edges of an object are good for: the fast estimator asks few rays of
  /// them, and an object that moves has new ones in every frame.
  explicit KeptTrees(TreeQuality tight = TreeQuality::for_few_rays);
  ~KeptTrees();
  KeptTrees(const KeptTrees&) = delete;
  KeptTrees& operator=(const KeptTrees&) = delete;
  /// The one that lives; null: none.
  [[nodiscard]] static KeptTrees* current();

  [[nodiscard]] std::shared_ptr<const SearchTree> tree_of(Meshes body, Edges edges);

  /// Of bodies asked for so far, and those of them that had to be built.
  struct Counts {
    std::int64_t asked = 0, built = 0;
  };
  [[nodiscard]] Counts counts() const;

 private:
  using Key = std::pair<std::vector<const SurfaceMesh*>, Edges>;
  struct Kept {
    std::vector<std::weak_ptr<const SurfaceMesh>> meshes;
    std::weak_ptr<const SearchTree> tree;
    std::shared_ptr<const SearchTree> held = {};  ///< from the second use on
  };
  void forget_what_is_gone();

  [[nodiscard]] std::shared_ptr<const SearchTree> build(Meshes body, Edges edges);

  TreeQuality tight_;
  mutable std::mutex mutex_;
  std::map<Key, Kept> kept_;
  Counts counts_;
};

/// The bodies of a geometry: runs of meshes of one object.
[[nodiscard]] std::vector<KeptTrees::Meshes> bodies_of(KeptTrees::Meshes meshes);

}  // namespace seamline::renderer
