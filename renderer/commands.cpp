#include "renderer/commands.h"

#include "renderer/bench_command.h"
#include "renderer/check_command.h"
#include "renderer/convergence_command.h"
#include "renderer/render_command.h"
#include "renderer/workbench_command.h"

namespace seamline::renderer {

void add_renderer_commands(CLI::App& app) {
  add_render_command(app);
  add_check_command(app);
  add_convergence_command(app);
  add_workbench_commands(app);
  add_bench_command(app);
}

}  // namespace seamline::renderer
