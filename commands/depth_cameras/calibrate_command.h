#pragma once

namespace CLI {
class App;
}

namespace seamline::registration {

/// `seamline calibrate`: cameras from pictures of a chessboard, a pose from pairs of points.
void add_calibrate_command(CLI::App& app);

}  // namespace seamline::registration
