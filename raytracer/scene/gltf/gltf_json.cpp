#include "raytracer/scene/gltf/gltf_json.h"

#include <limits>

namespace seamline::renderer {

const GltfJson* member(const GltfJson& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::int64_t whole_number(const GltfJson& object, const char* key, std::int64_t usual) {
  const GltfJson* found = member(object, key);
  if (found == nullptr || !found->is_number_integer()) return usual;
  // A number beyond those of 64 bits with a sign can be no index.
  if (found->is_number_unsigned() &&
      found->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    return usual;
  return found->get<std::int64_t>();
}

std::string text_of(const GltfJson& object, const char* key) {
  const GltfJson* found = member(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

std::size_t count_of(const GltfJson& object, const char* key) {
  const GltfJson* found = member(object, key);
  return found != nullptr && found->is_array() ? found->size() : 0;
}

}  // namespace seamline::renderer
