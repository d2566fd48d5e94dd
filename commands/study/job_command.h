#pragma once

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline job`: a set made by many machines.
void add_job_command(CLI::App& app);

}  // namespace seamline::renderer
