// [observer] is part of a study's hash, and no part of what people are shown: sets and logs go on when it
// changes. What a session leaves that stored nothing is no log of anybody.
#include <gmock/gmock.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include "log_fixture.h"
#include "stimuli/set/set_study.h"
#include "study/log/online/log_merge.h"
#include "study/running/simulation.h"
#include "study/running/visit_store.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* other_observer = "[observer.midpoint_width_px]\nreceiver = 77\n";

class ObserverIdentity : public LogTest {
 protected:
  [[nodiscard]] static std::string text(const std::string& more = "") {
    return study_text("tiny", "64, 512") + more;
  }
  /// The study rendered again where its set lies, as `render` does.
  RenderedSet render_again(const std::string& study_text) {
    const fs::path file = folder / "mine.toml";
    write_file_atomically(file, study_text);
    const StudyDefinition study = read_study(file, AssetCheck::not_needed);
    Manifest manifest = set.manifest;
    manifest.study_hash = identity_in(set.folder, study);
    write_study_file(set.folder, study, manifest.study_hash);
    write_manifest(set.folder, manifest);
    return load_rendered_set(set.folder);
  }
  void one_person() {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 3);
  }
  [[nodiscard]] SimulationRequest simulated(const RenderedSet& of, ObserverKind kind) const {
    return {.set_folder = of.folder, .log = path, .observer = kind, .count = 2, .seed = 1};
  }
};

TEST_F(ObserverIdentity, AStudysHashIsWhatItWas) {
  EXPECT_EQ(study_hash(set.study), "fdc5e2e4b37e37ec43186d6a9abdc70f0e9004844041a3d09fb5e46e74d781e6");
  EXPECT_NE(study_hash(read_study_text(text(other_observer), "study.toml")), study_hash(set.study));
}

TEST_F(ObserverIdentity, ASetRenderedAgainWithAnotherObserverIsTheSameSet) {
  one_person();
  const RenderedSet changed = render_again(text(other_observer));
  EXPECT_EQ(changed.set_hash, set.set_hash);
  EXPECT_EQ(changed.study.observer.midpoint.at(Artifact::receiver), 77);
  {
    LogWriter log(path, changed);
    EXPECT_EQ(enter(log, {.code = "p1"}, 1).answered, 4);
  }
  // Once more, and back.
  EXPECT_EQ(render_again(text("[observer]\nscale_octaves = 2\n")).set_hash, set.set_hash);
  EXPECT_EQ(render_again(text()).set_hash, set.set_hash);
  EXPECT_FALSE(fs::exists(set.folder / "rendered_study.toml"));
  // What people are shown is another study.
  EXPECT_NE(render_again(text("[catch]\nattention = 2\n")).set_hash, set.set_hash);
}

TEST_F(ObserverIdentity, ASetElsewhereWithAnotherObserverGoesOnInTheLog) {
  one_person();
  const RenderedSet elsewhere = write_set_of_text(folder / "elsewhere", text(other_observer));
  EXPECT_NE(elsewhere.set_hash, set.set_hash);
  {
    LogWriter log(path, elsewhere);
    EXPECT_EQ(enter(log, {.code = "p1"}, 1).answered, 4);
  }
  EXPECT_EQ(read_log(path).set_hash, set.set_hash);
  EXPECT_EQ(read_log(path).study_hash, set.manifest.study_hash);
  const RenderedSet shows_more = write_set_of_text(folder / "more", text("[catch]\nattention = 2\n"));
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, shows_more); }), HasSubstr("study_hash"));
}

TEST_F(ObserverIdentity, TheLogSaysWhatItsSimulatedObserversAreMadeOf) {
  one_person();
  const RenderedSet changed = render_again(text(other_observer));
  (void)run_simulated_study(simulated(changed, ObserverKind::threshold));
  EXPECT_THAT(read_log(path).study_text, HasSubstr("receiver = 77"));
  const RenderedSet again = render_again(text());
  EXPECT_THAT(complaint_of([&] { (void)run_simulated_study(simulated(again, ObserverKind::threshold)); }),
              HasSubstr("observer: wanted that of the simulated observers in"));
}

TEST_F(ObserverIdentity, LogsOfTwoObserversAreMerged) {
  one_person();
  const RenderedSet other = write_set_of_text(folder / "elsewhere", text(other_observer));
  const RenderedSet third = write_set_of_text(folder / "third", text("[observer]\nscale_octaves = 2\n"));
  const fs::path people = folder / "people.sqlite", made = folder / "made.sqlite",
                 more = folder / "more.sqlite";
  {
    LogWriter log(people, other);
    (void)enter(log, {.code = "p2"}, 3);
  }
  const auto simulate = [&](const RenderedSet& of, const fs::path& log, std::uint64_t seed) {
    (void)run_simulated_study(
        {.set_folder = of.folder, .log = log, .observer = ObserverKind::threshold, .count = 2, .seed = seed});
  };
  simulate(other, made, 1);
  simulate(third, more, 2);
  // Simulated people of every log have the same codes, and are others.
  SQLite::Database(more.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE participants SET code = 'more-' || code");
  const std::string own_text = read_log(path).study_text;
  // Of people it says nothing.
  EXPECT_THAT(merge_logs(path, {people})[0].added, testing::ElementsAre("p2"));
  EXPECT_EQ(read_log(path).study_text, own_text);
  // A log without simulated people takes the text that says what the first of them are made of.
  EXPECT_EQ(merge_logs(path, {made})[0].other_observer, 0);
  EXPECT_THAT(read_log(path).study_text, HasSubstr("receiver = 77"));
  EXPECT_EQ(read_log(path).study_hash, set.manifest.study_hash);
  // The next ones keep how they differ.
  const std::vector<MergedLog> merged = merge_logs(path, {more});
  EXPECT_EQ(merged[0].other_observer, 2);
  EXPECT_THAT(merge_text(merged, path), HasSubstr("2 of them are simulated with another [observer]"));
  int count = 0;
  {
    SQLite::Database log(path.string(), SQLite::OPEN_READONLY);
    SQLite::Statement kept(log, R"sql(
      SELECT DISTINCT code, detail FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      WHERE events.kind = 'observer' ORDER BY code)sql");
    while (kept.executeStep()) {
      ++count;
      EXPECT_EQ(kept.getColumn(1).getString(),
                "- midpoint receiver 77\n- observer 0.5 0.5\n+ midpoint receiver 300\n+ observer 2 0.5\n");
    }
  }
  EXPECT_EQ(count, 2);
  EXPECT_EQ(merge_logs(path, {more, made, people})[0].known, 2);
  // Other pictures are another study whatever the observer.
  const RenderedSet shows_more = write_set_of_text(folder / "shows", text("[catch]\nattention = 2\n"));
  const fs::path shown = folder / "shown.sqlite";
  simulate(shows_more, shown, 3);
  EXPECT_THAT(complaint_of([&] { (void)merge_logs(path, {shown}); }), HasSubstr("study_hash"));
}

TEST_F(ObserverIdentity, ARefusedSessionLeavesNoLog) {
  // Nobody knows where people see half of the noise: the study says no midpoint.
  std::string noise = text(
      "[depth]\nsource = \"pinhole\"\nsize_px = [32, 24]\nfield_of_view_deg = 60\n"
      "noise = { model = \"generic\", relative_sigma = 0.01 }\n"
      "[level]\nquantity = \"depth_noise\"\nvalues = [0, 1]\n");
  noise.erase(noise.find("depth_width_px"), std::string("depth_width_px = [64, 512]\n").size());
  const RenderedSet unknown = write_set_of_text(folder / "noise", noise);
  EXPECT_THAT(complaint_of([&] { (void)run_simulated_study(simulated(unknown, ObserverKind::threshold)); }),
              HasSubstr("midpoint"));
  EXPECT_FALSE(fs::exists(path));
  // The shipped consent text is for trial runs.
  EXPECT_THROW(VisitStore(set, path, {.code = "p1"}), InputError);
  EXPECT_FALSE(fs::exists(path));
  // Whatever fails later, as long as nothing is stored.
  EXPECT_THROW(
      {
        VisitStore store(set, path, {.code = "p1", .pilot = true});
        throw InputError("no screen");
      },
      InputError);
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(fs::exists(folder / "log.sqlite-wal"));
  EXPECT_THROW(
      {
        LogWriter log(path, set);
        (void)enter(log, {.code = "p1"}, 1);
        throw InputError("later");
      },
      InputError);
  EXPECT_EQ(read_log(path).answers.size(), 1U);
}

TEST_F(ObserverIdentity, ALogOfNobodyBelongsToNoStudy) {
  const RenderedSet other = write_set(folder / "other", "64, 128", "other");
  { LogWriter log(path, other); }  // somebody closed the window before they consented
  {
    LogWriter log(path, set);
    EXPECT_THROW(LogWriter(path, other), InputError);  // somebody has it open
    (void)enter(log, {.code = "p1"}, 2);
  }
  EXPECT_EQ(read_log(path).study_name, "tiny");
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, other); }), HasSubstr("study_hash"));
  // Somebody who declined, or was forgotten, was there.
  fs::remove(path);
  {
    LogWriter log(path, other);
    log.record_decline();
  }
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, set); }), HasSubstr("study_hash"));
}

}  // namespace
}  // namespace seamline::study
