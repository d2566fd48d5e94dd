#pragma once

namespace CLI {
class App;
}

namespace seamline::stability {

/// Adds `seamline lab stability`, which tries the product on stiff and extreme input. `any_failed` becomes
/// true when a case did not pass; it must outlive the parsing.
void add_stability_command(CLI::App& app, bool& any_failed);

}  // namespace seamline::stability
