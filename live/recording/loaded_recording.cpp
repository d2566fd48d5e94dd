#include "live/recording/loaded_recording.h"

#include <fmt/core.h>

#include <algorithm>

#include "live/recording/view_camera.h"
#include "registration/pictures/photograph.h"
#include "support/files/confined_path.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"
#include "support/text/limits.h"
#include "support/text/request_name.h"

namespace seamline::live {
namespace {

/// sRGB codes; the exposure is for files of linear light, because others hold codes already.
ByteImage read_codes(const std::filesystem::path& path, const sensors::PinholeCamera& camera,
                     double exposure_ev) {
  const Image linear = registration::read_photograph(path, camera);
  const std::string ending = lower_case_ending(path);
  return display_image(linear, ending == ".exr" || ending == ".hdr" ? exposure_ev : 0);
}

std::size_t frames_to_load(const Recording& recording, const LoadedRecording& loaded, int most_frames) {
  const std::size_t wanted = most_frames > 0
                                 ? std::min(static_cast<std::size_t>(most_frames), recording.frames.size())
                                 : recording.frames.size();
  const auto pixels = [](const sensors::PinholeCamera& camera) {
    return static_cast<std::int64_t>(camera.width_px) * camera.height_px;
  };
  const std::int64_t bytes = 4 * pixels(loaded.rig.depth_form.camera) + 3 * pixels(loaded.view);
  const std::int64_t fit = largest_loaded_recording_bytes / std::max<std::int64_t>(bytes, 1);
  if (static_cast<std::int64_t>(wanted) > fit)
    throw input_error({.file = recording.folder.string(),
                       .wanted = fmt::format("at most {} frames of this size in memory", fit),
                       .found = fmt::format("{}; {} N takes the first N", wanted, request_name("frames"))});
  return wanted;
}

}  // namespace

bool LoadedRecording::has_poses() const {
  return std::all_of(frames.begin(), frames.end(),
                     [](const LoadedFrame& frame) { return frame.world_from_colour.has_value(); });
}

double interval_before_s(const LoadedRecording& recording, std::size_t frame_index) {
  constexpr double usual_s = 1.0 / 30, longest_s = 1;
  const std::vector<LoadedFrame>& frames = recording.frames;
  const double whole_s = frames.back().time_s - frames.front().time_s;
  const double mean_s = whole_s > 0 ? whole_s / (frames.size() - 1) : usual_s;
  return std::min(longest_s,
                  frame_index > 0 ? frames[frame_index].time_s - frames[frame_index - 1].time_s : mean_s);
}

LoadedRecording load_recording(const Recording& recording, const LoadOptions& options) {
  LoadedRecording loaded{.rig = recording_rig(recording),
                         .view = {},
                         .up = recording.up,
                         .light = recording.light,
                         .has_light = recording.has_light,
                         .frames = {}};
  loaded.view = view_camera(loaded.rig.colour, options.width_px, options.height_px, request_name("size"));
  const std::size_t count = frames_to_load(recording, loaded, options.most_frames);
  const std::string index = (recording.folder / recording_index).string();
  Progress progress("frames", count);
  for (std::size_t i = 0; i < count; ++i) {
    stop_if_interrupted();
    const RecordedFrame& frame = recording.frames[i];
    const auto file = [&](const char* key, const std::string& name) {
      return path_below(
          recording.folder, name,
          {.file = index, .field = fmt::format("frame[{}].{}", i, key), .wanted = {}, .found = {}});
    };
    const ByteImage codes =
        read_codes(file("colour", frame.colour_file), loaded.rig.colour, recording.light.exposure_ev);
    loaded.frames.push_back(
        {.time_s = frame.time_s,
         .depth = sensors::read_depth_file(file("depth", frame.depth_file), loaded.rig.depth_form).frame,
         .colour = view_picture(codes, loaded.rig.colour, loaded.view, options.threads),
         .world_from_colour = frame.world_from_colour});
    progress.advance(1, frame.colour_file);
  }
  return loaded;
}

}  // namespace seamline::live
