#pragma once

namespace CLI {
class App;
}

namespace seamline::study::online {

/// `seamline export`: a set as a page or as videos, a log as tables, a scene in X3D; a command each.
void add_export_command(CLI::App& app);

}  // namespace seamline::study::online
