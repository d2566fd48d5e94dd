#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline export x3d`: a scene as a page in X3DOM.
void add_x3d_command(CLI::App& group);

}  // namespace seamline::renderer
