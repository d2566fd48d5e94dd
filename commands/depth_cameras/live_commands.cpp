#include "commands/depth_cameras/live_commands.h"

#include "commands/depth_cameras/live_command.h"
#include "commands/depth_cameras/record_command.h"

namespace seamline::live {

void add_live_commands(CLI::App& app, const ShowInWindow& show) {
  add_record_command(app);
  add_live_command(app, show);
}

}  // namespace seamline::live
