#include "study/running/stimulus_numbers.h"

#include "support/text/error.h"

namespace seamline::study {

StimulusNumbers::StimulusNumbers(const std::vector<Stimulus>& stimuli, const std::filesystem::path& log)
    : log_(log) {
  for (std::size_t i = 0; i < stimuli.size(); ++i) numbers_[stimulus_id(stimuli[i])] = static_cast<int>(i);
}

int StimulusNumbers::of(const std::string& id) const {
  const auto found = numbers_.find(id);
  if (found == numbers_.end())
    throw input_error({.file = log_.string(),
                       .field = "stimuli",
                       .wanted = "a stimulus of the study",
                       .found = "\"" + id + "\""});
  return found->second;
}

}  // namespace seamline::study
