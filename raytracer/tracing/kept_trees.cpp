#include "raytracer/tracing/kept_trees.h"

#include <algorithm>
#include <atomic>
#include <cassert>

namespace seamline::renderer {
namespace {

std::atomic<KeptTrees*>& living() {
  static std::atomic<KeptTrees*> one = nullptr;
  return one;
}

}  // namespace

KeptTrees::KeptTrees(TreeQuality tight) : tight_(tight) {
  [[maybe_unused]] const KeptTrees* const before = living().exchange(this);
  assert(before == nullptr);
}

KeptTrees::~KeptTrees() {
  living() = nullptr;
}

KeptTrees* KeptTrees::current() {
  return living();
}

std::shared_ptr<const SearchTree> KeptTrees::tree_of(Meshes body, Edges edges) {
  Key key{{}, edges};
  for (const auto& mesh : body) key.first.push_back(mesh.get());
  const std::lock_guard lock(mutex_);
  ++counts_.asked;
  forget_what_is_gone();
  if (const auto found = kept_.find(key); found != kept_.end()) {
    Kept& known = found->second;
    if (known.held) return known.held;
    known.held = known.tree.lock();
    if (!known.held) {
      known.held = build(body, edges);
    }
    return known.held;
  }
  auto tree = build(body, edges);
  kept_.emplace(std::move(key), Kept{.meshes = {body.begin(), body.end()}, .tree = tree});
  return tree;
}

std::shared_ptr<const SearchTree> KeptTrees::build(Meshes body, Edges edges) {
  ++counts_.built;
  const bool is_object = body.front()->object_index != 0;
  return std::make_shared<const SearchTree>(
      body, edges, is_object && edges == Edges::tight ? tight_ : TreeQuality::for_light);
}

/// Of a body whose meshes are gone: another mesh may lie where one of them did.
void KeptTrees::forget_what_is_gone() {
  std::erase_if(kept_, [](const auto& one) {
    return std::any_of(one.second.meshes.begin(), one.second.meshes.end(),
                       [](const auto& mesh) { return mesh.expired(); });
  });
}

KeptTrees::Counts KeptTrees::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

std::vector<KeptTrees::Meshes> bodies_of(KeptTrees::Meshes meshes) {
  std::vector<KeptTrees::Meshes> bodies;
  for (std::size_t first = 0; first < meshes.size();) {
    std::size_t end = first + 1;
    while (end < meshes.size() && meshes[end]->object_index == meshes[first]->object_index) ++end;
    bodies.push_back(meshes.subspan(first, end - first));
    first = end;
  }
  return bodies;
}

}  // namespace seamline::renderer
