#pragma once
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `--x3d DIR` of the command `export`, which belongs to a part of the house that the renderer does not look
/// at.
struct X3dExport {
  std::function<bool()> is_asked;                        ///< whether it was given
  std::function<void(const std::string& source)> write;  ///< writes the page and says what it holds
};

/// Adds `--x3d` and what goes with it to the command.
[[nodiscard]] X3dExport add_x3d_options(CLI::App& command);

}  // namespace seamline::renderer
