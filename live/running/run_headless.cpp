#include "live/running/run_headless.h"

#include <fmt/core.h>

#include <ctime>

#include "live/running/live_session.h"
#include "live/running/poses_table.h"
#include "live/running/times_table.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"
#include "support/text/printable.h"

namespace seamline::live {
namespace {

void write_pictures(const std::filesystem::path& folder, int number, const LiveFrame& frame) {
  for (std::size_t i = 0; i < frame.eyes.size(); ++i)
    write_png(folder / (frame.eyes.size() == 1 ? fmt::format("{:06}.png", number)
                                               : fmt::format("{:06}_{}.png", number, i)),
              frame.eyes[i].codes);
}

std::string bodies_text(const FallingBodies& bodies) {
  std::string text;
  for (std::size_t i = 0; i < bodies.poses().size(); ++i) {
    const BodyPose& pose = bodies.poses()[i];
    const Eigen::Vector3d at_m = pose.world_from_body.translation();
    text +=
        fmt::format("  {} after {:.2f} s of falling: at {:.4f} {:.4f} {:.4f}, {}\n",
                    printable(bodies.bodies()[i].name), bodies.simulated_s(), at_m.x(), at_m.y(), at_m.z(),
                    pose.is_held ? "held, because no surface is seen below it"
                                 : fmt::format("at {:.3g} m/s", pose.speed_m_s));
  }
  return text;
}

}  // namespace

std::string run_headless(const LiveRequest& request) {
  LiveSession session(request);
  if (!request.out.empty()) prepare_output_folder(request.out);
  const LoadedRecording& recording = session.recording();
  const int frames = request.frames > 0 ? request.frames : static_cast<int>(recording.frames.size());
  std::vector<TimedFrame> timed;
  PosesTable poses;
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
    if (session.bodies() != nullptr)
      poses.add(step.frame_index, recording.frames[step.frame_index].time_s, *session.bodies());
    triangles = step.frame.triangles;
    lost += step.pose.is_found ? 0 : 1;
    if (!request.out.empty()) write_pictures(request.out, i, step.frame);
    progress.advance(1, "");
  }
  write_tables(request, timed, poses);
  std::string text =
      fmt::format("{} x {}, {} view{}, local scene of {} triangles, virtual things of {}; {}, {}, {}\n{}",
                  recording.view.width_px, recording.view.height_px, request.settings.views,
                  request.settings.views == 1 ? "" : "s", triangles, session.virtual_triangles(),
                  word(request.methods.mapping), word(request.methods.occlusion),
                  word(request.methods.shadows), times_text(timed));
  text += fmt::format("  processor time of a frame, all cores together: {:.2f} ms (mean)\n",
                      1000 * processor_s / frames);
  if (session.bodies() != nullptr) text += bodies_text(*session.bodies());
  if (lost > 0) text += fmt::format("  the camera was not found in {} of {} frames\n", lost, frames);
  return text;
}

}  // namespace seamline::live
