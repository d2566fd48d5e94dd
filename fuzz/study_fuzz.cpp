// A study file, from the text to the list of stimuli. Also the copy that a log keeps.
#include "fuzz/fuzz_target.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  return fuzz::only_input_errors([&] {
    const StudyDefinition study = read_study_text(std::string(fuzz::text_of(data, size)), "study.toml");
    if (study_hash(study).size() != 64) abort();
    if (study.scenes.size() < 20 && list_stimuli(study).empty()) abort();
  });
}
