#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "commands/options/setting_option.h"
#include "raytracer/scene/gltf/transparency.h"

namespace seamline::renderer {

/// Adds `--transparent`: a way round half-transparent surfaces, which are refused without it.
inline CLI::Option* add_transparent_option(CLI::App& command, std::string& word, const char* of_what) {
  return command
      .add_option(
          "--transparent", word,
          std::string("half-transparent surfaces ") + of_what +
              " (refused without this): opaque; mask, with holes where alpha is below a half; or leave-out")
      ->check(CLI::IsMember(
          option_words(std::array{Transparency::opaque, Transparency::mask, Transparency::left_out})));
}

}  // namespace seamline::renderer
