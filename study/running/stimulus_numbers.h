#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"

namespace seamline::study {

/// Where the stimuli of a study stand in its list, by id, for going through the answers of a log again.
class StimulusNumbers {
 public:
  StimulusNumbers(const std::vector<Stimulus>& stimuli, const std::filesystem::path& log);
  /// Throws InputError when the study has no such stimulus.
  [[nodiscard]] int of(const std::string& id) const;

 private:
  std::filesystem::path log_;
  std::map<std::string, int> numbers_;
};

}  // namespace seamline::study
