#include "stimuli/set/clip_video.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "stimuli/set/clip_file.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

/// ITU-R BT.709, item 3: luminance of R'G'B', and what scales the differences to it into -0.5..0.5.
constexpr double red_share = 0.2126, blue_share = 0.0722;

char code_of(double value) {
  const double code = std::round(std::min(255.0, std::max(0.0, value)));
  return static_cast<char>(static_cast<std::uint8_t>(code));
}

/// One plane after the other.
void append_planes(const ByteImage& frame, std::string& video) {
  const std::size_t pixels = frame.values.size() / 3;
  std::array<std::string, 3> planes;
  for (std::size_t i = 0; i < pixels; ++i) {
    const double red = frame.values[3 * i], green = frame.values[3 * i + 1], blue = frame.values[3 * i + 2];
    const double luma = red_share * red + (1 - red_share - blue_share) * green + blue_share * blue;
    planes[0] += code_of(luma);
    planes[1] += code_of(128 + (blue - luma) / (2 * (1 - blue_share)));
    planes[2] += code_of(128 + (red - luma) / (2 * (1 - red_share)));
  }
  for (const std::string& plane : planes) video += plane;
}

/// Frames a second as a ratio of whole numbers.
std::string rate_text(double frames_per_s) {
  return frames_per_s == std::round(frames_per_s) ? fmt::format("{:.0f}:1", frames_per_s)
                                                  : fmt::format("{:.0f}:1000", 1000 * frames_per_s);
}

void write_video(const std::filesystem::path& clip, const std::filesystem::path& out) {
  ClipReader reader(clip);
  std::string video =
      fmt::format("YUV4MPEG2 W{} H{} F{} Ip A1:1 C444 XCOLORRANGE=FULL\n", reader.shape().width_px,
                  reader.shape().height_px, rate_text(reader.shape().frames_per_s));
  for (int frame = 0; frame < reader.frames(); ++frame) {
    video += "FRAME\n";
    append_planes(reader.decode(), video);
  }
  write_file_atomically(out, video);
}

}  // namespace

int write_videos(const std::filesystem::path& set_folder, const std::filesystem::path& out_folder) {
  const std::optional<ClipSet> clips = read_clip_set(set_folder);
  if (!clips)
    throw input_error({.file = set_folder.string(), .wanted = "a set of clips", .found = "a set of stills"});
  prepare_output_folder(out_folder);
  int written = 0;
  for (const auto* records : {&clips->stimuli, &clips->references})
    for (const ClipRecord& one : *records) {
      stop_if_interrupted();
      const std::string name = std::filesystem::path(one.file).stem().string();
      write_video(path_in_set(set_folder, one.file), out_folder / (name + ".y4m"));
      ++written;
    }
  return written;
}

}  // namespace seamline::inline stimuli
