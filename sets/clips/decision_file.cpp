#include "sets/clips/decision_file.h"

#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path decision_path(const fs::path& set_folder, const std::string& name) {
  return set_folder / "records" / ("decision-" + name + ".json");
}

Json read_decision(const fs::path& set_folder, const std::string& name, const std::string& inputs) {
  const fs::path path = decision_path(set_folder, name);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  const std::string text = read_file(path);
  require_bounded_json(text, path.string());
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() && json.value("inputs", Json()) == inputs ? json : Json();
}

void write_decision_json(const fs::path& set_folder, const std::string& name, const Json& json) {
  write_file_atomically(decision_path(set_folder, name), json.dump() + "\n");
}

}  // namespace

std::optional<PhotographDecision> read_photograph_decision(const fs::path& set_folder,
                                                           const std::string& name,
                                                           const std::string& inputs) {
  try {
    const Json json = read_decision(set_folder, name, inputs);
    return PhotographDecision{json.at("spp").get<std::vector<int>>(), json.at("strength").get<std::size_t>()};
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<StimulusDecision> read_stimulus_decision(const fs::path& set_folder, const std::string& name,
                                                       const std::string& inputs) {
  try {
    const Json json = read_decision(set_folder, name, inputs);
    return StimulusDecision{json.at("uncovered").get<std::vector<int>>(),
                            json.at("object").get<std::vector<int>>(),
                            json.at("filtered").get<std::vector<char>>()};
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void write_decision(const fs::path& set_folder, const std::string& name, const std::string& inputs,
                    const PhotographDecision& decision) {
  write_decision_json(set_folder, name,
                      {{"inputs", inputs}, {"spp", decision.spp}, {"strength", decision.strength}});
}

void write_decision(const fs::path& set_folder, const std::string& name, const std::string& inputs,
                    const StimulusDecision& decision) {
  write_decision_json(set_folder, name,
                      {{"inputs", inputs},
                       {"uncovered", decision.uncovered},
                       {"object", decision.object},
                       {"filtered", std::vector<int>(decision.filtered.begin(), decision.filtered.end())}});
}

}  // namespace seamline::renderer
