#include "stimuli/set/clip_file.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "stimuli/set/json_fields.h"
#include "support/codec/deflate.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/text_bounds.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::string_view clip_magic = "seamline clip 1\n";
constexpr std::size_t most_deflated = 1032;  ///< bytes that zlib packs into one
constexpr int most_clip_px = 16384, most_clip_frames = 999;

std::size_t pixels_size(const ClipShape& shape) {
  return static_cast<std::size_t>(shape.width_px) * static_cast<std::size_t>(shape.height_px) *
         static_cast<std::size_t>(shape.channels);
}

std::string_view as_text(const std::vector<std::uint8_t>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size()};
}

InputError no_clip(const std::filesystem::path& path, const std::string& found) {
  return input_error(
      {.file = path.string(), .wanted = "a clip as `seamline render` writes it", .found = found});
}

ClipShape read_shape(const SetFields& header) {
  ClipShape shape{.width_px = header.number("width_px", 1, most_clip_px),
                  .height_px = header.number("height_px", 1, most_clip_px),
                  .channels = header.number("channels", 1, 3),
                  .frames_per_s = header.real("frames_per_s", 1, 240)};
  if (shape.channels == 2) throw header.complaint("channels", "1 or 3", "2");
  return shape;
}

}  // namespace

void ClipWriter::add(const ByteImage& frame) {
  std::vector<std::uint8_t> change = frame.values;
  for (std::size_t i = 0; i < last_.size(); ++i) change[i] = static_cast<std::uint8_t>(change[i] - last_[i]);
  frames_.push_back({deflated(as_text(change)), sha256(as_text(frame.values))});
  last_ = frame.values;
}

std::string ClipWriter::bytes() const {
  Json header = {{"width_px", shape_.width_px},
                 {"height_px", shape_.height_px},
                 {"channels", shape_.channels},
                 {"frames_per_s", shape_.frames_per_s},
                 {"frames", Json::array()}};
  for (const Frame& frame : frames_)
    header["frames"].push_back({{"bytes", frame.stream.size()}, {"sha256", frame.sha256}});
  std::string out = std::string(clip_magic) + header.dump() + "\n";
  for (const Frame& frame : frames_) out += frame.stream;
  return out;
}

ClipReader::ClipReader(const std::filesystem::path& path)
    : path_(path), bytes_(read_file(path, largest_clip_bytes)) {
  const std::size_t end = bytes_.find('\n', clip_magic.size());
  if (!bytes_.starts_with(clip_magic) || end == std::string::npos) throw no_clip(path, "another file");
  const std::string text = bytes_.substr(clip_magic.size(), end - clip_magic.size());
  require_bounded_json(text, path.string());
  const Json json = Json::parse(text, nullptr, false);
  const SetFields header(json, path.string(), "");
  shape_ = read_shape(header);
  std::size_t begin = end + 1;
  for (const Json& item : header.array("frames")) {
    const SetFields frame(item, path.string(), "frames[" + std::to_string(frames_.size()) + "].");
    const auto size = static_cast<std::size_t>(std::max<std::int64_t>(0, frame.get<std::int64_t>("bytes")));
    if (size > bytes_.size() - begin) throw no_clip(path, "one that ends too early");
    frames_.push_back({begin, size, frame.get<std::string>("sha256")});
    begin += size;
  }
  if (frames_.empty() || frames_.size() > most_clip_frames || begin != bytes_.size())
    throw no_clip(path, "one whose frames do not fill it");
  if (pixels_size(shape_) / most_deflated > frames_.front().bytes)
    throw no_clip(path, "one whose first frame is too short for its pixels");
  frame_ = {shape_.width_px, shape_.height_px, shape_.channels,
            std::vector<std::uint8_t>(pixels_size(shape_))};
}

const ByteImage& ClipReader::decode() {
  if (next_ == 0) std::fill(frame_.values.begin(), frame_.values.end(), std::uint8_t{0});
  const Frame& frame = frames_[next_];
  const std::optional<std::string> change =
      inflated(std::string_view(bytes_).substr(frame.begin, frame.bytes), frame_.values.size());
  if (!change) throw no_clip(path_, "one whose frame " + std::to_string(next_) + " is damaged");
  for (std::size_t i = 0; i < frame_.values.size(); ++i)
    frame_.values[i] = static_cast<std::uint8_t>(frame_.values[i] + static_cast<std::uint8_t>((*change)[i]));
  if (sha256(as_text(frame_.values)) != frame.sha256)
    throw no_clip(path_, "one whose frame " + std::to_string(next_) + " has other pixels");
  next_ = (next_ + 1) % frames();
  return frame_;
}

}  // namespace seamline::inline stimuli
