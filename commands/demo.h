#pragma once

namespace CLI {
class App;
}

namespace seamline {

/// `seamline demo`: the whole chain on the quick study with simulated observers. It lies beside main.cpp
/// because, like it, it looks into every folder.
void add_demo_command(CLI::App& app);

}  // namespace seamline
