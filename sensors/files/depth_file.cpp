#include "sensors/files/depth_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "sensors/files/pgm.h"
#include "support/files/image.h"
#include "support/files/word_image.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;

constexpr double nearest_usual_m = 0.05, farthest_usual_m = 500;

InputError complaint(const fs::path& path, const std::string& field, const std::string& wanted,
                     const std::string& found) {
  return input_error({.file = path.string(), .field = field, .wanted = wanted, .found = found});
}

void require_size(const fs::path& path, const PinholeCamera& camera, int width_px, int height_px) {
  if (width_px == camera.width_px && height_px == camera.height_px) return;
  const bool same_shape =
      std::int64_t{width_px} * camera.height_px == std::int64_t{height_px} * camera.width_px;
  throw complaint(
      path, "size", fmt::format("{} x {} pixels, as its camera is stated", camera.width_px, camera.height_px),
      fmt::format("{} x {}{}", width_px, height_px,
                  same_shape
                      ? fmt::format(": state the camera of that size, its numbers of pixels times {:g}",
                                    static_cast<double>(width_px) / camera.width_px)
                      : std::string(", which is of another shape")));
}

void require_scale(const fs::path& path, const DepthFileForm& form) {
  if (!form.metres_per_step)
    throw complaint(path, "metres_per_step",
                    "how many metres a step of its whole numbers is (0.001: millimetres)", "nothing");
}

template <class Values>
std::vector<float> scaled(const Values& values, double metres_per_step) {
  std::vector<float> depth_m;
  depth_m.reserve(values.size());
  for (const auto value : values)
    depth_m.push_back(static_cast<float>(static_cast<double>(value) * metres_per_step));
  return depth_m;
}

std::vector<float> depths_of_exr(const fs::path& path, const DepthFileForm& form) {
  if (form.packing != DepthPacking::whole)
    throw complaint(path, "packing", "an 8-bit PNG, whose red and green hold the depth", "an EXR file");
  const Image image = read_image(path, [&](const ImageHeader& header) {
    if (header.channels != 1)
      throw complaint(path, "", "an EXR file with one channel, the depth",
                      fmt::format("{} channels", header.channels));
    require_size(path, form.camera, header.width_px, header.height_px);
  });
  return scaled(image.values, form.metres_per_step.value_or(1));
}

std::vector<float> depths_of_pgm(const fs::path& path, const DepthFileForm& form) {
  if (form.packing != DepthPacking::whole)
    throw complaint(path, "packing", "an 8-bit PNG, whose red and green hold the depth", "a PGM file");
  require_scale(path, form);
  const Pgm pgm = read_pgm(path, [&](const Pgm& header) {
    if (header.largest <= 255)
      throw complaint(path, "", "depths of 16 bits",
                      fmt::format("8 bits (its maximum is {})", header.largest));
    require_size(path, form.camera, header.width_px, header.height_px);
  });
  return scaled(pgm.values, *form.metres_per_step);
}

std::vector<float> depths_of_png(const fs::path& path, const DepthFileForm& form) {
  require_scale(path, form);
  const bool packed = form.packing == DepthPacking::red_green;
  const WordImage image = read_word_image(path, [&](const WordImage& header) {
    const std::string found = fmt::format(
        "{} of {} bits", header.channels == 1 ? "one channel" : fmt::format("{} channels", header.channels),
        header.bits);
    if (packed && (header.channels != 3 || header.bits != 8))
      throw complaint(path, "", "an RGB picture of 8 bits, whose red and green hold the depth", found);
    if (!packed && (header.channels != 1 || header.bits != 16))
      throw complaint(path, "", "one channel of 16 bits", found);
    require_size(path, form.camera, header.width_px, header.height_px);
  });
  if (!packed) return scaled(image.values, *form.metres_per_step);
  std::vector<std::uint16_t> steps;
  steps.reserve(image.values.size() / 3);
  for (std::size_t i = 0; i + 2 < image.values.size(); i += 3)
    steps.push_back(static_cast<std::uint16_t>(image.values[i] << 8 | image.values[i + 1]));
  return scaled(steps, *form.metres_per_step);
}

/// The file's kind by its first bytes.
std::vector<float> depths_of(const fs::path& path, const DepthFileForm& form) {
  if (!fs::is_regular_file(path)) throw complaint(path, "", "a depth map", "no such file");
  if (is_pgm(path)) return depths_of_pgm(path, form);
  std::array<char, 4> block{};
  std::ifstream in(path, std::ios::binary);
  in.read(block.data(), block.size());
  const std::string_view start(block.data(), static_cast<std::size_t>(in.gcount()));
  if (start == "\x76\x2f\x31\x01") return depths_of_exr(path, form);
  if (start == "\x89PNG") return depths_of_png(path, form);
  throw complaint(path, "", "an EXR, PNG or PGM (P5) file", "another kind of file");
}

std::int64_t count_holes(const DepthFrame& frame) {
  return std::count_if(frame.depth_m.begin(), frame.depth_m.end(), DepthFrame::is_hole);
}

double median_m(const DepthFrame& frame) {
  std::vector<float> depths_m;
  std::copy_if(frame.depth_m.begin(), frame.depth_m.end(), std::back_inserter(depths_m),
               [](float depth_m) { return !DepthFrame::is_hole(depth_m); });
  const auto middle = depths_m.begin() + static_cast<std::ptrdiff_t>(depths_m.size() / 2);
  std::nth_element(depths_m.begin(), middle, depths_m.end());
  return static_cast<double>(*middle);
}

/// The power of a thousand that brings a median among usual distances: what was probably meant.
void require_usual(const fs::path& path, const DepthFileForm& form, double median) {
  if (form.unusual_distances || (median >= nearest_usual_m && median <= farthest_usual_m)) return;
  const double scale = form.metres_per_step.value_or(1);
  std::string advice;
  for (const double factor : {1e-3, 1e3, 1e-6, 1e6})
    if (median * factor >= nearest_usual_m && median * factor <= farthest_usual_m && advice.empty())
      advice = fmt::format("give {:g} metres a step if it is {:g} m, or ", scale * factor, median * factor);
  throw complaint(path, "metres_per_step",
                  fmt::format("a median depth from {:g} to {:g} m", nearest_usual_m, farthest_usual_m),
                  fmt::format("{:g} m with {:g} metres a step: {}set unusual_distances if that is meant",
                              median, scale, advice));
}

}  // namespace

DepthFile read_depth_file(const fs::path& path, const DepthFileForm& form) {
  require_valid(form.camera, path.string() + ": camera.");
  if (form.metres_per_step && !(*form.metres_per_step > 0 && std::isfinite(*form.metres_per_step)))
    throw complaint(path, "metres_per_step", "a number above 0", fmt::format("{:g}", *form.metres_per_step));
  DepthFile file;
  file.frame.camera = form.camera;
  file.frame.convention = form.convention;
  file.frame.depth_m = depths_of(path, form);
  // Of all distances first: a range in metres would make holes of millimetres, and hide why.
  clean_holes(file.frame);
  if (count_holes(file.frame) == std::ssize(file.frame.depth_m))
    throw complaint(path, "", "a depth map with at least one depth",
                    "nothing but holes (0, negative or no number)");
  require_usual(path, form, median_m(file.frame));
  clean_holes(file.frame, form.nearest_m, form.farthest_m);
  file.holes = count_holes(file.frame);
  if (file.holes == std::ssize(file.frame.depth_m))
    throw complaint(path, "", fmt::format("a depth from {:g} to {:g} m", form.nearest_m, form.farthest_m),
                    "none");
  return file;
}

}  // namespace seamline::sensors
