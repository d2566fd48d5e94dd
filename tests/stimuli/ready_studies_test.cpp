// What ready studies mean is held: their hashes were taken before settings were described by rows, and sets
// that were rendered from them stay theirs.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string> hashes = {
    {"fuzz/corpus/study/adaptive_joint.toml",
     "b2682a787781933036e2c6a141b203eaca8b53d3c7194cf9c268542d9f128831"},
    {"fuzz/corpus/study/adaptive_priors.toml",
     "8910165a6de763b190a63e95b9a32d95ea172ec5297997e262b6f6ef842f14f1"},
    {"fuzz/corpus/study/all_keys.toml", "ae11060f3c0d1460fcc5419cfcdb54e3e5d6188669b32e24a7c3929427e70418"},
    {"fuzz/corpus/study/depth.toml", "9d2404d7b8312c009bf6085eb6c7dd6a51f38ab66c7f881767a1e9ee79bf9111"},
    {"fuzz/corpus/study/quick.toml", "0ad021eba0e98eef9184803add46c2ecd6a43292cc9b12f8dd00f15ca769acea"},
    {"stimuli/colour_bleeding.toml", "ec711f5417e84b7b22712ef377a0ecc738b5c38ccd40261609712596bedf3458"},
    {"stimuli/depth_reduction.toml", "d29947e3234a86625fc3eea01578bc835a7c0349b15251dce9d74063afa4b2ad"},
    {"stimuli/depth_resolution.toml", "2ceb090d27fe77b341a1f84027240fa6c417311802dddbd929e18eae2a77aba6"},
    {"stimuli/depth_resolution_isolated.toml",
     "017f8cda8f4a019ed03ef2740844d35a94f75ffce571999d6a82cfe3b0c5cc04"},
    {"stimuli/discontinuity.toml", "4a1ade658c3fa775a87f59a023fbd889e9cee71ec2ffac4756b9618ba921fe66"},
    {"stimuli/environment_light.toml", "1d594589d243ebea0dd981abac9dfd5556a1559070f4f0656f4a205544c6e534"},
    {"stimuli/field_of_view.toml", "5a8cb77b06abca13eaccae8d1773e0a6a434b6883cc99397c4cdc6a134640331"},
    {"stimuli/furnished_room.toml", "f6598a787dc08bff8633a130ff2bc940181e1f48e75b03a6f5c4ded73152b219"},
    {"stimuli/many_lights.toml", "bed65e9b101f4a94f8536b5155ae8d34e2fdd2c11bd8070a90110410aaf31de7"},
    {"stimuli/mesh_tolerance.toml", "12e087c58c5a2c994307059f8076f0b79e8ea71a0506814dd9f35a94e2b45b54"},
    {"stimuli/mitigations.toml", "b4e7c302d7925f40f83f6de87ddb7dea39ed6ba3feb3c335cf3ae9b490ae4d6a"},
    {"stimuli/occlusion_method.toml", "7a8cfc956f8512800b758e6072587f3963a6718ed021c6fbd0451611eac2eb9d"},
    {"stimuli/quick.toml", "f5c491d8f27a66c48fc65b07769da733bf4a114c4c09bcc4e8fb253be8448a28"},
    {"stimuli/realtime_methods.toml", "8f5577bc4dd12bf502b3ba28617d09b60cc6c647bdcd84ab5f71ea385c30d5a7"},
    {"stimuli/reflections.toml", "74c54fbc836ce5ecee84e0f89911c9412e9711a8658fcecbaf9630a9588e51e7"},
    {"stimuli/registration_error.toml", "23f6a8c4d9ebeea7de5fec0edd51e05bae1a1a51027a34dbb807e0b88f55fd2c"},
    {"stimuli/sensor_noise.toml", "9934bee70a37bcb72a6cc59efa5ff5fa3985c8f0ac5e3dd09c394aea25b7c62e"},
    {"stimuli/soft_light.toml", "bb8ae00fe9ca3308aaf2f35919ac86be18169edbd012b357e1280023b589ebc6"},
    {"stimuli/stereo_seams.toml", "03e546c108f76a8be08af0b7f98b73a570d0c322b1782bfa544cb92be628ab67"},
    {"tests/online/adaptive.toml", "321b4e7cfa2154ee906c2af16846c5d6a7b24bccfede66f4fb54e59f7b89cfe2"},
    {"tests/online/arabic.toml", "caad9355a7c259c090ccdc51c4bd5c56cde691d97a9ac0969d9ecaf5d3745707"},
    {"tests/online/tiny.toml", "d218906e85c965a5d52d42cefa7db8f36567b9426eed2be5f9b637860399f797"},
};

/// Of studies that came later.
const std::map<std::string, std::string> later_hashes = {
    {"stimuli/budgeted_depth.toml", "ebef589f3fcccd0b371ba493dbfc160cb0442d332335369aef240e67daa831c9"},
    {"stimuli/estimated_depth.toml", "9cdc1f160ed37e35d9ecdf711f2cf96095434141310830b333caaf8de228a5b7"},
    {"stimuli/interval.toml", "ddbd488077ff7852c8a39d748f2585a990de049c95e8d5e94e1e0ee81bdd9538"},
    {"stimuli/late_depth.toml", "0455c8fd8e261395596007a33ea40b9232cead752653207a0fc411acb96ba7bc"},
    {"stimuli/moving_objects.toml", "9f74862e368a386fdfbfb81dbaff29450b5574056bfb7b045f253a14e3ad222a"},
    {"stimuli/pair.toml", "038727b16095894d418fc454c1f754a73b0b084ecae2db27914a150c0732c34a"},
    {"stimuli/stereo_depth.toml", "0410ee47610aff900afa296c63498ec4e41462da7d0493b72ee97f61e3102d4e"},
    {"stimuli/video_background.toml", "8e2cac72e8802541bb691f1a0fd681e31a8e6fcd3405dd65135e8c54a2f92907"},
    {"stimuli/two_observers.toml", "b62b58235eed86d7dce4372bd56d43986437c4d4dc96de68fc9dc523ce0adb84"},
    {"stimuli/headset.toml", "7bee87b9aa84190fb6bf9d4d68ae5a6bd89c273408f57aa1efb3e232627af830"},
    {"stimuli/look_round.toml", "3dec19ac12893836b66e61e7835341f63e4610747f2fd68e7c5a699d3fe1d0f6"},
};

StudyDefinition ready_study(const std::string& file) {
  return read_study_text(read_file(fs::path(SEAMLINE_SOURCE_DIR) / file), file);
}

TEST(ReadyStudies, HaveTheHashesThatTheyHad) {
  for (const auto* held : {&hashes, &later_hashes})
    for (const auto& [file, hash] : *held) EXPECT_EQ(study_hash(ready_study(file)), hash) << file;
}

/// Of all of their stimuli: id, truth, and what of the depth is not the paper's.
TEST(ReadyStudies, ShowTheStimuliThatTheyShowed) {
  std::string said;
  for (const auto& [file, hash] : hashes)
    for (const Stimulus& one : list_stimuli(ready_study(file)))
      said += stimulus_id(one) + "|" + one.truth + "|" + std::to_string(one.depth.width_px) + "|" +
              canonical_text(one.depth.chain) + "|" + canonical_text(one.depth.mitigation) + "|" +
              canonical_text(one.depth.pipeline) + "\n";
  EXPECT_EQ(sha256(said), "3a60dfff3485fd82652a7b80de4cbfafbcc94bb8790c9b8a7bd7d24b941b3707");
}

TEST(ReadyStudies, AreAllHeld) {
  int found = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SEAMLINE_SOURCE_DIR) / "stimuli"))
    if (entry.path().extension() == ".toml") {
      ++found;
      const std::string file = "stimuli/" + entry.path().filename().string();
      EXPECT_TRUE(hashes.contains(file) || later_hashes.contains(file)) << file;
    }
  EXPECT_GE(found, 20);
}

}  // namespace
}  // namespace seamline
