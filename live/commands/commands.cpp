#include "live/commands/commands.h"

#include "live/commands/live_command.h"
#include "live/commands/record_command.h"

namespace seamline::live {

void add_live_commands(CLI::App& app, const ShowInWindow& show) {
  add_record_command(app);
  add_live_command(app, show);
}

}  // namespace seamline::live
