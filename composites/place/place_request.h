#pragma once
#include <functional>
#include <string>
#include <vector>

#include "composites/composite_request.h"

namespace seamline::renderer {

/// What `seamline place` works on.
struct PlaceRequest {
  CompositeRequest photo;  ///< photograph, depth and light; its objects and outputs say nothing
  std::string objects_file, asset_root;
  std::string command;             ///< of `composite`, with the options that both share
  std::vector<std::string> added;  ///< objects beside those of the file: files or "builtin:NAME"
  /// Hears each sentence about what the window shows and saves, and each note on the photograph's files.
  std::function<void(const std::string&)> said = [](const std::string&) {}, note = said;
};

/// Shows the window; null in builds without one.
using PlaceInWindow = void (*)(const PlaceRequest& request);

}  // namespace seamline::renderer
