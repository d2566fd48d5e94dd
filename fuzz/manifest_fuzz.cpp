// A set's manifest, and the record of one stimulus that a continued rendering reads.
#include "fuzz/fuzz_target.h"
#include "stimuli/set/manifest.h"

namespace {

/// What was read once reads again the same.
void round_trip(const seamline::Manifest& manifest) {
  for (const seamline::ManifestStimulus& stimulus : manifest.stimuli) {
    const std::string text = stimulus_record_text(stimulus);
    if (stimulus_record_text(seamline::stimulus_record_from_text(text, "record")) != text) abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  const std::string_view text = fuzz::text_of(data, size);
  fuzz::only_input_errors([&] { (void)stimulus_record_from_text(std::string(text), "record.json"); });
  const std::filesystem::path file = fuzz::file_of("manifest.json", text);
  return fuzz::only_input_errors([&] { round_trip(read_manifest(file.parent_path())); });
}
