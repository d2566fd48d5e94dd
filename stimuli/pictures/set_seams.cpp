#include "stimuli/pictures/set_seams.h"

#include <map>
#include <string>

#include "stimuli/set/manifest_pictures.h"
#include "support/running/parallel.h"

namespace seamline::inline stimuli {

std::vector<SeamMeasure> measure_seams(const std::filesystem::path& set_folder, const Manifest& manifest,
                                       int threads, const std::function<void(int finished)>& tick) {
  check_manifest_shapes(set_folder, manifest);
  std::map<std::string, ByteImage> references;
  for (const ManifestStimulus& record : manifest.stimuli)
    if (const std::string& truth = truth_of(record.stimulus); !references.contains(truth))
      references[truth] = read_manifest_picture(
          set_folder, reference_picture(manifest, reference_of(set_folder, manifest, record.stimulus)));
  std::vector<SeamMeasure> seams(manifest.stimuli.size());
  run_parallel(static_cast<int>(seams.size()), threads,
               [&](int index) {
                 const ManifestStimulus& record = manifest.stimuli[index];
                 seams[index] =
                     measure_seam(read_manifest_picture(set_folder, stimulus_picture(manifest, record)),
                                  references.at(truth_of(record.stimulus)));
               },
               {.tick = tick});
  return seams;
}

}  // namespace seamline::inline stimuli
