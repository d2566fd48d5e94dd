// A render as the pieces of a job: the same set, whatever a piece meets. The pieces start the program that
// made the job.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "run_program.h"
#include "running_program.h"
#include "sets/cluster/job_costs.h"
#include "stimuli/study_file/study_file.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_built;
using test::run_program;
using testing::HasSubstr;
using testing::Not;

/// The bedroom alone at two widths.
std::string small_study() {
  std::string text = test::small_study_with({{"[64, 256, 512, 1024, 2048]", "[64, 512]"}});
  text.erase(text.find("# Types 2 and 4"));
  return text;
}

/// A job's folder, its set's, and how the set is rendered.
struct Job {
  fs::path folder, set, study;
  std::string options;

  [[nodiscard]] Outcome piece(const std::string& name) const {
    return run_program("\"" + (folder / "task").string() + "\"", name);
  }
};

std::string render_of(const Job& job) {
  return job.study.string() + " --threads 1 " + job.options;
}

Job make_job(const fs::path& place, const std::string& options) {
  Job job{place / "a job's", place / "many", place / "study.toml", options};
  test::write_small_study(place, small_study());
  const Outcome made = run_built("job write " + render_of(job) + " --out " + job.set.string() +
                                 " --elements 2 --parallel \"" + job.folder.string() + "\"");
  EXPECT_EQ(made.status, 0) << made.output;
  return job;
}

/// What one process makes of the same study.
fs::path set_of_one_process(const Job& job) {
  const fs::path one = job.set.parent_path() / "one";
  EXPECT_EQ(run_built("render " + render_of(job) + " --out " + one.string()).status, 0);
  return one;
}

void expect_same_set(const Job& job) {
  const fs::path one = set_of_one_process(job);
  EXPECT_EQ(read_text(one / "manifest.json"), read_text(job.set / "manifest.json"));
  for (const char* part : {"stimuli", "references"})
    for (const auto& entry : fs::directory_iterator(one / part))
      EXPECT_EQ(read_text(entry.path()), read_text(job.set / part / entry.path().filename())) << entry.path();
  EXPECT_EQ(run_built("verify " + job.set.string()).status, 0);
}

TEST(Cluster, PiecesMakeTheSetOfOneProcessByBothEstimators) {
  for (const std::string options : {"--spp 2", "--error 0.05", "--spp 2 --estimator path"}) {
    const fs::path place = fresh_folder("cluster");
    const Job job = make_job(place, options);
    ASSERT_EQ(job.piece("truth-1").status, 0);
    EXPECT_TRUE(fs::exists(job.set / "truths"));
    for (const char* element : {"stimuli-2", "stimuli-1"}) {
      const Outcome outcome = job.piece(element);
      ASSERT_EQ(outcome.status, 0) << outcome.output;
    }
    EXPECT_FALSE(fs::exists(job.set / "manifest.json"));
    ASSERT_EQ(job.piece("join").status, 0);
    EXPECT_FALSE(fs::exists(job.set / "truths"));
    expect_same_set(job);
  }
}

TEST(Cluster, ADamagedTruthPassIsMadeAgain) {
  const Job job = make_job(fresh_folder("cluster-damaged"), "--spp 2");
  ASSERT_EQ(job.piece("truth-1").status, 0);
  const fs::path pass = fs::directory_iterator(job.set / "truths")->path();
  fs::resize_file(pass, fs::file_size(pass) - 1);
  ASSERT_EQ(job.piece("stimuli-1").status, 0);
  fs::remove(pass);
  ASSERT_EQ(job.piece("stimuli-2").status, 0);
  ASSERT_EQ(job.piece("join").status, 0);
  expect_same_set(job);
}

TEST(Cluster, StatusSaysWhatIsDoneAndLeftAndWhoFailed) {
  const Job job = make_job(fresh_folder("cluster-status"), "--spp 2");
  const std::string status = "job status " + job.set.string();
  EXPECT_THAT(run_built(status).output,
              HasSubstr("0 of 6 stimuli done (0 %), 6 left; 0 at work, 0 failed, 0 died\n"));
  EXPECT_THAT(run_built(status).output,
              HasSubstr("no piece has begun: not submitted (" + (job.folder / "run").string() + " does it)"));
  ASSERT_EQ(job.piece("truth-1").status, 0);
  EXPECT_THAT(run_built(status).output, HasSubstr("0 of 6 stimuli done"));
  ASSERT_EQ(job.piece("stimuli-1").status, 0);
  const Outcome early = job.piece("join");
  EXPECT_EQ(early.status, 1);
  EXPECT_THAT(early.output, HasSubstr("wanted a set whose stimuli are all rendered"));
  EXPECT_FALSE(fs::exists(job.set / "manifest.json"));
  const std::string half = run_built(status).output;
  EXPECT_THAT(half, Not(HasSubstr("0 of 6 stimuli done")));
  EXPECT_THAT(half, Not(HasSubstr("6 of 6 stimuli done")));
  EXPECT_THAT(half, HasSubstr("0 at work, 1 failed, 0 died"));
  EXPECT_THAT(half,
              HasSubstr("failed: " + job.set.string() + ": wanted a set whose stimuli are all rendered"));
  EXPECT_THAT(half, HasSubstr("nothing is at work: what is left waits in a queue, or "));
  // A mark that nobody renews, and one with a complaint.
  const fs::path marks = job.set / "records" / "running";
  test::write_text(marks / "stimuli-2.json", R"({"element":"stimuli-2","host":"far","done":1,"of":4})");
  EXPECT_THAT(run_built(status).output, HasSubstr("stimuli-2 on far: 1 of 4 done"));
  fs::last_write_time(marks / "stimuli-2.json",
                      fs::file_time_type::clock::now() - std::chrono::seconds(1000));
  EXPECT_THAT(run_built(status).output, HasSubstr("stimuli-2 on far: died: silent for 1000 s; 1 of 4 done"));
  test::write_text(marks / "stimuli-2.json", R"({"host":"far","failed":"study.toml: wanted <light>"})");
  EXPECT_THAT(run_built(status).output, HasSubstr("0 at work, 2 failed"));
  ASSERT_EQ(run_built(status + " --html " + (job.set / "status.html").string()).status, 0);
  EXPECT_THAT(read_text(job.set / "status.html"), HasSubstr("failed: study.toml: wanted &lt;light&gt;"));
  ASSERT_EQ(job.piece("stimuli-2").status, 0);
  EXPECT_THAT(run_built(status).output, HasSubstr("every stimulus is there, and no manifest yet"));
  ASSERT_EQ(job.piece("join").status, 0);
  EXPECT_THAT(
      run_built(status).output,
      HasSubstr("6 of 6 stimuli done (100 %), 0 left; 0 at work, 0 failed, 0 died; the manifest lists all"));
  // Of a set that one process made, and of none.
  const std::string one = run_built("job status " + set_of_one_process(job).string()).output;
  EXPECT_THAT(one, HasSubstr("6 of 6 stimuli done"));
  EXPECT_THAT(one, HasSubstr("rendered without a job"));
  EXPECT_THAT(run_built("job status " + (job.set / "none").string()).output, HasSubstr("no such folder"));
}

TEST(Cluster, MarksOfWrongTypesAreNone) {
  const Job job = make_job(fresh_folder("cluster-types"), "--spp 2");
  const fs::path marks = job.set / "records" / "running";
  fs::create_directories(marks);
  int number = 0;
  for (const char* text : {R"({"host":1})", R"({"done":"x"})", R"({"done":1e99})", R"({"of":[1]})",
                           R"({"failed":{}})", "[1,2]", "", R"({"kernel":null})", R"({"locked":"yes"})",
                           "{\"host\":\"\xFF\"}", R"({"done":99999999999999999999})"})
    test::write_text(marks / ("stimuli-" + std::to_string(++number) + ".json"), text);
  test::write_text(marks / "nested.json", std::string(10000, '['));
  fs::create_directory(marks / "folder.json");
  const Outcome status = run_built("job status " + job.set.string());
  EXPECT_EQ(status.status, 0) << status.output;
  EXPECT_THAT(status.output, HasSubstr("0 of 6 stimuli done (0 %), 6 left; 0 at work, 0 failed, 0 died"));
}

TEST(Cluster, APieceIsAtWorkUntilItIsKilledWhateverTheClocksSay) {
  const fs::path place = fresh_folder("cluster-killed");
  const Job job = make_job(place, "--spp 4096");
  const std::string status = "job status " + job.set.string();
  const test::Running piece =
      test::start({"job", "piece", job.study.string(), "--out", job.set.string(), "--threads", "1", "--spp",
                   "4096", "--job", job.folder.string(), "--element", "stimuli-1"},
                  place / "piece.txt");
  const fs::path mark = job.set / "records" / "running" / "stimuli-1.json";
  while (!fs::exists(mark)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  for (const int apart_s : {-3600, -300, 300, 3600}) {
    fs::last_write_time(mark, fs::file_time_type::clock::now() + std::chrono::seconds(apart_s));
    EXPECT_THAT(run_built(status).output, HasSubstr("; 1 at work, 0 failed, 0 died")) << apart_s;
  }
  ASSERT_EQ(test::status_after(piece, SIGKILL), 128 + SIGKILL) << read_text(piece.output);
  const std::string said = run_built(status).output;
  EXPECT_THAT(said, HasSubstr("; 0 at work, 0 failed, 1 died"));
  EXPECT_THAT(said, HasSubstr("died: killed, or its machine failed"));
}

TEST(Cluster, AStudyWithOtherStimuliIsRefusedByEveryPiece) {
  const Job job = make_job(fresh_folder("cluster-changed"), "--spp 2");
  const std::string study = read_text(job.study);
  ASSERT_EQ(job.piece("truth-1").status, 0);
  for (const auto& [from, to] :
       {std::pair("[64, 512]", "[64, 128, 512]"), std::pair("[64, 512]", "[64]"),
        std::pair("artifacts = [\"receiver\"]", "artifacts = [\"receiver\", \"occlusion\"]")}) {
    SCOPED_TRACE(to);
    test::write_text(job.study, test::with_replaced(study, {{from, to}}));
    for (const char* piece : {"truth-1", "stimuli-1", "stimuli-2", "join"}) {
      const Outcome outcome = job.piece(piece);
      EXPECT_EQ(outcome.status, 1);
      EXPECT_THAT(outcome.output, HasSubstr("wanted the 6 stimuli that the job was made with"));
    }
    EXPECT_THAT(run_built("job status " + job.set.string()).output, HasSubstr("; 0 at work, 4 failed"));
  }
  EXPECT_FALSE(fs::exists(job.set / "manifest.json"));
  // A study that cannot be read is said there too.
  test::write_text(job.study, "format = 1\n");
  EXPECT_EQ(job.piece("stimuli-2").status, 1);
  EXPECT_THAT(run_built("job status " + job.set.string()).output,
              HasSubstr("failed: " + job.study.string() + ": format: "));
  test::write_text(job.study, study);
  for (const char* piece : {"truth-1", "stimuli-1", "stimuli-2", "join"})
    EXPECT_EQ(job.piece(piece).status, 0);
  expect_same_set(job);
}

TEST(Cluster, ThePiecesOfSomeStimuliAreCountedAmongThemAlone) {
  const Job job = make_job(fresh_folder("cluster-only"), "--spp 2 --only '*-0064'");
  EXPECT_THAT(run_built("job status " + job.set.string()).output, HasSubstr("0 of 3 stimuli done"));
  for (const char* piece : {"truth-1", "stimuli-1", "stimuli-2", "join"})
    ASSERT_EQ(job.piece(piece).status, 0);
  EXPECT_THAT(
      run_built("job status " + job.set.string()).output,
      HasSubstr("3 of 3 stimuli done (100 %), 0 left; 0 at work, 0 failed, 0 died; the manifest lists all"));
}

TEST(Cluster, WritingAJobIsASmallShareOfItsWork) {
  const fs::path folder = fresh_folder("cluster-probe");
  test::write_small_study(folder, test::small_study_with({}));
  const StudyDefinition study = read_study(folder / "study.toml");
  const renderer::JobCosts costs =
      renderer::measure_costs(study, {.set_folder = folder / "set", .threads = 1}, 60);
  EXPECT_GT(costs.share_probed, 0);
  EXPECT_LE(costs.share_probed, 0.2);
  EXPECT_EQ(costs.stimuli.size(), list_stimuli(study).size());
  for (const auto& [id, seconds] : costs.stimuli) EXPECT_GT(seconds, 0) << id;
  for (const auto& [truth, seconds] : costs.truths) EXPECT_GT(seconds, 0) << truth;
}

TEST(Cluster, NoPieceAndNoFolderAreNotAllOfThem) {
  const Job job = make_job(fresh_folder("cluster-empty"), "--spp 2");
  const auto refused = [&](const Outcome& outcome, const std::string& said) {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.output, HasSubstr(said));
  };
  refused(job.piece(""), "wanted one of truth-N, stimuli-N and join, found nothing");
  refused(job.piece("\"\""), "wanted one of truth-N, stimuli-N and join");
  refused(job.piece("truth-1 stimuli-1"), "wanted one of truth-N, stimuli-N and join");
  refused(job.piece("--help"), "wanted truth-1 to truth-1");
  const fs::path other = job.set.parent_path() / "other";
  const std::string render = render_of(job) + " --out " + other.string();
  for (const char* unset : {"--slurm ''", "--parallel ''", "--only ''"})
    refused(run_built("job write " + render + " " + unset), "wanted a text that is not empty");
  refused(run_built("job piece " + render + " --job x --element ''"), "wanted a text that is not empty");
  refused(run_built("job status ''"), "wanted a text that is not empty");
  EXPECT_FALSE(fs::exists(other));
}

TEST(Cluster, WhatIsNotTheJobsIsRefusedInASentence) {
  const Job job = make_job(fresh_folder("cluster-refused"), "--spp 2");
  EXPECT_THAT(job.piece("stimuli-3").output,
              HasSubstr("wanted truth-1 to truth-1, stimuli-1 to stimuli-2, or join"));
  EXPECT_EQ(job.piece("stimuli-03").status, 1);
  const std::string text = read_text(job.folder / "job.json");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    test::write_text(job.folder / "job.json", other);
    const Outcome outcome = job.piece("truth-1");
    EXPECT_EQ(outcome.status, 1);
    return outcome.output;
  };
  EXPECT_THAT(with("\"instruction_set\": \"", "\"instruction_set\": \"other-"),
              HasSubstr("wanted a machine with the instruction set that the job was made with"));
  EXPECT_THAT(with("\"inputs\": \"", "\"inputs\": \"0"), HasSubstr("others: make the job again"));
  EXPECT_THAT(with("\"truths\"", "\"lies\""), HasSubstr("wanted a job that `seamline job write`"));
  EXPECT_FALSE(fs::exists(job.set / "stimuli"));
  const std::string render = "job write " + job.study.string() + " --out " + job.set.string();
  EXPECT_THAT(run_built(render + " --elements 3").output,
              HasSubstr("wanted one of --slurm DIR and --parallel DIR"));
  EXPECT_EQ(run_built(render + " --shard 1/2 --slurm x").status, 1);
  EXPECT_THAT(run_built(render + " --spp 2 --slurm '" + (job.set / "a b").string() + "'").output,
              HasSubstr("wanted a path of letters, digits and"));
  const fs::path full = job.set.parent_path() / "full";
  fs::create_directories(full);
  test::write_text(full / "letter.txt", "mine");
  EXPECT_THAT(run_built("job write " + render_of(job) + " --out " + full.string() + " --parallel " +
                        (job.set.parent_path() / "other_job").string())
                  .output,
              HasSubstr("wanted a new or an empty folder, or one with a set"));
  EXPECT_FALSE(fs::exists(full / "records"));
}

}  // namespace
}  // namespace seamline
