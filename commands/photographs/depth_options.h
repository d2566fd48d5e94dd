#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "composites/photo_depth.h"

namespace seamline::renderer {

/// What the command line says of a depth file from anywhere: its channel, unit, codes for nothing, and the
/// line of an estimate.
struct DepthOptions {
  std::string unit;
  sensors::DepthValue value = sensors::DepthValue::metres;
  double metres_per_step = 1, scale = 1, shift = 0;
  std::vector<double> nothing, points;
};

void add_depth_file_options(CLI::App& command, DepthOptions& options, PhotoDepthRequest& request);

/// Brings them into the request. Throws InputError at options that make one another void.
void take_depth_options(const DepthOptions& options, const CLI::App& command, PhotoDepthRequest& request);

}  // namespace seamline::renderer
