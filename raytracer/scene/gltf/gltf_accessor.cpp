#include "raytracer/scene/gltf/gltf_accessor.h"

#include <fmt/core.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

constexpr auto largest_count = static_cast<std::size_t>(3 * limits::largest_scene_triangles);

/// A run of elements inside one buffer, proven to lie within it.
struct Run {
  const unsigned char* data;
  std::size_t stride;
  std::size_t count;
  int component_type;
  bool normalised;
};

double component(const unsigned char* bytes, int type, bool normalised) {
  const auto read = [&]<class T>(T value, double largest) {
    std::memcpy(&value, bytes, sizeof value);
    const double number = static_cast<double>(value);
    return normalised ? std::max(number / largest, -1.0) : number;
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read(std::int8_t{}, 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read(std::uint8_t{}, 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read(std::int16_t{}, 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read(std::uint16_t{}, 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read(std::uint32_t{}, 4294967295.0);
    default:
      break;
  }
  float value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return double{value};
}

Run checked_run(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t stride_or_zero,
                std::size_t element_bytes, std::size_t count, int component_type, const Complaint& where) {
  const auto bad = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = where.file, .field = where.field, .wanted = wanted, .found = found});
  };
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= model.bufferViews.size())
    throw bad("a buffer view that exists", std::to_string(view_index));
  const tinygltf::BufferView& view = model.bufferViews[view_index];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
    throw bad("a buffer that exists", std::to_string(view.buffer));
  const std::vector<unsigned char>& bytes = model.buffers[view.buffer].data;
  const std::size_t stride = stride_or_zero != 0 ? stride_or_zero : element_bytes;
  const bool view_inside =
      view.byteLength <= bytes.size() && view.byteOffset <= bytes.size() - view.byteLength;
  // Divided, not multiplied: hostile offsets and strides must not wrap around.
  const bool inside =
      view_inside &&
      (count == 0 || (element_bytes <= view.byteLength && offset <= view.byteLength - element_bytes &&
                      count - 1 <= (view.byteLength - element_bytes - offset) / stride));
  if (!inside)
    throw bad("an accessor inside its buffer",
              fmt::format("{} elements of {} bytes from byte {} of {}", count, element_bytes, offset,
                          std::min(view.byteLength, bytes.size())));
  return {bytes.data() + view.byteOffset + offset, stride, count, component_type, false};
}

}  // namespace

std::vector<double> GltfReader::components(int index, int wanted_components, const std::string& field) const {
  const Complaint where{.file = file_, .field = field};
  if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size())
    throw input_error(
        {.file = file_, .field = field, .wanted = "an accessor that exists", .found = std::to_string(index)});
  const tinygltf::Accessor& accessor = model_.accessors[index];
  const int component_bytes =
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  const int component_count = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (component_bytes <= 0 || component_count != wanted_components ||
      accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE)
    throw input_error({.file = file_,
                       .field = field,
                       .wanted = fmt::format("an accessor of {} components", wanted_components),
                       .found = fmt::format("{} of type {}", component_count, accessor.componentType)});
  if (accessor.count > largest_count)
    throw input_error({.file = file_,
                       .field = field,
                       .wanted = fmt::format("at most {} elements", largest_count),
                       .found = std::to_string(accessor.count)});
  std::vector<double> values;
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    const std::size_t element_bytes = static_cast<std::size_t>(component_bytes * component_count);
    const bool view_exists =
        accessor.bufferView >= 0 && static_cast<std::size_t>(accessor.bufferView) < model_.bufferViews.size();
    const std::size_t stride = view_exists ? model_.bufferViews[accessor.bufferView].byteStride : 0;
    const Run run = checked_run(model_, accessor.bufferView, accessor.byteOffset, stride, element_bytes,
                                accessor.count, accessor.componentType, where);
    values.resize(accessor.count * static_cast<std::size_t>(component_count), 0.0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < run.count; ++i)
      for (int c = 0; c < component_count; ++c)
        values[next++] = component(run.data + i * run.stride + static_cast<std::size_t>(c * component_bytes),
                                   accessor.componentType, accessor.normalized);
  }
  values.resize(accessor.count * static_cast<std::size_t>(component_count), 0.0);
  if (accessor.sparse.isSparse) overwrite_sparse(index, component_count, values, field);
  return values;
}

void GltfReader::overwrite_sparse(int index, int component_count, std::vector<double>& values,
                                  const std::string& field) const {
  const tinygltf::Accessor& accessor = model_.accessors[index];
  const Complaint where{.file = file_, .field = field + " (sparse)"};
  const int index_type = accessor.sparse.indices.componentType;
  const int index_bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(index_type));
  const std::size_t component_bytes = static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  if (accessor.sparse.count < 0 || accessor.sparse.indices.byteOffset < 0 ||
      accessor.sparse.values.byteOffset < 0 || index_bytes <= 0 ||
      index_type == TINYGLTF_COMPONENT_TYPE_FLOAT)
    throw input_error({.file = where.file,
                       .field = where.field,
                       .wanted = "a count, offsets that are not negative, and whole-number indices",
                       .found = "others"});
  const std::size_t count = static_cast<std::size_t>(accessor.sparse.count);
  const Run where_run = checked_run(model_, accessor.sparse.indices.bufferView,
                                    static_cast<std::size_t>(accessor.sparse.indices.byteOffset), 0,
                                    static_cast<std::size_t>(index_bytes), count, index_type, where);
  const std::size_t element_bytes = component_bytes * static_cast<std::size_t>(component_count);
  const Run value_run = checked_run(model_, accessor.sparse.values.bufferView,
                                    static_cast<std::size_t>(accessor.sparse.values.byteOffset), 0,
                                    element_bytes, count, accessor.componentType, where);
  for (std::size_t i = 0; i < count; ++i) {
    const auto target =
        static_cast<std::size_t>(component(where_run.data + i * where_run.stride, index_type, false));
    if (target >= accessor.count)
      throw input_error({.file = where.file,
                         .field = where.field,
                         .wanted = "indices inside the accessor",
                         .found = std::to_string(target)});
    for (int c = 0; c < component_count; ++c)
      values[target * static_cast<std::size_t>(component_count) + static_cast<std::size_t>(c)] =
          component(value_run.data + i * value_run.stride + static_cast<std::size_t>(c) * component_bytes,
                    accessor.componentType, accessor.normalized);
  }
}

std::int64_t GltfReader::count(int index) const {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) return 0;
  const std::size_t count = model_.accessors[index].count;
  return std::in_range<std::int64_t>(count) ? static_cast<std::int64_t>(count)
                                            : std::numeric_limits<std::int64_t>::max();
}

template <class Vector>
std::vector<Vector> GltfReader::finite_vectors(int index, const std::string& field) const {
  constexpr int size = Vector::RowsAtCompileTime;
  const std::vector<double> values = components(index, size, field);
  std::vector<Vector> result(values.size() / size);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (int c = 0; c < size; ++c)
      result[i][c] = static_cast<typename Vector::Scalar>(values[size * i + static_cast<std::size_t>(c)]);
    if (!result[i].allFinite())
      throw input_error({.file = file_,
                         .field = field,
                         .wanted = "finite numbers",
                         .found = fmt::format("none at element {}", i)});
  }
  return result;
}

std::vector<double> GltfReader::numbers(int index, int wanted_components, const std::string& field) const {
  std::vector<double> values = components(index, wanted_components, field);
  const auto wrong =
      std::find_if(values.begin(), values.end(), [](double one) { return !std::isfinite(one); });
  if (wrong != values.end())
    throw input_error({.file = file_,
                       .field = field,
                       .wanted = "finite numbers",
                       .found = fmt::format("none at number {}", wrong - values.begin())});
  return values;
}

std::vector<Eigen::Vector3d> GltfReader::vectors(int index, const std::string& field) const {
  return finite_vectors<Eigen::Vector3d>(index, field);
}

std::vector<Eigen::Vector2f> GltfReader::texture_coordinates(int index, const std::string& field) const {
  return finite_vectors<Eigen::Vector2f>(index, field);
}

std::vector<Eigen::Vector4f> GltfReader::tangents(int index, const std::string& field) const {
  return finite_vectors<Eigen::Vector4f>(index, field);
}

std::vector<Eigen::Vector4d> GltfReader::quadruples(int index, const std::string& field) const {
  return finite_vectors<Eigen::Vector4d>(index, field);
}

std::vector<Eigen::Array4f> GltfReader::colours(int index, const std::string& field) const {
  const bool exists = index >= 0 && static_cast<std::size_t>(index) < model_.accessors.size();
  const bool has_alpha = !exists || model_.accessors[index].type != TINYGLTF_TYPE_VEC3;
  std::vector<Eigen::Array4f> out;
  if (has_alpha) {
    for (const Eigen::Vector4d& colour : finite_vectors<Eigen::Vector4d>(index, field))
      out.emplace_back(colour.cast<float>().array());
  } else {
    for (const Eigen::Vector3d& colour : finite_vectors<Eigen::Vector3d>(index, field))
      out.emplace_back(colour.homogeneous().cast<float>().array());
  }
  // Some writers forget to say that their bytes are shares.
  const tinygltf::Accessor& accessor = model_.accessors[index];
  const bool are_bytes = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
             are_words = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  const float scale = accessor.normalized ? 1.0F : are_bytes ? 1.0F / 255 : are_words ? 1.0F / 65535 : 1.0F;
  for (Eigen::Array4f& colour : out) {
    colour.head<3>() *= scale;
    if (has_alpha) colour[3] *= scale;
    colour = colour.max(0.0F).min(1.0F);
  }
  return out;
}

std::vector<Eigen::Affine3d> GltfReader::transforms(int index, const std::string& field) const {
  using Numbers = Eigen::Matrix<double, 16, 1>;
  std::vector<Eigen::Affine3d> out;
  for (const Numbers& numbers : finite_vectors<Numbers>(index, field)) {
    Eigen::Affine3d& transform = out.emplace_back();
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
    transform.makeAffine();
  }
  return out;
}

std::vector<std::uint32_t> GltfReader::indices(int index, const std::string& field) const {
  const std::vector<double> values = components(index, 1, field);
  std::vector<std::uint32_t> result;
  result.reserve(values.size());
  for (const double value : values) {
    if (!(value >= 0 && value <= 4294967295.0 && value == std::floor(value)))
      throw input_error(
          {.file = file_, .field = field, .wanted = "whole numbers", .found = std::to_string(value)});
    result.push_back(static_cast<std::uint32_t>(value));
  }
  return result;
}

}  // namespace seamline::renderer
