#include "sensors/files/depth_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/arithmetic/grid_index.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;

struct StatedDepth : DepthFileForm, DepthMeaning {};

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

/// What a metre is called where it was stated.
std::string name_of_scale(const StatedDepth& form) {
  return form.of_request ? request_name("metres_per_step") : "metres_per_step";
}

void require_scale(const fs::path& path, const StatedDepth& form, bool whole) {
  if (whole && !form.metres_per_step && !form.estimate)
    throw complaint(path, name_of_scale(form),
                    "how many metres a step of its whole numbers is (0.001: millimetres)", "nothing");
}

void require_form(const fs::path& path, const StatedDepth& form) {
  require_valid(form.camera, path.string() + ": camera.");
  if (form.metres_per_step && !(*form.metres_per_step > 0 && std::isfinite(*form.metres_per_step)))
    throw complaint(path, name_of_scale(form), "a number above 0",
                    fmt::format("{:g}", *form.metres_per_step));
}

/// Floats that were brought into 0 to 1 are no metres.
void require_metres(const RawDepth& raw, const fs::path& path, const StatedDepth& form) {
  if (raw.whole || form.metres_per_step || form.estimate) return;
  bool has_zero = false, has_one = false;
  for (const float value : raw.values) {
    if (value < 0.0F || value > 1.0F) return;
    has_zero = has_zero || value == 0.0F;
    has_one = has_one || value == 1.0F;
  }
  if (has_zero && has_one)
    throw complaint(path, request_name("depth_value"),
                    "distances in metres, or what an estimate's values are (inverse or relative, with scale "
                    "and shift; " +
                        request_name("metres_per_step") + " 1 if these are metres)",
                    "values that fill 0 to 1, as of an estimate");
}

double median_m(const DepthFrame& frame) {
  std::vector<float> depths_m;
  std::copy_if(frame.depth_m.begin(), frame.depth_m.end(), std::back_inserter(depths_m),
               [](float depth_m) { return !DepthFrame::is_hole(depth_m); });
  const auto middle = depths_m.begin() + static_cast<std::ptrdiff_t>(depths_m.size() / 2);
  std::nth_element(depths_m.begin(), middle, depths_m.end());
  return *middle;
}

/// The power of a thousand that brings a median among usual distances: what was probably meant.
void require_usual(const fs::path& path, const StatedDepth& form, double median) {
  if (form.unusual_distances || (median >= nearest_usual_m && median <= farthest_usual_m)) return;
  if (form.estimate)
    throw complaint(path, request_name("depth_scale"),
                    fmt::format("a median depth from {:g} to {:g} m", nearest_usual_m, farthest_usual_m),
                    fmt::format("{:g} m by the scale and shift of the estimate", median));
  const double scale = form.metres_per_step.value_or(1);
  std::string advice;
  for (const double factor : {1e-3, 1e3, 1e-6, 1e6})
    if (median * factor >= nearest_usual_m && median * factor <= farthest_usual_m && advice.empty())
      advice = fmt::format("give {:g} metres a step if it is {:g} m, or ", scale * factor, median * factor);
  throw complaint(
      path, name_of_scale(form),
      fmt::format("a median depth from {:g} to {:g} m", nearest_usual_m, farthest_usual_m),
      fmt::format("{:g} m with {:g} metres a step: {}set unusual_distances{} if that is meant", median, scale,
                  advice, form.of_request ? " in the file of " + request_name("camera") : ""));
}

bool stands_for_nothing(const StatedDepth& form, float value) {
  return std::any_of(form.nothing.begin(), form.nothing.end(),
                     [value](double code) { return static_cast<float>(code) == value; });
}

/// Values whose distance is known by a map that was measured.
std::vector<KnownValue> known_by_reference(const RawDepth& raw, const StatedDepth& form) {
  const DepthEstimate& estimate = *form.estimate;
  const RawDepth measured = read_raw_depth(estimate.reference, {});
  if (std::int64_t{measured.width_px} * raw.height_px != std::int64_t{measured.height_px} * raw.width_px)
    throw complaint(estimate.reference, request_name("depth_reference"), "a map of the estimate's shape",
                    fmt::format("{} x {} beside {} x {}", measured.width_px, measured.height_px, raw.width_px,
                                raw.height_px));
  StatedDepth own;
  own.camera = pinhole_of_field_of_view(measured.width_px, measured.height_px, 90);
  own.metres_per_step = estimate.reference_metres_per_step;
  if (measured.whole && measured.bits == 16) own.nothing.push_back(65535);
  own.unusual_distances = true;
  own.of_request = form.of_request;
  const DepthFrame reference = depth_of_values(measured, estimate.reference, own, own).file.frame;
  std::vector<KnownValue> known;
  for (int row = 0; row < measured.height_px; ++row)
    for (int column = 0; column < measured.width_px; ++column) {
      const float depth_m = reference.at(column, row);
      const auto x = static_cast<std::size_t>((2 * std::int64_t{column} + 1) * raw.width_px /
                                              (std::int64_t{2} * measured.width_px));
      const auto y = static_cast<std::size_t>((2 * std::int64_t{row} + 1) * raw.height_px /
                                              (std::int64_t{2} * measured.height_px));
      const float value = raw.values[y * static_cast<std::size_t>(raw.width_px) + x];
      if (DepthFrame::is_hole(depth_m) || !std::isfinite(value) || stands_for_nothing(form, value)) continue;
      known.push_back({static_cast<double>(value), static_cast<double>(depth_m)});
    }
  return known;
}

std::vector<KnownValue> known_by_points(const RawDepth& raw, const fs::path& path, const StatedDepth& form) {
  std::vector<KnownValue> known;
  for (const KnownPoint& point : form.estimate->points) {
    const auto found = [&](const std::string& what) {
      return complaint(path, request_name("depth_point"), "a place of the picture that has a value",
                       fmt::format("{:g},{:g}, {}", point.x_px, point.y_px, what));
    };
    if (!(point.x_px >= 0 && point.x_px < raw.width_px && point.y_px >= 0 && point.y_px < raw.height_px))
      throw found("which is outside");
    const float value =
        raw.values[grid_index(static_cast<int>(point.y_px), static_cast<int>(point.x_px), raw.width_px)];
    if (!std::isfinite(value) || stands_for_nothing(form, value)) throw found("where the map has none");
    known.push_back({static_cast<double>(value), point.depth_m});
  }
  return known;
}

DepthLine line_of(const RawDepth& raw, const fs::path& path, const StatedDepth& form, DepthFromValues& read) {
  const DepthEstimate& estimate = *form.estimate;
  if (estimate.stated) return *estimate.stated;
  if (!estimate.reference.empty()) {
    const DepthFit fit =
        fit_depth(estimate.value, known_by_reference(raw, form), request_name("depth_reference"));
    read.notes.push_back(fit_text(
        estimate.value, fit,
        fmt::format("least squares on {} pixels of {}", fit.used, printable(estimate.reference.string()))));
    return fit.line;
  }
  if (estimate.points.empty())
    throw complaint(path, request_name("depth_value"),
                    "an estimate's scale: " + request_name("depth_scale") + " and " +
                        request_name("depth_shift") +
                        ", points whose distance is known "
                        "(" +
                        request_name("depth_point") + " X,Y,METRES, two or more), or a measured map (" +
                        request_name("depth_reference") + ")",
                    "none, without which it is no distance");
  const DepthFit fit =
      fit_depth(estimate.value, known_by_points(raw, path, form), request_name("depth_point"));
  read.notes.push_back(fit_text(estimate.value, fit,
                                fit.used == 1 ? std::string("from one point, with a shift of 0")
                                              : fmt::format("from {} points", fit.used)));
  return fit.line;
}

/// Metres of a value; +infinity with its reason counted.
float metres_or_hole(float value, const StatedDepth& form, const DepthLine& line, DepthHoles& why) {
  if (std::isnan(value)) return ++why.no_number, hole;
  if (stands_for_nothing(form, value)) return ++why.coded, hole;
  if (form.estimate) {
    const double depth_m = metres_of_value(form.estimate->value, line, value);
    if (!(depth_m <= 1e9)) return ++why.beyond_line, hole;
    return static_cast<float>(depth_m);
  }
  if (value == 0.0F) return ++why.zero, hole;
  if (value < 0.0F) return ++why.negative, hole;
  if (std::isinf(value)) return ++why.infinite, hole;
  return static_cast<float>(value * form.metres_per_step.value_or(1));
}

void note_holes(const RawDepth& raw, const StatedDepth& form, DepthFromValues& read) {
  std::string text;
  std::int64_t told = 0;
  const auto add = [&](std::int64_t count, const std::string& what) {
    if (count == 0) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    told += count;
  };
  const DepthHoles& why = read.why;
  std::string codes;
  for (const double code : form.nothing) codes += fmt::format("{}{:g}", codes.empty() ? "" : " or ", code);
  add(why.coded, fmt::format("of {}{}", codes, form.estimate ? "" : ", taken for nothing"));
  add(why.zero, "of 0");
  add(why.negative, "negative");
  add(why.no_number, "no number");
  add(why.beyond_file, "outside of its data window");
  add(why.beyond_line, "beyond what the line gives a distance");
  add(why.out_of_range, "out of range");
  if (told == 0) return;
  add(why.infinite, "infinite");
  read.notes.push_back(
      fmt::format("{} of {} pixels have no depth: {}", read.file.holes, std::ssize(raw.values), text));
}

/// A whole range from 0 to the largest value looks like one that was stretched.
void note_stretched(const RawDepth& raw, const StatedDepth& form, DepthFromValues& read) {
  if (!raw.whole || raw.bits != 16 || form.estimate || read.why.coded == 0 || read.why.zero == 0) return;
  constexpr std::int64_t few = 16;
  if (read.why.coded * few < std::ssize(raw.values))
    read.notes.emplace_back(
        "its values reach from 0 to 65535, as those of an estimate do: then they are no distances "
        "(" +
        request_name("depth_value") + " inverse or relative)");
}

}  // namespace

DepthFromValues depth_of_values(const RawDepth& raw, const fs::path& path, const DepthFileForm& stated,
                                const DepthMeaning& meaning) {
  const StatedDepth form{stated, meaning};
  require_form(path, form);
  require_scale(path, form, raw.whole);
  require_size(path, form.camera, raw.width_px, raw.height_px);
  require_metres(raw, path, form);
  DepthFromValues read;
  read.notes = raw.notes;
  DepthFrame& frame = read.file.frame;
  frame.camera = form.camera;
  frame.convention = form.convention;
  const DepthLine line = form.estimate ? line_of(raw, path, form, read) : DepthLine{};
  frame.depth_m.reserve(raw.values.size());
  for (const float value : raw.values) frame.depth_m.push_back(metres_or_hole(value, form, line, read.why));
  read.why.beyond_file = static_cast<std::int64_t>(raw.beyond);
  read.why.no_number -= read.why.beyond_file;
  // Of all distances first: a range in metres would make holes of millimetres, and hide why.
  read.why.out_of_range += clean_holes(frame);
  const auto count_holes = [&] {
    return std::count_if(frame.depth_m.begin(), frame.depth_m.end(), DepthFrame::is_hole);
  };
  if (count_holes() == std::ssize(frame.depth_m))
    throw complaint(path, "", "a depth map with at least one depth",
                    "nothing but holes (0, negative or no number)");
  require_usual(path, form, median_m(frame));
  read.why.out_of_range += clean_holes(frame, form.nearest_m, form.farthest_m);
  read.file.holes = count_holes();
  if (read.file.holes == std::ssize(frame.depth_m))
    throw complaint(path, "", fmt::format("a depth from {:g} to {:g} m", form.nearest_m, form.farthest_m),
                    "none");
  note_holes(raw, form, read);
  note_stretched(raw, form, read);
  return read;
}

DepthFile read_depth_file(const fs::path& path, const DepthFileForm& form) {
  const StatedDepth stated{form, {}};
  require_form(path, stated);
  const RawDepth raw = read_raw_depth(path, {.packing = form.packing}, [&](const RawDepth& header) {
    require_scale(path, stated, header.whole);
    require_size(path, form.camera, header.width_px, header.height_px);
  });
  return depth_of_values(raw, path, form, {}).file;
}

}  // namespace seamline::sensors
