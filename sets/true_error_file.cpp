// `SET/true_errors.json`.
#include <nlohmann/json.hpp>

#include "sets/true_error_set.h"
#include "support/files/atomic_file.h"

namespace seamline::renderer {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* file_name = "true_errors.json";
constexpr const char* file_format = "seamline true errors 1";

}  // namespace

TrueErrors read_true_errors(const std::filesystem::path& set_folder) {
  TrueErrors errors;
  if (!std::filesystem::exists(set_folder / file_name)) return errors;
  try {
    const Json json = Json::parse(read_file(set_folder / file_name));
    if (json.at("format") != file_format) return {};
    for (const Json& line : json.at("stimuli"))
      errors[line.at("id").get<std::string>()] = {.rmse = line.at("rmse").get<double>(),
                                                  .standard_error = line.at("standard_error").get<double>(),
                                                  .worst_tile = line.at("worst_tile").get<double>(),
                                                  .noisy_reference = line.value("noisy_reference", false),
                                                  .reference_spp = line.at("reference_spp").get<int>(),
                                                  .picture_sha256 = line.at("sha256").get<std::string>()};
  } catch (const Json::exception&) {
    return {};  // a damaged file is measured anew
  }
  return errors;
}

void write_true_errors(const std::filesystem::path& set_folder, const TrueErrors& errors) {
  Json lines = Json::array();
  for (const auto& [id, error] : errors)
    lines.push_back({{"id", id},
                     {"rmse", error.rmse},
                     {"standard_error", error.standard_error},
                     {"worst_tile", error.worst_tile},
                     {"noisy_reference", error.noisy_reference},
                     {"reference_spp", error.reference_spp},
                     {"sha256", error.picture_sha256}});
  const Json json = {{"format", file_format},
                     {"note",
                      "errors of the pictures against the path estimator with another seed, without its "
                      "noise, in display units (0 to 1); sha256 is of the picture"},
                     {"stimuli", std::move(lines)}};
  write_file_atomically(set_folder / file_name, json.dump(1) + "\n");
}

}  // namespace seamline::renderer
