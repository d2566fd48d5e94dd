#pragma once

namespace CLI {
class App;
}

namespace seamline::laboratory {

/// `seamline lab scenes`.
void add_scenes_command(CLI::App& app);

}  // namespace seamline::laboratory
