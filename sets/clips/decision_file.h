#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/estimators/sample_decision.h"

namespace seamline::renderer {

/// `SET/records/decision-NAME.json`: how a clip's photographs or a clip are sampled. None where it is not
/// there, cannot be read, or was decided of other inputs: then it is decided again.
[[nodiscard]] std::optional<PhotographDecision> read_photograph_decision(
    const std::filesystem::path& set_folder, const std::string& name, const std::string& inputs);
[[nodiscard]] std::optional<StimulusDecision> read_stimulus_decision(const std::filesystem::path& set_folder,
                                                                     const std::string& name,
                                                                     const std::string& inputs);
void write_decision(const std::filesystem::path& set_folder, const std::string& name,
                    const std::string& inputs, const PhotographDecision& decision);
void write_decision(const std::filesystem::path& set_folder, const std::string& name,
                    const std::string& inputs, const StimulusDecision& decision);

}  // namespace seamline::renderer
