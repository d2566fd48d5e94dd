#include "raytracer/scene/gltf/draco_mesh.h"

#ifdef SEAMLINE_HAS_DRACO
#include <draco/compression/decode.h>

#include <array>
#include <cstring>
#endif

namespace seamline::renderer {

#ifdef SEAMLINE_HAS_DRACO

namespace {

/// glTF's code of a type; floats for types that glTF has not.
int component_type_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 5120;
    case draco::DT_UINT8:
      return 5121;
    case draco::DT_INT16:
      return 5122;
    case draco::DT_UINT16:
      return 5123;
    case draco::DT_UINT32:
      return 5125;
    default:
      return 5126;
  }
}

constexpr int code_of_floats = 5126;

std::optional<DracoAttribute> attribute_of(const draco::Mesh& mesh, const draco::PointAttribute& from) {
  DracoAttribute to{.component_type = component_type_of(from.data_type()),
                    .components = from.num_components(),
                    .bytes = {}};
  if (to.components < 1 || to.components > 4) return std::nullopt;
  const std::size_t bytes = static_cast<std::size_t>(to.components) *
                            (to.component_type == code_of_floats
                                 ? sizeof(float)
                                 : static_cast<std::size_t>(draco::DataTypeLength(from.data_type())));
  to.bytes.resize(bytes * mesh.num_points());
  char* out = to.bytes.data();
  for (draco::PointIndex i(0); i < mesh.num_points(); ++i, out += bytes) {
    const draco::AttributeValueIndex value = from.mapped_index(i);
    if (value.value() >= from.size()) return std::nullopt;
    if (to.component_type != code_of_floats) {
      from.GetValue(value, out);
      continue;
    }
    std::array<float, 4> numbers{};
    if (!from.ConvertValue<float>(value, static_cast<std::int8_t>(to.components), numbers.data()))
      return std::nullopt;
    std::memcpy(out, numbers.data(), bytes);
  }
  return to;
}

}  // namespace

bool has_draco() {
  return true;
}

std::optional<DracoMesh> decode_draco(std::string_view bytes, std::uint32_t most_vertices,
                                      std::uint32_t most_triangles) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  const auto kind = draco::Decoder::GetEncodedGeometryType(&buffer);
  if (!kind.ok() || kind.value() != draco::TRIANGULAR_MESH) return std::nullopt;
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return std::nullopt;
  const draco::Mesh& mesh = *decoded.value();
  if (mesh.num_points() > most_vertices || mesh.num_faces() > most_triangles) return std::nullopt;
  DracoMesh out{.corners = {}, .vertices = mesh.num_points(), .attributes = {}};
  out.corners.reserve(std::size_t{3} * mesh.num_faces());
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& corner : mesh.face(f)) out.corners.push_back(corner.value());
  for (int a = 0; a < mesh.num_attributes(); ++a) {
    auto attribute = attribute_of(mesh, *mesh.attribute(a));
    if (!attribute) return std::nullopt;
    out.attributes[static_cast<int>(mesh.attribute(a)->unique_id())] = std::move(*attribute);
  }
  return out;
}

#else

bool has_draco() {
  return false;
}

std::optional<DracoMesh> decode_draco(std::string_view, std::uint32_t, std::uint32_t) {
  return std::nullopt;
}

#endif

}  // namespace seamline::renderer
