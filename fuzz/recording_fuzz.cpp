// The index of a recording of another person: what was read is written and read as the same.
#include "fuzz/fuzz_target.h"
#include "live/recording/recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  using namespace seamline::live;
  return fuzz::only_input_errors([&] {
    Recording recording = parse_recording(std::string(fuzz::text_of(data, size)), "recording.toml");
    recording.has_light = false;  // directions are made unit again
    recording.up = Eigen::Vector3d::UnitY();
    const std::string text = recording_text(recording);
    if (recording_text(parse_recording(text, "again.toml")) != text) abort();
  });
}
