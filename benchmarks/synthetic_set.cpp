// Makes a set of thousands of stimuli of a few, so that everything after rendering can be measured with them
// (`benchmarks/scale` calls it):
//   seamline_synthetic_set STUDY.toml SET ONLY
// renders the stimuli that match ONLY, gives every other one the picture of the first with its object, and
// renders the set, of which everything is kept then. The last step's seconds are printed.
#include <fmt/core.h>

#include <filesystem>
#include <map>

#include "sets/render_set.h"
#include "sets/set_records.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"

namespace fs = std::filesystem;
using namespace seamline;
using namespace seamline::renderer;

namespace {

void copy_stimuli(const StudyDefinition& study, const fs::path& set) {
  const InputHashes hashes(study, render_settings(study, {}));
  const SetRecords records(set);
  std::map<std::string, ManifestStimulus> first;  // of each truth and object
  const auto key = [](const Stimulus& stimulus) { return truth_of(stimulus) + " " + stimulus.object; };
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  for (const Stimulus& stimulus : stimuli)
    if (const auto done = records.finished(stimulus_id(stimulus), hashes.of_stimulus(stimulus)))
      first.emplace(key(stimulus), *done);
  for (const Stimulus& stimulus : stimuli) {
    const std::string id = stimulus_id(stimulus);
    const auto like = first.find(key(stimulus));
    if (like == first.end())
      throw InputError("synthetic_set: no stimulus is rendered with the object of " + id);
    ManifestStimulus record = like->second;
    if (record.id == id) continue;
    record.id = id;
    record.stimulus = stimulus;
    record.image = "stimuli/" + id + ".png";
    fs::copy_file(set / like->second.image, set / record.image, fs::copy_options::skip_existing);
    records.finish(record, hashes.of_stimulus(stimulus));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw InputError("usage: seamline_synthetic_set STUDY.toml SET ONLY");
    const StudyDefinition study = read_study(argv[1]);
    // As an element of a job, so that `job status` knows the set.
    RenderRequest first{.set_folder = argv[2], .part = JobPart::stimuli, .element = "stimuli-1"};
    for (const Stimulus& stimulus : list_stimuli(study))
      if (matches_pattern(stimulus_id(stimulus), argv[3])) first.ids.insert(stimulus_id(stimulus));
    render_set(study, first);
    copy_stimuli(study, argv[2]);
    fmt::print("{}\n", render_set(study, {.set_folder = argv[2]}).seconds);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
