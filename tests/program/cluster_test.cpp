// A render as the pieces of a job: the same set, whatever a piece meets. The pieces start the program that
// made the job.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.h"

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
  std::string text = test::small_study_with({{"[64, 256, 512, 1024, 4096]", "[64, 512]"}});
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
  return "render " + job.study.string() + " --threads 1 " + job.options;
}

Job make_job(const fs::path& place, const std::string& options) {
  Job job{place / "a job's", place / "many", place / "study.toml", options};
  test::write_small_study(place, small_study());
  const Outcome made = run_built(render_of(job) + " --out " + job.set.string() +
                                 " --elements 2 --parallel \"" + job.folder.string() + "\"");
  EXPECT_EQ(made.status, 0) << made.output;
  return job;
}

/// What one process makes of the same study.
fs::path set_of_one_process(const Job& job) {
  const fs::path one = job.set.parent_path() / "one";
  EXPECT_EQ(run_built(render_of(job) + " --out " + one.string()).status, 0);
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
  const std::string status = "render --status " + job.set.string();
  EXPECT_THAT(run_built(status).output, HasSubstr("wanted a set that a job of `seamline render` has begun"));
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
  EXPECT_THAT(half, HasSubstr("0 at work, 0 failed"));
  // A mark that nobody renews, and one with a complaint.
  const fs::path marks = job.set / "records" / "running";
  test::write_text(marks / "stimuli-2.json", R"({"element":"stimuli-2","host":"far","done":1,"of":4})");
  EXPECT_THAT(run_built(status).output, HasSubstr("stimuli-2 on far: 1 of 4 done"));
  fs::last_write_time(marks / "stimuli-2.json",
                      fs::file_time_type::clock::now() - std::chrono::seconds(1000));
  EXPECT_THAT(run_built(status).output, HasSubstr("stimuli-2 on far: died: silent for 1000 s, after 1 of 4"));
  test::write_text(marks / "stimuli-2.json", R"({"host":"far","failed":"study.toml: wanted <light>"})");
  EXPECT_THAT(run_built(status).output, HasSubstr("0 at work, 1 failed"));
  ASSERT_EQ(run_built(status + " --html " + (job.set / "status.html").string()).status, 0);
  EXPECT_THAT(read_text(job.set / "status.html"), HasSubstr("failed: study.toml: wanted &lt;light&gt;"));
  ASSERT_EQ(job.piece("stimuli-2").status, 0);
  ASSERT_EQ(job.piece("join").status, 0);
  EXPECT_THAT(run_built(status).output, HasSubstr("6 of 6 stimuli done (100 %), 0 left; 0 at work, 0 failed; "
                                                  "the manifest lists all"));
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
  EXPECT_THAT(with("\"truths\"", "\"lies\""), HasSubstr("wanted a job that `seamline render --slurm`"));
  EXPECT_FALSE(fs::exists(job.set));
  const std::string render = "render " + job.study.string() + " --out " + job.set.string();
  EXPECT_THAT(run_built(render + " --elements 3").output, HasSubstr("wanted --slurm DIR or --parallel DIR"));
  EXPECT_EQ(run_built(render + " --shard 1/2 --slurm x").status, 1);
  EXPECT_THAT(run_built(render + " --spp 2 --slurm '" + (job.set / "a b").string() + "'").output,
              HasSubstr("wanted a path without spaces"));
}

}  // namespace
}  // namespace seamline
