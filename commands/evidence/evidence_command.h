#pragma once

namespace CLI {
class App;
}

namespace seamline::laboratory {

/// Adds `seamline lab evidence`, which remakes what documentation/evidence/ holds.
void add_evidence_command(CLI::App& app);

}  // namespace seamline::laboratory
