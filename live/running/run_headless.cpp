#include "live/running/run_headless.h"

#include <fmt/core.h>

#include <ctime>

#include "live/running/live_session.h"
#include "live/running/times_table.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"

namespace seamline::live {
namespace {

void write_pictures(const std::filesystem::path& folder, int number, const LiveFrame& frame) {
  for (std::size_t i = 0; i < frame.eyes.size(); ++i)
    write_png(folder / (frame.eyes.size() == 1 ? fmt::format("{:06}.png", number)
                                               : fmt::format("{:06}_{}.png", number, i)),
              frame.eyes[i].codes);
}

}  // namespace

void run_headless(const LiveRequest& request) {
  if (!request.out.empty()) prepare_output_folder(request.out);
  LiveSession session(request);
  const LoadedRecording& recording = session.recording();
  const int frames = request.frames > 0 ? request.frames : static_cast<int>(recording.frames.size());
  std::vector<TimedFrame> timed;
  std::size_t triangles = 0;
  double processor_s = 0;
  int lost = 0;
  Progress progress("live", frames);
  for (int i = 0; i < frames; ++i) {
    stop_if_interrupted();
    const std::clock_t begun = std::clock();
    const LiveSession::Step step = session.next(request.methods);
    processor_s += static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    timed.push_back({.frame_index = step.frame_index,
                     .time_s = recording.frames[step.frame_index].time_s,
                     .methods = request.methods,
                     .times = step.frame.times,
                     .is_tracked = step.pose.is_found});
    triangles = step.frame.triangles;
    lost += step.pose.is_found ? 0 : 1;
    if (!request.out.empty()) write_pictures(request.out, i, step.frame);
    progress.advance(1, "");
  }
  if (!request.csv.empty()) write_file_atomically(request.csv, csv_text(times_table(timed)));
  fmt::print("{} x {}, {} view{}, local scene of {} triangles, virtual things of {}; {}, {}, {}\n{}",
             recording.view.width_px, recording.view.height_px, request.settings.views,
             request.settings.views == 1 ? "" : "s", triangles, session.virtual_triangles(),
             word(request.methods.mapping), word(request.methods.occlusion), word(request.methods.shadows),
             times_text(timed));
  fmt::print("  processor time of a frame, all cores together: {:.2f} ms (mean)\n",
             1000 * processor_s / frames);
  if (lost > 0) fmt::print("  the camera was not found in {} of {} frames\n", lost, frames);
}

}  // namespace seamline::live
