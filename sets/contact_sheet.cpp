#include "sets/contact_sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "stimuli/set/manifest_pictures.h"
#include "support/arithmetic/grid_index.h"
#include "support/files/image.h"

namespace seamline::renderer {
namespace {

constexpr int cell_width_px = 240, cell_height_px = 200, gap_px = 6, label_px = 26;

/// A rectangle of pixels, ends excluded.
struct PixelBox {
  int left = 1 << 30, top = 1 << 30, right = 0, bottom = 0;
  [[nodiscard]] bool empty() const { return right <= left; }
  void include(int x, int y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x + 1);
    bottom = std::max(bottom, y + 1);
  }
};

int difference_at(const ByteImage& a, const ByteImage& b, int x, int y) {
  int largest = 0;
  for (int c = 0; c < 3; ++c) {
    const std::size_t i = grid_index(y, x, a.width_px) * 3 + c;
    largest = std::max(largest, std::abs(int{a.values[i]} - int{b.values[i]}));
  }
  return largest;
}

/// The window moved so that the difference inside it lies in its middle, as far as the picture goes.
PixelBox centred(const PixelBox& window, const ByteImage& stimulus, const ByteImage& reference) {
  double weight = 0, sum_x = 0, sum_y = 0;
  for (int y = window.top; y < window.bottom; ++y)
    for (int x = window.left; x < window.right; ++x) {
      const int difference = difference_at(stimulus, reference, x, y);
      if (difference <= 12) continue;
      weight += difference;
      sum_x += difference * x;
      sum_y += difference * y;
    }
  if (!(weight > 0)) return window;
  const int width = window.right - window.left, height = window.bottom - window.top;
  const int left = std::clamp(static_cast<int>(sum_x / weight) - width / 2, 0, stimulus.width_px - width);
  const int top = std::clamp(static_cast<int>(sum_y / weight) - height / 2, 0, stimulus.height_px - height);
  return {left, top, left + width, top + height};
}

/// Where a stimulus differs most from its reference: the densest window of the cell's shape, widened by half.
PixelBox artifact_window(const ByteImage& stimulus, const ByteImage& reference) {
  const int width = stimulus.width_px, height = stimulus.height_px;
  const int window_width = std::max(8, width / 3),
            window_height = std::min(height, window_width * cell_height_px / cell_width_px);
  const std::size_t stride = width + 1;
  std::vector<double> integral(stride * (height + 1), 0.0);
  for (int y = 0; y < height; ++y) {
    double row = 0;
    for (int x = 0; x < width; ++x) {
      const int difference = difference_at(stimulus, reference, x, y);
      row += difference > 12 ? difference : 0;
      const std::size_t i = (y + 1) * stride + x + 1;
      integral[i] = integral[i - stride] + row;
    }
  }
  const auto sum_to = [&](int x, int y) { return integral[y * stride + x]; };
  PixelBox best{0, 0, window_width, window_height};
  double most = -1;
  for (int y = 0; y + window_height <= height; y += 2)
    for (int x = 0; x + window_width <= width; x += 2) {
      const double sum = sum_to(x + window_width, y + window_height) - sum_to(x, y + window_height) -
                         sum_to(x + window_width, y) + sum_to(x, y);
      if (sum > most) {
        most = sum;
        best = {x, y, x + window_width, y + window_height};
      }
    }
  return centred(best, stimulus, reference);
}

/// Copies a window into a cell of the sheet, each cell pixel the mean of what it covers.
void place(const ByteImage& from, const PixelBox& window, ByteImage& sheet, int left, int top) {
  const double step_x = static_cast<double>(window.right - window.left) / cell_width_px;
  const double step_y = static_cast<double>(window.bottom - window.top) / cell_height_px;
  for (int y = 0; y < cell_height_px; ++y)
    for (int x = 0; x < cell_width_px; ++x)
      for (int c = 0; c < 3; ++c) {
        const int x0 = window.left + static_cast<int>(x * step_x),
                  y0 = window.top + static_cast<int>(y * step_y);
        const int x1 = std::max(x0 + 1, window.left + static_cast<int>((x + 1) * step_x));
        const int y1 = std::max(y0 + 1, window.top + static_cast<int>((y + 1) * step_y));
        int sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u) sum += from.values[grid_index(v, u, from.width_px) * 3 + c];
        const std::size_t i = grid_index(top + y, left + x, sheet.width_px) * 3 + c;
        sheet.values[i] = static_cast<std::uint8_t>(sum / ((x1 - x0) * (y1 - y0)));
      }
}

/// The stimuli of one object under one condition, by level, the least noticeable first.
struct SheetRow {
  std::string label;  ///< scene, object, and the condition where there are several
  std::map<double, const ManifestStimulus*> by_level;
};

/// By which levels are columns from left to right, beginning with what ought to be noticed least.
double column_order(const Stimulus& stimulus) {
  return facts(stimulus.quantity).noticeability == Direction::increasing ? stimulus.level : -stimulus.level;
}

std::string column_label(const Stimulus& stimulus) {
  if (stimulus.quantity != Quantity::depth_width_px) return level_text(stimulus.quantity, stimulus.level);
  return fmt::format("{} x {}", stimulus.depth.width_px, stimulus.depth.height_px());
}

using SheetRows =
    std::map<std::tuple<std::string, int, std::size_t>, SheetRow>;  // scene, object, condition's place

ByteImage sheet_of(const std::filesystem::path& set_folder, const Manifest& manifest, const SheetRows& rows) {
  std::map<double, std::string> labels;  // by column_order
  for (const auto& [key, row] : rows)
    for (const auto& [order, record] : row.by_level) labels.emplace(order, column_label(record->stimulus));
  const int columns = static_cast<int>(labels.size()) + 1;
  const int row_height = label_px + cell_height_px + gap_px;
  ByteImage sheet{columns * (cell_width_px + gap_px) + gap_px,
                  static_cast<int>(rows.size()) * row_height + label_px + gap_px,
                  3,
                  {}};
  sheet.values.assign(
      static_cast<std::size_t>(sheet.width_px) * static_cast<std::size_t>(sheet.height_px) * 3, paper_code);
  const auto left_of = [&](int column) { return gap_px + column * (cell_width_px + gap_px); };
  int column = 0;
  for (const auto& [order, label] : labels) draw_text(sheet, left_of(column++) + 4, 19, label, 16, ink_code);
  draw_text(sheet, left_of(column) + 4, 19, "reference", 16, ink_code);
  int top = label_px;
  for (const auto& [key, row] : rows) {
    const ManifestStimulus& coarsest = *row.by_level.rbegin()->second;
    draw_text(sheet, left_of(0) + 4, top + 19, row.label, 16, ink_code);
    top += label_px;
    const auto picture_of = [&](const ManifestStimulus& record) {
      return read_manifest_picture(set_folder, stimulus_picture(manifest, record));
    };
    const ByteImage reference = read_manifest_picture(
        set_folder, reference_picture(manifest, reference_of(set_folder, manifest, coarsest.stimulus)));
    const PixelBox window = artifact_window(picture_of(coarsest), reference);
    column = 0;
    for (const auto& [order, label] : labels) {
      if (const auto found = row.by_level.find(order); found != row.by_level.end())
        place(picture_of(*found->second), window, sheet, left_of(column), top);
      ++column;
    }
    place(reference, window, sheet, left_of(column), top);
    top += cell_height_px + gap_px;
  }
  return sheet;
}

}  // namespace

void write_contact_sheets(const std::filesystem::path& set_folder) {
  const Manifest manifest = read_manifest(set_folder);
  std::vector<std::string> conditions;  // in the study's order
  for (const Artifact artifact : every_artifact) {
    SheetRows rows;
    for (const ManifestStimulus& record : manifest.stimuli) {
      const Stimulus& stimulus = record.stimulus;
      if (stimulus.artifact != artifact) continue;
      const auto place = static_cast<std::size_t>(
          std::find(conditions.begin(), conditions.end(), stimulus.condition) - conditions.begin());
      if (place == conditions.size()) conditions.push_back(stimulus.condition);
      SheetRow& row = rows[{stimulus.scene, stimulus.object_index, place}];
      row.label = stimulus.scene + ": " + stimulus.object +
                  (stimulus.condition.empty() ? "" : ", " + stimulus.condition);
      row.by_level[column_order(stimulus)] = &record;
    }
    if (!rows.empty())
      write_png(set_folder / ("contact-" + std::string(word(artifact)) + ".png"),
                sheet_of(set_folder, manifest, rows));
  }
}

}  // namespace seamline::renderer
