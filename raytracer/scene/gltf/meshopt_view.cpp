#include "raytracer/scene/gltf/meshopt_view.h"

#ifdef SEAMLINE_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace seamline::renderer {

#ifdef SEAMLINE_HAS_MESHOPT

namespace {

bool decode_by_mode(std::string_view bytes, const MeshoptView& view, unsigned char* out) {
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  if (view.mode == "ATTRIBUTES" && view.stride % 4 == 0 && view.stride <= 256)
    return meshopt_decodeVertexBuffer(out, view.count, view.stride, from, bytes.size()) == 0;
  if (view.stride != 2 && view.stride != 4) return false;
  if (view.mode == "TRIANGLES" && view.count % 3 == 0)
    return meshopt_decodeIndexBuffer(out, view.count, view.stride, from, bytes.size()) == 0;
  return view.mode == "INDICES" &&
         meshopt_decodeIndexSequence(out, view.count, view.stride, from, bytes.size()) == 0;
}

bool undo_filter(const MeshoptView& view, unsigned char* out) {
  if (view.filter.empty() || view.filter == "NONE") return true;
  if (view.mode != "ATTRIBUTES") return false;
  if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) {
    meshopt_decodeFilterOct(out, view.count, view.stride);
    return true;
  }
  if (view.filter == "QUATERNION" && view.stride == 8) {
    meshopt_decodeFilterQuat(out, view.count, view.stride);
    return true;
  }
  if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0) {
    meshopt_decodeFilterExp(out, view.count, view.stride);
    return true;
  }
  return false;
}

}  // namespace

bool has_meshopt() {
  return true;
}

std::optional<std::vector<unsigned char>> decode_meshopt(std::string_view bytes, const MeshoptView& view) {
  if (view.count == 0 || view.stride == 0) return std::nullopt;
  // The library's filters work on rows of four elements.
  std::vector<unsigned char> out((view.count + 3) / 4 * 4 * view.stride);
  if (!decode_by_mode(bytes, view, out.data()) || !undo_filter(view, out.data())) return std::nullopt;
  out.resize(view.count * view.stride);
  return out;
}

#else

bool has_meshopt() {
  return false;
}

std::optional<std::vector<unsigned char>> decode_meshopt(std::string_view, const MeshoptView&) {
  return std::nullopt;
}

#endif

}  // namespace seamline::renderer
