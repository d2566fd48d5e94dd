#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "live/frame/methods.h"
#include "live/frame/pipeline.h"
#include "live/tracking/tracker.h"

namespace seamline::live {

/// A virtual thing as the command line names it. Without a place it stands on what the first picture shows
/// nearest to its middle; without a height it is a fifth of that distance high.
struct RequestedObject {
  std::string file;
  std::filesystem::path path;
  std::optional<Eigen::Vector3d> position_m = {};
  std::optional<double> height_m = {};
};

/// What `seamline live` is asked for.
struct LiveRequest {
  std::filesystem::path recording;
  std::vector<RequestedObject> objects;
  std::vector<renderer::PlacedModel> models = {};  ///< of a file of objects
  std::optional<SceneDefinition> light = {};       ///< of that file; none: the recording's
  Methods methods = {};
  Tracking tracking = Tracking::recorded;
  double marker_side_m = 0.16;
  PipelineSettings settings = {};
  LoadOptions load = {};
  bool physics = false;            ///< the objects fall
  double drop_m = 0.3;             ///< from so high above their places
  int frames = 0;                  ///< 0: the recording once (headless), or until the person leaves
  std::filesystem::path out = {};  ///< folder of pictures; empty: none
  std::filesystem::path csv =
      {};  ///< times of each frame, and beside it the poses of what falls; empty: none
};

}  // namespace seamline::live
