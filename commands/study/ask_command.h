#pragma once

namespace CLI {
class App;
}

namespace seamline::study::online {

/// `seamline ask`: a session whose pictures another program shows.
void add_ask_command(CLI::App& app);

}  // namespace seamline::study::online
