#pragma once

namespace CLI {
class App;
}

namespace seamline::study::online {

/// `seamline import` and `seamline merge`: answers that were stored elsewhere.
void add_gathering_commands(CLI::App& app);

}  // namespace seamline::study::online
