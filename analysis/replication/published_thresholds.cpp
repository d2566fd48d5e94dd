#include "analysis/replication/published_thresholds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "analysis/joint/joint_quantities.h"
#include "analysis/thresholds/paper_values.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/csv_read.h"

namespace seamline::analysis {
namespace {

constexpr const char* paper_source =
    "Visual Perception of Real World Depth Map Resolution for Mixed Reality Rendering, Table 1";

PublishedThresholds paper_published() {
  PublishedThresholds published{.name = "the paper's Table 1", .sha256 = {}, .values = {}};
  for (const PaperThresholds& column : paper_table_1)
    for (const auto& [quantity, width_px] : {std::pair{"PT", column.perceptual_px},
                                             {"SN", column.slightly_noticeable_px},
                                             {"IP", column.inflection_px}})
      published.values.push_back({.artifact = column.artifact,
                                  .condition = {},
                                  .quantity = quantity,
                                  .level = width_px ? std::optional<double>(*width_px) : std::nullopt,
                                  .low = {},
                                  .high = {},
                                  .participants = {},
                                  .source = paper_source});
  return published;
}

enum PublishedColumn : std::size_t { artifact_place, quantity_place, value_place, first_optional_place };
constexpr std::array optional_columns = {"condition", "low", "high", "n", "source"};

/// The columns that are there: the three that must be, then those of `optional_columns`.
std::vector<std::string> columns_there(const std::string& file, const std::string& text) {
  std::vector<std::string> columns = {"artifact", "quantity", "value"};
  const CsvHeader header = read_csv_header(file, text);
  for (const char* name : optional_columns)
    if (std::find(header.names.begin(), header.names.end(), name) != header.names.end())
      columns.emplace_back(name);
  return columns;
}

std::string quantity_words() {
  std::string words;
  for (const JointQuantity quantity : every_joint_quantity)
    words += (words.empty() ? "" : ", ") + std::string(word(quantity));
  return words;
}

class PublishedReader {
 public:
  PublishedReader(const std::string& file, const std::string& text) : columns_(columns_there(file, text)) {
    read_csv(file, text, columns_, [&](const CsvRow& row) { values.push_back(threshold_of_row(row)); });
  }
  std::vector<PublishedThreshold> values;

 private:
  [[nodiscard]] std::optional<std::size_t> place_of_column(const char* name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns_.begin());
  }
  [[nodiscard]] std::string text_of(const CsvRow& row, const char* name) const {
    const std::optional<std::size_t> place = place_of_column(name);
    return place ? row.values[*place] : std::string();
  }
  [[nodiscard]] std::optional<double> level_in(const CsvRow& row, const char* name) const {
    const std::optional<std::size_t> place = place_of_column(name);
    if (!place || row.values[*place].empty()) return std::nullopt;
    const double level = number_at(row, *place);
    if (!(level > 0)) throw complaint_about(row, *place, "a level above 0, or nothing", row.values[*place]);
    return level;
  }

  PublishedThreshold threshold_of_row(const CsvRow& row) {
    PublishedThreshold out{.artifact = Artifact::none,
                           .condition = text_of(row, "condition"),
                           .quantity = row.values[quantity_place],
                           .level = level_in(row, "value"),
                           .low = level_in(row, "low"),
                           .high = level_in(row, "high"),
                           .participants = {},
                           .source = text_of(row, "source")};
    const std::optional<Artifact> artifact = artifact_from_word(row.values[artifact_place]);
    if (!artifact)
      throw complaint_about(row, artifact_place, "receiver, shadow, occlusion, overlap or another artifact",
                            row.values[artifact_place]);
    out.artifact = *artifact;
    if (std::none_of(every_joint_quantity.begin(), every_joint_quantity.end(),
                     [&](JointQuantity one) { return word(one) == out.quantity; }))
      throw complaint_about(row, quantity_place, "one of " + quantity_words(), out.quantity);
    if (const std::optional<std::size_t> place = place_of_column("n"); place && !row.values[*place].empty())
      out.participants = static_cast<int>(count_at(row, *place, 1000000, "1000000"));
    require_interval(row, out);
    if (!seen_.insert({out.artifact, out.condition, out.quantity}).second)
      throw complaint_about(row, quantity_place, "each threshold once", "it a second time");
    return out;
  }

  void require_interval(const CsvRow& row, const PublishedThreshold& found) const {
    if (!found.low && !found.high) return;
    const std::string interval = fmt::format("{} to {}", text_of(row, "low"), text_of(row, "high"));
    if (!found.low || !found.high || !found.level)
      throw complaint_about(row, *place_of_column(found.low ? "low" : "high"),
                            "value, low and high, or no interval", interval);
    if (*found.low > *found.level || *found.level > *found.high)
      throw complaint_about(row, *place_of_column("low"), "an interval that holds the value", interval);
  }

  std::vector<std::string> columns_;
  std::set<std::tuple<Artifact, std::string, std::string>> seen_;
};

}  // namespace

PublishedThresholds read_published(const std::string& file_or_word) {
  if (file_or_word == published_paper_word) return paper_published();
  const std::string text = read_file(file_or_word);
  PublishedThresholds published{.name = std::filesystem::path(file_or_word).filename().string(),
                                .sha256 = sha256(text),
                                .values = PublishedReader(file_or_word, text).values};
  if (published.values.empty())
    throw input_error(
        {.file = file_or_word, .field = {}, .wanted = "at least one published threshold", .found = "none"});
  return published;
}

}  // namespace seamline::analysis
