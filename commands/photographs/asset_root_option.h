#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace seamline::renderer {

/// `--asset-root DIR`, the same for every command that reads the scenes of a study file.
inline void add_asset_root_option(CLI::App& command, std::string& asset_root) {
  command.add_option("--asset-root", asset_root,
                     "folder whose scene files the study may name besides those below its own folder");
}

}  // namespace seamline::renderer
