#include "tiny_study.h"

#include <fmt/core.h>

#include <array>
#include <cstring>
#include <fstream>
#include <vector>

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

using Corner = std::array<float, 3>;

/// A closed box as binary glTF buffer: 8 positions, 36 indices.
std::string box_bytes(const Corner& low, const Corner& high) {
  std::string bytes;
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 0; axis < 3; ++axis) put((i >> axis & 1U) != 0 ? high[axis] : low[axis]);
  for (const int index : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                          2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5})
    put(static_cast<std::uint16_t>(index));
  return bytes;
}

/// One glTF file of boxes, with its buffer beside it.
void write_boxes(const fs::path& folder, const std::string& name,
                 const std::vector<std::pair<Corner, Corner>>& boxes) {
  std::string bytes, views, accessors, meshes, nodes, roots;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::size_t begin = bytes.size();
    bytes += box_bytes(boxes[i].first, boxes[i].second);
    const char* comma = i == 0 ? "" : ",";
    views += fmt::format(
        R"({}{{"buffer":0,"byteOffset":{},"byteLength":96}},{{"buffer":0,"byteOffset":{},"byteLength":72}})",
        comma, begin, begin + 96);
    accessors += fmt::format(
        R"({}{{"bufferView":{},"componentType":5126,"type":"VEC3","count":8}},{{"bufferView":{},"componentType":5123,"type":"SCALAR","count":36}})",
        comma, 2 * i, 2 * i + 1);
    meshes += fmt::format(R"({}{{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}}}]}})", comma,
                          2 * i, 2 * i + 1);
    nodes += fmt::format(R"({}{{"mesh":{}}})", comma, i);
    roots += fmt::format("{}{}", comma, i);
  }
  std::ofstream(folder / (name + ".bin"), std::ios::binary) << bytes;
  std::ofstream(folder / (name + ".gltf"), std::ios::binary) << fmt::format(
      R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"{}.bin"}}],"bufferViews":[{}],"accessors":[{}],"meshes":[{}],"nodes":[{}],"scenes":[{{"nodes":[{}]}}]}})",
      bytes.size(), name, views, accessors, meshes, nodes, roots);
}

}  // namespace

fs::path write_tiny_study(const fs::path& folder, int widths, const std::string& artifacts) {
  fs::create_directories(folder);
  write_boxes(folder, "room",
              {{{-4, -0.1F, -8}, {4, 0, 4}}, {{-4, 0, -8}, {4, 3, -7.9F}}, {{-2, 0, -5}, {-1.8F, 2, -4.8F}}});
  write_boxes(folder, "box", {{{-0.3F, 0, -0.3F}, {0.3F, 0.8F, 0.3F}}});
  std::string text =
      "format = \"seamline study 1\"\nname = \"tiny\"\nwidth_px = 64\nheight_px = 36\nsamples_per_pixel = 2\n"
      "depth_width_px = [";
  for (int i = 0; i < widths; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", widths <= 8 ? 8 << i : 8 + 2 * i);
  text +=
      "]\n[[scene]]\nname = \"room\"\nfile = \"room.gltf\"\nbounces = 1\n"
      "artifacts = [" +
      artifacts +
      "]\n"
      "[scene.sun]\nto_sun = [0.4, 1, 0.6]\nirradiance_w_m2 = [3, 3, 3]\n"
      "[scene.camera]\nposition_m = [0, 1.2, 1]\nlook_at_m = [0, 0.8, -4]\nhorizontal_fov_deg = 70\n";
  for (int i = 0; i < 3; ++i)
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"box.gltf\"\nposition_m = [{}, 0, -4]\n",
                        std::array{"left", "middle", "right"}[static_cast<std::size_t>(i)], 1.3 * (i - 1));
  const fs::path study = folder / "tiny.toml";
  std::ofstream(study, std::ios::binary) << text;
  return study;
}

}  // namespace seamline::faults
